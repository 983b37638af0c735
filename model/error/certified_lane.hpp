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

struct CertifiedOptions {
  std::optional<ErrorBoundKind> kind;  ///< none: the first that exists
  /// Digits of a running bound, 1..8; 1: exponents alone.
  int bound_digits = 4;
  /// What the scene declares, one per input; checked in hardware as far as a proof or a removal
  /// uses it.
  std::vector<std::optional<Range>> ranges;
};

/// The lane with its certified decision, checks and hazards, or an error that says which operation
/// has no bound of the kind, why, and what the user can do. Proofs: docs/error_bounds.md.
Result<Lane> certified_lane(TypedGraph graph, const CertifiedOptions& options);

/// Every kind that exists for the graph, running ones with 4 digits and with exponents alone.
struct CandidateLane {
  ErrorBoundKind kind;
  int bound_digits;   ///< 0 where it does not apply
  Result<Lane> lane;  ///< or why it does not exist
};
std::vector<CandidateLane> candidate_lanes(const TypedGraph& graph,
                                           const std::vector<std::optional<Range>>& ranges);

}  // namespace mixcmp::model
