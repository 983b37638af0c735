#include "model/lane/fixed/bilinear_form.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <set>
#include <utility>

#include "model/base/number/exact.hpp"
#include "model/lane/fixed/node_enclosure.hpp"

namespace mixcmp::fixed {
namespace {

/// More terms are no shorter than what they stand for.
constexpr std::size_t most_terms = 64;

constexpr std::size_t roles = 3;

constexpr std::size_t index_of(ItemRole role) {
  return static_cast<std::size_t>(role);
}

constexpr std::size_t first = index_of(ItemRole::first), second = index_of(ItemRole::second),
                      row = index_of(ItemRole::row);

/// A product of numbers: an integer, and a node for each item or row that the term depends on.
struct Term {
  mpz_class coefficient = 1;
  std::array<NodeId, roles> factors = {-1, -1, -1};
  NodeId constant = -1;  ///< a constant factor

  int dependencies() const {
    return static_cast<int>(
        std::count_if(factors.begin(), factors.end(), [](NodeId id) { return id >= 0; }));
  }
};

using Terms = std::vector<Term>;

/// A multiple of a node.
struct Multiple {
  mpz_class coefficient;
  NodeId node;
};

class Rewriter {
public:
  Rewriter(const FixedLane& lane, const std::vector<ItemInput>& inputs)
      : made_(lane), inputs_(inputs) {
    for (const FixedNode& node : lane.nodes) reads_.push_back(reads_of(node));
  }

  std::optional<FixedLane> run() {
    bool changes = false;
    for (FixedPart& part : made_.parts) {
      const std::optional<NodeId> difference = rewritten(part.difference);
      if (!difference) continue;
      part.difference = *difference;
      changes = true;
    }
    return changes ? std::optional(std::move(made_)) : std::nullopt;
  }

private:
  /// A set of roles, one bit each.
  unsigned reads_of(const FixedNode& node) const {
    if (node.operation == Operation::input) return 1U << index_of(inputs_[node.input].role);
    unsigned reads = 0;
    for (int k = 0; k < arity(node.operation); ++k) reads |= reads_[node.operands[k]];
    return reads;
  }

  static bool is_of_one(unsigned reads) { return std::has_single_bit(reads); }

  std::optional<NodeId> rewritten(NodeId difference) {
    const std::optional<Terms> terms = expanded(difference);
    if (!terms) return std::nullopt;
    const Terms collected = joined_equals(folded(*terms));
    const auto depends_on = [](int most) {
      return [most](const Term& term) { return term.dependencies() > most; };
    };
    if (std::any_of(collected.begin(), collected.end(), depends_on(2))) return std::nullopt;
    if (std::none_of(collected.begin(), collected.end(), depends_on(1))) return std::nullopt;
    const std::optional<NodeId> sum = sum_of(collected, difference);
    return sum && keeps_what_is_checked(*sum, difference) ? sum : std::nullopt;
  }

  /// Whether a sum depends on everything that may leave the difference undecided: on its inputs,
  /// whose operands may not fit, and on its limits. None of them may cancel.
  bool keeps_what_is_checked(NodeId sum, NodeId difference) const {
    const std::set<NodeId> kept = fan_in(made_, sum), needed = fan_in(made_, difference);
    return std::all_of(needed.begin(), needed.end(), [&](NodeId id) {
      const FixedNode& node = made_.nodes[id];
      const bool may_not_fit = node.operation == Operation::input || is_checked(node);
      return !may_not_fit || kept.contains(id);
    });
  }

  /// A node as a sum of terms; nothing if it is no polynomial of numbers of one role each, or if
  /// bits are dropped, or checked, behind these numbers.
  std::optional<Terms> expanded(NodeId id) {
    const FixedNode node = made_.nodes[id];
    if (is_of_one(reads_[id])) return of_one(id, node);
    if (node.operation == Operation::constant) return Terms{{.constant = id}};
    if (node.dropped_bits > 0) return std::nullopt;
    switch (node.operation) {
      case Operation::negate: return scaled(expanded(node.operands[0]), -1);
      case Operation::add: return joined(expanded(node.operands[0]), expanded(node.operands[1]));
      case Operation::subtract:
        return joined(expanded(node.operands[0]), scaled(expanded(node.operands[1]), -1));
      case Operation::square:
        return product(expanded(node.operands[0]), expanded(node.operands[0]));
      case Operation::multiply:
        return product(expanded(node.operands[0]), expanded(node.operands[1]));
      default: return std::nullopt;
    }
  }

