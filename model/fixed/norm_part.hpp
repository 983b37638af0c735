#pragma once

#include <optional>

#include "model/fixed/fixed_lane.hpp"
#include "model/fixed/graph_builder.hpp"

namespace mixcmp::fixed {

/// The part decided by the norm of its errors, if f and g have the form of theorem 4. Elements of
/// norms lose the low bits that the thresholds do not need, and the high bits that differ from the
/// sign only where f and g are far apart.
std::optional<FixedPart> norm_part(FixedGraphBuilder& builder, NodeId f, NodeId g);

}  // namespace mixcmp::fixed
