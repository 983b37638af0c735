#pragma once

#include "generator/hardware/datapath/schedule.hpp"
#include "generator/present/page/pipeline.hpp"
#include "model/design/lane.hpp"

/// Pictures of a design: its datapaths, word by word, and the system around them.
namespace mixcmp::schematic {

/// A lane as it is scheduled: a box for each unit, with its format and the cycles in which it
/// works.
page::Pipeline lane_pipeline(const design::Lane& lane, const datapath::Schedule& schedule);

/// The conversion that computes the words of an engine's items or rows, as it is scheduled.
page::Pipeline item_pipeline(const fixed::FixedLane& loader, const datapath::Schedule& schedule);

/// A reference as it is scheduled.
page::Pipeline reference_pipeline(const design::ReferenceDatapath& reference,
                                  const datapath::Schedule& schedule);

}  // namespace mixcmp::schematic
