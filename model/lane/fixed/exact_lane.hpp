#pragma once

#include "model/lane/fixed/fixed_lane.hpp"

/// Lanes without error, for operands in fixed point and for promised multiples of a grid.
namespace mixcmp::fixed {

/// The fewest bits W with which fixed_lane rounds nothing, with these options but for W. Without
/// the bound `grid` such a lane also decides every comparison. It is an error if there is none with
/// at most `most_bits`: it names the reason, such as an operation that rounds or an input in
/// floating point without a grid.
Result<int> exact_bits(const Graph& graph, FloatFormat input_format, FixedOptions options,
                       int most_bits);

}  // namespace mixcmp::fixed
