#pragma once

#include "model/data/comparisons.hpp"
#include "model/expression/typed_graph.hpp"

namespace mixcmp::workload {

/// Makes a Contest that decides as a reference datapath does, bit for bit.
data::Contest reference_contest(const TypedGraph& reference);

}  // namespace mixcmp::workload
