#pragma once

#include <vector>

#include "model/proof/cone.hpp"

namespace mixcmp::model::proof {

/// Which nodes of a graph are zero in one case; meaningful for the cone's nodes.
using Zeros = std::vector<bool>;

/// The nodes whose being zero decides which operands of sums and roots are zero. A sum of operands
/// of one sign is zero where both are, a product where a factor is: atoms are what remains.
std::vector<NodeId> zero_atoms(const Cone& cone);

/// What is zero if these nodes are and the other atoms are not; empty where that cannot be, or
/// where a divisor is zero, which is exceptional.
Zeros zeros_from(const Cone& cone, const std::vector<NodeId>& atoms, unsigned long pattern);

}  // namespace mixcmp::model::proof
