#pragma once

#include <vector>

#include "model/expression/typed_graph.hpp"

namespace mixcmp::model {

/// Upper bounds in hardware: non-negative numbers of `precision` digits (1: powers of two,
/// exponents alone). Packed without a sign: biased exponent, then precision - 1 fraction bits.
/// Exponent field 0 is zero, with fraction 0; all ones is infinite, with fraction 0: no bound at
/// all. No subnormals. The bias is that of a FloatFormat of as many exponent bits, so a bound
/// followed by zeros compares as an integer with a magnitude of that format.
struct BoundFormat {
  int precision;      ///< 1..52, at most the lane's
  int exponent_bits;  ///< the lane's

  int width() const { return exponent_bits + precision - 1; }
  int bias() const { return (1 << (exponent_bits - 1)) - 1; }
  Bits infinity() const { return low_mask(exponent_bits) << (precision - 1); }
  Bits smallest() const { return Bits{1} << (precision - 1); }

  friend bool operator==(const BoundFormat&, const BoundFormat&) = default;
};

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
