#pragma once

#include <optional>
#include <string_view>

namespace mixcmp::model {

/// The order of f and g: the answer to one comparison. The values are those of the two verdict bits
/// in hardware.
enum class Verdict {
  less = 0,
  equal = 1,
  greater = 2,
  unordered = 3,  ///< f or g has no value
};
std::string_view to_string(Verdict verdict);
/// "less", or "undetermined" where there is none.
std::string_view to_string(const std::optional<Verdict>& truth);

}  // namespace mixcmp::model
