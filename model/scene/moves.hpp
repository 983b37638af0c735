#pragma once

#include <optional>
#include <vector>

#include "model/comparison/expression/graph.hpp"

namespace mixcmp::scene {

inline constexpr std::size_t most_moves = 3;

/// Other formulations of a comparison, in which an operation that is dear in hardware has moved to
/// the other side as its inverse: sqrt(a) < b is a < b^2, a / c < b is a < b c, and exp(a) < b is
/// a < log(b). For all operands in the ranges both formulations have the same verdict by real
/// numbers; a move whose condition (b >= 0, c > 0, b > 0) the ranges do not prove is not made. At
/// most `most_moves`, those of the fewest moves first. Each graph has the inputs of the given one
/// and no node beyond those that it needs. `ranges`: one for each input.
std::vector<Graph> moved(const Graph& graph, const std::vector<std::optional<Range>>& ranges);

}  // namespace mixcmp::scene
