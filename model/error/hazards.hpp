#pragma once

#include <optional>
#include <vector>

#include "model/error/lane.hpp"

namespace mixcmp::model {

/// Whether the operation has a hardware unit: all have but inputs and constants, which are given,
/// and negate and absolute, which are wires.
bool has_unit(Operation operation);

/// A check of sign and magnitude for every input of the graph that has a declared range.
std::vector<RangeCheck> full_range_checks(const TypedGraph& graph,
                                          const std::vector<std::optional<Range>>& ranges);

/// What the checks imply of each input; none for one that is not checked.
std::vector<std::optional<Range>> checked_ranges(const TypedGraph& graph,
                                                 const std::vector<RangeCheck>& checks);

/// What follows from the expression alone, whatever the operands are: sums of squares do not
/// cancel.
std::vector<Hazards> structural_hazards(const TypedGraph& graph);

/// Marks what interval analysis and signs rule out of each operation, given full range checks;
/// where ranges help, the lane gets those checks.
void remove_hazards(Lane& lane, const std::vector<std::optional<Range>>& ranges);

}  // namespace mixcmp::model
