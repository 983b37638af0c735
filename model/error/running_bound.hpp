#pragma once

#include <optional>

#include "model/error/lane.hpp"
#include "model/error/relative_bound.hpp"

namespace mixcmp::model {

/// true value = computed value * t + a, with low <= t <= high and |a| <= the bound node `absolute`
/// of the analysis (-1: a = 0), wherever nothing was exceptional and every condition holds.
/// docs/error_bounds.md, theorem 7.
struct MixedBound {
  RelativeBound factor;
  int absolute = -1;
};

/// A mixed bound of every node of a lane's graph, absolute parts as one shared bound graph with exact
/// constants, its format still open.
struct MixedAnalysis {
  std::vector<std::optional<MixedBound>> nodes;
  std::vector<BoundNode> bounds;
  std::vector<BoundCondition> conditions;
  std::vector<RangeCheck> checks;       ///< signs that proofs use
  std::vector<std::string> reasons;     ///< one a node; why there is no bound, in words for the user
};
MixedAnalysis analyse_mixed(const TypedGraph& graph, const std::vector<bool>& input_nonnegative);

}  // namespace mixcmp::model
