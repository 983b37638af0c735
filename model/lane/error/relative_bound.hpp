#pragma once

#include <gmpxx.h>

#include "model/base/number/float_format.hpp"

namespace mixcmp::error {

/// States that true value = computed value * t with 0 < low <= t <= high, if no operation on the
/// way was exceptional. Bounds are exact rationals; only square roots and bounds with very many
/// digits are rounded, outward. Theorem numbers: docs/error_bounds.md.
struct RelativeBound {
  mpq_class low = 1;
  mpq_class high = 1;
};

bool is_exact(const RelativeBound& bound);
/// The bound of one rounding that is not exceptional (theorem 1).
RelativeBound rounding_bound(int precision, Rounding rounding);
RelativeBound product(const RelativeBound& a, const RelativeBound& b);
RelativeBound quotient(const RelativeBound& a, const RelativeBound& b);
RelativeBound hull(const RelativeBound& a, const RelativeBound& b);
RelativeBound square_root(const RelativeBound& a);
/// A rational just below the root, off by less than 2^-256 of it.
mpq_class root_below(const mpq_class& value);

/// `bound` rounded outward, and `value` rounded up, to some 512 binary digits if there are more
/// than 1024, so that repeated products do not grow without limit.
RelativeBound widened(const RelativeBound& bound);
mpq_class widened_up(const mpq_class& value);
/// Whether a bound is useless: it allows a ratio beyond that of any two numbers of any format.
bool is_useless(const RelativeBound& bound);

/// The smallest distance of f and g in ulps that decides, from their bounds in this precision
/// (theorem 3); 0 if both are exact.
Bits guard_ulp(const RelativeBound& f, const RelativeBound& g, int precision);

/// The smallest deciding distance in ulps, from the bounds of f and g before their last rounding.
/// Rounding is monotone, so the last roundings of f and g together cost a single step (theorem 4).
Bits guard_ulp_before_rounding(const RelativeBound& f, const RelativeBound& g, int precision);

/// The smallest n such that a step of n encodings up from any positive number of this precision
/// multiplies it by more than `ratio` >= 1 (theorem 2); all ones if no format has so many
/// encodings.
Bits steps_beyond(const mpq_class& ratio, int precision);

}  // namespace mixcmp::error
