#include "model/lane/function/series.hpp"

#include <algorithm>
#include <utility>

namespace mixcmp::function {
namespace {

/// The coefficient of h^k of a product, without the terms of the first `skipped` coefficients of a.
/// Reads no coefficients of a above k, and none of b above k - skipped.
Interval product_coefficient(const Series& a, const Series& b, std::size_t k,
                             std::size_t skipped = 0) {
  Interval sum = 0, term;
  for (std::size_t i = skipped; i <= k; ++i) {
    if (mpfi_is_zero(a[i].get()) > 0 || mpfi_is_zero(b[k - i].get()) > 0) continue;
    mpfi_mul(term.get(), a[i].get(), b[k - i].get());
    mpfi_add(sum.get(), sum.get(), term.get());
  }
  return sum;
}

/// h a', whose coefficients are k a[k].
Series grown(const Series& a) {
  Series y = constant(0, a.size());
  for (std::size_t k = 1; k < a.size(); ++k) y[k] = Interval(static_cast<int>(k)) * a[k];
  return y;
}

bool is_line(const Series& u) {
  return u.size() <= 2 || std::all_of(u.begin() + 2, u.end(), [](const Interval& each) {
           return mpfi_is_zero(each.get()) > 0;
         });
}

}  // namespace

Series constant(const Interval& value, std::size_t count) {
  Series y(count, 0);
  y.front() = value;
  return y;
}

Series line(const Interval& x, const Interval& slope, std::size_t count) {
  Series y = constant(x, count);
  if (count > 1) y[1] = slope;
  return y;
}

Series sum(const Series& a, const Series& b) {
  Series y;
  for (std::size_t k = 0; k < a.size(); ++k) y.push_back(a[k] + b[k]);
  return y;
}

Series difference(const Series& a, const Series& b) {
  Series y;
  for (std::size_t k = 0; k < a.size(); ++k) y.push_back(a[k] - b[k]);
  return y;
}

Series multiple(const Interval& factor, const Series& a) {
  Series y;
  for (const Interval& each : a) y.push_back(factor * each);
  return y;
}

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

/// y b = a.
Series quotient(const Series& a, const Series& b) {
  Series y;
  for (std::size_t k = 0; k < a.size(); ++k) {
    y.emplace_back(0);
    y.back() = (a[k] - product_coefficient(b, y, k, 1)) / b.front();
  }
  return y;
}

Series composed(const Series& f, const Series& u) {
  const std::size_t count = u.size();
  if (is_line(u)) {
    Series y = f;
    Interval power = 1;
    for (std::size_t k = 1; k < count; ++k) {
      power = power * u[1];
      y[k] = y[k] * power;
    }
    return y;
  }
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

Series exponential(const Interval& first, const Interval& rate, const Series& u) {
  const Series growth = multiple(rate, grown(u));
  Series y = constant(first, u.size());
  for (std::size_t k = 1; k < y.size(); ++k) {
    y[k] = product_coefficient(growth, y, k, 1) / Interval(static_cast<int>(k));
  }
  return y;
}

Series integral_of_quotient(const Interval& first, const Series& a, const Series& b) {
  // h y' b = h a'
  Series growth = quotient(grown(a), b);
  for (std::size_t k = 1; k < growth.size(); ++k) {
    growth[k] = growth[k] / Interval(static_cast<int>(k));
  }
  growth.front() = first;
  return growth;
}

Series oscillation(const Interval& first, const Interval& slope, int sign, const Series& u) {
  const Series growth = grown(u);
  Series y = constant(first, u.size()), slopes = constant(slope, u.size());
  for (std::size_t k = 1; k < y.size(); ++k) {
    const Interval divisor(static_cast<int>(k));
    y[k] = product_coefficient(growth, slopes, k, 1) / divisor;
    slopes[k] = Interval(sign) * product_coefficient(growth, y, k, 1) / divisor;
  }
  return y;
}

Series tangent(const Interval& first, int sign, const Series& u) {
  const Series growth = grown(u);
  Series y = constant(first, u.size()), slopes = constant(0, u.size());
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (k > 0) {
      y[k] = product_coefficient(growth, slopes, k, 1) / Interval(static_cast<int>(k));
    }
    slopes[k] = Interval(k == 0 ? 1 : 0) + Interval(sign) * product_coefficient(y, y, k);
  }
  return y;
}

}  // namespace mixcmp::function