  std::optional<Terms> of_one(NodeId id, const FixedNode& node) {
    if (node.operation == Operation::negate && node.dropped_bits == 0) {
      return scaled(expanded(node.operands[0]), -1);
    }
    Term term;
    for (std::size_t role = 0; role < roles; ++role) {
      if (reads_[id] == 1U << role) term.factors[role] = id;
    }
    return Terms{term};
  }

  static std::optional<Terms> scaled(std::optional<Terms> terms, int factor) {
    if (terms) {
      for (Term& term : *terms) term.coefficient *= factor;
    }
    return terms;
  }

  static std::optional<Terms> joined(std::optional<Terms> a, const std::optional<Terms>& b) {
    if (!a || !b || a->size() + b->size() > most_terms) return std::nullopt;
    a->insert(a->end(), b->begin(), b->end());
    return a;
  }

  std::optional<Terms> product(const std::optional<Terms>& a, const std::optional<Terms>& b) {
    if (!a || !b || a->size() * b->size() > most_terms) return std::nullopt;
    Terms products;
    for (const Term& of_a : *a) {
      for (const Term& of_b : *b) products.push_back(product(of_a, of_b));
    }
    return products;
  }

  Term product(const Term& a, const Term& b) {
    Term result{.coefficient = a.coefficient * b.coefficient};
    for (std::size_t role = 0; role < roles; ++role) {
      result.factors[role] = product(a.factors[role], b.factors[role]);
    }
    result.constant = product(a.constant, b.constant);
    return result;
  }

  NodeId product(NodeId a, NodeId b) {
    if (a < 0 || b < 0) return std::max(a, b);
    if (a == b) return add(exact_node(made_.nodes, Operation::square, a));
    return add(exact_node(made_.nodes, Operation::multiply, std::min(a, b), std::max(a, b)));
  }

  /// Terms whose constant is part of their first factor. A term that is only a constant becomes a
  /// number of the first item.
  Terms folded(Terms terms) {
    for (Term& term : terms) {
      if (term.constant < 0) continue;
      auto factor =
          std::find_if(term.factors.begin(), term.factors.end(), [](NodeId id) { return id >= 0; });
      if (factor == term.factors.end()) factor = term.factors.begin();
      *factor = product(*factor, std::exchange(term.constant, -1));
    }
    return terms;
  }

  /// One term in place of several that differ only in their integers; none where these cancel.
  static Terms joined_equals(const Terms& terms) {
    Terms joined;
    for (const Term& term : terms) {
      const auto equal = std::find_if(joined.begin(), joined.end(), [&](const Term& other) {
        return other.factors == term.factors;
      });
      if (equal == joined.end()) {
        joined.push_back(term);
      } else {
        equal->coefficient += term.coefficient;
      }
    }
    std::erase_if(joined, [](const Term& term) { return term.coefficient == 0; });
    return joined;
  }

  /// The sum: first the numbers of one item or row each, then product by product, so that
  /// multipliers may add them one behind the other.
  std::optional<NodeId> sum_of(const Terms& terms, NodeId difference) {
    std::vector<Multiple> addends;
    for (std::size_t role = 0; role < roles; ++role) {
      std::vector<Multiple> own;
      for (const Term& term : terms) {
        if (term.dependencies() == 1 && term.factors[role] >= 0) {
          own.push_back({term.coefficient, term.factors[role]});
        }
      }
      if (!own.empty()) addends.push_back(own_number(std::move(own)));
    }
    NodeId sum = addends.empty() ? -1 : sum_of(addends);
    for (const NodeId product : products_of(terms)) {
      sum = sum < 0 ? product : add(exact_node(made_.nodes, Operation::add, sum, product));
    }
    return standing_for(difference, sum);
  }

  /// The number of one item or row. It is negated in the pair's lane, not in the word: then both
  /// items of a distance have the same field.
  Multiple own_number(std::vector<Multiple> own) {
    const bool negates = own.front().coefficient < 0;
    for (Multiple& each : own) {
      if (negates) each.coefficient = -each.coefficient;
    }
    return {negates ? -1 : 1, sum_of(std::move(own))};
  }

  /// The sum, which is the same integer as the difference, in the narrower one of their formats;
  /// nothing if their units differ.
  std::optional<NodeId> standing_for(NodeId difference, NodeId sum) {
    const FixedNode& original = made_.nodes[difference];
    FixedNode node = made_.nodes[sum];
    if (node.format.unit_exponent != original.format.unit_exponent) return std::nullopt;
    if (node.format.width <= original.format.width) return sum;
    node.format = original.format;
    node.value = original.value;
    node.error = original.error;
    return add(std::move(node));
  }

