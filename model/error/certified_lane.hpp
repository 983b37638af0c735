#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "model/error/lane.hpp"

namespace mixcmp::error {

/// How the error of f - g is bounded.
enum class ErrorBoundKind {
  relative,  ///< by the relative errors of f and g: a distance in ulps, one integer subtraction
  running,   ///< by an absolute bound, computed beside the values in a few digits, rounded up
  constant,  ///< by an absolute bound that follows from the inputs' ranges
};
std::string_view to_string(ErrorBoundKind kind);

/// Whether a lane's operations omit the hardware for hazards that the ranges rule out.
enum class HazardRemoval {
  remove,
  keep,  ///< ranges are used for the bound alone
};

struct CertifiedOptions {
  std::optional<ErrorBoundKind> kind = {};  ///< none: relative if it exists, else running
  /// Digits of a running bound, 1..8, at most the lane's; 1: exponents alone.
  int bound_digits = 4;
  /// The ranges that the scene declares, one per input; empty if it declares none. The lane checks
  /// those that a proof or the removal of a hazard relies on.
  std::vector<std::optional<Range>> ranges = {};
  HazardRemoval hazards = HazardRemoval::remove;
};

/// Makes a lane with a certified decision, checks and hazards. An error says which operation has no
/// bound of the kind, why, and what the user can do. Proofs: docs/error_bounds.md.
Result<Lane> certified_lane(TypedGraph graph, const CertifiedOptions& options);

}  // namespace mixcmp::error
