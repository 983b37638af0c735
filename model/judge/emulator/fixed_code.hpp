#pragma once

#include <optional>
#include <vector>

#include "model/judge/emulator/column_blocks.hpp"
#include "model/judge/emulator/fixed_kernels.hpp"
#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::emulator {

/// A lane in fixed point, compiled to instructions on columns of doubles. Column k belongs to node
/// k and is filled only if something reads it. Columns of operands in floating point and of
/// intermediate results follow.
struct FixedCode {
  ColumnLayout layout;
  std::vector<FixedInstruction> instructions;
  std::vector<FixedCriterion> criteria;  ///< one per part
};

/// None if double cannot hold some integer, unit or threshold exactly.
std::optional<FixedCode> make_fixed_code(const fixed::FixedLane& lane);

}  // namespace mixcmp::emulator
