#pragma once

#include <vector>

#include "generator/datapath/unit_placer.hpp"
#include "model/expression/typed_graph.hpp"

namespace mixcmp::datapath {

/// Places the nodes of a reference onto as few shared units as a comparison every
/// `initiation_interval` (2 or more) cycles allows, by list scheduling: in each cycle, of the
/// operations whose operands are ready and whose unit is free in this phase, the one from which the
/// longest way is left to go. Additions and subtractions share adders; squares share multipliers
/// where there are multiplications. Sets the steps, shared_units and
/// initiation_interval of `schedule`.
void place_folded(const TypedGraph& reference, scene::Multipliers multipliers,
                  int initiation_interval, UnitPlacer& placer, Schedule& schedule);

/// The phase in which the last operand of a comparison is read, comparisons of parts included: an
/// operand is read directly in the first interval, and held from the last phase on if it is needed
/// later.
int last_operand_phase(const TypedGraph& reference, const Schedule& schedule);

}  // namespace mixcmp::datapath
