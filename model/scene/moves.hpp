#pragma once

#include <optional>
#include <vector>

#include "model/comparison/expression/graph.hpp"

namespace mixcmp::scene {

inline constexpr std::size_t most_moves = 3;

/// Other formulations of a comparison, in which an operation that is expensive in hardware has
/// moved to the other side as its inverse: sqrt(a) < b is a < b^2, a / c < b is a < b c, and exp(a)
/// < b is a < log(b). For all operands in the ranges both formulations have the same verdict by
/// real numbers: a move is made only if the ranges prove its condition (b >= 0, c > 0, b > 0).
/// Returns at most `most_moves` graphs, fewest moved operations first, with the same inputs and no
/// unused node. `ranges`: one for each input. Proof: docs/error_bounds.md, theorem 13.
std::vector<Graph> moved(const Graph& graph, const std::vector<std::optional<Range>>& ranges);

}  // namespace mixcmp::scene
