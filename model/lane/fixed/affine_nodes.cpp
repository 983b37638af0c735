#include "model/lane/fixed/affine_nodes.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/lane/fixed/sum_of_squares.hpp"

namespace mixcmp::fixed {
namespace {

/// Whether multiplication and division by the node keep the digits of a magnitude.
bool is_shift(const Node& node) {
  return node.operation == Operation::constant && is_power_of_two(mpq_class(abs(node.value)));
}

/// `affine`: [node] whether it is affine; the operands' entries are set.
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
    case Operation::multiply: return is_shift(operand(0)) || is_shift(operand(1));
    case Operation::divide: return is_shift(operand(1));
    case Operation::square:
    case Operation::square_root:
    case Operation::function:
    case Operation::fused_sum: return false;
    case Operation::look_up: break;
  }
  MIXCMP_CHECK(false);
}

/// Collects the nodes that operations behind the cut read, from the sides of the parts down.
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

/// Collects the affine nodes below products, from the sides of a part down.
class ProductFinder {
public:
  explicit ProductFinder(const Graph& graph) : graph_(graph), affine_(affine_nodes(graph)) {}

  std::vector<NodeId> run(const Sides& part) {
    for (const NodeId side : {part.f, part.g}) read(side, false);
    return {found_.begin(), found_.end()};
  }

private:
  void read(NodeId id, bool below_product) {
    const Node& node = graph_.nodes()[id];
    if (affine_[id]) {
      if (below_product && node.operation != Operation::constant) found_.insert(id);
      return;
    }
    const bool is_product = node.operation == Operation::multiply ||
                            node.operation == Operation::square ||
                            node.operation == Operation::divide;
    // Small arguments make a function neither small nor its error.
    if (node.operation == Operation::function) return;
    if (!visited_.insert({id, below_product}).second) return;
    for (int k = 0; k < arity(node.operation); ++k) {
      read(node.operands[k], below_product || is_product);
    }
  }

  const Graph& graph_;
  std::vector<bool> affine_;
  std::set<NodeId> found_;
  std::set<std::pair<NodeId, bool>> visited_;
};

}  // namespace

std::vector<bool> affine_nodes(const Graph& graph) {
  std::vector<bool> affine;
  for (const Node& node : graph.nodes()) affine.push_back(is_affine(graph, node, affine));
  return affine;
}

std::vector<NodeId> nodes_to_cut(const Graph& graph) {
  return CutFinder(graph).run();
}

std::vector<NodeId> nodes_in_products(const Graph& graph, const Sides& part) {
  return ProductFinder(graph).run(part);
}

std::vector<std::vector<NodeId>> nodes_in_norms(const Graph& graph) {
  const std::vector<bool> affine = affine_nodes(graph);
  std::vector<std::vector<NodeId>> of_parts;
  for (const Sides& sides : graph.parts()) {
    const auto f = sum_of_squares(graph.nodes(), sides.f);
    const auto g = sum_of_squares(graph.nodes(), sides.g);
    if (!f || !g) continue;
    std::vector<NodeId>& squared = of_parts.emplace_back();
    for (const auto& elements : {f->elements, g->elements}) {
      std::copy_if(elements.begin(), elements.end(), std::back_inserter(squared),
                   [&](NodeId id) { return affine[id]; });
    }
  }
  return of_parts;
}

}  // namespace mixcmp::fixed
