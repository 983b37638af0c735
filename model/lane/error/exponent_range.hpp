#pragma once

#include <optional>
#include <vector>

#include "model/comparison/expression/range.hpp"
#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::error {

/// Returns the fewest exponent bits, 4 or more, that a lane of this arithmetic's precision P needs.
/// The arithmetic's own exponent bits are ignored. On operands that pass the ranges' checks:
/// - no operation may overflow or divide by zero;
/// - 2^(-2P) times the largest number that any operation computes must be normal. Smaller results
///   underflow and are recomputed; they are about as rare as comparisons that P digits leave
///   undecided.
/// The result is the reference's exponent bits if an input has no range, or if fewer bits do not
/// suffice.
int lane_exponent_bits(const Graph& graph, FloatFormat reference, const Arithmetic& arithmetic,
                       LaneInputs inputs, const std::vector<std::optional<Range>>& ranges);

}  // namespace mixcmp::error
