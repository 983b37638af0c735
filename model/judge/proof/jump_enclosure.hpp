#pragma once

#include "model/judge/proof/function_enclosure.hpp"

/// sign and mod in fixed point, derived again from a lane's nodes by theorem 11 of
/// docs/fixed_point.md.
namespace mixcmp::proof {

/// Whether a node's result is a remainder.
bool is_remainder(const fixed::FixedNode& node);

/// The nodes that compute a remainder; none if they are others than X - k M, where k is a constant
/// or X times a constant, and another one, without the fraction.
std::optional<FunctionNodes> nodes_of_remainder(const std::vector<fixed::FixedNode>& nodes,
                                                NodeId result);

/// The nodes are as the lane states them, except those of the argument. None if the lane's quotient
/// is not that of every argument, or the sign of a rounded argument is not known.
std::optional<FunctionEnclosure> enclose_jump(const std::vector<fixed::FixedNode>& nodes,
                                              const FunctionNodes& function);

}  // namespace mixcmp::proof
