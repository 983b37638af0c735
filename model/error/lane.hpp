#pragma once

#include <string>
#include <variant>
#include <vector>

#include "model/error/bound_graph.hpp"
#include "model/error/range_check.hpp"
#include "model/expression/typed_graph.hpp"

namespace mixcmp::error {

/// Certified decision on packed encodings, for relative bounds. key(x) is the integer in the
/// magnitude bits of x, negated if x is negative. The lane decides iff nothing is exceptional and
/// |key(f) - key(g)| >= guard_ulp; the verdict is then the order of the keys. guard_ulp = 0 means
/// that f and g are exact: every comparison is then decided, equality included.
struct UlpDistanceDecision {
  Bits guard_ulp;
  /// f and g are never negative: the hardware compares plain magnitudes.
  bool nonnegative;
};

/// A condition that a bound depends on: the bound node `bound` is at most the magnitude of the
/// lane's node `value`, which is in the lane's format.
struct BoundCondition {
  int bound;
  NodeId value;
};

/// Certified decision for absolute bounds, running or constant. The lane decides iff nothing is
/// exceptional, every condition holds and magnitude(difference) > magnitude(bound) + guard_ulp,
/// where magnitudes are integers as encoded in the lane's format; the verdict is the difference's
/// sign. With an infinite bound the lane decides nothing.
struct AbsoluteBoundDecision {
  NodeId difference;  ///< f - g, rounded: a node of the lane's graph
  BoundGraph bound;
  std::vector<BoundCondition> conditions;
  /// Covers the slack factor, 1 or a little more, that the bound leaves out. A bound has few
  /// digits: where the guard fits into the bits below them, the hardware concatenates the two,
  /// {bound, guard}.
  Bits guard_ulp = 0;
};

/// The paper's decision, equations 1-3, in the lane's format: D = f - g, E = |f|*RE_f + |g|*RE_g,
/// greater iff D - E > 0, less iff D + E < 0. The nodes are part of the lane's graph.
struct IntervalDecision {
  NodeId minimum;  ///< D - E
  NodeId maximum;  ///< D + E
  mpq_class relative_error_f;
  mpq_class relative_error_g;
};

/// Special cases of one operation, each true unless the range checks or the expression itself rule
/// it out. A case that is ruled out has no hardware (docs/rtl.md says what each promises).
struct Hazards {
  bool special_operand = true;  ///< a NaN or an infinity among the operands
  bool overflow = true;         ///< or a division by zero
  bool underflow = true;        ///< a subnormal result, exact or not, or a subnormal operand
  bool cancellation = true;     ///< of an add or a subtract: the addends may have unlike signs

  friend bool operator==(const Hazards&, const Hazards&) = default;
};

using LaneDecision = std::variant<UlpDistanceDecision, AbsoluteBoundDecision, IntervalDecision>;

/// A reduced-precision datapath for one f and one g: what it computes and when it may decide. A
/// comparison of several parts has a CombinedLane.
struct Lane {
  TypedGraph graph;
  LaneDecision decision;
  /// An operand that fails its check leaves the lane undecided.
  std::vector<RangeCheck> checks = {};
  /// One per node; empty: nothing is ruled out.
  std::vector<Hazards> hazards = {};

  bool certified() const { return !std::holds_alternative<IntervalDecision>(decision); }
};

/// When the lane decides, for a report: "certified: where f and g are 7 ulp apart or more".
std::string describe_decision(const Lane& lane);

}  // namespace mixcmp::error
