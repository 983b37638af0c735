#pragma once

#include <optional>
#include <vector>

#include "model/emulator/column_blocks.hpp"
#include "model/emulator/fixed_kernels.hpp"
#include "model/fixed/fixed_lane.hpp"

namespace mixcmp::emulator {

/// A lane in fixed point, compiled to instructions on columns of doubles. Column k belongs to node
/// k and is filled only if something reads it. Columns of operands in floating point and of
/// intermediate results follow.
struct FixedCode {
  std::vector<FixedInput> inputs;
  /// The least e of theorem 6 (docs/fixed_point.md); none except in block floating point.
  std::optional<int> least_block_exponent;
  ColumnLayout arriving;   ///< its inputs are operands in floating point
  ColumnLayout converted;  ///< its inputs are operands that are already converted
  std::vector<FixedInstruction> instructions;
  std::vector<FixedCriterion> criteria;  ///< one per part
};

/// None if some integer has more bits than a double.
std::optional<FixedCode> make_fixed_code(const fixed::FixedLane& lane);

}  // namespace mixcmp::emulator
