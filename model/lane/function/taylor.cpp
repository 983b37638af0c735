#include "model/lane/function/taylor.hpp"

#include <utility>

#include "model/base/common/check.hpp"

namespace mixcmp::function {
namespace {

using Series = std::vector<Interval>;
using Evaluate = int (*)(mpfi_ptr, mpfi_srcptr);

Interval apply(Evaluate evaluate, const Interval& x) {
  Interval y;
  evaluate(y.get(), x.get());
  return y;
}

/// The k-th coefficient of a product.
Interval coefficient(const Series& a, const Series& b, std::size_t k) {
  Interval sum = 0;
  for (std::size_t i = 0; i <= k; ++i) sum = sum + a[i] * b[k - i];
  return sum;
}

/// Of y with y' = rate y.
Series exponential(Interval first, const Interval& rate, int count) {
  Series y = {std::move(first)};
  for (int k = 1; k < count; ++k) y.push_back(rate * y.back() / Interval(k));
  return y;
}

/// Of y with y' = scale / x.
Series logarithm(Interval first, const Interval& x, const Interval& scale, int count) {
  Series y = {std::move(first)};
  Interval power = scale / x;  // +- scale / x^k
  for (int k = 1; k < count; ++k) {
    y.push_back(power / Interval(k));
    power = Interval(0) - power / x;
  }
  return y;
}

/// Of y with y'' = sign y.
Series oscillation(Interval first, Interval slope, int sign, int count) {
  Series y = {std::move(first), std::move(slope)};
  for (int k = 2; k < count; ++k) {
    y.push_back(Interval(sign) * y[static_cast<std::size_t>(k) - 2] / Interval(k * (k - 1)));
  }
  y.resize(static_cast<std::size_t>(count));
  return y;
}

/// Of y with y' = 1 + sign y^2.
Series tangent(Interval first, int sign, int count) {
  Series y = {std::move(first)};
  for (int k = 1; k < count; ++k) {
    const Interval square = coefficient(y, y, static_cast<std::size_t>(k) - 1);
    y.push_back((Interval(k == 1 ? 1 : 0) + Interval(sign) * square) / Interval(k));
  }
  return y;
}

/// Of atan: y' = 1 / (1 + x^2).
Series arc_tangent(const Interval& x, int count) {
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
  Series y = {apply(mpfi_atan, x)};
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

Series taylor(Function function, const Interval& x, int count) {
  MIXCMP_CHECK(count > 0);
  const Interval one = 1;
  switch (function) {
    case Function::exp: return exponential(apply(mpfi_exp, x), one, count);
    case Function::exp2: return exponential(apply(mpfi_exp2, x), log_of_two(), count);
    case Function::expm1: {
      Series y = exponential(apply(mpfi_exp, x), one, count);
      y.front() = apply(mpfi_expm1, x);
      return y;
    }
    case Function::log: return logarithm(apply(mpfi_log, x), x, one, count);
    case Function::log2: return logarithm(apply(mpfi_log2, x), x, one / log_of_two(), count);
    case Function::log1p: return logarithm(apply(mpfi_log1p, x), one + x, one, count);
    case Function::sin: return oscillation(apply(mpfi_sin, x), apply(mpfi_cos, x), -1, count);
    case Function::cos:
      return oscillation(apply(mpfi_cos, x), Interval(0) - apply(mpfi_sin, x), -1, count);
    case Function::tan: return tangent(apply(mpfi_tan, x), 1, count);
    case Function::atan: return arc_tangent(x, count);
    case Function::sinh: return oscillation(apply(mpfi_sinh, x), apply(mpfi_cosh, x), 1, count);
    case Function::cosh: return oscillation(apply(mpfi_cosh, x), apply(mpfi_sinh, x), 1, count);
    case Function::tanh: return tangent(apply(mpfi_tanh, x), -1, count);
  }
  MIXCMP_CHECK(false);
}

Interval value(Function function, const Interval& x) {
  return taylor(function, x, 1).front();
}

}  // namespace mixcmp::function
