#include "tests/support/parsed.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace mixcmp::test {
mpq_class evaluate(const Graph& graph, NodeId id, const Inputs& inputs) {
  const Node& node = graph.nodes()[static_cast<std::size_t>(id)];
  const auto operand = [&](int k) {
    return evaluate(graph, node.operands[static_cast<std::size_t>(k)], inputs);
  };
  switch (node.operation) {
    case Operation::input:
      for (const auto& [name, value] : inputs) {
        if (name == graph.inputs()[static_cast<std::size_t>(node.input)]) return value;
      }
      break;
    case Operation::constant: return node.value;
    case Operation::negate: return -operand(0);
    case Operation::absolute: return abs(operand(0));
    case Operation::add: return operand(0) + operand(1);
    case Operation::subtract: return operand(0) - operand(1);
    case Operation::multiply: return operand(0) * operand(1);
    case Operation::square: return operand(0) * operand(0);
    case Operation::divide: return operand(0) / operand(1);
    case Operation::minimum: return std::min(operand(0), operand(1));
    case Operation::maximum: return std::max(operand(0), operand(1));
    case Operation::convert:
    case Operation::square_root:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  ADD_FAILURE() << "node " << id << " has no exact value";
  return 0;
}

mpq_class value_of(const std::string& text, const Inputs& inputs,
                   const std::vector<LetDefinition>& lets) {
  Graph graph;
  const Result<NodeId> node = parse_expression(graph, text, lets);
  EXPECT_TRUE(node.ok()) << text << ": " << (node.ok() ? "" : node.error().to_string());
  return node.ok() ? evaluate(graph, *node, inputs) : 0;
}

Error error_of(const std::string& text, const std::vector<LetDefinition>& lets) {
  Graph graph;
  const Result<NodeId> node = parse_expression(graph, text, lets);
  EXPECT_FALSE(node.ok()) << text;
  return node.ok() ? Error{} : node.error();
}

int count(const Graph& graph, Operation operation) {
  int total = 0;
  for (const Node& node : graph.nodes()) total += node.operation == operation;
  return total;
}

}  // namespace mixcmp::test
