#pragma once

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/base/number/float_format.hpp"
#include "model/comparison/expression/graph.hpp"
#include "model/judge/golden/big_float.hpp"
#include "model/judge/golden/separation.hpp"

namespace mixcmp::golden {

/// An interval that contains a real number; a single point if the arithmetic was exact.
struct Interval {
  BigFloat low;
  BigFloat high;
};

/// Whether a graph's real values are known on one comparison.
enum class Knowledge {
  enclosed,   ///< every node has a real value, within its interval
  uncertain,  ///< a divisor may be zero or a radicand negative: more digits may decide
  undefined,  ///< a divisor is zero, a radicand negative, a logarithm's argument not positive, or
              ///< an input not finite
};

/// The largest precision of intervals, in bits, before a value counts as undetermined: four times
/// the number of exponents of the format, for products of sums, and at least 2^14.
mpfr_prec_t last_precision(FloatFormat format);

/// Interval arithmetic over the nodes that f and g need, every end rounded outward. If an interval
/// contains zero and is narrower than the value's separation from zero, the value is proven to be
/// zero. The same operation on operands that are proven to be equal has equal results.
class Enclosure {
public:
  /// Encloses the sides of `graph`'s only part, or of `part`, in intervals of `precision` digits,
  /// at least encoding_precision. `graph` must outlive this object.
  Enclosure(const Graph& graph, mpfr_prec_t precision);
  Enclosure(const Graph& graph, Sides part, mpfr_prec_t precision);

  /// `undefined` if any node is undefined, even if another node is uncertain.
  Knowledge compute(FloatFormat format, std::span<const Bits> inputs);

  /// The intervals of f and g; valid after compute() has returned `enclosed`.
  const Interval& f() const { return values_[part_.f]; }
  const Interval& g() const { return values_[part_.g]; }
  /// Whether f = g is proven; valid after compute() has returned `enclosed`.
  bool are_equal();

private:
  bool operands_are_known(NodeId id) const;
  Knowledge compute_node(NodeId id, FloatFormat format, std::span<const Bits> inputs);
  void decide_zero(NodeId id);
  bool are_equal(NodeId a, NodeId b);
  bool are_proven_equal(NodeId a, NodeId b);
  bool apply_the_same(NodeId a, NodeId b);
  const Separation& separation(NodeId id);
  Separation find_separation(NodeId id);

  const Graph& graph_;
  Sides part_;
  std::vector<bool> needed_;
  std::vector<bool> known_;  ///< the node has an interval
  std::vector<Interval> values_;
  /// Computed on demand, which is rare; empty until then.
  std::vector<std::optional<Separation>> separations_;
  std::map<std::pair<NodeId, NodeId>, bool> equal_;  ///< pairs of nodes that were tried
  BigFloat scratch_;
};

}  // namespace mixcmp::golden
