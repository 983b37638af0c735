#include "model/judge/proof/jump_enclosure.hpp"

#include <algorithm>

#include "model/base/number/dyadic.hpp"
#include "model/lane/fixed/node_enclosure.hpp"

namespace mixcmp::proof {
namespace {

using fixed::FixedNode;

constexpr int most_steps = 1 << 12;

/// The node X - k M below a remainder's result, which may be limited.
NodeId difference_below(const std::vector<FixedNode>& nodes, NodeId result) {
  return fixed::is_limit(nodes[result]) ? nodes[result].operands[0] : result;
}

std::optional<FunctionEnclosure> enclose_sign(const std::vector<FixedNode>& nodes, NodeId argument,
                                              const FixedNode& word) {
  const bool is_one = word.words.size() == 2 && word.words[0] == 1 && word.words[1] == -1;
  if (!is_one || word.format.unit_exponent != 0 || !nodes[argument].format.is_signed) {
    return std::nullopt;
  }
  const Range& error = nodes[argument].error;
  if (error.high > 0 || error.low <= -nodes[argument].format.unit()) return std::nullopt;
  return FunctionEnclosure{.value = {-1, 1},
                           .error = {0, 0},
                           .reason = "by theorem 11, the argument is only rounded down"};
}

/// The re-derivation of X - k M.
class Remainder {
public:
  Remainder(const std::vector<FixedNode>& nodes, const FunctionNodes& function)
      : nodes_(nodes),
        function_(function),
        argument_(nodes[function.argument]),
        difference_(difference_below(nodes, function.result)),
        multiple_(nodes[nodes[difference_].operands[1]]),
        period_(value_of(multiple_.operands[1], 0)),
        divisor_(nodes[function.result].function->parameter()) {}

  std::optional<FunctionEnclosure> enclose() {
    const mpq_class unit = argument_.format.unit();
    const mpz_class least = ceiling_of(argument_.value.low / unit);
    const mpz_class greatest = floor_of(argument_.value.high / unit);
    const Range count = {quotient(least), quotient(greatest)};
    const bool is_constant = nodes_[multiple_.operands[0]].operation == Operation::constant;
    const Range& error = argument_.error;
    // With both ends of a known error, it is with every error between them.
    const bool is_exact = is_constant ? is_quotient_of_all(count.low)
                                      : are_equal(least, greatest, error.low) &&
                                            are_equal(least, greatest, error.high);
    if (!is_exact && (is_constant || !are_equal(least, greatest, 0))) return std::nullopt;
    const Range off = product(count, {period_ - divisor_, period_ - divisor_});  // k M - k y
    Range value = difference(argument_.value, product(count, {period_, period_}));
    if (!is_constant) {
      const Range moved = is_exact ? error : Range{0, 0};
      fixed::narrow(value, difference({moved.low, divisor_ + moved.high}, off));
    }
    value = multiples_in(value, nodes_[difference_].format.unit());
    const bool is_limited = difference_ != function_.result;
    if (is_limited) {
      inside_[difference_] = value;
      value = within_limits(value);
    }
    const bool keeps_away = is_limited && value.low + off.low >= error.high &&
                            value.high + off.high < divisor_ + error.low;
    if (!is_exact && !keeps_away) return std::nullopt;
    enclose_inside(argument_.value);
    return FunctionEnclosure{.value = value,
                             .error = difference(argument_.error, off),
                             .inside = inside_,
                             .reason = "by theorem 11, the quotient is that of every argument"};
  }

private:
  static Range multiples_in(const Range& range, const mpq_class& unit) {
    return {ceiling_of(range.low / unit) * unit, floor_of(range.high / unit) * unit};
  }

  /// A node inside, for an argument: products and sums, without dropped bits.
  mpq_class value_of(NodeId id, const mpq_class& argument) const {
    if (id == function_.argument) return argument;
    const FixedNode& node = nodes_[id];
    if (node.operation == Operation::constant) return node.constant * node.format.unit();
    const mpq_class a = value_of(node.operands[0], argument),
                    b = value_of(node.operands[1], argument);
    const mpq_class exact =
        node.operation == Operation::multiply ? mpq_class(a * b) : mpq_class(a + b);
    return node.dropped_bits == 0 ? exact
                                  : floor_of(exact / node.format.unit()) * node.format.unit();
  }

  mpz_class quotient(const mpz_class& argument) const {
    return floor_of(value_of(multiple_.operands[0], argument * argument_.format.unit()));
  }

