#pragma once

#include "model/comparison/data/comparisons.hpp"
#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::workload {

/// Makes a data::CompareItems that decides as a reference datapath does, bit for bit.
data::CompareItems compare_by_reference(const TypedGraph& reference);

}  // namespace mixcmp::workload
