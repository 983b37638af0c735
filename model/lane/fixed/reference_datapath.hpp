#pragma once

#include <variant>

#include "model/comparison/expression/typed_graph.hpp"
#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::fixed {

/// The datapath of a reference: the comparison in a floating-point format, or a lane in fixed point
/// that decides everything.
using ReferenceDatapath = std::variant<TypedGraph, FixedLane>;

}  // namespace mixcmp::fixed
