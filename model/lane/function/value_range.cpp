#include "model/lane/function/value_range.hpp"

#include "model/base/common/check.hpp"
#include "model/lane/function/taylor.hpp"

namespace mixcmp::function {
namespace {

std::optional<Range> function_range(const Function& function, const Range& argument) {
  if (has_jumps(function) || !has_value_in(function, argument)) return std::nullopt;
  const Interval values = value(function, Interval(argument));
  return values.is_bounded() ? std::optional(values.range()) : std::nullopt;
}

/// Encloses the values of an operation on operands in the ranges a and b.
PossibleRange result_range(const Node& node, const PossibleRange& a, const PossibleRange& b) {
  if (!a || (arity(node.operation) == 2 && !b)) return std::nullopt;
  switch (node.operation) {
    case Operation::negate: return negated(*a);
    case Operation::absolute: return absolute(*a);
    case Operation::add: return sum(*a, *b);
    case Operation::subtract: return difference(*a, *b);
    case Operation::multiply: return product(*a, *b);
    case Operation::square: return square(*a);
    case Operation::minimum: return minimum(*a, *b);
    case Operation::maximum: return maximum(*a, *b);
    case Operation::divide:
      if (contains_zero(*b)) return std::nullopt;
      return product(*a, {1 / b->high, 1 / b->low});
    case Operation::square_root: return function_range(Function::power_of(mpq_class(1, 2)), *a);
    case Operation::function: return function_range(*node.function, *a);
    case Operation::input:
    case Operation::constant:
    case Operation::convert:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(!"an operand, or an operation of typed graphs");
}

}  // namespace

bool has_value_in(const Function& function, const Range& arguments) {
  const Domain all = domain(function);
  return all.contains(arguments.low) && all.contains(arguments.high);
}

PossibleRange value_range(const Node& node, const std::vector<PossibleRange>& inputs,
                          const std::vector<PossibleRange>& nodes) {
  const auto operand = [&](NodeId id) {
    return id < 0 ? PossibleRange() : nodes[static_cast<std::size_t>(id)];
  };
  switch (node.operation) {
    case Operation::constant: return Range{node.value, node.value};
    case Operation::input:
      return inputs.empty() ? std::nullopt : inputs[static_cast<std::size_t>(node.input)];
    default: return result_range(node, operand(node.operands[0]), operand(node.operands[1]));
  }
}

}  // namespace mixcmp::function
