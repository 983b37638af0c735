#pragma once

#include <string>
#include <vector>

#include "model/data/pairing.hpp"
#include "model/expression/graph.hpp"

namespace mixcmp::model {

/// What looks like a slip in how f and g name items i and j, in words for the user's eye: an input
/// of one item without its fellow of the other where both are rows of one table; of arg_min, f and
/// g that are not one cost of two candidates.
std::vector<std::string> pairing_notes(const Graph& graph, Pairing pairing);

}  // namespace mixcmp::model
