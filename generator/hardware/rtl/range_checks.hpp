#pragma once

#include "generator/hardware/rtl/datapath_builder.hpp"
#include "model/lane/error/lane.hpp"

namespace mixcmp::rtl {

/// Builds a flag for each part, which is set where an operand fails a check of that part. Where
/// there is nothing to check it is never set.
std::vector<Signal> build_range_checks(DatapathBuilder& builder, const error::Lane& lane,
                                       const datapath::Schedule& schedule);

}  // namespace mixcmp::rtl
