#pragma once

#include <string_view>

namespace mixcmp::inline expression {

/// How the verdicts of a comparison's parts combine into one.
enum class Combination {
  /// Less if every part is less; one greater part decides. The result is the last of the parts'
  /// verdicts in the order less, equal, unordered, greater.
  all,
  /// Less if any part is less. The result is the first of the parts' verdicts in the order less,
  /// unordered, equal, greater.
  any,
};
/// "all", "any".
std::string_view to_string(Combination combination);

}  // namespace mixcmp::inline expression
