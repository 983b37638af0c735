#pragma once

#include <optional>
#include <vector>

#include "model/error/lane.hpp"
#include "model/number/bound.hpp"

namespace mixcmp::error {

/// Whether a lane's operations omit the hardware for hazards that the ranges rule out.
enum class HazardRemoval {
  remove,
  keep,  ///< ranges are used for the bound alone
};

struct CertifiedOptions {
  std::optional<BoundKind> kind = {};  ///< none: relative if it exists, else running
  /// Digits of a running bound, 1..8, at most the lane's; 1: exponents alone.
  int bound_digits = 4;
  /// The ranges that the scene declares, one per input; empty if it declares none. The lane checks
  /// those that a proof or the removal of a hazard relies on.
  std::vector<std::optional<Range>> ranges = {};
  HazardRemoval hazards = HazardRemoval::remove;
};

/// Makes a lane with a certified criterion for each part, checks and hazards. An error says which
/// operation has no bound of the kind, why, and what the user can do; it names the part if there
/// are several. Proofs: docs/error_bounds.md.
Result<Lane> certified_lane(const TypedGraph& graph, const CertifiedOptions& options);

/// The result of one way to certify a lane: the lane, or the reason why there is none.
struct CandidateLane {
  Bound bound;
  Result<Lane> lane;
};
/// Tries four ways to certify the lane: the relative bound, the running bound with 4 digits, the
/// running bound with exponents alone (1 digit), and the constant bound, in this order.
std::vector<CandidateLane> candidate_lanes(const TypedGraph& graph,
                                           const std::vector<std::optional<Range>>& ranges);

}  // namespace mixcmp::error
