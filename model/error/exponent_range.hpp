#pragma once

#include <optional>
#include <vector>

#include "model/expression/range.hpp"
#include "model/expression/typed_graph.hpp"

namespace mixcmp::model {

/// The fewest exponent bits with which a lane of this arithmetic's precision (its exponent bits are
/// not looked at) does its work on operands that pass the ranges' checks:
/// - no operation overflows;
/// - 2^(-2P) times the largest number that any operation computes is still normal. What is smaller
///   underflows and is recomputed; it is about as rare as what P digits leave undecided.
/// The reference's where an input has no range, or where fewer do not serve.
int lane_exponent_bits(const Graph& graph, FloatFormat reference, const Arithmetic& arithmetic,
                       LaneInputs inputs, const std::vector<std::optional<Range>>& ranges);

}  // namespace mixcmp::model
