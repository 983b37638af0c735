#pragma once

#include <cmath>
#include <limits>

#include "model/plan/profile/envelope.hpp"

/// Each kernel evaluates one operation of an envelope on a block. In theorem 1 of docs/theory.md,
/// `value` is x, `error` is E, and q is Q, the bound on the error that comes from the operands.
/// Loops are plain for the vectoriser, and conditions use | and &, since || and && would branch.
/// Functions are inlined into functions that are compiled for several instruction sets.
namespace mixcmp::profile::envelope_kernels {

/// Covers the roundings of an error's own computation in double: a few steps of 2^-53.
inline constexpr double outward = 1 + 0x1p-45;
/// Covers products of errors that underflow in double, and stays below 2^-52 of any tame value.
inline constexpr double error_floor = 0x1p-980;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Function>
[[gnu::always_inline]] inline void for_each_lane(Function function) {
  for (std::size_t k = 0; k < envelope_width; ++k) function(k);
}

/// The error after a rounding with relative error `unit`. It takes 2Q instead of Q, since `value`
/// is itself rounded and may lie on the other side of x.
[[gnu::always_inline]] inline double after_rounding(double value, double q, double unit) {
  return (q + unit * (std::fabs(value) + 2 * q)) * outward;
}

[[gnu::always_inline]] inline void sum(NodeEnvelope& y, const NodeEnvelope& a,
                                       const NodeEnvelope& b, double sign, double unit) {
  for_each_lane([&](std::size_t k) {
    const double value = a.value[k] + sign * b.value[k];
    y.value[k] = value;
    y.error[k] = after_rounding(value, a.error[k] + b.error[k], unit);
  });
}

[[gnu::always_inline]] inline void product(NodeEnvelope& y, const NodeEnvelope& a,
                                           const NodeEnvelope& b, double unit) {
  for_each_lane([&](std::size_t k) {
    const double av = std::fabs(a.value[k]), bv = std::fabs(b.value[k]);
    const double ae = a.error[k], be = b.error[k];
    const double value = a.value[k] * b.value[k];
    const double error = after_rounding(value, (av + ae) * be + (bv + be) * ae, unit) + error_floor;
    const bool zero = (av + ae == 0) | (bv + be == 0);
    y.value[k] = value;
    y.error[k] = zero ? 0 * error : error;
  });
}

[[gnu::always_inline]] inline void square(NodeEnvelope& y, const NodeEnvelope& a, double unit) {
  for_each_lane([&](std::size_t k) {
    const double magnitude = std::fabs(a.value[k]), error_in = a.error[k];
    const double value = a.value[k] * a.value[k];
    const double error =
        after_rounding(value, 2 * (magnitude + error_in) * error_in, unit) + error_floor;
    y.value[k] = value;
    y.error[k] = magnitude + error_in == 0 ? 0 : error;
  });
}

[[gnu::always_inline]] inline void quotient(NodeEnvelope& y, const NodeEnvelope& a,
                                            const NodeEnvelope& b, double unit) {
  for_each_lane([&](std::size_t k) {
    const double least = (std::fabs(b.value[k]) - 1.5 * b.error[k]) * (1 - 0x1p-50);
    const double largest = std::fabs(a.value[k]) + a.error[k];
    const double q = (a.error[k] + largest / least * b.error[k]) / least;
    const double value = a.value[k] / b.value[k];
    const double error = after_rounding(value, q, unit) + error_floor;
    const double inside = largest == 0 ? 0 : error;
    y.value[k] = value;
    y.error[k] = least > 0 ? inside : infinity;
  });
}

[[gnu::always_inline]] inline void root(NodeEnvelope& y, const NodeEnvelope& a, double unit) {
  for_each_lane([&](std::size_t k) {
    const double x = a.value[k], error_in = a.error[k];
    const double value = std::sqrt(x);
    const double least = std::sqrt((x - 0.5 * error_in) * (1 - 0x1p-50));
    const double error = after_rounding(value, error_in / least, unit) + error_floor;
    const double outside = ((x == 0) & (error_in == 0)) ? 0 : infinity;
    y.value[k] = value;
    y.error[k] = x - 1.5 * error_in > 0 ? error : outside;
  });
}

[[gnu::always_inline]] inline void selection(NodeEnvelope& y, const NodeEnvelope& a,
                                             const NodeEnvelope& b, bool larger) {
  for_each_lane([&](std::size_t k) {
    const double av = a.value[k], bv = b.value[k];
    const double ae = a.error[k], be = b.error[k];
    y.value[k] = (av < bv) != larger ? av : bv;
    // The last term is 0, or NaN if one of them is not finite: a comparison would lose that.
    y.error[k] = (ae < be ? be : ae) + 0 * (ae + be);
  });
}

[[gnu::always_inline]] inline void converted(NodeEnvelope& y, const NodeEnvelope& a, double unit) {
  for_each_lane([&](std::size_t k) {
    y.value[k] = a.value[k];
    y.error[k] = after_rounding(a.value[k], a.error[k], unit);
  });
}

[[gnu::always_inline]] inline void negated(NodeEnvelope& y, const NodeEnvelope& a) {
  for_each_lane([&](std::size_t k) { y.value[k] = -a.value[k]; });
  y.error = a.error;
}

[[gnu::always_inline]] inline void magnitude(NodeEnvelope& y, const NodeEnvelope& a) {
  for_each_lane([&](std::size_t k) { y.value[k] = std::fabs(a.value[k]); });
  y.error = a.error;
}

}  // namespace mixcmp::profile::envelope_kernels
