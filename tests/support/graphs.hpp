#pragma once

#include <string>
#include <vector>

#include "model/error/lane.hpp"
#include "model/expression/graph.hpp"

namespace mixcmp::test {

/// The comparison of two expressions that are known to be valid.
model::Graph graph_of(const std::string& f, const std::string& g);

/// Where the certified decision exists: what it is.
const model::UlpDistanceDecision& certified_decision(const model::Lane& lane);

}  // namespace mixcmp::test
