#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "model/error/lane.hpp"

namespace mixcmp::model {

/// What bounds the error of f - g; in the order in which they are tried.
enum class ErrorBoundKind {
  relative,  ///< of f and of g: a distance in ulps, one integer subtraction
  running,   ///< absolute, computed beside the values in a few digits rounded up
  constant,  ///< absolute, from the inputs' ranges
};
std::string_view to_string(ErrorBoundKind kind);

/// Whether what the ranges rule out of a lane's operations is left out of them.
enum class HazardRemoval {
  remove,
  keep,  ///< ranges serve the bound alone
};

struct CertifiedOptions {
  std::optional<ErrorBoundKind> kind = {};  ///< none: the first that exists
  /// Digits of a running bound, 1..8, at most the lane's; 1: exponents alone.
  int bound_digits = 4;
  /// What the scene declares, one per input (empty: nothing); the lane checks what a proof or a
  /// removal uses.
  std::vector<std::optional<Range>> ranges = {};
  HazardRemoval hazards = HazardRemoval::remove;
};

/// The lane with its certified decision, checks and hazards, or an error that says which operation
/// has no bound of the kind, why, and what the user can do. Proofs: docs/error_bounds.md.
Result<Lane> certified_lane(TypedGraph graph, const CertifiedOptions& options);

}  // namespace mixcmp::model
