#pragma once

#include <limits>
#include <vector>

#include "model/comparison/data/operand_source.hpp"
#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::profile {

/// Limits on the values of one lane node that hold for all comparisons of the data.
struct NodeMagnitude {
  static constexpr int unknown = std::numeric_limits<int>::min() / 4;

  double largest;       ///< |true value|, |computed value| <= largest; infinite if unknown
  int grid = unknown;   ///< computed values are multiples of 2^grid
  int least = unknown;  ///< computed values are 0 or at least 2^least in magnitude
};

/// The magnitudes of an input's values. A value that is not finite makes `largest` infinite.
NodeMagnitude magnitude_of(const std::vector<double>& values);

/// The magnitudes of every node of `lane`, if its operations round to `precision` digits with
/// unbounded exponent (docs/theory.md, "What cannot underflow"). `inputs` has one element per
/// input.
std::vector<NodeMagnitude> node_magnitudes(const TypedGraph& lane, int precision,
                                           const std::vector<NodeMagnitude>& inputs);

/// Whether the operation rounds its result; the others are exact.
bool rounds(Operation operation);

}  // namespace mixcmp::profile
