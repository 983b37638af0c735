#pragma once

#include "generator/cli/options.hpp"
#include "generator/report/report_sections.hpp"

namespace mixcmp::cli {

/// Simulates one lane of the design's first kind with one reference on a few of the scene's
/// comparisons, with Icarus or, where there is none, with Verilator, and returns what went through
/// the lane: among them, where one is found, a comparison that it leaves to the reference. An error
/// means that no simulator is there, that one failed, or that a result differs from the model's.
Result<report::LaneTraffic> lane_traffic(const design::Design& design,
                                         const data::Comparisons& data);

}  // namespace mixcmp::cli
