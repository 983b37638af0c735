#include "model/lane/fixed/formulas.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "model/comparison/expression/formula.hpp"
#include "model/comparison/expression/graph_copy.hpp"
#include "model/lane/function/value_range.hpp"

namespace mixcmp::fixed {
namespace {

using function::PossibleRange;

/// A range with a margin for the rounding of computed numbers: a share of the range on each side,
/// but of an end near 0 no more than that share of it.
PossibleRange with_margin(const PossibleRange& range) {
  constexpr int share = 256;
  if (!range) return range;
  const mpq_class margin = (range->high - range->low) / share;
  Range wider = {range->low - margin, range->high + margin};
  if (range->low > 0) wider.low = std::max<mpq_class>(wider.low, range->low * (share - 1) / share);
  if (range->high < 0) {
    wider.high = std::min<mpq_class>(wider.high, range->high * (share - 1) / share);
  }
  return wider;
}

/// A function with all derivatives where it has a value.
bool is_differentiable(const Function& function) {
  return !has_jumps(function) && function.kind() != Function::table;
}

/// Whether one table is cheaper than the operations. A function of an affine map is one table
/// anyway, as is 1 / x, and a root of an affine map has hardware of its own.
bool is_worth_a_table(const Formula& formula) {
  std::vector<bool> varies;  // [node]
  int functions = 0, roots = 0, curves = 0;
  bool ends_in_function = false;
  for (const Node& node : formula.nodes) {
    const auto operand_varies = [&](std::size_t k) {
      return static_cast<int>(k) < arity(node.operation) &&
             varies[static_cast<std::size_t>(node.operands[k])];
    };
    const bool a = operand_varies(0), b = operand_varies(1);
    varies.push_back(a || b || node.operation == Operation::input);
    const bool is_quotient = node.operation == Operation::divide && b;
    const bool is_function = (node.operation == Operation::function && a) || is_quotient;
    const bool is_product = node.operation == Operation::multiply && a && b;
    functions += is_function ? 1 : 0;
    roots += node.operation == Operation::square_root && a ? 1 : 0;
    curves += is_product || (node.operation == Operation::square && a) ? 1 : 0;
    const auto reads_variable = [&](std::size_t k) {
      return formula.nodes[static_cast<std::size_t>(node.operands[k])].operation ==
             Operation::input;
    };
    ends_in_function = is_quotient ? !a && reads_variable(1) : is_function;
  }
  if (functions == 0) return roots > 1 || (roots == 1 && curves > 0);
  return functions > 1 || roots > 0 || curves > 0 || !ends_in_function;
}

/// A formula, and the node that it reads.
struct AppliedFormula {
  Function function;
  NodeId variable;
};

constexpr NodeId none = -1;

/// The place of a node in formulas.
struct NodeFacts {
  NodeId variable = none;    ///< the number on which it depends; none for a constant
  bool has_domain = false;   ///< it needs its variable in a range
  bool needs_table = false;  ///< a function or a quotient is on the way from the variable
  bool is_variable = false;  ///< others read it as a number on which they depend
};

/// Finds the nodes that depend on one number: an input, or a result that formulas do not hold.
class FormulaFinder {
public:
  FormulaFinder(const Graph& graph, const std::vector<PossibleRange>& ranges)
      : graph_(graph), ranges_(ranges) {}

  std::map<NodeId, AppliedFormula> run();

private:
  const Node& node(NodeId id) const { return graph_.nodes()[static_cast<std::size_t>(id)]; }
  const NodeFacts& of(NodeId id) const { return facts_[static_cast<std::size_t>(id)]; }
  std::vector<NodeId> operands(NodeId id) const {
    const Node& reader = node(id);
    return {reader.operands.begin(), reader.operands.begin() + arity(reader.operation)};
  }

  void find_facts(const std::set<NodeId>& tables);
  NodeFacts facts_of(NodeId id, bool has_values) const;
  std::optional<NodeId> common_variable(NodeId id) const;
  bool may_fail(NodeId id) const;
  std::set<NodeId> tables() const;
  Formula formula(NodeId id) const;

