#include "model/judge/proof/cone.hpp"

#include <algorithm>
#include <utility>

#include "model/base/common/check.hpp"

namespace mixcmp::proof {
namespace {

bool is_power_of_two(const TypedNode& node) {
  if (node.operation != Operation::constant || node.value == 0) return false;
  const mpz_class product = abs(node.value.get_num()) * node.value.get_den();
  return mpz_popcount(product.get_mpz_t()) == 1;
}

void collect(const Cone& cone, NodeId id, std::vector<bool>& seen) {
  if (seen[id]) return;
  seen[id] = true;
  const TypedNode& node = cone.graph->nodes[id];
  if (cone.is_leaf[id] && id != cone.root) return;
  for (int k = 0; k < arity(node.operation); ++k) collect(cone, node.operands[k], seen);
}

}  // namespace

bool is_inexpressible(const TypedGraph& graph, const std::vector<NodeClaim>& claims, NodeId id) {
  const TypedNode& node = graph.nodes[id];
  switch (node.operation) {
    case Operation::minimum:
    case Operation::maximum: return true;
    case Operation::absolute: return !claims[node.operands[0]].is_exact();
    case Operation::input:
    case Operation::constant:
    case Operation::convert:
    case Operation::negate:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square:
    case Operation::divide:
    case Operation::square_root:
    case Operation::fused_sum: return false;
    case Operation::function:
    case Operation::look_up: break;
  }
  MIXCMP_CHECK(false);
}

Cone whole_cone(const TypedGraph& graph, const std::vector<NodeClaim>& claims,
                const std::vector<error::RangeCheck>& checks, NodeId root) {
  std::vector<bool> is_leaf;
  for (NodeId id = 0; id < static_cast<NodeId>(graph.nodes.size()); ++id) {
    const bool given = arity(graph.nodes[id].operation) == 0;
    is_leaf.push_back(id != root && (given || is_inexpressible(graph, claims, id)));
  }
  return {&graph, &claims, &checks, root, std::move(is_leaf)};
}

Cone node_cone(const TypedGraph& graph, const std::vector<NodeClaim>& claims,
               const std::vector<error::RangeCheck>& checks, NodeId root) {
  std::vector<bool> is_leaf(graph.nodes.size(), true);
  is_leaf[root] = false;
  return {&graph, &claims, &checks, root, std::move(is_leaf)};
}

std::vector<NodeId> nodes_of(const Cone& cone) {
  std::vector<bool> seen(cone.graph->nodes.size(), false);
  collect(cone, cone.root, seen);
  std::vector<NodeId> nodes;
  for (NodeId id = 0; id <= cone.root; ++id) {
    if (seen[id]) nodes.push_back(id);
  }
  return nodes;
}

int depth_of(const TypedGraph& graph, NodeId id) {
  std::vector<int> depths;
  for (NodeId node = 0; node <= id; ++node) {
    int depth = 0;
    for (int k = 0; k < arity(graph.nodes[node].operation); ++k) {
      depth = std::max(depth, 1 + depths[graph.nodes[node].operands[k]]);
    }
    depths.push_back(depth);
  }
  return depths.back();
}

int digits_of_operands(const TypedGraph& graph, const TypedNode& node) {
  std::vector<int> digits;
  const auto most_of = [&](const TypedNode& of) {
    int most = 0;
    for (int k = 0; k < arity(of.operation); ++k) most = std::max(most, digits[of.operands[k]]);
    return most;
  };
  for (const TypedNode& each : graph.nodes) {
    if (&each == &node) break;
    const int own = each.format.precision();
    switch (each.operation) {
      case Operation::input: digits.push_back(graph.arriving_format(each.input).precision()); break;
      case Operation::convert:
      case Operation::negate:
      case Operation::absolute:
      case Operation::minimum:
      case Operation::maximum: digits.push_back(std::min(own, most_of(each))); break;
      case Operation::constant:
      case Operation::add:
      case Operation::subtract:
      case Operation::multiply:
      case Operation::divide:
      case Operation::square:
      case Operation::square_root:
      case Operation::fused_sum: digits.push_back(own); break;
      case Operation::function:
      case Operation::look_up: break;
    }
  }
  return most_of(node);
}

OwnRounding own_rounding(const TypedGraph& graph, const TypedNode& node) {
  const int operand_digits = digits_of_operands(graph, node);
  const int digits = node.format.precision();
  const auto scales_by = [&](int operand) {
    return operand_digits <= digits && is_power_of_two(graph.nodes[node.operands[operand]]);
  };
  const auto exact_if = [](bool few_digits) {
    return few_digits ? OwnRounding::exact_by_digits : OwnRounding::rounds;
  };
  switch (node.operation) {
    case Operation::input:
    case Operation::constant:
    case Operation::negate:
    case Operation::absolute:
    case Operation::minimum:
    case Operation::maximum: return OwnRounding::never_rounds;
    case Operation::convert: return exact_if(operand_digits <= digits);
    case Operation::square: return exact_if(2 * operand_digits <= digits);
    case Operation::multiply:
      if (scales_by(0) || scales_by(1)) return OwnRounding::exact_by_hand;
      return exact_if(2 * operand_digits <= digits);
    case Operation::divide: return scales_by(1) ? OwnRounding::exact_by_hand : OwnRounding::rounds;
    case Operation::add:
    case Operation::subtract:
    case Operation::square_root:
    case Operation::fused_sum: return OwnRounding::rounds;
    case Operation::function:
    case Operation::look_up: break;
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::proof
