#pragma once

#include "model/common/result.hpp"
#include "model/design/reference_structure.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::design {

/// Cycles that a request of so many beats takes to arrive at a reference: its lane sends a beat in
/// two cycles, and no other request passes meanwhile.
int arrival_cycles(int request_beats);

/// Cycles from one recomputation to the next at a reference of this initiation interval that serves
/// one lane, which is what a plan knows; performance::service_cycles knows how many share it.
int planned_service_cycles(int initiation_interval, int request_beats);

/// The beats in which operands leave a lane for references of this initiation interval, none of
/// which is below it. "auto": as many as cost no time, at most 8, of 16 bits or more each, where
/// the operands are in block memory, which reads beats without a multiplexer; else one.
int request_beats(const scene::SystemSpec& system, int operand_bits, int initiation_interval);

/// Refuses beats where nothing is carried, and more than a folded reference has the time for.
Result<Done> check_request_beats(const scene::SystemSpec& system, int initiation_interval);

}  // namespace mixcmp::design
