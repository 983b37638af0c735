#pragma once

#include <string_view>

namespace mixcmp::inline expression {

/// How the verdicts of a comparison's parts combine into one.
enum class Combination {
  all,  ///< the last of the verdicts in the order less, equal, unordered, greater
  any,  ///< the first of them in the order less, unordered, equal, greater
};
/// "all", "any".
std::string_view to_string(Combination combination);

}  // namespace mixcmp::inline expression