  const Graph& graph_;
  const std::vector<PossibleRange>& ranges_;
  std::vector<NodeFacts> facts_;       ///< [node]
  std::vector<PossibleRange> values_;  ///< [node]: even if variables are a little off
};

/// Whether an operation has no value, or an infinite slope, for some values of the variable.
bool FormulaFinder::may_fail(NodeId id) const {
  const Node& reader = node(id);
  const auto varies = [&](std::size_t k) { return of(reader.operands[k]).variable != none; };
  switch (reader.operation) {
    case Operation::divide: return varies(1);
    case Operation::square_root: return varies(0);
    case Operation::function: {
      const Domain all = domain(*reader.function);
      return varies(0) && (all.low || all.high || reader.function->kind() == Function::tan);
    }
    default: return false;
  }
}

/// The variable of all operands, or `none` if they are constants. Nothing if there are several
/// variables, or if formulas do not hold the operation.
std::optional<NodeId> FormulaFinder::common_variable(NodeId id) const {
  const Node& reader = node(id);
  switch (reader.operation) {
    case Operation::negate:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square:
    case Operation::divide:
    case Operation::square_root: break;
    case Operation::function:
      if (!is_differentiable(*reader.function)) return std::nullopt;
      break;
    default: return std::nullopt;
  }
  NodeId found = none;
  for (const NodeId operand : operands(id)) {
    const NodeId variable = of(operand).is_variable ? operand : of(operand).variable;
    if (variable == none) continue;
    if (found != none && found != variable) return std::nullopt;
    found = variable;
  }
  return found;
}

/// `has_values`: whether values of the node are known to be bounded.
NodeFacts FormulaFinder::facts_of(NodeId id, bool has_values) const {
  const Node& each = node(id);
  if (each.operation == Operation::constant) return {};
  const std::optional<NodeId> variable = common_variable(id);
  if (!variable || (may_fail(id) && !has_values) || graph_.limits().contains(id)) {
    return {.variable = id, .is_variable = true};
  }
  NodeFacts facts = {.variable = *variable, .has_domain = may_fail(id)};
  facts.needs_table =
      facts.has_domain || (each.operation == Operation::function && *variable != none);
  for (const NodeId operand : operands(id)) {
    if (of(operand).is_variable) continue;
    facts.has_domain = facts.has_domain || of(operand).has_domain;
    facts.needs_table = facts.needs_table || of(operand).needs_table;
  }
  return facts;
}

/// `tables`: nodes that others read as numbers, even if one formula could hold both.
void FormulaFinder::find_facts(const std::set<NodeId>& tables) {
  facts_.clear();
  values_.clear();
  for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes().size()); ++id) {
    const PossibleRange values = function::value_range(node(id), ranges_, values_);
    NodeFacts facts = facts_of(id, values.has_value());
    facts.is_variable = facts.is_variable || tables.contains(id);
    facts_.push_back(facts);
    values_.push_back(facts.is_variable ? with_margin(values) : values);
  }
}

/// The nodes in formulas that need a table, and that a side or an operation outside of the formula
/// reads.
std::set<NodeId> FormulaFinder::tables() const {
  std::set<NodeId> found;
  const auto read = [&](NodeId id) {
    if (!of(id).is_variable && of(id).needs_table) found.insert(id);
  };
  for (const Sides& part : graph_.parts()) {
    read(part.f);
    read(part.g);
  }
  for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes().size()); ++id) {
    if (!of(id).is_variable) continue;
    for (const NodeId operand : operands(id)) read(operand);
  }
  return found;
}

/// The operations from the variable to a node.
Formula FormulaFinder::formula(NodeId id) const {
  const NodeId variable = of(id).variable;
  Formula made;
  std::vector<NodeId> copies(static_cast<std::size_t>(id) + 1, none);
  std::set<NodeId> needed = {id};
  for (NodeId each = id; each > 0; --each) {
    if (!needed.contains(each) || each == variable) continue;
    for (const NodeId operand : operands(each)) needed.insert(operand);
  }
  for (const NodeId each : needed) {
    Node copied = node(each);
    for (int k = 0; k < arity(copied.operation); ++k) {
      copied.operands[static_cast<std::size_t>(k)] =
          copies[static_cast<std::size_t>(copied.operands[static_cast<std::size_t>(k)])];
    }
    if (each == variable) copied = {.operation = Operation::input, .input = 0, .value = {}};
    copies[static_cast<std::size_t>(each)] = static_cast<NodeId>(made.nodes.size());
    made.nodes.push_back(std::move(copied));
  }
  if (of(id).has_domain) made.arguments = values_[static_cast<std::size_t>(variable)];
  return made;
}

std::map<NodeId, AppliedFormula> FormulaFinder::run() {
  find_facts({});
  const std::set<NodeId> ends = tables();
  // A table that several operations read is computed once, and formulas read its value.
  find_facts(ends);
  std::map<NodeId, AppliedFormula> found;
  for (const NodeId id : ends) {
    Formula made = formula(id);
    if (!is_worth_a_table(made)) continue;
    found.insert({id, {Function::of_formula(std::move(made)), of(id).variable}});
  }
  return found;
}

/// The comparison of a formula with 0.
std::optional<Graph> compared_with_zero(const Graph& graph, const AppliedFormula& applied) {
  GraphCopy copies(graph);
  const NodeId variable = copies.copy(applied.variable);
  const NodeId f = copies.to().apply(applied.function, variable);
  const NodeId zero = copies.to().constant(0);
  return std::move(copies).compared({{f, zero}});
}

}  // namespace

std::optional<Graph> with_formulas(const Graph& graph,
                                   const std::vector<std::optional<Range>>& ranges,
                                   const std::function<bool(const Graph&)>& is_possible) {
  std::map<NodeId, AppliedFormula> formulas = FormulaFinder(graph, ranges).run();
  std::erase_if(formulas, [&](const auto& each) {
    const auto compared = is_possible ? compared_with_zero(graph, each.second) : std::nullopt;
    return compared && !is_possible(*compared);
  });
  if (formulas.empty()) return std::nullopt;
  GraphCopy copies(graph, [&](NodeId id, GraphCopy& made) -> std::optional<NodeId> {
    const auto found = formulas.find(id);
    if (found == formulas.end()) return std::nullopt;
    return made.to().apply(found->second.function, made.copy(found->second.variable));
  });
  std::vector<Sides> parts = copies.copy(graph.parts());
  return std::move(copies).compared(std::move(parts));
}

}  // namespace mixcmp::fixed
