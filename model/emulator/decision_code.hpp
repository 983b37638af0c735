#pragma once

#include <vector>

#include "model/emulator/code.hpp"

namespace mixcmp::model::emulator {

/// Completes `code`, of the lane's graph, by how the lane decides. False where double cannot be
/// trusted with its bound.
bool add_decision(Code& code, const Lane& lane);

/// The nodes whose encodings the decision or its bound reads: those of subnormal numbers, which
/// constants may be, do not follow from doubles.
std::vector<NodeId> values_as_encodings(const Lane& lane);

}  // namespace mixcmp::model::emulator