  /// Whether the lane's quotient is floor((X u - error) / y) for all X. It grows with X, since it
  /// is a product with a positive constant: it is if it is on both sides of every step of the
  /// other.
  bool are_equal(const mpz_class& least, const mpz_class& greatest, const mpq_class& error) const {
    const mpq_class unit = argument_.format.unit();
    if (value_of(multiple_.operands[0], 1 << 20) < value_of(multiple_.operands[0], 0)) return false;
    const auto right = [&](const mpz_class& number) {
      return floor_of((number * unit - error) / divisor_);
    };
    const auto is_right = [&](const mpz_class& number) {
      return quotient(number) == right(number);
    };
    if (!is_right(least) || !is_right(greatest)) return false;
    const mpz_class first = right(least), last = right(greatest);
    if (last - first > most_steps) return false;
    for (mpz_class k = first + 1; k <= last; ++k) {
      const mpz_class step = ceiling_of((k * divisor_ + error) / unit);
      if (!is_right(step) || !is_right(step - 1)) return false;
    }
    return true;
  }

  /// Whether no real argument has another quotient.
  bool is_quotient_of_all(const mpq_class& count) const {
    const Range real = difference(argument_.value, argument_.error);
    return floor_of(real.low / divisor_) == count && floor_of(real.high / divisor_) == count;
  }

  /// Hardware checks an end of the limit that lies inside of what the lane states for the operand.
  Range within_limits(const Range& operand) const {
    const Range &limit = nodes_[function_.result].value, &said = nodes_[difference_].value;
    return {limit.low > said.low ? std::max(limit.low, operand.low) : operand.low,
            limit.high < said.high ? std::min(limit.high, operand.high) : operand.high};
  }

  /// Products and sums grow with the argument.
  void enclose_inside(const Range& arguments) {
    for (const NodeId id : function_.inside) {
      if (id == difference_) continue;
      const Range ends = {value_of(id, arguments.low), value_of(id, arguments.high)};
      inside_[id] = {std::min(ends.low, ends.high), std::max(ends.low, ends.high)};
    }
  }

  const std::vector<FixedNode>& nodes_;
  const FunctionNodes& function_;
  const FixedNode& argument_;
  NodeId difference_;
  const FixedNode& multiple_;
  mpq_class period_, divisor_;  ///< M, y
  std::map<NodeId, Range> inside_;
};

/// Whether the node is the argument times a constant, plus a constant: collects such nodes.
bool is_linear(const std::vector<FixedNode>& nodes, NodeId id, FunctionNodes& found) {
  const FixedNode& node = nodes[id];
  const auto is_constant = [&](NodeId each) {
    return nodes[each].operation == Operation::constant;
  };
  if (is_constant(id)) return true;
  found.inside.insert(id);
  if (arity(node.operation) != 2 || !is_constant(node.operands[1])) return false;
  if (node.operation == Operation::multiply) return node.operands[0] == found.argument;
  return node.operation == Operation::add && is_linear(nodes, node.operands[0], found);
}

}  // namespace

bool is_remainder(const FixedNode& node) {
  if (!node.function || node.function->kind() != Function::remainder) return false;
  return node.operation == Operation::subtract || fixed::is_limit(node);
}

std::optional<FunctionNodes> nodes_of_remainder(const std::vector<FixedNode>& nodes,
                                                NodeId result) {
  FunctionNodes found{result, -1, {}};
  const NodeId difference = difference_below(nodes, result);
  if (difference != result) found.inside.insert(difference);
  const FixedNode& node = nodes[difference];
  if (node.operation != Operation::subtract) return std::nullopt;
  found.argument = node.operands[0];
  const FixedNode& multiple = nodes[node.operands[1]];
  if (multiple.operation != Operation::multiply || multiple.dropped_bits > 0) return std::nullopt;
  found.inside.insert(node.operands[1]);
  if (nodes[multiple.operands[1]].operation != Operation::constant) return std::nullopt;
  if (!is_linear(nodes, multiple.operands[0], found)) return std::nullopt;
  return found;
}

std::optional<FunctionEnclosure> enclose_jump(const std::vector<FixedNode>& nodes,
                                              const FunctionNodes& function) {
  const FixedNode& result = nodes[function.result];
  if (result.function->kind() == Function::sign) {
    return enclose_sign(nodes, function.argument, result);
  }
  return Remainder(nodes, function).enclose();
}

}  // namespace mixcmp::proof
