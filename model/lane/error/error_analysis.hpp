#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/lane/error/bound_graph_builder.hpp"
#include "model/lane/error/lane.hpp"
#include "model/lane/error/relative_bound.hpp"

namespace mixcmp::error {

/// Bounds the absolute part a of a node's error (MixedBound): |a| <= inflation * B, where B is the
/// value of bound node `bound`. The hardware computes only B, in few digits. The criterion's guard
/// covers `inflation`, which is 1 or a little more.
struct AbsoluteError {
  BoundId bound = no_bound_node;  ///< none: a = 0
  mpq_class inflation = 1;
};

/// States that true value = computed value * t + a with t within `factor` and a within `absolute`,
/// if no operation was exceptional and every condition holds (docs/error_bounds.md, theorem 7).
struct MixedBound {
  RelativeBound factor;
  AbsoluteError absolute;

  bool is_relative() const { return absolute.bound == no_bound_node; }
};

/// The bounds and the sign of one node of a lane's graph.
struct NodeBound {
  std::optional<MixedBound> mixed;
  /// The mixed bound's factor if the mixed bound has no absolute part.
  std::optional<RelativeBound> relative;
  /// For a node that rounds: the relative bound before its own rounding. True value = x * t, where
  /// x is the operation's exact result on the computed operands.
  std::optional<RelativeBound> unrounded;
  /// For a node in the lane's format: the relative bound that theorem 4 uses. The node holds a real
  /// number x, rounded. x is its exact result or, for a choice, the exact result of the chosen
  /// operand. The bound says: true value = x * t.
  std::optional<RelativeBound> before_rounding;
  bool nonnegative = false;
  bool nonpositive = false;
  std::string reason;  ///< why there is no relative bound, in words for the user
};

struct ErrorAnalysis {
  std::vector<NodeBound> nodes;
  std::vector<BoundNode> bounds;           ///< nodes of all absolute parts, not yet in a format
  std::vector<BoundCondition> conditions;  ///< on nodes of `bounds`
  std::vector<int> nonnegative_inputs;     ///< inputs that the proof assumes to be nonnegative
};

/// Bounds the error of every node; docs/error_bounds.md proves each rule. `input_nonnegative[i]`:
/// the scene's range of input i excludes negative values. If the proof uses that, input i is in
/// ErrorAnalysis::nonnegative_inputs, and the lane must check its sign bit.
ErrorAnalysis analyse_errors(const TypedGraph& graph, const std::vector<bool>& input_nonnegative);

}  // namespace mixcmp::error
