#pragma once

#include "model/comparison/data/comparisons.hpp"
#include "model/lane/fixed/reference_datapath.hpp"

namespace mixcmp::workload {

/// Makes a data::CompareItems that decides as a reference datapath does, bit for bit.
data::CompareItems compare_by_reference(const fixed::ReferenceDatapath& reference);

}  // namespace mixcmp::workload
