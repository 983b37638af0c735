#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/comparison/expression/graph.hpp"
#include "model/lane/error/certified_lane.hpp"

namespace mixcmp::test {

/// The comparison of two expressions that are known to be valid.
Graph graph_of(const std::string& f, const std::string& g);

/// The graph of several parts {f, g}.
Graph graph_of(const std::vector<std::pair<std::string, std::string>>& parts,
               Combination combination);

/// The certified decision; it must exist.
const error::UlpDistanceCriterion& certified_decision(const error::Lane& lane);

/// The lane with a relative bound, if there is one, and nothing left out of its operations; the
/// ranges of these inputs exclude negative values.
Result<error::Lane> relative_lane(TypedGraph graph, const std::vector<bool>& nonnegative);

}  // namespace mixcmp::test
