#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "model/common/check.hpp"
#include "model/error/relative_bound.hpp"
#include "model/expression/text.hpp"
#include "model/golden/arithmetic.hpp"
#include "model/proof/choice_lemmas.hpp"
#include "model/proof/cone.hpp"
#include "model/proof/lane_proof.hpp"
#include "model/proof/script.hpp"

namespace mixcmp::model::proof {
namespace {

/// Beyond this an interval end leaves Gappa's digits.
constexpr long most_doublings = 200;

bool is_moderate(const RelativeBound& bound) {
  const mpq_class most(mpz_class(1) << most_doublings);
  return bound.low >= 1 / most && bound.high <= most;
}

/// The worst of several scripts.
Outcome worst(Outcome a, Outcome b) {
  const auto badness = [](Outcome outcome) {
    switch (outcome) {
      case Outcome::proven: return 0;
      case Outcome::not_expressible: return 1;
      case Outcome::unchecked: return 2;
      case Outcome::out_of_time: return 3;
      case Outcome::not_proven: return 4;
    }
    MIXCMP_CHECK(false);
  };
  return badness(a) >= badness(b) ? a : b;
}

std::vector<ConeCase> without_zeros(const std::vector<std::string>& scripts) {
  std::vector<ConeCase> cases;
  for (const std::string& script : scripts) cases.push_back({"", script});
  return cases;
}

class RelativeProof {
public:
  RelativeProof(const Lane& lane, const std::vector<NodeClaim>& claims, const Prove& prove,
                Effort effort)
      : lane_(lane), graph_(lane.graph), claims_(claims), prove_(prove), effort_(effort) {}

  std::vector<Finding> run() &&;

private:
  void prove_rounding();
  void prove_exactness();
  void prove_root(const std::string& name, NodeId root);
  /// Whether nothing remains to be tried.
  bool prove_whole(const std::string& name, const Cone& cone);
  void prove_node(NodeId id);
  void check_constant(NodeId id);
  void check_exact_input(NodeId id);
  void prove_choice(NodeId id);
  void check_guard();
  Finding run_scripts(std::string what, const std::vector<ConeCase>& cases);
  std::string text(NodeId id) const;
  RelativeBound proven(NodeId id, const std::optional<RelativeBound>& bound) const {
    return provable(*bound, depth_of(graph_, id));
  }

