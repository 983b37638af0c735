#pragma once

#include <optional>
#include <vector>

#include "model/expression/range.hpp"
#include "model/expression/typed_graph.hpp"

namespace mixcmp::model {

/// Which nodes of a graph hold exactly the real number that their expression has: every input lies
/// in its range and is a whole multiple of its grid (a power of two), so that all values of a node
/// are multiples of some 2^k below some 2^m, and the format has m - k digits. Inputs without a
/// range or a grid, divisions other than by powers of two, roots, and constants that the format
/// rounds are not exact, nor is what follows them.
std::vector<bool> exact_on_grid(const TypedGraph& graph,
                                const std::vector<std::optional<Range>>& ranges,
                                const std::vector<std::optional<mpq_class>>& grids);

}  // namespace mixcmp::model
