#pragma once

#include "generator/rtl/datapath_builder.hpp"
#include "model/error/lane.hpp"

namespace mixcmp::gen {

/// One flag, set where an operand fails its check; never, where there is nothing to check.
Signal build_range_checks(DatapathBuilder& builder, const model::Lane& lane,
                          const Schedule& schedule);

}  // namespace mixcmp::gen
