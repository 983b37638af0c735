#include "generator/schematic/datapath_pipeline.hpp"

#include "generator/schematic/fixed_pipeline.hpp"
#include "generator/schematic/float_pipeline.hpp"
#include "model/common/cases.hpp"

namespace mixcmp::schematic {

page::Pipeline lane_pipeline(const design::Lane& lane, const datapath::Schedule& schedule) {
  return std::visit(
      Cases{
          [&](const error::Lane& made) { return float_lane_pipeline(made, schedule); },
          [&](const fixed::FixedLane& made) { return fixed_lane_pipeline(made, schedule); },
      },
      lane);
}

}  // namespace mixcmp::schematic
