#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "model/base/common/result.hpp"
#include "model/comparison/expression/typed_graph.hpp"
#include "model/lane/error/bound_graph.hpp"
#include "model/lane/error/range_check.hpp"

namespace mixcmp::error {

/// Certified criterion on packed encodings, for relative bounds. key(x) is the integer in the
/// magnitude bits of x, negated if x is negative. The lane decides iff nothing is exceptional and
/// |key(f) - key(g)| >= guard_ulp; the verdict is then the order of the keys. guard_ulp = 0 means
/// that f and g are exact: every comparison is then decided, equality included.
struct UlpDistanceCriterion {
  Bits guard_ulp;
  /// f and g are never negative: the hardware compares plain magnitudes.
  bool nonnegative;

  friend bool operator==(const UlpDistanceCriterion&, const UlpDistanceCriterion&) = default;
};

/// A condition that a bound depends on: the bound node `bound` is at most the magnitude of the
/// lane's node `value`, which is in the lane's format.
struct BoundCondition {
  int bound;
  NodeId value;

  friend bool operator==(const BoundCondition&, const BoundCondition&) = default;
};

/// Certified criterion for absolute bounds, running or constant. The lane decides iff nothing is
/// exceptional, every condition holds and magnitude(difference) > magnitude(bound) + guard_ulp,
/// where magnitudes are integers as encoded in the lane's format; the verdict is the difference's
/// sign. With an infinite bound the lane decides nothing.
struct AbsoluteBoundCriterion {
  NodeId difference;  ///< f - g, rounded: a node of the lane's graph
  BoundGraph bound;
  std::vector<BoundCondition> conditions;
  /// The error is at most inflation * bound (AbsoluteError), and the inflation is 1 or a little
  /// more. The hardware computes only the bound; these ulps cover the inflation. A guard that fits
  /// into the places below the bound's few digits needs no adder: {bound, guard}.
  Bits guard_ulp = 0;

  friend bool operator==(const AbsoluteBoundCriterion&, const AbsoluteBoundCriterion&) = default;
};

/// The paper's criterion, equations 1-3, in the lane's format: D = f - g, E = |f|*RE_f + |g|*RE_g,
/// greater iff D - E > 0, less iff D + E < 0. The nodes are part of the lane's graph.
struct IntervalCriterion {
  NodeId minimum;  ///< D - E
  NodeId maximum;  ///< D + E
  mpq_class relative_error_f;
  mpq_class relative_error_g;

  friend bool operator==(const IntervalCriterion&, const IntervalCriterion&) = default;
};

/// Special cases of one operation, each true unless the range checks or the expression itself rule
/// it out. A case that is ruled out has no hardware. rtl_templates/fp/README.md lists the promise
/// of each flag.
struct Hazards {
  bool special_operand = true;  ///< a NaN or an infinity among the operands
  bool overflow = true;         ///< or a division by zero
  bool underflow = true;        ///< a subnormal result, exact or not, or a subnormal operand
  bool cancellation = true;     ///< the addends of a sum may have unlike signs

  friend bool operator==(const Hazards&, const Hazards&) = default;
};

using Criterion = std::variant<UlpDistanceCriterion, AbsoluteBoundCriterion, IntervalCriterion>;

/// When a lane decides one part of its comparison: only that part's operations and checks matter.
/// Theorem 11 of docs/error_bounds.md says how the verdicts of the parts combine.
struct LanePart {
  Criterion criterion;
  /// Indices in Lane::checks. An operand that fails one of them leaves the part undecided.
  std::vector<std::size_t> checks = {};

  bool certified() const { return !std::holds_alternative<IntervalCriterion>(criterion); }

  friend bool operator==(const LanePart&, const LanePart&) = default;
};

/// A reduced-precision datapath: its operations, and when it may decide.
struct Lane {
  TypedGraph graph;
  std::vector<LanePart> parts;          ///< one for each of graph.parts
  std::vector<RangeCheck> checks = {};  ///< without duplicates
  /// One per node; empty: nothing is ruled out. Parts that share a node share its hazards: a hazard
  /// is ruled out only if every such part rules it out.
  std::vector<Hazards> hazards = {};

  /// The criterion of a comparison that has one part.
  const Criterion& criterion() const;
  Criterion& criterion();
  bool certified() const;

  friend bool operator==(const Lane&, const Lane&) = default;
};

/// Makes a lane of one part, which applies all of `checks`.
Lane one_part_lane(TypedGraph graph, Criterion criterion, std::vector<RangeCheck> checks = {});

/// Makes a lane of one part, given the part as a graph of its own.
using MakePart = std::function<Result<Lane>(const TypedGraph& part)>;

/// Makes the lane of all parts of `graph`, each by `make_part`. If there are several, an error
/// names the part.
Result<Lane> lane_of_parts(const TypedGraph& graph, const MakePart& make_part);

/// Adds the part's name to an error if there are several parts.
Error of_part(Error error, std::size_t part, std::size_t parts);

/// One part of a lane as a lane of its own, with the nodes and the checks that it needs.
Lane part_of(const Lane& lane, std::size_t part);

/// Which nodes a part computes: those of its sides and of its criterion.
std::vector<bool> nodes_of_part(const Lane& lane, std::size_t part);

/// When the lane decides, for a report: "certified: where f and g are 7 ulp apart or more".
std::string describe_criterion(const Lane& lane);

}  // namespace mixcmp::error
