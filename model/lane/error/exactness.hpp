#pragma once

#include <optional>
#include <vector>

#include "model/comparison/expression/range.hpp"
#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::error {

/// Tells for each node of a graph whether it holds its expression's real value exactly. Every input
/// lies in its range and is a multiple of its grid (a power of two). So all values of a node are
/// multiples of some 2^k and at most some 2^m; they are exact if the format has m - k digits. These
/// nodes are not exact, nor is any node that depends on one: inputs without a range or a grid,
/// divisions other than by powers of two, roots, and constants that the format rounds.
std::vector<bool> exact_on_grid(const TypedGraph& graph,
                                const std::vector<std::optional<Range>>& ranges,
                                const std::vector<std::optional<mpq_class>>& grids);

}  // namespace mixcmp::error
