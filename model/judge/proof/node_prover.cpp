#include "model/judge/proof/node_prover.hpp"

#include <fmt/core.h>

#include <tuple>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/judge/proof/choice_lemmas.hpp"
#include "model/judge/proof/script.hpp"

namespace mixcmp::proof {
namespace {

/// Interval ends beyond 2^200 or 2^-200 would need more digits than Gappa has.
constexpr long most_doublings = 200;

bool is_moderate(const error::RelativeBound& bound) {
  const mpq_class most(mpz_class(1) << most_doublings);
  return bound.low >= 1 / most && bound.high <= most;
}

std::vector<ConeCase> without_zeros(const std::vector<std::string>& scripts) {
  std::vector<ConeCase> cases;
  for (const std::string& script : scripts) cases.push_back({"", script});
  return cases;
}

}  // namespace

std::string describe_arithmetic(const Arithmetic& arithmetic) {
  return fmt::format("{}, {}", arithmetic.format.name(), to_string(arithmetic.rounding));
}

Outcome worse(Outcome a, Outcome b) {
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

void NodeProver::prove_arithmetic() {
  prove_rounding();
  prove_exactness();
}

void NodeProver::prove_rounding() {
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

void NodeProver::prove_exactness() {
  std::set<std::tuple<ExactOperation, int, int>> seen;
  for (const TypedNode& node : graph_.nodes) {
    if (own_rounding(graph_, node) != OwnRounding::exact_by_digits) continue;
    const ExactOperation operation = node.operation == Operation::convert ? ExactOperation::convert
                                     : node.operation == Operation::square
                                         ? ExactOperation::square
                                         : ExactOperation::multiply;
    const int from = digits_of_operands(graph_, node), to = node.format.precision();
    if (!seen.insert({operation, from, to}).second) continue;
    const std::string what =
        fmt::format("{} of {} digits into {} rounds nothing", to_string(operation), from, to);
    const Rounding rounding = graph_.arithmetic.rounding;
    findings_.push_back(run_scripts(what, {{"", exactness_script(operation, from, to, rounding)}}));
  }
}

Finding NodeProver::run_scripts(std::string what, const std::vector<ConeCase>& cases) const {
  Finding finding = {std::move(what), Outcome::proven, ""};
  for (const ConeCase& one : cases) {
    const ScriptResult result = prove_(one.script);
    if (!result.file.empty()) finding.files.push_back(result.file);
    if (result.outcome != Outcome::proven &&
        worse(finding.outcome, result.outcome) != finding.outcome) {
      finding.detail = (one.zeros.empty() ? "" : "where zero: " + one.zeros + "; ") + result.detail;
    }
    finding.outcome = worse(finding.outcome, result.outcome);
  }
  return finding;
}

void NodeProver::prove_node(NodeId id) {
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

void NodeProver::check_exact_input(NodeId id) {
  const NodeClaim& claim = claims_[id];
  const int input = graph_.nodes[id].input;
  const bool sign =
      !claim.nonpositive && (!claim.nonnegative || is_checked_nonnegative(lane_.checks, input));
  if (claim.is_exact() && sign) return;
  findings_.push_back({"input " + graph_.input_names[input], Outcome::not_proven,
                       "its claim needs a sign that the lane does not check"});
}

void NodeProver::check_constant(NodeId id) {
  const TypedNode& node = graph_.nodes[id];
  const NodeClaim& claim = claims_[id];
  const mpq_class computed = to_rational(node.format, node.constant);
  const bool within = claim.relative && claim.relative->low * abs(computed) <= abs(node.value) &&
                      abs(node.value) <= claim.relative->high * abs(computed);
  const bool sign =
      (!claim.nonnegative || node.value >= 0) && (!claim.nonpositive || node.value <= 0);
  findings_.push_back({"constant " + text(id),
                       within && sign ? Outcome::proven : Outcome::not_proven,
                       "by exact arithmetic"});
}

void NodeProver::prove_choice(NodeId id) {
  Finding finding =
      run_scripts(fmt::format("{} {}", to_string(graph_.nodes[id].operation), text(id)),
                  without_zeros(choice_scripts(graph_, claims_, id)));
  if (!signs_follow(graph_, claims_, id)) {
    finding.outcome = Outcome::not_proven;
    finding.detail = "the sign does not follow from its operands'";
  }
  findings_.push_back(std::move(finding));
}

std::string NodeProver::text(NodeId id) const {
  constexpr std::size_t readable_length = 60;
  return to_text(graph_.nodes, graph_.input_names, id, readable_length);
}

}  // namespace mixcmp::proof
