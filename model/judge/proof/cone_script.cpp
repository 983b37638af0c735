#include <fmt/core.h>

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/judge/proof/cone.hpp"
#include "model/judge/proof/script.hpp"
#include "model/judge/proof/zero_patterns.hpp"

namespace mixcmp::proof {
namespace {

/// Writes the script of one case. Node number k of the cone is named ck as computed and tk in exact
/// arithmetic, or xk if it is an exact leaf. A zero node has no name.
class CaseScript {
public:
  CaseScript(const Cone& cone, const std::vector<NodeId>& atoms, const Zeros& zeros)
      : cone_(cone), graph_(*cone.graph), zeros_(zeros), names_(graph_.nodes.size()) {
    for (const NodeId id : atoms) {
      if (!zeros[id]) must_be_nonzero_.push_back(id);
    }
    for (const NodeId id : nodes_of(cone)) {
      const TypedNode& node = graph_.nodes[id];
      const bool divides = !cone.is_leaf[id] && node.operation == Operation::divide;
      if (divides && !must_be_nonzero(node.operands[1])) {
        must_be_nonzero_.push_back(node.operands[1]);
      }
    }
  }

  std::string text() &&;

private:
  struct Names {
    std::string computed;
    std::string truth;
    std::string unrounded;  ///< the exact result on computed operands
  };

  bool must_be_nonzero(NodeId id) const {
    return std::find(must_be_nonzero_.begin(), must_be_nonzero_.end(), id) !=
           must_be_nonzero_.end();
  }
  void add_operators();
  void add_leaf(NodeId id, int number);
  void add_constant(NodeId id, int number);
  void add_operation(NodeId id, int number);
  void add_magnitude(NodeId id);
  void assume_nonzero(NodeId id, const char* shape);
  std::string least_magnitude(NodeId id) const;
  std::string limit(NodeId id) const;
  void add_goals();
  std::string expression(NodeId id, std::string Names::*name) const;
  std::string sum(const TypedNode& node, std::string Names::*name) const;
  const NodeClaim& claim(NodeId id) const { return (*cone_.claims)[id]; }
  error::RelativeBound bound(NodeId id, const error::RelativeBound& exactly) const {
    return provable(exactly, depth_of(graph_, id));
  }
  std::string rounded(const TypedNode& node, const std::string& expression) const {
    return fmt::format("rnd{}({})", node.format.precision(), expression);
  }

