#pragma once

#include <vector>

#include "model/judge/proof/cone.hpp"

namespace mixcmp::proof {

/// Which nodes of a graph are zero in one case; meaningful for the cone's nodes.
using Zeros = std::vector<bool>;

/// The nodes whose zeros decide which operands of sums and square roots are zero. A sum of operands
/// of one sign, a conversion, a change of sign, a square and a root are zero only if their operands
/// are, so the atoms of their operands stand for them. All other nodes (leaves, products,
/// quotients, sums that may cancel) are atoms themselves.
std::vector<NodeId> zero_atoms(const Cone& cone);

/// The nodes that are zero if the atoms with a bit set in `pattern` (bit k: atoms[k]) are zero and
/// the other atoms are not. Empty if that is impossible, or if a divisor is zero, which is
/// exceptional.
Zeros zeros_from(const Cone& cone, const std::vector<NodeId>& atoms, unsigned long pattern);

}  // namespace mixcmp::proof
