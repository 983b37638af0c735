#include <fmt/core.h>

#include <algorithm>

#include "model/error/relative_bound.hpp"
#include "model/proof/cone.hpp"
#include "model/proof/lane_proof.hpp"
#include "model/proof/node_prover.hpp"

namespace mixcmp::model::proof {
namespace {

class RelativeProof {
public:
  RelativeProof(const Lane& lane, const std::vector<NodeClaim>& claims, const Prove& prove,
                Effort effort)
      : lane_(lane),
        graph_(lane.graph),
        claims_(claims),
        effort_(effort),
        nodes_(lane, claims, prove) {}

  std::vector<Finding> run() &&;

private:
  void prove_root(const std::string& name, NodeId root);
  /// Whether nothing remains to be tried.
  bool prove_whole(const std::string& name, const Cone& cone);
  void check_guard();
  RelativeBound before_rounding(NodeId id) const;
  RelativeBound proven(NodeId id, const std::optional<RelativeBound>& bound) const {
    return provable(*bound, depth_of(graph_, id));
  }

  const Lane& lane_;
  const TypedGraph& graph_;
  const std::vector<NodeClaim>& claims_;
  Effort effort_;
  NodeProver nodes_;
};

std::vector<Finding> RelativeProof::run() && {
  nodes_.prove_arithmetic();
  prove_root("f", graph_.f);
  prove_root("g", graph_.g);
  check_guard();
  return std::move(nodes_).take();
}

void RelativeProof::prove_root(const std::string& name, NodeId root) {
  if (nodes_.is_done(root)) return;
  const TypedNode& node = graph_.nodes[root];
  // A negation is proven apart: theorem 4 looks through it, at its operand's last rounding.
  if (arity(node.operation) == 0 || node.operation == Operation::negate ||
      is_inexpressible(graph_, claims_, root)) {
    nodes_.prove_node(root);
    for (int k = 0; k < arity(node.operation); ++k) {
      prove_root(nodes_.text(node.operands[k]), node.operands[k]);
    }
    return;
  }
  const Cone cone = whole_cone(graph_, claims_, lane_.checks, root);
  const bool whole = effort_ == Effort::whole && prove_whole(name, cone);
  if (whole) nodes_.mark_done(root);
  for (const NodeId id : nodes_of(cone)) {
    if (cone.is_leaf[id]) {
      prove_root(nodes_.text(id), id);
    } else if (!whole) {
      nodes_.prove_node(id);
    }
  }
}

bool RelativeProof::prove_whole(const std::string& name, const Cone& cone) {
  const std::string what = name + ", the whole expression";
  const auto cases = cases_of(cone);
  if (!cases) {
    nodes_.add({what,
                Outcome::not_expressible,
                fmt::format("more than {} terms may be zero", max_zero_nodes),
                {},
                true});
    return false;
  }
  Finding finding = nodes_.run_scripts(fmt::format("{}, {} case{}", what, cases->size(),
                                                   cases->size() == 1 ? "" : "s of zero terms"),
                                       *cases);
  const bool settled = finding.outcome == Outcome::proven || finding.outcome == Outcome::unchecked;
  finding.optional = !settled;
  nodes_.add(std::move(finding));
  return settled;
}

/// The bound of theorem 4, written from it and not from the analysis: of the real number whose
/// rounding the node, of the lane's format, holds.
RelativeBound RelativeProof::before_rounding(NodeId id) const {
  const TypedNode& node = graph_.nodes[id];
  if (claims_[id].unrounded) return proven(id, claims_[id].unrounded);
  switch (node.operation) {
    case Operation::negate:
    case Operation::absolute: return before_rounding(node.operands[0]);
    case Operation::minimum:
    case Operation::maximum:
      return hull(before_rounding(node.operands[0]), before_rounding(node.operands[1]));
    case Operation::constant:
      if (graph_.arithmetic.rounding == Rounding::nearest_even) return {};
      break;
    case Operation::input:
    case Operation::convert:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square:
    case Operation::divide:
    case Operation::square_root: break;
  }
  return proven(id, claims_[id].relative);
}

/// What the lane's guard would be if the bounds were as wide as they are proven.
void RelativeProof::check_guard() {
  const auto& decision = std::get<UlpDistanceDecision>(lane_.decision);
  const FloatFormat format = graph_.arithmetic.format;
  const NodeClaim &f = claims_[graph_.f], &g = claims_[graph_.g];
  const Bits guard = std::min(
      guard_ulp(proven(graph_.f, f.relative), proven(graph_.g, g.relative), format.precision()),
      guard_ulp_before_rounding(before_rounding(graph_.f), before_rounding(graph_.g),
                                format.precision()));
  const bool beyond = decision.guard_ulp == low_mask(format.width());
  const bool follows = decision.guard_ulp >= guard || beyond;
  const bool signs = !decision.nonnegative || (f.nonnegative && g.nonnegative);
  nodes_.add({fmt::format("a guard of {} ulp from these bounds",
                          static_cast<unsigned long long>(decision.guard_ulp)),
              follows && signs ? Outcome::proven : Outcome::not_proven,
              "by exact arithmetic; theorems 2 to 4 by hand"});
}

}  // namespace

LaneProof prove_relative(const Lane& lane, const std::vector<NodeClaim>& claims, const Prove& prove,
                         Effort effort) {
  LaneProof proof;
  proof.lane = describe_arithmetic(lane.graph.arithmetic);
  proof.kind = "relative";
  proof.findings = RelativeProof(lane, claims, prove, effort).run();
  proof.by_hand = {
      "theorems 2 to 4 of docs/error_bounds.md: from the bounds of f and g to the guard",
      "that a non-exceptional result is the rounding with unbounded exponents",
      "that rounding and its error scale with powers of two"};
  return proof;
}

}  // namespace mixcmp::model::proof
