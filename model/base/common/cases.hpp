#pragma once

namespace mixcmp::inline common {

/// Makes a visitor of a std::variant from one function for each alternative.
///
///     std::visit(Cases{[](int i) { return i; }, [](const std::string& s) { return 0; }}, value)
template <class... Functions>
struct Cases : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Cases(Functions...) -> Cases<Functions...>;  // clang 14 deduces no aggregates itself

}  // namespace mixcmp::inline common
