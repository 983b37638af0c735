#pragma once

#include <string>
#include <variant>
#include <vector>

#include "model/error/bound_graph.hpp"
#include "model/error/range_check.hpp"
#include "model/expression/typed_graph.hpp"

namespace mixcmp::model {

/// Certified decision on packed encodings, for relative bounds. With key(x) = +-magnitude bits of x
/// by its sign, the lane is decided iff nothing is exceptional and |key(f) - key(g)| >= guard_ulp;
/// the verdict is then the order of the keys. guard_ulp = 0 means f and g are exact: all is
/// decided, equality too.
struct UlpDistanceDecision {
  Bits guard_ulp;
  /// f and g are never negative: the hardware compares plain magnitudes.
  bool nonnegative;
};

/// A condition under which alone a bound holds: the bound node `bound` is at most the magnitude of
/// the lane's node `value`, which is in the lane's format.
struct BoundCondition {
  int bound;
  NodeId value;
};

/// Certified decision for absolute bounds, running or constant: decided iff nothing is exceptional,
/// every condition holds and magnitude(difference) > magnitude(bound) + guard_ulp, magnitudes as
/// encoded in the lane's format; the verdict is the difference's sign. An infinite bound decides
/// nothing.
struct AbsoluteBoundDecision {
  NodeId difference;  ///< f - g, rounded: a node of the lane's graph
  BoundGraph bound;
  std::vector<BoundCondition> conditions;
  /// Covers factors near 1 that the bound leaves out. A bound has few digits, so the guard stands
  /// in the places below them: {bound, guard} in hardware, where it fits.
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

/// What neither the range checks nor the expression itself can rule out of one operation; what they
/// rule out is not built (docs/rtl.md says what each promises to the hardware).
struct Hazards {
  bool special_operand = true;  ///< a NaN or an infinity among the operands
  bool overflow = true;         ///< or a division by zero
  bool underflow = true;        ///< a subnormal result, exact or not, or a subnormal operand
  bool cancellation = true;     ///< of an add or a subtract: what is added may have unlike signs

  friend bool operator==(const Hazards&, const Hazards&) = default;
};

using LaneDecision = std::variant<UlpDistanceDecision, AbsoluteBoundDecision, IntervalDecision>;

/// A reduced-precision datapath for one f and one g (of several parts: CombinedLane): what it
/// computes and when it dares to decide.
struct Lane {
  TypedGraph graph;
  LaneDecision decision;
  /// An operand that fails its check leaves the lane undecided.
  std::vector<RangeCheck> checks = {};
  /// One a node; empty: nothing is ruled out.
  std::vector<Hazards> hazards = {};

  bool certified() const { return !std::holds_alternative<IntervalDecision>(decision); }
};

/// When the lane decides, for a report: "certified: where f and g are 7 ulp apart or more".
std::string describe_decision(const Lane& lane);

}  // namespace mixcmp::model
