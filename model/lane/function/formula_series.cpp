#include "model/lane/function/formula_series.hpp"

#include <algorithm>
#include <vector>

#include "model/base/common/check.hpp"
#include "model/lane/function/taylor.hpp"

namespace mixcmp::function {
namespace {

Series of_node(const Node& node, const std::vector<Series>& known, const Series& variable) {
  const auto operand = [&](std::size_t k) -> const Series& {
    return known[static_cast<std::size_t>(node.operands[k])];
  };
  switch (node.operation) {
    case Operation::input: return variable;
    case Operation::constant: return constant(node.value, variable.size());
    case Operation::negate: return multiple(-1, operand(0));
    case Operation::add: return sum(operand(0), operand(1));
    case Operation::subtract: return difference(operand(0), operand(1));
    case Operation::multiply: return product(operand(0), operand(1));
    case Operation::square: return square(operand(0));
    case Operation::divide: return quotient(operand(0), operand(1));
    case Operation::square_root: return taylor(Function::power_of(mpq_class(1, 2)), operand(0));
    case Operation::function: return taylor(*node.function, operand(0));
    case Operation::convert:
    case Operation::absolute:
    case Operation::minimum:
    case Operation::maximum:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(!"an operation that formulas have");
}

}  // namespace

Series taylor(const Formula& formula, const Series& variable) {
  std::vector<Series> known;
  for (const Node& node : formula.nodes) {
    known.push_back(of_node(node, known, variable));
    const bool is_bounded = std::all_of(known.back().begin(), known.back().end(),
                                        [](const Interval& each) { return each.is_bounded(); });
    // A later operation may hide it, as atan(1 / x) does at 0.
    if (!is_bounded) return Series(variable.size(), Interval::unbounded());
  }
  return known.back();
}

Interval value(const Formula& formula, const Interval& x) {
  return taylor(formula, constant(x, 1)).front();
}

}  // namespace mixcmp::function
