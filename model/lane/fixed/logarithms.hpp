#pragma once

#include <optional>
#include <vector>

#include "model/comparison/expression/graph.hpp"

namespace mixcmp::fixed {

/// The comparison with exp2(log2(a) - log2(b)) in place of a / b, and with the like for products,
/// powers and roots, where a function reads the result, all factors are above 0, and they span many
/// binades: in fixed point the logarithms then err less than the factors. log(a / b) becomes
/// log(a) - log(b). None if there is nothing of the kind. `ranges`: one for each input, or none.
std::optional<Graph> with_logarithms(const Graph& graph,
                                     const std::vector<std::optional<Range>>& ranges);

}  // namespace mixcmp::fixed
