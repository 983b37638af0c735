#pragma once

#include <optional>
#include <vector>

#include "model/base/number/bound.hpp"
#include "model/lane/error/lane.hpp"

namespace mixcmp::error {

/// Whether a lane's operations omit the hardware for hazards that the ranges rule out.
enum class HazardRemoval {
  remove,
  keep,  ///< ranges are used only for the bound
};

struct CertifiedOptions {
  std::optional<BoundKind> kind = {};  ///< none: relative if it exists, else running
  /// Digits of a running bound, 1..8, at most the lane's; 1: only exponents.
  int bound_digits = 4;
  /// The ranges that the scene declares, one per input; empty if it declares none. The lane checks
  /// those that a proof or the removal of a hazard relies on.
  std::vector<std::optional<Range>> ranges = {};
  HazardRemoval hazards = HazardRemoval::remove;
};

/// Makes a lane with checks, hazards and a certified criterion for each part. An error names the
/// operation that has no bound of the kind, the reason and the remedy; with several parts it also
/// names the part. Proofs: docs/error_bounds.md.
Result<Lane> certified_lane(const TypedGraph& graph, const CertifiedOptions& options);

/// The result of one way to certify a lane: the lane, or the reason why there is none.
struct CandidateLane {
  Bound bound;
  Result<Lane> lane;
};
/// Tries four ways to certify the lane, in this order: the relative bound, the running bound with 4
/// digits, the running bound with 1 digit (only exponents), and the constant bound.
std::vector<CandidateLane> candidate_lanes(const TypedGraph& graph,
                                           const std::vector<std::optional<Range>>& ranges);

}  // namespace mixcmp::error
