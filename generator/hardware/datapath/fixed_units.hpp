#pragma once

#include <vector>

#include "generator/hardware/datapath/units.hpp"
#include "model/lane/fixed/fixed_lane.hpp"
#include "model/lane/fixed/square_tables.hpp"

namespace mixcmp::datapath {

/// The bits by which an operand of `node` is shifted up, to the unit in which the operation counts.
/// Only additions, subtractions, minima and maxima align their operands; for others it is 0.
int alignment_bits(const std::vector<fixed::FixedNode>& nodes, const fixed::FixedNode& node,
                   int operand);
/// The bits of an operand of `node` as its unit takes it: aligned, in two's complement.
int operand_bits(const std::vector<fixed::FixedNode>& nodes, const fixed::FixedNode& node,
                 int operand);

/// The unit that computes `node` of a lane. The node must not be a constant, which is a literal in
/// hardware, nor a square that is read from a memory.
Unit fixed_unit(const fixed::FixedLane& lane, const fixed::FixedNode& node,
                scene::Multipliers multipliers, const DelayTable& delays);
/// The unit of a sum by the adder behind an embedded multiplier (multiplier_sums.hpp).
Unit multiplier_sum_unit(const DelayTable& delays);
/// The unit that reads one or two squares from a memory.
Unit memory_square_unit(const fixed::SquareTable& table, const DelayTable& delays);
/// The unit that finds the largest exponent of the operands of block floating point.
Unit block_exponent_unit(const fixed::FixedLane& lane, const DelayTable& delays);
/// The unit that finds how many bits the common cuts drop.
Unit common_drop_unit(const fixed::FixedLane& lane, const DelayTable& delays);
/// The unit that finds the threshold of a running bound.
Unit step_threshold_unit(const fixed::RunningThresholds& thresholds, const DelayTable& delays);
/// The low bits of a limit's operand that do not tell whether it is within the limit.
int unchecked_bits(const std::vector<fixed::FixedNode>& nodes, const fixed::FixedNode& limit);
/// The unit that finds the numbers outside a limit, or beyond a reach.
Unit check_unit(const fixed::FixedLane& lane, const fixed::FixedNode& checked,
                const DelayTable& delays);
/// The unit that decides one part of a lane.
Unit fixed_decision_unit(const fixed::FixedLane& lane, const fixed::FixedPart& part,
                         const DelayTable& delays);

/// The width of the largest threshold of a norm decision, or of a running bound.
int threshold_bits(const fixed::FixedLane& lane, const fixed::NormThresholds& thresholds);
int threshold_bits(const fixed::RunningThresholds& thresholds);

}  // namespace mixcmp::datapath
