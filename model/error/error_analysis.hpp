#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/error/bound_graph_builder.hpp"
#include "model/error/lane.hpp"
#include "model/error/relative_bound.hpp"

namespace mixcmp::error {

/// Bounds the absolute part a of a node's error (MixedBound): |a| <= inflation * B, where B is
/// the value of bound node `bound`. The hardware computes B alone, in few digits; `inflation`,
/// which is 1 or a little more, is covered by the criterion's guard.
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

/// What is known of one node of a lane's graph.
struct NodeBound {
  std::optional<MixedBound> mixed;
  /// The mixed bound's factor where it has no absolute part.
  std::optional<RelativeBound> relative;
  /// The relative bound before the node's own rounding, of a node that rounds: true value = x * t,
  /// where x is the operation's exact result on the computed operands.
  std::optional<RelativeBound> unrounded;
  /// The relative bound that theorem 4 uses, of a node in the lane's format. The node holds some
  /// real number x, rounded: x is its exact result or, of a choice, that of the operand chosen. The
  /// bound says: true value = x * t.
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
