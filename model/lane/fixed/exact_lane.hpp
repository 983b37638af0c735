#pragma once

#include "model/lane/fixed/fixed_lane.hpp"

/// Lanes without error, for operands in fixed point.
namespace mixcmp::fixed {

/// The fewest bits W of an exact lane. It is an error if there is none with at most `most_bits`: it
/// names the reason, such as an operation that rounds or an input in floating point.
Result<int> exact_bits(const Graph& graph, const std::vector<OperandFormat>& operand_formats,
                       int most_bits);

/// The smallest floating-point format in which the comparison of such operands rounds nothing. Its
/// precision is at least `least_precision`.
Result<FloatFormat> exact_format(const Graph& graph,
                                 const std::vector<OperandFormat>& operand_formats,
                                 int least_precision);

}  // namespace mixcmp::fixed
