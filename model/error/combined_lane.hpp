#pragma once

#include "model/error/certified_lane.hpp"
#include "model/expression/combined_graph.hpp"

namespace mixcmp::error {

/// One reduced-precision datapath: a lane for each part of the comparison, at least one, all over
/// the same inputs and in the same arithmetic. Each part decides by its own operations and its own
/// checks alone; theorem 11 of docs/error_bounds.md says how their verdicts combine.
struct CombinedLane {
  Combination combination = Combination::all;
  std::vector<Lane> parts;

  CombinedLane(Combination combined, std::vector<Lane> lanes);
  /// Makes the datapath of a comparison of one part.
  CombinedLane(Lane only) : CombinedLane(Combination::all, {std::move(only)}) {}

  const Arithmetic& arithmetic() const { return parts.front().graph.arithmetic; }
  FloatFormat input_format() const { return parts.front().graph.input_format; }
  bool certified() const;
};

/// Calls certified_lane for every part. An error names the part if there are several.
Result<CombinedLane> certified_lanes(const CombinedGraph& graph, const CertifiedOptions& options);

/// Calls profiled_lane for every part, with the same relative errors.
CombinedLane profiled_lanes(const CombinedGraph& graph, const mpq_class& relative_error_f,
                            const mpq_class& relative_error_g);

/// Names the part in an error if there are several.
Error of_part(Error error, std::size_t part, std::size_t parts);

/// The result of one way to certify every part: a lane, or the reason why there is none.
struct CandidateLanes {
  ErrorBoundKind kind;
  int bound_digits;  ///< digits of a running bound; 0 for others
  Result<CombinedLane> lane;
};
/// Tries four ways to certify the lane: the relative bound, the running bound with 4 digits, the
/// running bound with exponents alone (1 digit), and the constant bound, in this order.
std::vector<CandidateLanes> candidate_lanes(const CombinedGraph& graph,
                                            const std::vector<std::optional<Range>>& ranges);

std::string describe_decision(const CombinedLane& lane);

/// A part of a SharedLane; its nodes are numbered in the graph that all parts share.
struct SharedPart {
  Sides sides;
  LaneDecision decision;
  std::vector<std::size_t> checks;  ///< indices of SharedLane::checks
};

/// A lane as hardware builds it: each operation and each check occurs once, whichever parts use it.
struct SharedLane {
  TypedGraph graph;                ///< its f and g are those of the first part
  std::vector<Hazards> hazards;    ///< one per node; empty: nothing is ruled out
  std::vector<RangeCheck> checks;  ///< without duplicates
  std::vector<SharedPart> parts;
  Combination combination = Combination::all;
};
SharedLane share(const CombinedLane& lane);

}  // namespace mixcmp::error
