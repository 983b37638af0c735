#include "model/lane/function/formula_series.hpp"

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/lane/function/taylor.hpp"

namespace mixcmp::function {
namespace {

using Series = std::vector<Interval>;

Series product(const Series& a, const Series& b) {
  Series y;
  for (std::size_t k = 0; k < a.size(); ++k) y.push_back(product_coefficient(a, b, k));
  return y;
}

Series square(const Series& a) {
  Series y = product(a, a);
  mpfi_sqr(y.front().get(), a.front().get());
  return y;
}

/// y, where y b = a.
Series quotient(const Series& a, const Series& b) {
  Series y;
  for (std::size_t k = 0; k < a.size(); ++k) {
    y.emplace_back(0);
    y.back() = (a[k] - product_coefficient(b, y, k, 1)) / b.front();
  }
  return y;
}

/// The series of f(u): `f` is that of f around the first coefficient of u.
Series composed(const Series& f, const Series& u) {
  const std::size_t count = u.size();
  Series y = {f.back()};
  for (std::size_t k = count - 1; k-- > 0;) {
    // y has the factor (u - u[0])^k in front of it, so that further coefficients do not matter.
    y.resize(count - k, 0);
    Series next = {f[k]};
    for (std::size_t i = 1; i < y.size(); ++i) next.push_back(product_coefficient(u, y, i, 1));
    y = std::move(next);
  }
  return y;
}

Series applied(const Function& function, const Series& u) {
  return composed(taylor(function, u.front(), static_cast<int>(u.size())), u);
}

Series constant(const mpq_class& value, std::size_t count) {
  Series y(count, 0);
  y.front() = value;
  return y;
}

Series with_signs(const Series& a, int sign) {
  Series y;
  for (const Interval& each : a) y.push_back(Interval(sign) * each);
  return y;
}

Series sum(const Series& a, const Series& b) {
  Series y;
  for (std::size_t k = 0; k < a.size(); ++k) y.push_back(a[k] + b[k]);
  return y;
}

Series of_node(const Node& node, const std::vector<Series>& known, const Series& variable) {
  const auto operand = [&](std::size_t k) -> const Series& {
    return known[static_cast<std::size_t>(node.operands[k])];
  };
  switch (node.operation) {
    case Operation::input: return variable;
    case Operation::constant: return constant(node.value, variable.size());
    case Operation::negate: return with_signs(operand(0), -1);
    case Operation::add: return sum(operand(0), operand(1));
    case Operation::subtract: return sum(operand(0), with_signs(operand(1), -1));
    case Operation::multiply: return product(operand(0), operand(1));
    case Operation::square: return square(operand(0));
    case Operation::divide: return quotient(operand(0), operand(1));
    case Operation::square_root: return applied(Function::power_of(mpq_class(1, 2)), operand(0));
    case Operation::function: return applied(*node.function, operand(0));
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

std::vector<Interval> taylor(const Formula& formula, const Interval& x, int count) {
  Series variable(static_cast<std::size_t>(count), 0);
  variable.front() = x;
  if (count > 1) variable[1] = 1;
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
  return taylor(formula, x, 1).front();
}

}  // namespace mixcmp::function
