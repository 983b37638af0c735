#pragma once

#include "tests/support/sphere.hpp"

namespace mixcmp::test {

/// A sphere lane of few digits on rounded inputs: what it bounds runs beside it.
inline model::Lane running_sphere_lane(model::FloatFormat lane, model::FloatFormat reference) {
  const model::Arithmetic reduced = {lane, model::Rounding::nearest_even, model::Subnormals::flush};
  return certified_lane(lane_graph(sphere_graph(), reference, reduced, model::LaneInputs::rounded),
                        {.kind = model::ErrorBoundKind::running,
                         .bound_digits = 4,
                         .ranges = std::vector<std::optional<model::Range>>(8)})
      .value();
}

/// Seven lanes: two precisions, exact and rounded inputs, multipliers of either make, and a group
/// that is the first one again; three references of two makes.
inline model::Design mixed_sphere_design() {
  const model::FloatFormat reference = format("s24e8");
  model::Design design = sphere_design(format("s6e8"), reference, 2, 1);
  const model::LaneGroup narrow = design.lanes.front();
  design.lanes.push_back({.lane = running_sphere_lane(format("s6e8"), reference),
                          .inputs = model::LaneInputs::rounded,
                          .count = 1});
  model::LaneGroup wide = sphere_design(format("s9e8"), reference, 3, 1).lanes.front();
  wide.multipliers = model::Multipliers::logic;
  design.lanes.push_back(std::move(wide));
  design.lanes.push_back(narrow);
  design.lanes.back().count = 1;
  design.references = {{.multipliers = model::Multipliers::embedded, .count = 1},
                       {.multipliers = model::Multipliers::logic, .count = 2}};
  design.system.target_mhz = 400;  // there the two makes of reference differ in latency
  return design;
}

}  // namespace mixcmp::test
