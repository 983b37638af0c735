#pragma once

#include "model/base/common/result.hpp"
#include "model/design/reference_structure.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::design {

/// Cycles that a request of `request_beats` beats takes to arrive at a reference: its lane sends a
/// beat in two cycles, and no other request passes meanwhile.
int arrival_cycles(int request_beats);

/// Cycles from one recomputation to the next at a reference of this initiation interval that serves
/// one lane. A plan knows no more than that; performance::service_cycles knows how many lanes share
/// the reference.
int planned_service_cycles(int initiation_interval, int request_beats);

/// The beats in which operands leave a lane for references with at least this initiation interval.
/// "auto" is one beat, or more if the operands are in block memory, which reads beats without a
/// multiplexer: the most that cost no time, at most 8, of at least 16 bits each.
int request_beats(const scene::SystemSpec& system, int operand_bits, int initiation_interval);

/// Refuses beats if nothing is carried, and more beats than a folded reference has time for.
Result<Done> check_request_beats(const scene::SystemSpec& system, int initiation_interval);

}  // namespace mixcmp::design
