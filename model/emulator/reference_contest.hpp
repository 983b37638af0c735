#pragma once

#include "model/data/comparisons.hpp"
#include "model/expression/typed_graph.hpp"

namespace mixcmp::model {

/// Contests decided by a reference datapath, bit for bit.
Contest reference_contest(const TypedGraph& reference);

}  // namespace mixcmp::model
