#pragma once

#include "tests/support/sphere.hpp"

namespace mixcmp::test {

/// A sphere lane of few digits on rounded inputs, with a running bound.
inline error::Lane running_sphere_lane(FloatFormat lane, FloatFormat reference) {
  const Arithmetic reduced = {lane, Rounding::nearest_even, Subnormals::flush};
  return error::certified_lane(lane_graph(sphere_graph(), reference, reduced, LaneInputs::rounded),
                               {.kind = BoundKind::running,
                                .bound_digits = 4,
                                .ranges = std::vector<std::optional<Range>>(8)})
      .value();
}

/// Seven lanes: two precisions, exact and rounded inputs, multipliers of either make, and a group
/// that is the first one again; three references of two makes.
inline design::Design mixed_sphere_design() {
  const FloatFormat reference = format("s24e8");
  design::Design design = sphere_design(format("s6e8"), reference, 2, 1);
  const design::LaneGroup narrow = design.lanes.front();
  design.lanes.push_back({.lane = running_sphere_lane(format("s6e8"), reference),
                          .inputs = LaneInputs::rounded,
                          .count = 1});
  design::LaneGroup wide = sphere_design(format("s9e8"), reference, 3, 1).lanes.front();
  wide.multipliers = scene::Multipliers::logic;
  design.lanes.push_back(std::move(wide));
  design.lanes.push_back(narrow);
  design.lanes.back().count = 1;
  design.references = {{.structure = {}, .count = 1},
                       {.structure = {.multipliers = scene::Multipliers::logic}, .count = 2}};
  design.system.target_mhz = 400;  // there the two makes of reference differ in latency
  return design;
}

}  // namespace mixcmp::test
