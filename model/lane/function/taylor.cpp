#include "model/lane/function/taylor.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/common/memo.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/lane/function/formula_series.hpp"

namespace mixcmp::function {
namespace {

bool is_whole(const mpq_class& number) {
  return number.get_den() == 1;
}

/// x^exponent for a number x, 0 or more unless the exponent is an integer.
void raise(mpfr_ptr y, mpfr_srcptr x, const mpq_class& exponent, mpfr_rnd_t rounding) {
  if (is_whole(exponent)) {
    mpfr_pow_z(y, x, exponent.get_num_mpz_t(), rounding);
    return;
  }
  const bool divides = exponent < 0;
  const mpz_class power = abs(exponent.get_num());
  const mpfr_rnd_t rounded = divides == (rounding == MPFR_RNDU) ? MPFR_RNDD : MPFR_RNDU;
  mpfr_pow_z(y, x, power.get_mpz_t(), rounded);
  mpfr_rootn_ui(y, y, exponent.get_den().get_ui(), rounded);
  if (divides) mpfr_ui_div(y, 1, y, rounding);
}

/// x^exponent for every x of the interval; that of 0 for those below 0 unless the exponent is an
/// integer.
void enclose_power(mpfi_ptr y, mpfi_srcptr x, const mpq_class& exponent) {
  const bool is_integer = is_whole(exponent);
  const bool is_even = is_integer && mpz_even_p(exponent.get_num_mpz_t()) != 0;
  if (exponent < 0 && mpfi_has_zero(x) > 0) {
    mpfi_set_str(y, "[-inf, inf]", 10);
    return;
  }
  mpfi_t base;
  mpfi_init2(base, mpfi_get_prec(x));
  if (is_even) {
    mpfi_abs(base, x);
  } else {
    mpfi_set(base, x);
  }
  for (mpfr_ptr end : {&base->left, &base->right}) {
    if (!is_integer && mpfr_sgn(end) < 0) mpfr_set_zero(end, 1);
  }
  const bool falls = exponent < 0;
  raise(&y->left, falls ? &base->right : &base->left, exponent, MPFR_RNDD);
  raise(&y->right, falls ? &base->left : &base->right, exponent, MPFR_RNDU);
  mpfi_clear(base);
}

/// The series of (x + h)^exponent, by the binomial one.
Series binomial(const Interval& x, const mpq_class& exponent, std::size_t count) {
  const bool is_below = !is_whole(exponent) && mpfr_sgn(&x.get()->right) < 0;
  Series y;
  mpq_class factor = is_below ? 0 : 1;  // that of x^(exponent - k)
  for (std::size_t k = 0; k < count; ++k) {
    const mpq_class left = exponent - static_cast<int>(k);
    y.push_back(factor == 0 ? Interval(0) : Interval(factor) * value(Function::power_of(left), x));
    factor *= left / (static_cast<int>(k) + 1);
  }
  return y;
}

/// floor(x / divisor) if it is the same for all x of the interval.
std::optional<mpz_class> one_quotient(mpfi_srcptr x, const mpq_class& divisor) {
  if (!is_bounded(x)) return std::nullopt;
  const Range range = range_of(x);
  const mpz_class least = floor_of(range.low / divisor), most = floor_of(range.high / divisor);
  return least == most ? std::optional(least) : std::nullopt;
}

void enclose_remainder(mpfi_ptr y, mpfi_srcptr x, const mpq_class& divisor) {
  if (const auto quotient = one_quotient(x, divisor)) {
    const mpq_class multiple = *quotient * divisor;
    mpfi_sub_q(y, x, multiple.get_mpq_t());
  } else {
    mpfi_interv_q(y, mpq_class(0).get_mpq_t(), divisor.get_mpq_t());
  }
}

void enclose_sign(mpfi_ptr y, mpfi_srcptr x) {
  const int least = mpfr_sgn(&x->left) < 0 ? -1 : 1, most = mpfr_sgn(&x->right) < 0 ? -1 : 1;
  mpfi_interv_si(y, least, most);
}

/// The series of a function that is a line between its jumps. An interval that holds a jump has no
/// bounded slopes.
Series between_jumps(const Interval& first, bool jumps, int slope, std::size_t count) {
  Series y = line(first, slope, count);
  for (std::size_t k = 1; jumps && k < y.size(); ++k) y[k] = Interval::unbounded();
  return y;
}

/// Encloses p^(k)(t) / k! of a polynomial, by Horner's rule.
Range derived(const std::vector<mpq_class>& polynomial, std::size_t k, const Range& t) {
  Range all = {0, 0};
  for (std::size_t i = polynomial.size(); i-- > k;) {
    mpz_class choices;
    mpz_bin_uiui(choices.get_mpz_t(), i, k);
    const mpq_class factor = choices * polynomial[i];
    all = sum(product(all, t), {factor, factor});
  }
  return all;
}

/// Encloses the k-th Taylor coefficient of an interpolation. Beyond its ends it is constant.
Range coefficient(const Interpolation& table, mpfi_srcptr x, std::size_t k) {
  const std::vector<mpq_class>& knots = table.knots();
  const auto is_below = [](mpfr_srcptr number, const mpq_class& knot) {
    return mpfr_cmp_q(number, knot.get_mpq_t()) < 0;
  };
  const auto is_above = [](mpfr_srcptr number, const mpq_class& knot) {
    return mpfr_cmp_q(number, knot.get_mpq_t()) > 0;
  };
  std::optional<Range> all;
  const auto include = [&](const Range& found) {
    all = all ? Range{std::min(all->low, found.low), std::max(all->high, found.high)} : found;
  };
  const auto include_constant = [&](const mpq_class& knot) {
    const mpq_class value = k == 0 ? table.at(knot) : mpq_class(0);
    include({value, value});
  };
  if (is_below(&x->left, knots.front())) include_constant(knots.front());
  if (is_above(&x->right, knots.back())) include_constant(knots.back());
  if (is_below(&x->right, knots.front()) || is_above(&x->left, knots.back())) return *all;
  const Range inside = {is_below(&x->left, knots.front()) ? knots.front() : rational(&x->left, -1),
                        is_above(&x->right, knots.back()) ? knots.back() : rational(&x->right, 1)};
  const std::size_t last = table.segment_of(inside.high);
  for (std::size_t segment = table.segment_of(inside.low); segment <= last; ++segment) {
    const mpq_class low = std::max(inside.low, knots[segment]) - knots[segment];
    const mpq_class high = std::min(inside.high, knots[segment + 1]) - knots[segment];
    include(derived(table.polynomial(segment), k, {low, high}));
  }
  return *all;
}

Series polynomials(const Interpolation& table, const Interval& x, std::size_t count) {
  Series y;
  for (std::size_t k = 0; k < count; ++k) {
    y.emplace_back(coefficient(table, x.get(), k));
  }
  return y;
}

/// The series of factor u + offset.
Series mapped(const Series& u, const AffineMap& map) {
  Series y = multiple(Interval(map.factor), u);
  y.front() = y.front() + Interval(map.offset);
  return y;
}

Interval log_of_two() {
  Interval constant;
  mpfi_const_log2(constant.get());
  return constant;
}

/// The series of scale log(u). It has no bound where u has no logarithm; scale u' / u may have one
/// there.
Series logarithm(const Interval& first, const Series& u, const Interval& scale) {
  if (!first.is_bounded()) return Series(u.size(), first);
  return integral_of_quotient(first, multiple(scale, u), u);
}

/// The series around x of a function that formulas do not hold, or of a power.
Series around(const Function& function, const Interval& x, std::size_t count) {
  const Interval first = value(function, x);
  switch (function.kind()) {
    case Function::power: return binomial(x, function.parameter(), count);
    case Function::sign: return between_jumps(first, mpfi_has_zero(first.get()) > 0, 0, count);
    case Function::remainder:
      return between_jumps(first, !one_quotient(x.get(), function.parameter()), 1, count);
    case Function::table: return polynomials(function.interpolation(), x, count);
    default: MIXCMP_CHECK(!"a function of these");
  }
}

}  // namespace

Series taylor(const Function& function, const Series& argument) {
  if (!function.inner().is_identity()) {
    return taylor(function.outer(), mapped(argument, function.inner()));
  }
  const Series& u = argument;
  const Interval& x = u.front();
  const Interval first = value(function, x), one = 1;
  switch (function.kind()) {
    case Function::exp: return exponential(first, one, u);
    case Function::exp2: return exponential(first, log_of_two(), u);
    case Function::expm1: {
      Series y = exponential(value(Function::exp, x), one, u);
      y.front() = first;
      return y;
    }
    case Function::log: return logarithm(first, u, one);
    case Function::log2: return logarithm(first, u, one / log_of_two());
    case Function::log1p: return logarithm(first, sum(u, constant(one, u.size())), one);
    case Function::sin: return oscillation(first, value(Function::cos, x), -1, u);
    case Function::cos: return oscillation(first, Interval(0) - value(Function::sin, x), -1, u);
    case Function::tan: return tangent(first, 1, u);
    case Function::atan:
      return integral_of_quotient(first, u, sum(square(u), constant(one, u.size())));
    case Function::sinh: return oscillation(first, value(Function::cosh, x), 1, u);
    case Function::cosh: return oscillation(first, value(Function::sinh, x), 1, u);
    case Function::tanh: return tangent(first, -1, u);
    case Function::power:
    case Function::sign:
    case Function::remainder:
    case Function::table: return composed(around(function, x, u.size()), u);
    case Function::formula: return taylor(function.expression(), u);
  }
  MIXCMP_CHECK(false);
}

Series taylor(const Function& function, const Interval& x, int count, const mpq_class& slope) {
  MIXCMP_CHECK(count > 0);
  return taylor(function, line(x, slope, static_cast<std::size_t>(count)));
}

namespace {

Series hull_of_parts(const Function& function, const Range& x, int count) {
  constexpr int shares = 128;
  const mpq_class step = (x.high - x.low) / shares;
  Series all;
  for (int part = 0; part < shares; ++part) {
    const Interval where(Range{x.low + step * part, x.low + step * (part + 1)});
    Series series = taylor(function, where, count);
    for (std::size_t k = 0; k < all.size(); ++k) {
      mpfi_union(series[k].get(), series[k].get(), all[k].get());
    }
    all = std::move(series);
  }
  return all;
}

}  // namespace

Series taylor_on(const Function& function, const Range& x, int count) {
  if (function.kind() != Function::formula || x.low == x.high) {
    return taylor(function, Interval(x), count);
  }
  using Key = std::tuple<Function, std::string, std::string, int>;
  static Memo<Key, Series> known;
  const Key key{function, x.low.get_str(62), x.high.get_str(62), count};
  return *known.of(key, [&] { return hull_of_parts(function, x, count); });
}

void enclose(const Function& function, mpfi_ptr y, mpfi_srcptr x) {
  if (const AffineMap& inner = function.inner(); !inner.is_identity()) {
    mpfi_mul_q(y, x, inner.factor.get_mpq_t());
    mpfi_add_q(y, y, inner.offset.get_mpq_t());
    return enclose(function.outer(), y, y);
  }
  switch (function.kind()) {
    case Function::exp: mpfi_exp(y, x); return;
    case Function::exp2: mpfi_exp2(y, x); return;
    case Function::expm1: mpfi_expm1(y, x); return;
    case Function::log: mpfi_log(y, x); return;
    case Function::log2: mpfi_log2(y, x); return;
    case Function::log1p: mpfi_log1p(y, x); return;
    case Function::sin: mpfi_sin(y, x); return;
    case Function::cos: mpfi_cos(y, x); return;
    case Function::tan: mpfi_tan(y, x); return;
    case Function::atan: mpfi_atan(y, x); return;
    case Function::sinh: mpfi_sinh(y, x); return;
    case Function::cosh: mpfi_cosh(y, x); return;
    case Function::tanh: mpfi_tanh(y, x); return;
    case Function::power: enclose_power(y, x, function.parameter()); return;
    case Function::sign: enclose_sign(y, x); return;
    case Function::remainder: enclose_remainder(y, x, function.parameter()); return;
    case Function::table: {
      const Range values = coefficient(function.interpolation(), x, 0);
      mpfi_interv_q(y, values.low.get_mpq_t(), values.high.get_mpq_t());
      return;
    }
    case Function::formula: {
      Interval argument;
      mpfi_set(argument.get(), x);
      mpfi_set(y, value(function.expression(), argument).get());
      return;
    }
  }
  MIXCMP_CHECK(false);
}

Interval value(const Function& function, const Interval& x) {
  Interval y;
  enclose(function, y.get(), x.get());
  return y;
}

Interval value_on(const Function& function, const Range& x) {
  return taylor_on(function, x, 1).front();
}

}  // namespace mixcmp::function
