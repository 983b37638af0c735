#pragma once

#include <span>
#include <vector>

#include "model/expression/graph.hpp"
#include "model/format/float_format.hpp"
#include "model/golden/big_float.hpp"

namespace mixcmp::model::golden {

/// Contains a real number; of width zero where the arithmetic happened to be exact.
struct Interval {
  BigFloat low;
  BigFloat high;
};

/// What is known of the real values of a graph on one comparison.
enum class Knowledge {
  enclosed,   ///< every node has a real value, within its interval
  uncertain,  ///< a divisor may be zero or a radicand negative: more digits may tell
  undefined,  ///< a divisor is zero, a radicand negative, or an input not finite
};

/// Interval arithmetic over the nodes that f and g need, every end rounded outward.
class Enclosure {
public:
  /// Of the only part. At least encoding_precision digits. Looks at `graph` as long as it lives.
  Enclosure(const Graph& graph, mpfr_prec_t precision);
  Enclosure(const Graph& graph, Sides part, mpfr_prec_t precision);

  Knowledge compute(FloatFormat format, std::span<const Bits> inputs);

  /// After compute() said `enclosed`.
  const Interval& f() const { return values_[part_.f]; }
  const Interval& g() const { return values_[part_.g]; }

private:
  Knowledge compute_node(NodeId id, FloatFormat format, std::span<const Bits> inputs);

  const Graph& graph_;
  Sides part_;
  std::vector<bool> needed_;
  std::vector<Interval> values_;
  BigFloat scratch_;
};

}  // namespace mixcmp::model::golden
