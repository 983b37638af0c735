#pragma once

#include <fmt/core.h>

#include <string>
#include <utility>

namespace mixcmp::test {

/// f and g over the positive inputs a and b: 13 roots, added from the first to the last and from
/// the last to the first. They are equal, which golden::true_verdict cannot prove.
inline std::pair<std::string, std::string> unproven_tie() {
  std::string forwards = "sqrt(a)", backwards = "sqrt(a)";
  for (int k = 1; k < 13; ++k) {
    const std::string root = fmt::format("sqrt({} + {})", k % 2 == 0 ? "a" : "b", k);
    forwards += " + " + root;
    backwards = root + " + " + backwards;
  }
  return {forwards, backwards};
}

}  // namespace mixcmp::test
