#include "model/fixed/affine_nodes.hpp"

#include <set>

#include "model/common/check.hpp"
#include "model/number/dyadic.hpp"

namespace mixcmp::fixed {
namespace {

bool is_power_of_two(const Node& node) {
  return node.operation == Operation::constant && node.value != 0 &&
         power_of_two(static_cast<int>(floor_log2(abs(node.value)))) == abs(node.value);
}

/// `affine`: whether the operands are.
bool is_affine(const Graph& graph, const Node& node, const std::vector<bool>& affine) {
  const auto operand = [&](int k) -> const Node& { return graph.nodes()[node.operands[k]]; };
  for (int k = 0; k < arity(node.operation); ++k) {
    if (!affine[node.operands[k]]) return false;
  }
  switch (node.operation) {
    case Operation::input:
    case Operation::constant:
    case Operation::convert:
    case Operation::negate:
    case Operation::absolute:
    case Operation::add:
    case Operation::subtract:
    case Operation::minimum:
    case Operation::maximum: return true;
    case Operation::multiply: return is_power_of_two(operand(0)) || is_power_of_two(operand(1));
    case Operation::divide: return is_power_of_two(operand(1));
    case Operation::square:
    case Operation::square_root: return false;
  }
  MIXCMP_CHECK(false);
}

/// Collects what the nodes behind the cut read, from the sides of the parts down.
class CutFinder {
public:
  explicit CutFinder(const Graph& graph) : graph_(graph), affine_(affine_nodes(graph)) {}

  std::vector<NodeId> run() {
    for (const Sides& sides : graph_.parts()) {
      if (affine_[sides.f] && affine_[sides.g]) continue;
      read(sides.f);
      read(sides.g);
    }
    return {found_.begin(), found_.end()};
  }

private:
  void read(NodeId id) {
    const Node& node = graph_.nodes()[id];
    if (affine_[id]) {
      if (node.operation != Operation::constant) found_.insert(id);
      return;
    }
    if (!visited_.insert(id).second) return;
    for (int k = 0; k < arity(node.operation); ++k) read(node.operands[k]);
  }

  const Graph& graph_;
  std::vector<bool> affine_;
  std::set<NodeId> found_, visited_;
};

/// Appends what is squared in a sum of squares; false where the node is something else.
bool add_squared(const Graph& graph, NodeId id, std::vector<NodeId>& squared) {
  const Node& node = graph.nodes()[id];
  const auto& [first, second] = node.operands;
  if (node.operation == Operation::square) squared.push_back(first);
  if (node.operation != Operation::add) return node.operation == Operation::square;
  return add_squared(graph, first, squared) && add_squared(graph, second, squared);
}

}  // namespace

std::vector<bool> affine_nodes(const Graph& graph) {
  std::vector<bool> affine;
  for (const Node& node : graph.nodes()) affine.push_back(is_affine(graph, node, affine));
  return affine;
}

std::vector<NodeId> nodes_to_cut(const Graph& graph) {
  return CutFinder(graph).run();
}

std::vector<std::vector<NodeId>> nodes_in_norms(const Graph& graph) {
  const std::vector<bool> affine = affine_nodes(graph);
  std::vector<std::vector<NodeId>> of_parts;
  for (const Sides& sides : graph.parts()) {
    std::vector<NodeId> squared;
    if (!add_squared(graph, sides.f, squared) || !add_squared(graph, sides.g, squared)) continue;
    std::erase_if(squared, [&](NodeId id) { return !affine[id]; });
    of_parts.push_back(std::move(squared));
  }
  return of_parts;
}

}  // namespace mixcmp::fixed
