#include "model/scene/moves.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/comparison/expression/graph_copy.hpp"
#include "model/comparison/expression/range.hpp"
#include "model/lane/function/value_range.hpp"

namespace mixcmp::scene {
namespace {

using function::PossibleRange;

/// Between the poles of tan at +-pi / 2: tan grows.
const Range tan_branch = {mpq_class(-157, 100), mpq_class(157, 100)};

bool is_within(const Range& inner, const Range& outer) {
  return outer.low <= inner.low && inner.high <= outer.high;
}

/// The increasing function that undoes an increasing one; none if expressions have none.
std::optional<Function> inverse_of(const Function& function) {
  if (!function.inner().is_identity()) return std::nullopt;
  switch (function.kind()) {
    case Function::exp: return Function::log;
    case Function::log: return Function::exp;
    case Function::exp2: return Function::log2;
    case Function::log2: return Function::exp2;
    case Function::expm1: return Function::log1p;
    case Function::log1p: return Function::expm1;
    case Function::tan: return Function::atan;
    case Function::atan: return Function::tan;
    case Function::power:
      if (function.parameter() <= 0) return std::nullopt;
      return Function::power_of(1 / function.parameter());
    case Function::sin:
    case Function::cos:
    case Function::sinh:
    case Function::cosh:
    case Function::tanh:
    case Function::sign:
    case Function::remainder:
    case Function::table:
    case Function::formula: return std::nullopt;
  }
  MIXCMP_CHECK(false);
}

bool is_expensive(Operation operation) {
  return operation == Operation::divide || operation == Operation::square_root ||
         operation == Operation::function;
}

/// Encloses the numbers that lanes take for those of the declared ranges. A lane checks sign and
/// size: in fixed point up to the next power of two, in floating point up to 9 / 8 of the range.
std::vector<PossibleRange> accepted_by_lanes(const std::vector<PossibleRange>& declared) {
  std::vector<PossibleRange> accepted;
  for (const PossibleRange& range : declared) {
    accepted.push_back(range);
    if (!range) continue;
    const mpq_class greatest = absolute(*range).high;
    const int exponent = greatest == 0 ? 0 : static_cast<int>(floor_log2(greatest)) + 1;
    const mpq_class most = std::max<mpq_class>(power_of_two(exponent), greatest * 9 / 8);
    accepted.back() = Range{range->low < 0 ? mpq_class(-most) : mpq_class(0),
                            range->high > 0 ? most : mpq_class(0)};
  }
  return accepted;
}

/// "The order of scale * left and right", or the opposite order.
struct Claim {
  NodeId left, right;
  bool is_opposite = false;
  mpq_class scale = 1;  ///< above 0
};

/// Moves operations from one side of a part to the other, in a graph that grows.
class Mover {
public:
  Mover(Graph graph, const std::vector<PossibleRange>& declared)
      : graph_(std::move(graph)),
        declared_{declared, {}},
        accepted_{accepted_by_lanes(declared), {}} {}

  const Graph& graph() const { return graph_; }
  /// Up to `most_moves` other formulations of a part.
  std::vector<Sides> others(const Sides& part);

private:
  const Node& node(NodeId id) const { return graph_.nodes()[static_cast<std::size_t>(id)]; }
  const mpq_class* constant_of(NodeId id) const {
    return node(id).operation == Operation::constant ? &node(id).value : nullptr;
  }
  /// Ranges of the inputs, and of the first nodes.
  struct Ranges {
    std::vector<PossibleRange> inputs, nodes;
  };
  const PossibleRange& range(NodeId id, Ranges& ranges);
  /// Whether all values are within limits if the inputs have numbers that lanes accept.
  bool has(NodeId id, const Range& limits) {
    const PossibleRange& values = range(id, accepted_);
    return values && is_within(*values, limits);
  }
  bool is_never_negative(NodeId id) {
    const PossibleRange& values = range(id, accepted_);
    return values && values->low >= 0;
  }
  bool has_value(const Function& function, NodeId argument) {
    const PossibleRange& values = range(argument, declared_);
    return values && function::has_value_in(function, *values);
  }
  /// False if the node has limits (`within`), which lanes check.
  bool may_leave(NodeId id) const { return !graph_.limits().contains(id); }
  /// -1 or 1 if all values are on that side of 0, otherwise 0.
  int sign_of(NodeId id);
  /// Whether the function grows over its argument, and so does its inverse over the right side.
  bool grows(const Function& function, NodeId argument, NodeId right);

