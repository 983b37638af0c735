#pragma once

#include <vector>

#include "generator/hardware/datapath/scheduler.hpp"
#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::datapath {

/// Places the nodes of a reference onto as few shared units as a comparison every
/// `initiation_interval` (2 or more) cycles allows, by list scheduling, then moves them so that
/// fewer values wait in registers (fold_plan.hpp). Additions and subtractions share adders. Squares
/// share squarers, which take several cycles for a square if that is smaller. A multiplier with
/// free cycles takes squares if that saves a squarer. Sets the steps, shared_units and
/// initiation_interval of the schedule.
void place_folded(const TypedGraph& reference, scene::Multipliers multipliers,
                  int initiation_interval, Scheduler& scheduler);

/// The phase in which the last operand of a comparison is read, also by the comparisons of parts.
/// An operand is read directly in the first interval, and held from the last phase on if it is
/// needed later.
int last_operand_phase(const TypedGraph& reference, const Schedule& schedule);

}  // namespace mixcmp::datapath
