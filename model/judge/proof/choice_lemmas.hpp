#pragma once

#include <string>
#include <vector>

#include "model/judge/proof/claims.hpp"

namespace mixcmp::proof {

/// Scripts that prove the claim of a minimum, a maximum or an absolute value, for which Gappa has
/// no operation. Let a and b be the computed operands of a minimum or maximum, a s and b t the true
/// ones, and q = b / a. If the computed choice is a but the true one is b t, either q >= 1 and q t
/// <= s, or 0 <= q <= 1 and q t >= s (docs/error_bounds.md, theorem 5). The scripts show that both
/// q t and s are within the node's bound. The scripts of an absolute value use that its operand and
/// the operand's true value have the same sign.
std::vector<std::string> choice_scripts(const TypedGraph& graph,
                                        const std::vector<NodeClaim>& claims, NodeId id);

/// Whether the signs claimed of a minimum, a maximum or an absolute value follow from those of its
/// operands.
bool signs_follow(const TypedGraph& graph, const std::vector<NodeClaim>& claims, NodeId id);

}  // namespace mixcmp::proof
