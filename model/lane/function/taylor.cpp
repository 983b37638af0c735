#include "model/lane/function/taylor.hpp"

#include "model/base/common/check.hpp"

namespace mixcmp::function {
namespace {

using Series = std::vector<Interval>;

/// The k-th coefficient of a product.
Interval coefficient(const Series& a, const Series& b, std::size_t k) {
  Interval sum = 0;
  for (std::size_t i = 0; i <= k; ++i) sum = sum + a[i] * b[k - i];
  return sum;
}

/// The series of y, where y' = rate y.
Series exponential(const Interval& first, const Interval& rate, int count) {
  Series y = {first};
  for (int k = 1; k < count; ++k) y.push_back(rate * y.back() / Interval(k));
  return y;
}

/// The series of y, where y' = scale / x. It has no bound where x has no logarithm; scale / x may
/// have one there.
Series logarithm(const Interval& first, const Interval& x, const Interval& scale, int count) {
  if (!first.is_bounded()) return Series(static_cast<std::size_t>(count), first);
  Series y = {first};
  Interval power = scale / x;  // +- scale / x^k
  for (int k = 1; k < count; ++k) {
    y.push_back(power / Interval(k));
    power = Interval(0) - power / x;
  }
  return y;
}

/// The series of y, where y'' = sign y.
Series oscillation(const Interval& first, const Interval& slope, int sign, int count) {
  Series y = {first, slope};
  for (int k = 2; k < count; ++k) {
    y.push_back(Interval(sign) * y[static_cast<std::size_t>(k) - 2] / Interval(k * (k - 1)));
  }
  y.resize(static_cast<std::size_t>(count));
  return y;
}

/// The series of y, where y' = 1 + sign y^2.
Series tangent(const Interval& first, int sign, int count) {
  Series y = {first};
  for (int k = 1; k < count; ++k) {
    const Interval square = coefficient(y, y, static_cast<std::size_t>(k) - 1);
    y.push_back((Interval(k == 1 ? 1 : 0) + Interval(sign) * square) / Interval(k));
  }
  return y;
}

/// The series of atan, where y' = 1 / (1 + x^2).
Series arc_tangent(const Interval& first, const Interval& x, int count) {
  Interval square;
  mpfi_sqr(square.get(), x.get());
  const Interval divisor = Interval(1) + square, twice = Interval(2) * x;
  Series rate = {Interval(1) / divisor};  // (divisor + twice h + h^2) rate = 1
  for (int k = 1; k < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    Interval rest = twice * rate[at - 1];
    if (k > 1) rest = rest + rate[at - 2];
    rate.push_back(Interval(0) - rest / divisor);
  }
  Series y = {first};
  for (int k = 1; k < count; ++k) {
    y.push_back(rate[static_cast<std::size_t>(k) - 1] / Interval(k));
  }
  return y;
}

Interval log_of_two() {
  Interval constant;
  mpfi_const_log2(constant.get());
  return constant;
}

}  // namespace

std::vector<Interval> taylor(Function function, const Interval& x, int count) {
  MIXCMP_CHECK(count > 0);
  const Interval one = 1, first = value(function, x);
  switch (function) {
    case Function::exp: return exponential(first, one, count);
    case Function::exp2: return exponential(first, log_of_two(), count);
    case Function::expm1: {
      Series y = exponential(value(Function::exp, x), one, count);
      y.front() = first;
      return y;
    }
    case Function::log: return logarithm(first, x, one, count);
    case Function::log2: return logarithm(first, x, one / log_of_two(), count);
    case Function::log1p: return logarithm(first, one + x, one, count);
    case Function::sin: return oscillation(first, value(Function::cos, x), -1, count);
    case Function::cos: return oscillation(first, Interval(0) - value(Function::sin, x), -1, count);
    case Function::tan: return tangent(first, 1, count);
    case Function::atan: return arc_tangent(first, x, count);
    case Function::sinh: return oscillation(first, value(Function::cosh, x), 1, count);
    case Function::cosh: return oscillation(first, value(Function::sinh, x), 1, count);
    case Function::tanh: return tangent(first, -1, count);
  }
  MIXCMP_CHECK(false);
}

std::vector<Interval> taylor(Function function, const Interval& x, int count,
                             const mpq_class& slope) {
  std::vector<Interval> series = taylor(function, x, count);
  if (slope == 1) return series;
  const Interval factor(slope);
  Interval power = 1;
  for (Interval& coefficient : series) {
    coefficient = coefficient * power;
    power = power * factor;
  }
  return series;
}

void enclose(Function function, mpfi_ptr y, mpfi_srcptr x) {
  switch (function) {
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
  }
  MIXCMP_CHECK(false);
}

Interval value(Function function, const Interval& x) {
  Interval y;
  enclose(function, y.get(), x.get());
  return y;
}

}  // namespace mixcmp::function
