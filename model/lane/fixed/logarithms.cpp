#include "model/lane/fixed/logarithms.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/comparison/expression/graph_copy.hpp"
#include "model/lane/function/value_range.hpp"

namespace mixcmp::fixed {
namespace {

using function::PossibleRange;

/// Factors that span fewer binades, all together, are left as they are.
constexpr long least_binades = 16;

/// coefficient * factor^exponent * ..., of factors above 0.
struct Monomial {
  mpq_class coefficient = 1;                   ///< not 0
  std::map<NodeId, mpq_class> exponents = {};  ///< [factor]; 0 if it cancels, as in x / x

  /// The coefficient is 1, or the exponent 1 or -1.
  Monomial raised(const mpq_class& exponent) const {
    MIXCMP_CHECK(coefficient == 1 || abs(exponent) == 1);
    Monomial result{.coefficient = exponent < 0 ? mpq_class(1 / coefficient) : coefficient};
    for (const auto& [factor, own] : exponents) result.exponents[factor] = own * exponent;
    return result;
  }
  Monomial times(const Monomial& other) const {
    Monomial result = *this;
    result.coefficient *= other.coefficient;
    for (const auto& [factor, exponent] : other.exponents) result.exponents[factor] += exponent;
    return result;
  }
};

class MonomialFinder {
public:
  MonomialFinder(const Graph& graph, const std::vector<PossibleRange>& ranges) : graph_(graph) {
    for (const Node& node : graph.nodes()) {
      ranges_.push_back(function::value_range(node, ranges, ranges_));
      monomials_.push_back(monomial_of(node));
    }
  }

  /// By the nodes that functions read.
  std::map<NodeId, Monomial> run() const;

private:
  const Node& node(NodeId id) const { return graph_.nodes()[static_cast<std::size_t>(id)]; }
  const Monomial& of(NodeId id) const { return monomials_[static_cast<std::size_t>(id)]; }
  bool is_positive(NodeId id) const {
    const PossibleRange& range = ranges_[static_cast<std::size_t>(id)];
    return range && range->low > 0;
  }
  bool is_constant(NodeId id) const { return node(id).operation == Operation::constant; }

  Monomial monomial_of(const Node& node) const;
  Monomial itself() const { return {.exponents = {{static_cast<NodeId>(monomials_.size()), 1}}}; }
  bool is_worth_logarithms(const Monomial& monomial) const;
  void find_below(NodeId id, std::map<NodeId, Monomial>& found) const;

  const Graph& graph_;
  std::vector<PossibleRange> ranges_;  ///< [node]
  std::vector<Monomial> monomials_;    ///< [node]: often the node itself
};

Monomial MonomialFinder::monomial_of(const Node& node) const {
  const auto id = static_cast<NodeId>(monomials_.size());
  const auto [a, b] = node.operands;
  const bool has_limits = graph_.limits().contains(id);
  if (has_limits) return itself();
  switch (node.operation) {
    case Operation::constant: return node.value == 0 ? itself() : Monomial{node.value};
    case Operation::negate: return of(a).times({-1});
    case Operation::multiply: return of(a).times(of(b));
    case Operation::divide: return of(a).times(of(b).raised(-1));
    case Operation::square: return of(a).times(of(a));
    case Operation::square_root:
      return of(a).coefficient == 1 ? of(a).raised(mpq_class(1, 2)) : itself();
    case Operation::function:
      if (node.function->kind() != Function::power || of(a).coefficient != 1) return itself();
      return of(a).raised(node.function->parameter());
    default: return itself();
  }
}

bool MonomialFinder::is_worth_logarithms(const Monomial& monomial) const {
  if (monomial.exponents.size() < 2) return false;
  long binades = 0;
  for (const auto& [factor, exponent] : monomial.exponents) {
    // A factor that cancels still needs a value, and its logarithm would not be read.
    if (!is_positive(factor) || exponent == 0) return false;
    const Range& range = *ranges_[static_cast<std::size_t>(factor)];
    binades += floor_log2(range.high / range.low);
  }
  return binades >= least_binades;
}

/// Finds monomials in a function's argument. Looks through negations, squares and operations with a
/// constant.
void MonomialFinder::find_below(NodeId id, std::map<NodeId, Monomial>& found) const {
  if (graph_.limits().contains(id)) return;
  if (is_worth_logarithms(of(id))) {
    found.emplace(id, of(id));
    return;
  }
  const Node& reader = node(id);
  const auto [a, b] = reader.operands;
  switch (reader.operation) {
    case Operation::negate:
    case Operation::square: return find_below(a, found);
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::divide:
      if (is_constant(a)) return find_below(b, found);
      if (is_constant(b)) return find_below(a, found);
      return;
    default: return;
  }
}

std::map<NodeId, Monomial> MonomialFinder::run() const {
  std::map<NodeId, Monomial> found;
  for (const Node& reader : graph_.nodes()) {
    if (reader.operation != Operation::function || has_jumps(*reader.function)) continue;
    find_below(reader.operands[0], found);
  }
  return found;
}

NodeId multiple(Graph& graph, NodeId id, const mpq_class& factor) {
  if (factor == 1) return id;
  if (factor == -1) return graph.apply(Operation::negate, id);
  return graph.apply(Operation::multiply, id, graph.constant(factor));
}

/// The logarithm of the monomial without its coefficient.
NodeId sum_of_logarithms(const Monomial& monomial, Function::Kind logarithm, GraphCopy& copies) {
  Graph& graph = copies.to();
  NodeId sum = -1;
  for (const auto& [factor, exponent] : monomial.exponents) {
    const NodeId term = multiple(graph, graph.apply(logarithm, copies.copy(factor)), abs(exponent));
    if (sum < 0) {
      sum = exponent < 0 ? graph.apply(Operation::negate, term) : term;
    } else {
      sum = graph.apply(exponent < 0 ? Operation::subtract : Operation::add, sum, term);
    }
  }
  return sum;
}

NodeId by_logarithms(const Monomial& monomial, GraphCopy& copies) {
  const NodeId sum = sum_of_logarithms(monomial, Function::log2, copies);
  Graph& graph = copies.to();
  return multiple(graph, graph.apply(Function::exp2, sum), monomial.coefficient);
}

bool is_logarithm(const Node& node) {
  return node.operation == Operation::function &&
         (*node.function == Function(Function::log) || *node.function == Function(Function::log2));
}

}  // namespace

std::optional<Graph> with_logarithms(const Graph& graph,
                                     const std::vector<std::optional<Range>>& ranges) {
  if (!graph.first_function()) return std::nullopt;
  const std::map<NodeId, Monomial> monomials = MonomialFinder(graph, ranges).run();
  if (monomials.empty()) return std::nullopt;
  GraphCopy copies(graph, [&](NodeId id, GraphCopy& made) -> std::optional<NodeId> {
    if (const auto found = monomials.find(id); found != monomials.end()) {
      return by_logarithms(found->second, made);
    }
    const Node& reader = graph.nodes()[static_cast<std::size_t>(id)];
    if (!is_logarithm(reader)) return std::nullopt;
    const auto found = monomials.find(reader.operands[0]);
    if (found == monomials.end() || found->second.coefficient != 1) return std::nullopt;
    return sum_of_logarithms(found->second, reader.function->kind(), made);
  });
  std::vector<Sides> parts = copies.copy(graph.parts());
  return std::move(copies).compared(std::move(parts));
}

}  // namespace mixcmp::fixed
