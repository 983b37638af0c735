#pragma once

#include "model/error/certified_lane.hpp"
#include "model/expression/combined_graph.hpp"

namespace mixcmp::model {

/// One reduced-precision datapath: a lane for each part of the comparison, at least one, all over
/// the same inputs, in the same arithmetic. A part decides by what it depends on itself: its own
/// operations, its own checks. Together they decide as docs/error_bounds.md, theorem 11, says.
struct CombinedLane {
  Combination combination = Combination::all;
  std::vector<Lane> parts;

  CombinedLane(Combination combined, std::vector<Lane> lanes);
  /// A comparison of one part is that part.
  CombinedLane(Lane only) : CombinedLane(Combination::all, {std::move(only)}) {}

  const Arithmetic& arithmetic() const { return parts.front().graph.arithmetic; }
  FloatFormat input_format() const { return parts.front().graph.input_format; }
  bool certified() const;
};

/// certified_lane of every part. An error names the part, where there are several.
Result<CombinedLane> certified_lanes(const CombinedGraph& graph, const CertifiedOptions& options);

/// profiled_lane of every part, with the same constants.
CombinedLane profiled_lanes(const CombinedGraph& graph, const mpq_class& relative_error_f,
                            const mpq_class& relative_error_g);

/// Names the part in an error, where there are several.
Error of_part(Error error, std::size_t part, std::size_t parts);

/// One way to certify every part, or why it does not exist.
struct CandidateLanes {
  ErrorBoundKind kind;
  int bound_digits;  ///< of a running bound; else 0
  Result<CombinedLane> lane;
};
/// Tries four ways to certify the lane: the relative bound, the running bound with 4 digits, the
/// running bound with exponents alone (1 digit), and the constant bound, in this order.
std::vector<CandidateLanes> candidate_lanes(const CombinedGraph& graph,
                                            const std::vector<std::optional<Range>>& ranges);

std::string describe_decision(const CombinedLane& lane);

/// A part of a lane over nodes that all parts share.
struct SharedPart {
  Sides sides;
  LaneDecision decision;
  std::vector<std::size_t> checks;  ///< indices of SharedLane::checks
};

/// What hardware builds of a lane: each operation and each check once, whichever parts need it.
struct SharedLane {
  TypedGraph graph;                ///< f and g are the first part's
  std::vector<Hazards> hazards;    ///< one a node; empty: nothing is ruled out
  std::vector<RangeCheck> checks;  ///< each once
  std::vector<SharedPart> parts;
  Combination combination = Combination::all;
};
SharedLane share(const CombinedLane& lane);

}  // namespace mixcmp::model
