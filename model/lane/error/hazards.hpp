#pragma once

#include <optional>
#include <vector>

#include "model/lane/error/lane.hpp"

namespace mixcmp::error {

/// Whether the operation has a hardware unit. All have one except inputs and constants, which are
/// given, and negate and absolute, which are wires.
bool has_unit(Operation operation);

/// A check of sign and magnitude for every input of the graph that has a declared range.
std::vector<RangeCheck> full_range_checks(const TypedGraph& graph,
                                          const std::vector<std::optional<Range>>& ranges);

/// The range that the checks guarantee for each input; none if magnitudes are not checked.
std::vector<std::optional<Range>> checked_ranges(const TypedGraph& graph,
                                                 const std::vector<RangeCheck>& checks);

/// The hazards of each node if no range is known. The expression itself may rule out cancellation:
/// sums of squares do not cancel.
std::vector<Hazards> structural_hazards(const TypedGraph& graph);

/// Clears those hazards of a one-part lane that interval and sign analysis rule out under full
/// range checks, and gives the lane these checks. If they rule out no more than structural_hazards,
/// the lane keeps its checks and gets the structural hazards.
void remove_hazards(Lane& lane, const std::vector<std::optional<Range>>& ranges);

}  // namespace mixcmp::error
