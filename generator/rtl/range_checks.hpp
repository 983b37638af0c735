#pragma once

#include "generator/rtl/datapath_builder.hpp"
#include "model/error/combined_lane.hpp"

namespace mixcmp::gen {

/// For each part one flag, set where an operand fails a check of that part; never, where there is
/// nothing to check.
std::vector<Signal> build_range_checks(DatapathBuilder& builder, const model::SharedLane& lane,
                                       const Schedule& schedule);

}  // namespace mixcmp::gen
