#pragma once

#include <string>
#include <vector>

#include "model/proof/claims.hpp"

namespace mixcmp::model::proof {

/// The lemmas of what Gappa has no word for. Minimum and maximum: computed operands a and b, the
/// true ones a s and b t. Where the computed choice is a but the true one b t, with q = b / a
/// either q >= 1 and q t <= s, or 0 <= q <= 1 and q t >= s (docs/error_bounds.md, theorem 5); to
/// show is that q t is within the node's bound, and that s is. Absolute: a and its truth have one
/// sign.
std::vector<std::string> choice_scripts(const TypedGraph& graph,
                                        const std::vector<NodeClaim>& claims, NodeId id);

/// Whether the signs claimed of such a node follow from those of its operands.
bool signs_follow(const TypedGraph& graph, const std::vector<NodeClaim>& claims, NodeId id);

}  // namespace mixcmp::model::proof
