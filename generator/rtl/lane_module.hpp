#pragma once

#include <string>
#include <vector>

#include "generator/datapath/schedule.hpp"
#include "generator/rtl/module.hpp"
#include "model/design/lane.hpp"

namespace mixcmp::rtl {

/// A lane of either number system; `header` is left to the caller.
Module lane_module(const std::string& name, const std::vector<std::string>& inputs,
                   const design::Lane& lane, const datapath::Schedule& schedule);

}  // namespace mixcmp::rtl
