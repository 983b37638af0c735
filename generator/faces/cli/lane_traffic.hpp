#pragma once

#include "generator/faces/cli/options.hpp"
#include "generator/present/report/report_sections.hpp"

namespace mixcmp::cli {

/// Simulates one lane of the design's first kind with one reference on a few of the scene's
/// comparisons, with Icarus or, where there is none, with Verilator. Returns the comparisons that
/// went through the lane. One of them, where one is found, is left to the reference. An error means
/// that no simulator is there, that one failed, or that a result differs from the model's.
Result<report::LaneTraffic> lane_traffic(const design::Design& design,
                                         const data::Comparisons& data);

}  // namespace mixcmp::cli
