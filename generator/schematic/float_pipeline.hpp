#pragma once

#include "generator/datapath/schedule.hpp"
#include "generator/page/pipeline.hpp"
#include "model/error/lane.hpp"

namespace mixcmp::schematic {

page::Pipeline float_lane_pipeline(const error::Lane& lane, const datapath::Schedule& schedule);

}  // namespace mixcmp::schematic