  const Cone& cone_;
  const TypedGraph& graph_;
  const Zeros& zeros_;
  std::vector<NodeId> must_be_nonzero_;
  std::vector<Names> names_;
  Script script_;
};

std::string CaseScript::text() && {
  add_operators();
  int number = 0;
  for (const NodeId id : nodes_of(cone_)) {
    ++number;
    if (zeros_[id]) continue;
    const Operation operation = graph_.nodes[id].operation;
    if (operation == Operation::constant) {
      add_constant(id, number);
    } else if (cone_.is_leaf[id] || operation == Operation::input) {
      add_leaf(id, number);
    } else {
      add_operation(id, number);
    }
  }
  for (const NodeId id : must_be_nonzero_) assume_nonzero(id, "|{}|");
  add_goals();
  return script_.text();
}

void CaseScript::add_operators() {
  std::vector<int> precisions;
  for (const NodeId id : nodes_of(cone_)) {
    if (cone_.is_leaf[id]) continue;
    if (own_rounding(graph_, graph_.nodes[id]) != OwnRounding::rounds) continue;
    precisions.push_back(graph_.nodes[id].format.precision());
  }
  std::sort(precisions.begin(), precisions.end());
  precisions.erase(std::unique(precisions.begin(), precisions.end()), precisions.end());
  for (const int precision : precisions) {
    script_.define_operator(fmt::format("rnd{}", precision),
                            rounding_operator(precision, graph_.arithmetic.rounding));
  }
}

void CaseScript::add_leaf(NodeId id, int number) {
  MIXCMP_CHECK(claim(id).relative.has_value());
  if (claim(id).is_exact()) {
    const std::string name = fmt::format("x{}", number);
    names_[id] = {name, name, name};
  } else {
    const std::string name = fmt::format("c{}", number), truth = fmt::format("t{}", number);
    names_[id] = {name, truth, name};
    script_.assume_relative(truth, name, bound(id, *claim(id).relative));
  }
  add_magnitude(id);
}

/// Assumes a leaf's sign and magnitude. An input's sign is assumed only if the lane checks it. Sign
/// and magnitude are one fact: from two facts Gappa would discard the conclusion as too small an
/// improvement.
void CaseScript::add_magnitude(NodeId id) {
  const bool is_input = graph_.nodes[id].operation == Operation::input;
  const bool nonnegative = is_input ? is_checked_nonnegative(*cone_.checks, graph_.nodes[id].input)
                                    : claim(id).nonnegative;
  const bool nonpositive = !is_input && claim(id).nonpositive;
  const bool nonzero = must_be_nonzero(id);
  std::erase(must_be_nonzero_, id);
  const std::string& name = names_[id].computed;
  const std::string least = nonzero ? least_magnitude(id) : "0", most = limit(id);
  if (nonnegative || nonpositive) {
    script_.assume_within(name, nonnegative ? least : "-" + most, nonpositive ? "-" + least : most);
  } else {
    script_.assume_within("|" + name + "|", least, most);
  }
}

void CaseScript::add_constant(NodeId id, int number) {
  const TypedNode& node = graph_.nodes[id];
  const mpq_class value = to_rational(node.format, node.constant);
  const std::string name = fmt::format("c{}", number);
  names_[id] = {name, name, name};
  script_.assume_within(name, dyadic(value), dyadic(value));
  if (value == node.value) return;
  names_[id].truth = fmt::format("t{}", number);
  const mpq_class ratio = node.value / value;
  script_.assume_relative(names_[id].truth, name, bound(id, {ratio, ratio}));
}

void CaseScript::add_operation(NodeId id, int number) {
  const TypedNode& node = graph_.nodes[id];
  if (node.operation == Operation::square_root) assume_nonzero(node.operands[0], "{}");
  const std::string computed = expression(id, &Names::computed);
  const std::string truth = expression(id, &Names::truth);
  Names& names = names_[id];
  names = {fmt::format("c{}", number), fmt::format("t{}", number), fmt::format("y{}", number)};
  script_.define(names.unrounded, computed);
  if (truth == computed) {
    names.truth = names.unrounded;
  } else {
    script_.define(names.truth, truth);
  }
  if (own_rounding(graph_, node) != OwnRounding::rounds) {
    names.computed = names.unrounded;
    return;
  }
  script_.define(names.computed, rounded(node, names.unrounded));
  script_.assume_relative(names.unrounded, names.computed,
                          rounding_interval(node.format.precision(), graph_.arithmetic.rounding));
}

std::string CaseScript::expression(NodeId id, std::string Names::*name) const {
  const TypedNode& node = graph_.nodes[id];
  const auto operand = [&](int k) -> const std::string& { return names_[node.operands[k]].*name; };
  switch (node.operation) {
    case Operation::convert: return operand(0);
    case Operation::negate: return fmt::format("(-{})", operand(0));
    case Operation::absolute: return fmt::format("|{}|", operand(0));
    case Operation::add:
    case Operation::subtract: return sum(node, name);
    case Operation::multiply: return fmt::format("({} * {})", operand(0), operand(1));
    case Operation::square: return fmt::format("({0} * {0})", operand(0));
    case Operation::divide: return fmt::format("({} / {})", operand(0), operand(1));
    case Operation::square_root: return fmt::format("sqrt({})", operand(0));
    case Operation::input:
    case Operation::constant:
    case Operation::minimum:
    case Operation::maximum:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(false);
}

std::string CaseScript::sum(const TypedNode& node, std::string Names::*name) const {
  const bool subtracts = node.operation == Operation::subtract;
  const std::string& a = names_[node.operands[0]].*name;
  const std::string& b = names_[node.operands[1]].*name;
  if (zeros_[node.operands[1]]) return a;
  if (zeros_[node.operands[0]]) return subtracts ? fmt::format("(-{})", b) : b;
  return fmt::format("({} {} {})", a, subtracts ? "-" : "+", b);
}

/// The smallest positive number of the node's format; `limit` is above all its finite numbers.
std::string CaseScript::least_magnitude(NodeId id) const {
  const FloatFormat format = graph_.nodes[id].format;
  return fmt::format("1b-{}", format.fraction_bits() - format.min_exponent());
}

std::string CaseScript::limit(NodeId id) const {
  return fmt::format("1b{}", graph_.nodes[id].format.max_exponent() + 1);
}

/// Assumes that the node, or its magnitude (`shape`), is a positive finite number of its format.
void CaseScript::assume_nonzero(NodeId id, const char* shape) {
  script_.assume_within(fmt::format(fmt::runtime(shape), names_[id].computed), least_magnitude(id),
                        limit(id));
}

void CaseScript::add_goals() {
  const NodeId root = cone_.root;
  const Names& names = names_[root];
  const NodeClaim& claimed = claim(root);
  script_.conclude_relative(names.truth, names.computed, bound(root, *claimed.relative));
  if (claimed.unrounded) {
    script_.conclude_relative(names.truth, names.unrounded, bound(root, *claimed.unrounded));
  }
  if (claimed.nonnegative) script_.conclude(names.unrounded + " >= 0");
  if (claimed.nonpositive) script_.conclude(names.unrounded + " <= 0");
}

std::string zeros_text(const Cone& cone, const std::vector<NodeId>& atoms, const Zeros& zeros) {
  constexpr std::size_t readable_length = 40;
  std::string text;
  for (const NodeId id : atoms) {
    if (!zeros[id]) continue;
    text += (text.empty() ? "" : ", ") +
            to_text(cone.graph->nodes, cone.graph->input_names, id, readable_length);
  }
  return text;
}

}  // namespace

std::optional<std::vector<ConeCase>> cases_of(const Cone& cone) {
  const std::vector<NodeId> atoms = zero_atoms(cone);
  if (atoms.size() > max_zero_nodes) return std::nullopt;
  std::vector<ConeCase> cases;
  for (unsigned long pattern = 0; pattern < 1UL << atoms.size(); ++pattern) {
    const Zeros zeros = zeros_from(cone, atoms, pattern);
    if (zeros.empty() || zeros[cone.root]) continue;
    cases.push_back({zeros_text(cone, atoms, zeros), CaseScript(cone, atoms, zeros).text()});
  }
  return cases;
}

}  // namespace mixcmp::proof
