#pragma once

#include <vector>

#include "model/expression/typed_graph.hpp"
#include "model/number/bound_format.hpp"

namespace mixcmp::model {

/// Every result is rounded up: a non-zero one below the smallest number is that number, one beyond
/// the largest is infinite, and an infinite operand makes the result infinite (0 times it, too).
enum class BoundOperation {
  constant,    ///< an exact rational >= 0
  magnitude,   ///< |x| of a lane's node; of a NaN or an infinity infinite
  binade,      ///< 2^floor(log2 |x|) of a node, 0 of 0; a subnormal x gives the smallest number
  reciprocal,  ///< the power of two 2^-floor(log2 |x|) >= 1 / |x|; of 0 and subnormals infinite
  add,
  multiply,
  maximum,
};
int arity(BoundOperation operation);
std::string_view to_string(BoundOperation operation);

struct BoundNode {
  BoundOperation operation;
  std::array<int, 2> operands = {-1, -1};  ///< indices in the bound graph
  NodeId value = -1;                       ///< magnitude, binade, reciprocal: of this node
  mpq_class constant;                      ///< exactly; rounded up into the format when used
};

/// An upper bound as an expression of what a lane has computed; operands before their users, the
/// bound itself is the last node.
struct BoundGraph {
  BoundFormat format;
  std::vector<BoundNode> nodes;
};

}  // namespace mixcmp::model
