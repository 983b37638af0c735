#pragma once

#include <vector>

#include "model/base/number/bound_format.hpp"
#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::error {

/// Operations of a bound graph. Every result is rounded up: a non-zero result below the smallest
/// number becomes that number, and one beyond the largest becomes infinite. An infinite operand
/// makes the result infinite, even if it is multiplied by 0.
enum class BoundOperation {
  constant,    ///< an exact rational >= 0
  magnitude,   ///< |x| of a lane's node x; infinite for a NaN or an infinity
  binade,      ///< 2^floor(log2 |x|); 0 for x = 0, the smallest number for a subnormal x
  reciprocal,  ///< the power of two 2^-floor(log2 |x|) >= 1 / |x|; infinite for 0 and subnormals
  add,
  multiply,
  maximum,
};
int arity(BoundOperation operation);
std::string_view to_string(BoundOperation operation);

struct BoundNode {
  BoundOperation operation;
  std::array<int, 2> operands = {-1, -1};  ///< indices in the bound graph
  NodeId value = -1;                       ///< the lane's node x; for magnitude, binade, reciprocal
  mpq_class constant;                      ///< exact; rounded up into the format when used

  friend bool operator==(const BoundNode&, const BoundNode&) = default;
};

/// An upper bound as an expression over values that a lane computes. Operands come before their
/// users; the last node is the bound itself.
struct BoundGraph {
  BoundFormat format;
  std::vector<BoundNode> nodes;

  friend bool operator==(const BoundGraph&, const BoundGraph&) = default;
};

}  // namespace mixcmp::error
