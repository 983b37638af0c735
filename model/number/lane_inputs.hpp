#pragma once

#include <string_view>

namespace mixcmp::inline number {

/// How a reduced lane takes the operands that arrive in reference format.
enum class LaneInputs {
  rounded,  ///< each is converted to the lane's format first
  exact,    ///< operations on inputs and constants alone take them unrounded; others as `rounded`.
            ///< Negate, absolute, minimum and maximum of such operands are exact themselves: they
            ///< stay in the reference format and count as inputs for what follows
};
/// "rounded", "exact".
std::string_view to_string(LaneInputs inputs);

}  // namespace mixcmp::inline number
