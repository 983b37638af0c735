#pragma once

#include "model/data/comparisons.hpp"
#include "model/expression/combined_graph.hpp"

namespace mixcmp::model {

/// Makes a Contest that decides as a reference datapath does, bit for bit.
Contest reference_contest(const CombinedGraph& reference);

}  // namespace mixcmp::model
