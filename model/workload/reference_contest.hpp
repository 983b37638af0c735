#pragma once

#include "model/data/comparisons.hpp"
#include "model/expression/combined_graph.hpp"

namespace mixcmp::model {

/// Contests decided by a reference datapath, bit for bit.
Contest reference_contest(const CombinedGraph& reference);

}  // namespace mixcmp::model
