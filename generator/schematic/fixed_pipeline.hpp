#pragma once

#include "generator/datapath/schedule.hpp"
#include "generator/page/pipeline.hpp"
#include "model/fixed/fixed_lane.hpp"

namespace mixcmp::schematic {

page::Pipeline fixed_lane_pipeline(const fixed::FixedLane& lane,
                                   const datapath::Schedule& schedule);

}  // namespace mixcmp::schematic
