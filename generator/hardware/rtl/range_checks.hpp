#pragma once

#include "generator/hardware/rtl/datapath_builder.hpp"
#include "model/lane/error/lane.hpp"

namespace mixcmp::rtl {

/// Builds a flag for each part. It is set if an operand fails a check of that part, and never set
/// if there is nothing to check.
std::vector<Signal> build_range_checks(DatapathBuilder& builder, const error::Lane& lane,
                                       const datapath::Schedule& schedule);

}  // namespace mixcmp::rtl
