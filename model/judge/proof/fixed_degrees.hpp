#pragma once

#include <vector>

#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::proof {

/// The numbers that a lane divides by a power of two before it decides: the operands in block
/// floating point, affine nodes with guard digits.
enum class Scaled { operands, cuts };

/// Whether all numbers that a lane adds, subtracts or compares grow alike with the scaled numbers,
/// so that every part's difference has a degree (theorems 6 and 7 of docs/fixed_point.md). Nodes
/// before all cuts are left out if cuts are scaled. A node that reads one of them beside a node
/// behind a cut has no degree.
bool is_homogeneous(const std::vector<fixed::FixedNode>& nodes, Scaled scaled);

}  // namespace mixcmp::proof
