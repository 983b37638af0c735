#pragma once

#include "model/lane/fixed/fixed_lane.hpp"

/// Lanes without error, for operands in fixed point.
namespace mixcmp::fixed {

/// The fewest bits W of an exact lane with this bound, as FixedOptions have it. It is an error if
/// there is none with at most `most_bits`: it names the reason, such as an operation that rounds or
/// an input in floating point.
Result<int> exact_bits(const Graph& graph, const std::vector<OperandFormat>& operand_formats,
                       std::optional<BoundKind> bound, int most_bits);

/// A floating-point format in which no operation of the comparison of such operands rounds: the
/// smallest that is no smaller than binary64.
Result<FloatFormat> exact_format(const Graph& graph,
                                 const std::vector<OperandFormat>& operand_formats);

}  // namespace mixcmp::fixed