  const Lane& lane_;
  const TypedGraph& graph_;
  const std::vector<NodeClaim>& claims_;
  const Prove& prove_;
  Effort effort_;
  std::set<NodeId> done_;  ///< nodes whose claim is a finding
  std::vector<Finding> findings_;
};

std::vector<Finding> RelativeProof::run() && {
  prove_rounding();
  prove_exactness();
  prove_root("f", graph_.f);
  prove_root("g", graph_.g);
  check_guard();
  return std::move(findings_);
}

void RelativeProof::prove_rounding() {
  std::set<int> precisions;
  for (const TypedNode& node : graph_.nodes) {
    if (own_rounding(graph_, node) == OwnRounding::rounds) {
      precisions.insert(node.format.precision());
    }
  }
  const Rounding rounding = graph_.arithmetic.rounding;
  for (const int precision : precisions) {
    const std::string what =
        fmt::format("one rounding to {} digits, {}, in the binades of 1 and -1", precision,
                    to_string(rounding));
    findings_.push_back(run_scripts(what, without_zeros(rounding_scripts(precision, rounding))));
  }
}

void RelativeProof::prove_exactness() {
  std::set<std::tuple<ExactOperation, int, int>> seen;
  for (const TypedNode& node : graph_.nodes) {
    if (own_rounding(graph_, node) != OwnRounding::exact_by_digits) continue;
    const ExactOperation operation = node.operation == Operation::convert ? ExactOperation::convert
                                     : node.operation == Operation::square
                                         ? ExactOperation::square
                                         : ExactOperation::multiply;
    const int from = node.operand_format.precision(), to = node.format.precision();
    if (!seen.insert({operation, from, to}).second) continue;
    const std::string what =
        fmt::format("{} of {} digits into {} rounds nothing", to_string(operation), from, to);
    const Rounding rounding = graph_.arithmetic.rounding;
    findings_.push_back(run_scripts(what, {{"", exactness_script(operation, from, to, rounding)}}));
  }
}

Finding RelativeProof::run_scripts(std::string what, const std::vector<ConeCase>& cases) {
  Finding finding = {std::move(what), Outcome::proven, ""};
  for (const ConeCase& one : cases) {
    const ScriptResult result = prove_(one.script);
    if (!result.file.empty()) finding.files.push_back(result.file);
    if (result.outcome != Outcome::proven &&
        worst(finding.outcome, result.outcome) != finding.outcome) {
      finding.detail = (one.zeros.empty() ? "" : "where zero: " + one.zeros + "; ") + result.detail;
    }
    finding.outcome = worst(finding.outcome, result.outcome);
  }
  return finding;
}

void RelativeProof::prove_root(const std::string& name, NodeId root) {
  if (done_.contains(root)) return;
  const TypedNode& node = graph_.nodes[root];
  if (arity(node.operation) == 0 || is_inexpressible(graph_, claims_, root)) {
    prove_node(root);
    for (int k = 0; k < arity(node.operation); ++k) {
      prove_root(text(node.operands[k]), node.operands[k]);
    }
    return;
  }
  const Cone cone = whole_cone(graph_, claims_, lane_.checks, root);
  const bool whole = effort_ == Effort::whole && prove_whole(name, cone);
  if (whole) done_.insert(root);
  for (const NodeId id : nodes_of(cone)) {
    if (cone.is_leaf[id]) {
      prove_root(text(id), id);
    } else if (!whole) {
      prove_node(id);
    }
  }
}

bool RelativeProof::prove_whole(const std::string& name, const Cone& cone) {
  const std::string what = name + ", the whole expression";
  const auto cases = cases_of(cone);
  if (!cases) {
    findings_.push_back({what,
                         Outcome::not_expressible,
                         fmt::format("more than {} terms may be zero", max_zero_nodes),
                         {},
                         true});
    return false;
  }
  Finding finding = run_scripts(fmt::format("{}, {} case{}", what, cases->size(),
                                            cases->size() == 1 ? "" : "s of zero terms"),
                                *cases);
  const bool settled = finding.outcome == Outcome::proven || finding.outcome == Outcome::unchecked;
  finding.optional = !settled;
  findings_.push_back(std::move(finding));
  return settled;
}

void RelativeProof::prove_node(NodeId id) {
  if (!done_.insert(id).second) return;
  const TypedNode& node = graph_.nodes[id];
  if (node.operation == Operation::input) return check_exact_input(id);
  if (node.operation == Operation::constant) return check_constant(id);
  const std::string what = fmt::format("{} {}", to_string(node.operation), text(id));
  if (!claims_[id].relative || !is_moderate(*claims_[id].relative)) {
    findings_.push_back({what, Outcome::not_expressible, "so wide a bound takes too many digits"});
    return;
  }
  if (depth_of(graph_, id) > max_provable_depth) {
    findings_.push_back({what, Outcome::not_expressible, "so deep an expression"});
    return;
  }
  if (is_inexpressible(graph_, claims_, id)) return prove_choice(id);
  const auto cases = cases_of(node_cone(graph_, claims_, lane_.checks, id));
  MIXCMP_CHECK(cases.has_value());
  findings_.push_back(run_scripts(what, *cases));
}

void RelativeProof::check_exact_input(NodeId id) {
  const NodeClaim& claim = claims_[id];
  const int input = graph_.nodes[id].input;
  const bool sign =
      !claim.nonpositive && (!claim.nonnegative || is_checked_nonnegative(lane_.checks, input));
  if (claim.is_exact() && sign) return;
  findings_.push_back({"input " + graph_.input_names[input], Outcome::not_proven,
                       "its claim needs a sign that the lane does not check"});
}

void RelativeProof::check_constant(NodeId id) {
  const TypedNode& node = graph_.nodes[id];
  const NodeClaim& claim = claims_[id];
  const mpq_class computed = golden::to_rational(node.format, node.constant);
  const bool within = claim.relative && claim.relative->low * abs(computed) <= abs(node.value) &&
                      abs(node.value) <= claim.relative->high * abs(computed);
  const bool sign =
      (!claim.nonnegative || node.value >= 0) && (!claim.nonpositive || node.value <= 0);
  findings_.push_back({"constant " + text(id),
                       within && sign ? Outcome::proven : Outcome::not_proven,
                       "by exact arithmetic"});
}

void RelativeProof::prove_choice(NodeId id) {
  Finding finding =
      run_scripts(fmt::format("{} {}", to_string(graph_.nodes[id].operation), text(id)),
                  without_zeros(choice_scripts(graph_, claims_, id)));
  if (!signs_follow(graph_, claims_, id)) {
    finding.outcome = Outcome::not_proven;
    finding.detail = "the sign does not follow from its operands'";
  }
  findings_.push_back(std::move(finding));
}

/// What the lane's guard would be if the bounds were as wide as they are proven.
void RelativeProof::check_guard() {
  const auto& decision = std::get<UlpDistanceDecision>(lane_.decision);
  const FloatFormat format = graph_.arithmetic.format;
  const NodeClaim &f = claims_[graph_.f], &g = claims_[graph_.g];
  Bits guard =
      guard_ulp(proven(graph_.f, f.relative), proven(graph_.g, g.relative), format.precision());
  if (f.unrounded && g.unrounded) {
    guard = std::min(guard,
                     guard_ulp_before_rounding(proven(graph_.f, f.unrounded),
                                               proven(graph_.g, g.unrounded), format.precision()));
  }
  const bool beyond = decision.guard_ulp == low_mask(format.width());
  const bool follows = decision.guard_ulp >= guard || beyond;
  const bool signs = !decision.nonnegative || (f.nonnegative && g.nonnegative);
  findings_.push_back({fmt::format("a guard of {} ulp from these bounds",
                                   static_cast<unsigned long long>(decision.guard_ulp)),
                       follows && signs ? Outcome::proven : Outcome::not_proven,
                       "by exact arithmetic; theorems 2 to 4 by hand"});
}

std::string RelativeProof::text(NodeId id) const {
  constexpr std::size_t readable_length = 60;
  return to_text(graph_.nodes, graph_.input_names, id, readable_length);
}

}  // namespace

LaneProof prove_relative(const Lane& lane, const std::vector<NodeClaim>& claims, const Prove& prove,
                         Effort effort) {
  LaneProof proof;
  const Arithmetic& arithmetic = lane.graph.arithmetic;
  proof.lane = fmt::format("{}, {}", arithmetic.format.name(), to_string(arithmetic.rounding));
  proof.kind = "relative";
  proof.findings = RelativeProof(lane, claims, prove, effort).run();
  proof.by_hand = {
      "theorems 2 to 4 of docs/error_bounds.md: from the bounds of f and g to the guard",
      "that a non-exceptional result is the rounding with unbounded exponents",
      "that rounding and its error scale with powers of two"};
  return proof;
}

}  // namespace mixcmp::model::proof
