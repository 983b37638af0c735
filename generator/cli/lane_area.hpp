#pragma once

#include "generator/emit/system.hpp"

namespace mixcmp::cli {

/// What Yosys maps a module to, before placement: an estimate of area, no clock.
struct Area {
  int luts = 0;  ///< look-up tables, those that serve as shift registers included
  int registers = 0;
  int dsps = 0;
};

/// The area of one lane alone (no streams around it) on the device's family. An error where Yosys
/// is not there or fails.
model::Result<Area> lane_area(const model::Design& design);

}  // namespace mixcmp::cli
