#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/comparison/expression/graph.hpp"

namespace mixcmp::fixed {

/// The comparison with one function in place of operations that depend on a single number, where
/// one table is cheaper: 1 / (1 + exp(-x)) and sin(x)^2 are one table each. None if there are no
/// such operations. `ranges`: one for each input, or none. `is_possible`: whether lanes can compute
/// a graph that compares one of these functions with 0; others stay as they are written.
std::optional<Graph> with_formulas(const Graph& graph,
                                   const std::vector<std::optional<Range>>& ranges,
                                   const std::function<bool(const Graph&)>& is_possible = {});

}  // namespace mixcmp::fixed
