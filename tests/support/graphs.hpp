#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/error/certified_lane.hpp"
#include "model/expression/graph.hpp"

namespace mixcmp::test {

/// The comparison of two expressions that are known to be valid.
model::Graph graph_of(const std::string& f, const std::string& g);

/// The same of several parts {f, g}.
model::Graph graph_of(const std::vector<std::pair<std::string, std::string>>& parts,
                      model::Combination combination);

/// Where the certified decision exists: what it is.
const model::UlpDistanceDecision& certified_decision(const model::Lane& lane);

/// The lane with a relative bound, if there is one, and nothing left out of its operations; the
/// ranges of these inputs exclude negative values.
model::Result<model::Lane> relative_lane(model::TypedGraph graph,
                                         const std::vector<bool>& nonnegative);

}  // namespace mixcmp::test
