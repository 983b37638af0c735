#include <fmt/core.h>

#include <algorithm>

#include "model/judge/proof/cone.hpp"
#include "model/judge/proof/lane_proof.hpp"
#include "model/judge/proof/node_prover.hpp"
#include "model/lane/error/relative_bound.hpp"

namespace mixcmp::proof {
namespace {

/// The form of a bound that is used.
enum class Width {
  exact,     ///< as the analysis has it, in rationals
  provable,  ///< as Gappa proves it: wider, since it needs dyadic numbers
};

class RelativeProof {
public:
  RelativeProof(const error::Lane& lane, const std::vector<NodeClaim>& claims, const Prove& prove,
                Effort effort)
      : lane_(lane),
        graph_(lane.graph),
        claims_(claims),
        effort_(effort),
        nodes_(lane, claims, prove) {}

  std::vector<Finding> run() &&;

private:
  void prove_root(const std::string& name, NodeId root);
  /// Tries one proof for the whole expression; false if its operations must be proven one by one.
  bool prove_whole(const std::string& name, const Cone& cone);
  void check_guard();
  Bits guard_from(Width width) const;
  error::RelativeBound before_rounding(NodeId id, Width width) const;
  error::RelativeBound claimed(NodeId id, const std::optional<error::RelativeBound>& bound,
                               Width width) const {
    return width == Width::exact ? *bound : provable(*bound, depth_of(graph_, id));
  }

  const error::Lane& lane_;
  const TypedGraph& graph_;
  const std::vector<NodeClaim>& claims_;
  Effort effort_;
  NodeProver nodes_;
};

std::vector<Finding> RelativeProof::run() && {
  nodes_.prove_arithmetic();
  prove_root("f", graph_.f());
  prove_root("g", graph_.g());
  check_guard();
  return std::move(nodes_).take();
}

void RelativeProof::prove_root(const std::string& name, NodeId root) {
  if (nodes_.is_done(root)) return;
  const TypedNode& node = graph_.nodes[root];
  // A negation is proven by itself: theorem 4 uses the last rounding of its operand.
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

/// Theorem 4's bound of the real number whose rounding to the lane's format is the node. It is
/// written from the theorem, independently of the analysis.
error::RelativeBound RelativeProof::before_rounding(NodeId id, Width width) const {
  const TypedNode& node = graph_.nodes[id];
  if (claims_[id].unrounded) return claimed(id, claims_[id].unrounded, width);
  switch (node.operation) {
    case Operation::negate:
    case Operation::absolute: return before_rounding(node.operands[0], width);
    case Operation::minimum:
    case Operation::maximum:
      return hull(before_rounding(node.operands[0], width),
                  before_rounding(node.operands[1], width));
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
    case Operation::square_root:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  return claimed(id, claims_[id].relative, width);
}

/// The guard, in ulps, that follows from these bounds.
Bits RelativeProof::guard_from(Width width) const {
  const FloatFormat format = graph_.arithmetic.format;
  const NodeClaim &f = claims_[graph_.f()], &g = claims_[graph_.g()];
  return std::min(
      guard_ulp(claimed(graph_.f(), f.relative, width), claimed(graph_.g(), g.relative, width),
                format.precision()),
      error::guard_ulp_before_rounding(before_rounding(graph_.f(), width),
                                       before_rounding(graph_.g(), width), format.precision()));
}

/// Checks the guard against the proven bounds. If f and g have the same constant factor, its error
/// cancels exactly in exact bounds, but not in widened ones. The guard then follows from the exact
/// bounds only.
void RelativeProof::check_guard() {
  const auto& criterion = std::get<error::UlpDistanceCriterion>(lane_.criterion());
  const NodeClaim &f = claims_[graph_.f()], &g = claims_[graph_.g()];
  const bool beyond = criterion.guard_ulp == low_mask(graph_.arithmetic.format.width());
  const bool signs = !criterion.nonnegative || (f.nonnegative && g.nonnegative);
  const auto follows_from = [&](Width width) {
    return signs && (beyond || criterion.guard_ulp >= guard_from(width));
  };
  Finding finding{fmt::format("a guard of {} ulp from these bounds",
                              static_cast<unsigned long long>(criterion.guard_ulp)),
                  Outcome::not_proven, "by exact arithmetic; theorems 2 to 4 by hand"};
  if (follows_from(Width::provable)) {
    finding.outcome = Outcome::proven;
  } else if (follows_from(Width::exact)) {
    finding.outcome = Outcome::not_expressible;
    finding.detail = "it follows from the exact bounds, which have no binary digits; by hand";
  }
  nodes_.add(std::move(finding));
}

}  // namespace

LaneProof prove_relative(const error::Lane& lane, const std::vector<NodeClaim>& claims,
                         const Prove& prove, Effort effort) {
  LaneProof proof;
  proof.lane = describe_arithmetic(lane.graph.arithmetic);
  proof.kind = "relative";
  proof.findings = RelativeProof(lane, claims, prove, effort).run();
  proof.by_hand = {scaling_by_hand(),
                   {"2 to 4", "theorems 2 to 4: from the bounds of f and g to the guard"}};
  return proof;
}

}  // namespace mixcmp::proof
