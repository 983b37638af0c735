#pragma once

#include <optional>

#include "model/lane/fixed/fixed_lane.hpp"
#include "model/lane/fixed/graph_builder.hpp"

namespace mixcmp::fixed {

/// The part decided by the norm of its errors, if f and g have the form of theorem 4.
///
/// Elements of the norms lose low bits as long as the slopes of the thresholds do not change. (The
/// offset may grow, to a unit above the square of half a slope.) Elements of the sum also lose the
/// high bits that matter only if one square decides the part: theorem 8. If f and g can be read in
/// two ways, the one with the smaller slopes is taken, or else the one with the narrower
/// difference.
std::optional<FixedPart> norm_part(FixedGraphBuilder& builder, NodeId f, NodeId g);

}  // namespace mixcmp::fixed