  /// The products of terms of two roles. Terms that share a factor are one product: of that factor
  /// and the sum of the others.
  std::vector<NodeId> products_of(const Terms& terms) {
    const std::size_t item = shared_item(terms);
    std::vector<std::pair<NodeId, std::vector<Multiple>>> groups;  // in the order of the terms
    for (const Term& term : terms) {
      if (term.dependencies() != 2) continue;
      const auto& factors = term.factors;
      const std::size_t shared = factors[row] >= 0 ? row : item;
      const std::size_t other = shared != first && factors[first] >= 0 ? first : second;
      auto group = std::find_if(groups.begin(), groups.end(),
                                [&](const auto& known) { return known.first == factors[shared]; });
      if (group == groups.end()) group = groups.insert(groups.end(), {factors[shared], {}});
      group->second.push_back({term.coefficient, factors[other]});
    }
    std::vector<NodeId> products;
    for (auto& [factor, others] : groups) products.push_back(product_of(factor, others));
    return products;
  }

  /// The item with fewer different factors in the terms of both items.
  static std::size_t shared_item(const Terms& terms) {
    std::array<std::set<NodeId>, roles> different;
    for (const Term& term : terms) {
      if (term.dependencies() != 2 || term.factors[row] >= 0) continue;
      for (const std::size_t item : {first, second}) different[item].insert(term.factors[item]);
    }
    return different[first].size() < different[second].size() ? first : second;
  }

  /// factor times the sum of the others. A power of two in all coefficients only changes the unit.
  NodeId product_of(NodeId factor, std::vector<Multiple>& others) {
    mp_bitcnt_t places = mpz_scan1(others.front().coefficient.get_mpz_t(), 0);
    for (const Multiple& other : others) {
      places = std::min(places, mpz_scan1(other.coefficient.get_mpz_t(), 0));
    }
    for (Multiple& other : others) {
      mpz_fdiv_q_2exp(other.coefficient.get_mpz_t(), other.coefficient.get_mpz_t(), places);
    }
    FixedNode node = exact_node(made_.nodes, Operation::multiply, sum_of(others), factor);
    const mpq_class scale = power_of_two(static_cast<int>(places));
    node.format.unit_exponent += static_cast<int>(places);
    node.value = {node.value.low * scale, node.value.high * scale};
    node.error = {node.error.low * scale, node.error.high * scale};
    return add(std::move(node));
  }

  /// A sum of multiples; those with positive coefficients come first.
  NodeId sum_of(std::vector<Multiple> multiples) {
    std::stable_partition(multiples.begin(), multiples.end(),
                          [](const Multiple& each) { return each.coefficient > 0; });
    NodeId sum = -1;
    for (const Multiple& each : multiples) {
      const NodeId node = multiple(abs(each.coefficient), each.node);
      const bool subtracts = each.coefficient < 0;
      if (sum >= 0) {
        const Operation operation = subtracts ? Operation::subtract : Operation::add;
        sum = add(exact_node(made_.nodes, operation, sum, node));
      } else {
        sum = subtracts ? add(exact_node(made_.nodes, Operation::negate, node)) : node;
      }
    }
    return sum;
  }

  NodeId multiple(const mpz_class& factor, NodeId node) {
    if (factor == 1) return node;
    FixedNode constant{.operation = Operation::constant, .constant = factor};
    constant.format = FixedFormat::holding(factor, factor, 0);
    constant.value = {factor, factor};
    constant.error = {0, 0};
    return add(exact_node(made_.nodes, Operation::multiply, add(std::move(constant)), node));
  }

  NodeId add(FixedNode node) {
    const auto known = std::find(made_.nodes.begin(), made_.nodes.end(), node);
    if (known != made_.nodes.end()) return static_cast<NodeId>(known - made_.nodes.begin());
    reads_.push_back(reads_of(node));
    made_.nodes.push_back(std::move(node));
    return static_cast<NodeId>(made_.nodes.size()) - 1;
  }

  FixedLane made_;
  const std::vector<ItemInput>& inputs_;
  std::vector<unsigned> reads_;  ///< [node]: the roles that it depends on
};

}  // namespace

std::optional<FixedLane> in_bilinear_form(const FixedLane& lane,
                                          const std::vector<ItemInput>& inputs) {
  return Rewriter(lane, inputs).run();
}

}  // namespace mixcmp::fixed
