#include "model/comparison/expression/function.hpp"

#include <fmt/core.h>

#include "model/base/common/check.hpp"

namespace mixcmp::inline expression {

std::string_view to_string(Function function) {
  switch (function) {
    case Function::exp: return "exp";
    case Function::exp2: return "exp2";
    case Function::expm1: return "expm1";
    case Function::log: return "log";
    case Function::log2: return "log2";
    case Function::log1p: return "log1p";
    case Function::sin: return "sin";
    case Function::cos: return "cos";
    case Function::tan: return "tan";
    case Function::atan: return "atan";
    case Function::sinh: return "sinh";
    case Function::cosh: return "cosh";
    case Function::tanh: return "tanh";
  }
  MIXCMP_CHECK(false);
}

std::optional<mpq_class> open_end(Function function) {
  if (function == Function::log || function == Function::log2) return 0;
  return function == Function::log1p ? std::optional<mpq_class>(-1) : std::nullopt;
}

std::string accepted_arguments(Function function) {
  const std::optional<mpq_class> end = open_end(function);
  return end ? fmt::format("a number above {}", end->get_str()) : "a number";
}

}  // namespace mixcmp::inline expression
