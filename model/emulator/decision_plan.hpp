#pragma once

#include <vector>

#include "model/emulator/plan.hpp"

namespace mixcmp::model::emulator {

/// Completes `plan`, of the lane's graph, by how the lane decides. False where double cannot be
/// trusted with its bound.
bool add_decision(Plan& plan, const Lane& lane);

/// The nodes that an absolute bound reads: not to be subnormal.
std::vector<NodeId> values_in_bound(const Lane& lane);

}  // namespace mixcmp::model::emulator
