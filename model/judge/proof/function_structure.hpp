#pragma once

#include <optional>
#include <set>
#include <vector>

#include "model/lane/fixed/fixed_lane.hpp"

/// Which nodes of a lane in fixed point compute its functions.
namespace mixcmp::proof {

/// The nodes that compute one function. Those inside (tables, t, products and sums) stand for no
/// number of the comparison.
struct FunctionNodes {
  NodeId result;
  NodeId argument;
  std::set<NodeId> inside;
};

/// The functions that a lane computes. None if a node inside a polynomial has an operation that
/// polynomials do not have, or is read from outside, or if an encoding is read by others than
/// functions.
std::optional<std::vector<FunctionNodes>> functions_of(const fixed::FixedLane& lane);

/// Whether a node is t, or an argument's code made of low bits.
bool is_place(const fixed::FixedNode& node);
/// Whether a node takes the argument of a polynomial apart.
bool reads_argument(const fixed::FixedNode& node);
/// Whether a node finds the piece of a table of points: a comparison with a start, a sum of such,
/// or t.
bool is_step(const fixed::FixedNode& node);

}  // namespace mixcmp::proof
