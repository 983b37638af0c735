#include "generator/rtl/net_names.hpp"

#include <fmt/core.h>

#include "model/common/check.hpp"

namespace mixcmp::gen {
namespace {

using model::NodeId;
using model::Operation;
using model::TypedGraph;
using model::TypedNode;

/// Beyond this an identifier is no longer read but skipped.
constexpr std::size_t longest_spelled_name = 28;

std::string spelled(const TypedNode& node, const std::string& a, const std::string& b) {
  switch (node.operation) {
    case Operation::input: return a;
    case Operation::constant: return "constant";
    case Operation::convert: return a + "_rounded";
    case Operation::negate: return a + "_negated";
    case Operation::absolute: return a + "_magnitude";
    case Operation::add: return a + "_plus_" + b;
    case Operation::subtract: return a + "_minus_" + b;
    case Operation::multiply: return a + "_times_" + b;
    case Operation::square: return a + "_squared";
    case Operation::divide: return a + "_over_" + b;
    case Operation::square_root: return a + "_root";
    case Operation::minimum: return a + "_min_" + b;
    case Operation::maximum: return a + "_max_" + b;
  }
  MIXCMP_CHECK(false);
}

std::string role(Operation operation) {
  switch (operation) {
    case Operation::input: return "operand";
    case Operation::constant: return "constant";
    case Operation::convert: return "rounded";
    case Operation::negate: return "negated";
    case Operation::absolute: return "magnitude";
    case Operation::add: return "sum";
    case Operation::subtract: return "difference";
    case Operation::multiply: return "product";
    case Operation::square: return "square";
    case Operation::divide: return "quotient";
    case Operation::square_root: return "root";
    case Operation::minimum: return "smaller";
    case Operation::maximum: return "larger";
  }
  MIXCMP_CHECK(false);
}

}  // namespace

std::string NamePool::unique(const std::string& wanted) {
  std::string name = wanted;
  for (int count = 2; !taken_.insert(name).second; ++count) {
    name = fmt::format("{}_{}", wanted, count);
  }
  return name;
}

std::vector<std::string> name_nodes(const TypedGraph& graph, const std::vector<std::string>& ports,
                                    NamePool& pool) {
  std::vector<std::string> names;
  for (NodeId id = 0; id < static_cast<NodeId>(graph.nodes.size()); ++id) {
    const TypedNode& node = graph.nodes[id];
    if (node.operation == Operation::input) {
      names.push_back(ports[node.input]);
      continue;
    }
    const int count = model::arity(node.operation);
    const std::string a = count > 0 ? names[node.operands[0]] : "";
    const std::string b = count > 1 ? names[node.operands[1]] : "";
    std::string wanted = spelled(node, a, b);
    if (wanted.size() > longest_spelled_name) wanted = role(node.operation);
    if (id == graph.g) wanted = "g";
    if (id == graph.f) wanted = "f";
    names.push_back(pool.unique(wanted));
  }
  return names;
}

std::string formula(const TypedGraph& graph, NodeId id, const std::vector<std::string>& names) {
  const TypedNode& node = graph.nodes[id];
  const auto operand = [&](int k) {
    const NodeId source = node.operands[k];
    const bool constant = graph.nodes[source].operation == Operation::constant;
    return constant ? graph.nodes[source].value.get_str() : names[source];
  };
  switch (node.operation) {
    case Operation::input:
    case Operation::constant: return names[id];
    case Operation::convert: return operand(0);
    case Operation::negate: return "-" + operand(0);
    case Operation::absolute: return "|" + operand(0) + "|";
    case Operation::add: return operand(0) + " + " + operand(1);
    case Operation::subtract: return operand(0) + " - " + operand(1);
    case Operation::multiply: return operand(0) + " * " + operand(1);
    case Operation::square: return operand(0) + "^2";
    case Operation::divide: return operand(0) + " / " + operand(1);
    case Operation::square_root: return "sqrt(" + operand(0) + ")";
    case Operation::minimum: return "min(" + operand(0) + ", " + operand(1) + ")";
    case Operation::maximum: return "max(" + operand(0) + ", " + operand(1) + ")";
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::gen