  NodeId negated(NodeId a);
  NodeId sum(NodeId a, NodeId b);
  NodeId difference(NodeId a, NodeId b);
  NodeId product(NodeId a, NodeId b);
  NodeId scaled(NodeId a, const mpq_class& factor);
  NodeId square(NodeId a);
  NodeId applied(const Function& function, NodeId a);

  std::vector<Claim> without_outermost(const Claim& claim);
  std::optional<Claim> without_quotient(const Claim& claim);
  std::optional<Claim> without_root(const Claim& claim);
  std::optional<Claim> without_function(const Claim& claim);
  std::vector<Claim> without_cheap(const Claim& claim);
  /// The roots, quotients and functions that a part needs.
  std::set<NodeId> expensive_operations(const Sides& part) const;
  /// Whether sums, differences, negations and products on the way from a node end at such an
  /// operation.
  bool leads_to_expensive(NodeId id);

  Graph graph_;
  Ranges declared_, accepted_;
  std::set<NodeId> seen_;       ///< left sides of the search for an expensive operation
  std::vector<bool> leads_on_;  ///< of the first nodes: see leads_to_expensive
};

const PossibleRange& Mover::range(NodeId id, Ranges& ranges) {
  for (auto next = static_cast<NodeId>(ranges.nodes.size()); next <= id; ++next) {
    ranges.nodes.push_back(function::value_range(node(next), ranges.inputs, ranges.nodes));
  }
  return ranges.nodes[static_cast<std::size_t>(id)];
}

int Mover::sign_of(NodeId id) {
  const PossibleRange& values = range(id, declared_);
  if (!values) return 0;
  return values->low > 0 ? 1 : values->high < 0 ? -1 : 0;
}

bool Mover::grows(const Function& function, NodeId argument, NodeId right) {
  switch (function.kind()) {
    case Function::power: return is_never_negative(argument) && is_never_negative(right);
    case Function::tan: return has(argument, tan_branch);
    case Function::atan: return has(right, tan_branch);
    default: return true;
  }
}

NodeId Mover::negated(NodeId a) {
  if (const mpq_class* value = constant_of(a)) return graph_.constant(-*value);
  if (node(a).operation == Operation::negate) return node(a).operands[0];
  return graph_.apply(Operation::negate, a);
}

NodeId Mover::sum(NodeId a, NodeId b) {
  if (constant_of(a) != nullptr) std::swap(a, b);
  const mpq_class* first = constant_of(a);
  const mpq_class* second = constant_of(b);
  if (first != nullptr && second != nullptr) return graph_.constant(*first + *second);
  if (second != nullptr && *second == 0) return a;
  return graph_.apply(Operation::add, a, b);
}

NodeId Mover::difference(NodeId a, NodeId b) {
  const mpq_class* first = constant_of(a);
  const mpq_class* second = constant_of(b);
  if (first != nullptr && second != nullptr) return graph_.constant(*first - *second);
  if (second != nullptr && *second == 0) return a;
  if (first != nullptr && *first == 0) return negated(b);
  if (node(b).operation == Operation::negate) return sum(a, node(b).operands[0]);
  return graph_.apply(Operation::subtract, a, b);
}

NodeId Mover::product(NodeId a, NodeId b) {
  if (constant_of(a) != nullptr) std::swap(a, b);
  const mpq_class* first = constant_of(a);
  const mpq_class* second = constant_of(b);
  if (first != nullptr && second != nullptr) return graph_.constant(*first * *second);
  if (second != nullptr && *second == 0) return b;
  if (second != nullptr && *second == 1) return a;
  if (second != nullptr && *second == -1) return negated(a);
  return graph_.apply(Operation::multiply, a, b);
}

NodeId Mover::square(NodeId a) {
  if (node(a).operation == Operation::square_root && may_leave(a)) return node(a).operands[0];
  return constant_of(a) != nullptr ? product(a, a) : graph_.apply(Operation::square, a);
}

/// Applies a function. Its inverse is undone, and small whole powers are products, as the parser
/// writes them.
NodeId Mover::applied(const Function& function, NodeId a) {
  const auto undone = inverse_of(function);
  const bool is_function = node(a).operation == Operation::function && may_leave(a);
  if (is_function && undone && *node(a).function == *undone) {
    const NodeId argument = node(a).operands[0];
    if (grows(*undone, argument, a)) return argument;
  }
  constexpr int most_whole_power = 16;
  const bool is_power = function.kind() == Function::power;
  if (!is_power || function.parameter().get_den() != 1 || function.parameter() > most_whole_power) {
    return graph_.apply(function, a);
  }
  NodeId result = a;
  for (int k = 1; k < function.parameter(); ++k) result = product(result, a);
  return result;
}

NodeId Mover::scaled(NodeId a, const mpq_class& factor) {
  return product(a, graph_.constant(factor));
}

/// a / c against p / q is a q against p c; against another side it is a against side c.
std::optional<Claim> Mover::without_quotient(const Claim& claim) {
  const auto [dividend, divisor] = node(claim.left).operands;
  const int sign = sign_of(divisor);
  if (sign == 0) return std::nullopt;
  const NodeId left = scaled(dividend, claim.scale.get_num());
  const bool is_opposite = claim.is_opposite != (sign < 0);
  const auto [p, q] = node(claim.right).operands;
  const bool is_quotient = node(claim.right).operation == Operation::divide;
  if (!is_quotient || !may_leave(claim.right) || sign_of(q) == 0) {
    const NodeId right = scaled(claim.right, claim.scale.get_den());
    return Claim{left, product(right, divisor), is_opposite};
  }
  const bool is_negative = sign_of(q) < 0;
  return Claim{product(left, q), product(scaled(p, claim.scale.get_den()), divisor),
               is_opposite != is_negative};
}

std::optional<Claim> Mover::without_root(const Claim& claim) {
  const NodeId radicand = node(claim.left).operands[0];
  if (!is_never_negative(radicand) || !is_never_negative(claim.right)) return std::nullopt;
  const mpz_class& num = claim.scale.get_num();
  const mpz_class& den = claim.scale.get_den();
  return Claim{scaled(radicand, num * num), square(scaled(claim.right, den)), claim.is_opposite};
}

std::optional<Claim> Mover::without_function(const Claim& claim) {
  const NodeId argument = node(claim.left).operands[0];
  const NodeId right = scaled(claim.right, 1 / claim.scale);
  const Function function = *node(claim.left).function;
  const auto inverse = inverse_of(function);
  if (!inverse || !has_value(function, argument) || !has_value(*inverse, right)) {
    return std::nullopt;
  }
  if (!grows(function, argument, right)) return std::nullopt;
  return Claim{argument, applied(*inverse, right), claim.is_opposite};
}

/// The claims in which one sum, difference, negation or product by a constant has left the left
/// side.
std::vector<Claim> Mover::without_cheap(const Claim& claim) {
  const auto [a, b] = node(claim.left).operands;
  const auto& [left, right, is, scale] = claim;
  switch (node(left).operation) {
    case Operation::negate: return {{a, negated(right), !is, scale}};
    case Operation::add:
      return {{a, difference(right, scaled(b, scale)), is, scale},
              {b, difference(right, scaled(a, scale)), is, scale}};
    case Operation::subtract:
      return {{a, sum(right, scaled(b, scale)), is, scale},
              {b, difference(scaled(a, scale), right), !is, scale}};
    case Operation::multiply:
      for (const auto& [factor, rest] : {std::pair(a, b), std::pair(b, a)}) {
        if (constant_of(factor) == nullptr || *constant_of(factor) == 0) continue;
        const mpq_class value = *constant_of(factor);
        if (value > 0) return {{rest, right, is, scale * value}};
        return {{rest, negated(right), !is, -scale * value}};
      }
      return {};
    default: return {};
  }
}

/// The claims after the outermost root, quotient or function of the left side has moved.
std::vector<Claim> Mover::without_outermost(const Claim& claim) {
  if (!may_leave(claim.left) || !seen_.insert(claim.left).second) return {};
  std::optional<Claim> moved;
  switch (node(claim.left).operation) {
    case Operation::divide: moved = without_quotient(claim); break;
    case Operation::square_root: moved = without_root(claim); break;
    case Operation::function: moved = without_function(claim); break;
    default: {
      std::vector<Claim> all;
      if (!leads_to_expensive(claim.left)) return all;
      for (const Claim& each : without_cheap(claim)) {
        for (const Claim& further : without_outermost(each)) all.push_back(further);
      }
      return all;
    }
  }
  return moved ? std::vector<Claim>{*moved} : std::vector<Claim>();
}

bool Mover::leads_to_expensive(NodeId id) {
  for (auto next = static_cast<NodeId>(leads_on_.size()); next <= id; ++next) {
    const Node& each = node(next);
    bool leads = is_expensive(each.operation);
    switch (each.operation) {
      case Operation::negate:
      case Operation::add:
      case Operation::subtract:
      case Operation::multiply:
        for (int k = 0; k < arity(each.operation); ++k) {
          leads = leads || leads_on_[static_cast<std::size_t>(each.operands[k])];
        }
        break;
      default: break;
    }
    leads_on_.push_back(leads);
  }
  return leads_on_[static_cast<std::size_t>(id)];
}

std::set<NodeId> Mover::expensive_operations(const Sides& part) const {
  std::set<NodeId> found, seen;
  std::vector<NodeId> open = {part.f, part.g};
  while (!open.empty()) {
    const NodeId id = open.back();
    open.pop_back();
    if (!seen.insert(id).second) continue;
    const Operation operation = node(id).operation;
    if (is_expensive(operation)) found.insert(id);
    for (int k = 0; k < arity(operation); ++k) {
      open.push_back(node(id).operands[static_cast<std::size_t>(k)]);
    }
  }
  return found;
}

std::vector<Sides> Mover::others(const Sides& part) {
  std::vector<Sides> known = {part};
  std::set<std::set<NodeId>> expensive = {expensive_operations(part)};
  for (std::size_t next = 0; next < known.size() && known.size() <= most_moves; ++next) {
    const Sides from = known[next];
    seen_.clear();
    std::vector<Claim> claims = without_outermost({from.f, from.g, false});
    seen_.clear();
    for (const Claim& each : without_outermost({from.g, from.f, true})) claims.push_back(each);
    for (const Claim& each : claims) {
      const Sides sides =
          each.is_opposite ? Sides{each.right, each.left} : Sides{each.left, each.right};
      // Formulations that need the same expensive operations as a known one are of no use.
      if (expensive.insert(expensive_operations(sides)).second) known.push_back(sides);
    }
  }
  known.erase(known.begin());
  if (known.size() > most_moves) known.resize(most_moves);
  return known;
}

/// The formulation with these parts; none if they do not need every input, as a / c against 0 does
/// not need c without the quotient.
std::optional<Graph> compared(const Graph& graph, std::vector<Sides> parts) {
  GraphCopy copies(graph);
  parts = copies.copy(std::move(parts));
  if (copies.lacks_an_input()) return std::nullopt;
  return std::move(copies).compared(std::move(parts));
}

}  // namespace

std::vector<Graph> moved(const Graph& graph, const std::vector<PossibleRange>& ranges) {
  Mover mover(graph, ranges);
  std::vector<std::vector<Sides>> of_parts;
  std::size_t most = 0;
  for (const Sides& part : graph.parts()) {
    of_parts.push_back(mover.others(part));
    most = std::max(most, of_parts.back().size());
    of_parts.back().insert(of_parts.back().begin(), part);
  }
  std::vector<Graph> all;
  for (std::size_t k = 1; k <= most; ++k) {
    std::vector<Sides> parts;
    for (const auto& others : of_parts) {
      const Sides& part = others[std::min(k, others.size() - 1)];
      if (std::find(parts.begin(), parts.end(), part) == parts.end()) parts.push_back(part);
    }
    auto formulation = compared(mover.graph(), std::move(parts));
    if (formulation) all.push_back(*std::move(formulation));
  }
  return all;
}

}  // namespace mixcmp::scene
