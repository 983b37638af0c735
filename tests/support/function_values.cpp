#include "tests/support/function_values.hpp"

#include <mpfr.h>

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/comparison/expression/formula.hpp"
#include "model/judge/golden/big_float.hpp"
#include "tests/support/graphs.hpp"

namespace mixcmp::test {
namespace {

using golden::BigFloat;

mpq_class raised(const mpq_class& base, const mpz_class& exponent) {
  mpq_class result = 1;
  for (mpz_class k = 0; k < exponent; ++k) result *= base;
  return result;
}

mpq_class rational(const BigFloat& number) {
  MIXCMP_CHECK(mpfr_number_p(number.get()) != 0);
  mpq_class value;
  mpfr_get_q(value.get_mpq_t(), number.get());
  return value;
}

/// x^exponent by MPFR's power with a rounded exponent: a last place off at most, unless the power
/// is a number of so many digits.
int raise(mpfr_ptr y, const BigFloat& x, const mpq_class& exponent, mpfr_rnd_t rounding) {
  const mpfr_prec_t digits = mpfr_get_prec(y);
  BigFloat rounded(digits + 64), value(digits + 64), short_value(digits / 2);
  mpfr_set_q(rounded.get(), exponent.get_mpq_t(), MPFR_RNDN);
  mpfr_pow(value.get(), x.get(), rounded.get(), MPFR_RNDN);
  mpfr_set(short_value.get(), value.get(), MPFR_RNDN);
  const mpq_class power = raised(rational(x), abs(exponent.get_num()));
  const mpq_class root = raised(rational(short_value), exponent.get_den());
  if (root == (exponent < 0 ? 1 / power : power)) {
    mpfr_set(y, short_value.get(), MPFR_RNDN);
    return 0;
  }
  mpfr_set(y, value.get(), MPFR_RNDN);
  if (rounding == MPFR_RNDD) mpfr_nextbelow(y);
  if (rounding == MPFR_RNDU) mpfr_nextabove(y);
  return 0;
}

int apply(const Function& function, mpfr_ptr y, const BigFloat& argument, mpfr_rnd_t rounding) {
  mpfr_srcptr x = argument.get();
  switch (function.kind()) {
    case Function::exp: return mpfr_exp(y, x, rounding);
    case Function::exp2: return mpfr_exp2(y, x, rounding);
    case Function::expm1: return mpfr_expm1(y, x, rounding);
    case Function::log: return mpfr_log(y, x, rounding);
    case Function::log2: return mpfr_log2(y, x, rounding);
    case Function::log1p: return mpfr_log1p(y, x, rounding);
    case Function::sin: return mpfr_sin(y, x, rounding);
    case Function::cos: return mpfr_cos(y, x, rounding);
    case Function::tan: return mpfr_tan(y, x, rounding);
    case Function::atan: return mpfr_atan(y, x, rounding);
    case Function::sinh: return mpfr_sinh(y, x, rounding);
    case Function::cosh: return mpfr_cosh(y, x, rounding);
    case Function::tanh: return mpfr_tanh(y, x, rounding);
    case Function::power: return raise(y, argument, function.parameter(), rounding);
    case Function::sign:
    case Function::remainder:
    case Function::table:
    case Function::formula: break;  // they have functions of their own below
  }
  MIXCMP_CHECK(false);
}

/// One operation of a formula, rounded to the digits of y.
void compute(const Node& node, const std::vector<BigFloat>& known, const BigFloat& argument,
             mpfr_ptr y) {
  const auto operand = [&](std::size_t k) {
    return known[static_cast<std::size_t>(node.operands[k])].get();
  };
  switch (node.operation) {
    case Operation::input: mpfr_set(y, argument.get(), MPFR_RNDN); return;
    case Operation::constant: mpfr_set_q(y, node.value.get_mpq_t(), MPFR_RNDN); return;
    case Operation::negate: mpfr_neg(y, operand(0), MPFR_RNDN); return;
    case Operation::add: mpfr_add(y, operand(0), operand(1), MPFR_RNDN); return;
    case Operation::subtract: mpfr_sub(y, operand(0), operand(1), MPFR_RNDN); return;
    case Operation::multiply: mpfr_mul(y, operand(0), operand(1), MPFR_RNDN); return;
    case Operation::square: mpfr_sqr(y, operand(0), MPFR_RNDN); return;
    case Operation::divide: mpfr_div(y, operand(0), operand(1), MPFR_RNDN); return;
    case Operation::square_root: mpfr_sqrt(y, operand(0), MPFR_RNDN); return;
    case Operation::function: {
      const auto& x = known[static_cast<std::size_t>(node.operands[0])];
      apply(*node.function, y, x, MPFR_RNDN);
      return;
    }
    default: MIXCMP_CHECK(!"an operation of formulas");
  }
}

/// A formula's value to about half of the digits.
BigFloat formula_value(const Formula& formula, const BigFloat& x, mpfr_prec_t digits) {
  std::vector<BigFloat> known;
  for (const Node& node : formula.nodes) {
    BigFloat result(digits);
    compute(node, known, x, result.get());
    known.push_back(std::move(result));
  }
  return known.back();
}

/// The value of a function that maps rational numbers to such.
std::optional<mpq_class> rational_value(const Function& function, const mpq_class& x) {
  switch (function.kind()) {
    case Function::sign: return x < 0 ? -1 : 1;
    case Function::remainder: {
      const mpz_class quotient = floor_of(x / function.parameter());
      return x - quotient * function.parameter();
    }
    case Function::table: return function.interpolation().at(x);
    default: return std::nullopt;
  }
}

}  // namespace

Function measured(int degree) {
  std::vector<mpq_class> x = {-6, -4, -1, mpq_class(-1, 3), 0, mpq_class(1, 7), 2, 5, 9};
  std::vector<mpq_class> y = {1, -1, mpq_class(1, 2), 3, mpq_class(-2, 3),
                              0, 4,  mpq_class(7, 2), -2};
  const auto made = Interpolation::through(std::move(x), std::move(y), degree);
  return Function::through("measured.csv", made.value());
}

std::vector<Function> tested_functions() {
  std::vector<Function> all(all_functions.begin(), all_functions.end());
  for (const mpq_class& exponent : {mpq_class(1, 3), mpq_class(12, 5), mpq_class(5, 11),
                                    mpq_class(-1), mpq_class(-1, 2), mpq_class(17)}) {
    all.push_back(Function::power_of(exponent));
  }
  for (const int degree : {1, 2, 3}) all.push_back(measured(degree));
  return all;
}

Function parsed_formula(const std::string& expression) {
  const Graph graph = graph_of(expression, "0");
  std::vector<Node> nodes(graph.nodes().begin(), graph.nodes().begin() + graph.f() + 1);
  return Function::of_formula({.nodes = std::move(nodes)});
}

std::vector<Function> tested_formulas() {
  return {parsed_formula("1 / (1 + exp(-x))"), parsed_formula("x * exp(-x^2 / 2) + cos(x)^2"),
          parsed_formula("sqrt(2 + sin(x)) - 1 / (x^2 + 3)^(-0.25)")};
}

Range value_at(const Function& function, const mpq_class& x, int digits) {
  if (const AffineMap& inner = function.inner(); !inner.is_identity()) {
    return value_near(function, {x, x});
  }
  if (const auto rational = rational_value(function, x)) return {*rational, *rational};
  BigFloat argument(std::max<mpfr_prec_t>(2, digits_of(x.get_num()))), value(digits);
  MIXCMP_CHECK(mpfr_set_q(argument.get(), x.get_mpq_t(), MPFR_RNDN) == 0);
  Range range;
  if (function.kind() == Function::formula) {
    const BigFloat near = formula_value(function.expression(), argument, 2 * digits + 200);
    mpfr_set(value.get(), near.get(), MPFR_RNDD);
    range.low = rational(value);
    mpfr_set(value.get(), near.get(), MPFR_RNDU);
    return {range.low, rational(value)};
  }
  apply(function, value.get(), argument, MPFR_RNDD);
  range.low = rational(value);
  apply(function, value.get(), argument, MPFR_RNDU);
  range.high = rational(value);
  return range;
}

Range value_near(const Function& function, const Range& x) {
  if (const AffineMap& inner = function.inner(); !inner.is_identity()) {
    const mpq_class unit = power_of_two(-300);
    const Range mapped = inner.of(x);
    return value_near(function.outer(),
                      {floor_of(mapped.low / unit) * unit, ceiling_of(mapped.high / unit) * unit});
  }
  if (x.low == x.high) return value_at(function, x.low);
  MIXCMP_CHECK(x.high - x.low < power_of_two(-200));
  const mpq_class most_change = (x.high - x.low) * power_of_two(40);
  Range near = value_at(function, x.low);
  near.low -= most_change;
  near.high += most_change;
  return near;
}

}  // namespace mixcmp::test
