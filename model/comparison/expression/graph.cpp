#include "model/comparison/expression/graph.hpp"

#include <algorithm>

#include "model/base/common/check.hpp"

namespace mixcmp::inline expression {
namespace {

bool is_commutative(Operation operation) {
  return operation == Operation::add || operation == Operation::multiply || is_choice(operation);
}

bool same(const Node& a, const Node& b) {
  return a.operation == b.operation && a.operands == b.operands && a.input == b.input &&
         a.value == b.value && a.function == b.function;
}

}  // namespace

int arity(Operation operation) {
  switch (operation) {
    case Operation::input:
    case Operation::constant:
    case Operation::fused_sum: return 0;
    case Operation::convert:
    case Operation::negate:
    case Operation::absolute:
    case Operation::square:
    case Operation::square_root:
    case Operation::function:
    case Operation::look_up: return 1;
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::divide:
    case Operation::minimum:
    case Operation::maximum: return 2;
  }
  MIXCMP_CHECK(false);
}

bool is_choice(Operation operation) {
  return operation == Operation::minimum || operation == Operation::maximum;
}

bool only_moves_bits(Operation operation) {
  return is_choice(operation) || operation == Operation::negate || operation == Operation::absolute;
}

std::string_view to_string(Operation operation) {
  switch (operation) {
    case Operation::input: return "input";
    case Operation::constant: return "constant";
    case Operation::convert: return "convert";
    case Operation::negate: return "negate";
    case Operation::absolute: return "absolute";
    case Operation::add: return "add";
    case Operation::subtract: return "subtract";
    case Operation::multiply: return "multiply";
    case Operation::square: return "square";
    case Operation::divide: return "divide";
    case Operation::square_root: return "square_root";
    case Operation::minimum: return "minimum";
    case Operation::maximum: return "maximum";
    case Operation::function: return "function";
    case Operation::look_up: return "look_up";
    case Operation::fused_sum: return "fused_sum";
  }
  MIXCMP_CHECK(false);
}

std::string_view to_string(Combination combination) {
  switch (combination) {
    case Combination::all: return "all";
    case Combination::any: return "any";
  }
  MIXCMP_CHECK(false);
}

NodeId Graph::input(const std::string& name) {
  const auto found = std::find(inputs_.begin(), inputs_.end(), name);
  const int index = static_cast<int>(found - inputs_.begin());
  if (found == inputs_.end()) inputs_.push_back(name);
  return intern({.operation = Operation::input, .input = index, .value = {}});
}

NodeId Graph::constant(const mpq_class& value) {
  return intern({.operation = Operation::constant, .value = value});
}

NodeId Graph::apply(Operation operation, NodeId first, NodeId second) {
  MIXCMP_CHECK(operation != Operation::convert && operation != Operation::fused_sum);
  MIXCMP_CHECK(operation != Operation::function && operation != Operation::look_up);
  MIXCMP_CHECK(arity(operation) == (second < 0 ? 1 : 2));
  if (operation == Operation::multiply && first == second) {
    return intern({.operation = Operation::square, .operands = {first, -1}, .value = {}});
  }
  if (is_commutative(operation) && second < first) std::swap(first, second);
  return intern({.operation = operation, .operands = {first, second}, .value = {}});
}

NodeId Graph::apply(const Function& function, NodeId argument) {
  return intern({.operation = Operation::function,
                 .operands = {argument, -1},
                 .value = {},
                 .function = function});
}

std::optional<Function> Graph::first_function() const {
  for (const Node& node : nodes_) {
    if (node.function) return node.function;
  }
  return std::nullopt;
}

bool Graph::limit(NodeId id, const Range& limits) {
  const auto known = limits_.find(id);
  Range narrowed = limits;
  if (known != limits_.end()) {
    narrowed.low = std::max(limits.low, known->second.low);
    narrowed.high = std::min(limits.high, known->second.high);
  }
  if (narrowed.low > narrowed.high) return false;
  limits_[id] = narrowed;
  return true;
}

std::optional<OperandFormat> Graph::arriving_format(int input) const {
  const auto found = arriving_.find(input);
  return found == arriving_.end() ? std::nullopt : std::optional(found->second);
}

Graph Graph::with_any_operands() const {
  Graph free = *this;
  free.arriving_.clear();
  return free;
}

void Graph::compare(NodeId f, NodeId g) {
  compare({{f, g}}, Combination::all);
}

void Graph::compare(std::vector<Sides> parts, Combination combination) {
  MIXCMP_CHECK(!parts.empty());
  parts_ = std::move(parts);
  combination_ = combination;
}

NodeId Graph::f() const {
  MIXCMP_CHECK(parts_.size() == 1);
  return parts_.front().f;
}

NodeId Graph::g() const {
  MIXCMP_CHECK(parts_.size() == 1);
  return parts_.front().g;
}

Graph Graph::part(std::size_t index) const {
  Graph alone = *this;
  alone.parts_ = {parts_[index]};
  return alone;
}

NodeId Graph::intern(Node node) {
  const auto found = std::find_if(nodes_.begin(), nodes_.end(),
                                  [&](const Node& known) { return same(known, node); });
  if (found != nodes_.end()) return static_cast<NodeId>(found - nodes_.begin());
  nodes_.push_back(std::move(node));
  return static_cast<NodeId>(nodes_.size()) - 1;
}

}  // namespace mixcmp::inline expression
