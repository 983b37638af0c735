#pragma once

#include <optional>

#include "model/error/lane.hpp"

namespace mixcmp::model {

/// true value = computed value * t with low <= t <= high, low > 0, wherever nothing on the way was
/// exceptional. Exact rationals: the analysis itself rounds nowhere except in square roots,
/// outward.
struct RelativeBound {
  mpq_class low = 1;
  mpq_class high = 1;
};

/// What is known of one node of a lane's graph.
struct NodeBound {
  /// None after a cancelling difference of inexact operands.
  std::optional<RelativeBound> relative;
  /// Where the node rounds: true value = (the operation's exact result, before its own rounding) *
  /// t.
  std::optional<RelativeBound> unrounded;
  bool nonnegative = false;
  bool nonpositive = false;
  std::string reason;  ///< why there is no bound, in words for the user
};

/// docs/error_bounds.md proves each rule. `input_nonnegative[i]`: the scene's range of input i
/// excludes negative values (the proof may use it; the lane then checks the sign bit).
struct RelativeAnalysis {
  std::vector<NodeBound> nodes;
  std::vector<int> nonnegative_inputs;  ///< those the proof really used
};
RelativeAnalysis analyse_relative(const TypedGraph& graph,
                                  const std::vector<bool>& input_nonnegative);

/// The lane with its certified decision, or an error that says which operation has no bound and
/// what the user can do.
Result<Lane> relative_lane(TypedGraph graph, const std::vector<bool>& input_nonnegative);

/// Smallest distance in ulps that decides, from the bounds of f and g in precision P
/// (docs/error_bounds.md, theorem 3).
Bits guard_ulp(const RelativeBound& f, const RelativeBound& g, int precision);

/// The same where f and g are both rounded last, from the bounds before that: rounding keeps the
/// order, so that the last one costs both together a single step (theorem 4).
Bits guard_ulp_before_rounding(const RelativeBound& f, const RelativeBound& g, int precision);

}  // namespace mixcmp::model
