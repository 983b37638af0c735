#pragma once

#include <gmpxx.h>

#include <span>

#include "model/base/number/float_format.hpp"
#include "model/base/number/verdict.hpp"

/// The golden model's arithmetic: packed operands in, correctly rounded packed results out, by
/// MPFR. It shares these rules, and nothing else, with rtl_templates/fp:
/// - NaN results are FloatFormat::quiet_nan(); x - x is +0; zero signs as IEEE 754.
/// - Subnormals::flush reads a subnormal operand as a zero of its sign and replaces a non-zero
///   result by a zero of its sign when, rounded to P digits with unbounded exponent, it is below
///   2^min_exponent.
/// - Overflow gives infinity when rounding to nearest, the largest finite number toward zero.
namespace mixcmp::golden {

struct Rounded {
  Bits bits;
  /// The result's relative error may exceed half an ulp (one ulp toward zero), or it is not finite:
  /// an operand is NaN or infinite; the result is NaN, infinite or overflowed; an operand was
  /// flushed; or the exact result is non-zero and, rounded to P digits with unbounded exponent,
  /// below 2^min_exponent, and (`flush`, or `gradual` and inexact).
  bool exceptional;

  friend bool operator==(const Rounded&, const Rounded&) = default;
};

/// Functions of two operands take both in format `operands` and round once to `result`.
Rounded add(const Arithmetic& result, FloatFormat operands, Bits a, Bits b);
Rounded subtract(const Arithmetic& result, FloatFormat operands, Bits a, Bits b);
Rounded multiply(const Arithmetic& result, FloatFormat operands, Bits a, Bits b);
Rounded square(const Arithmetic& result, FloatFormat operands, Bits a);
Rounded divide(const Arithmetic& result, FloatFormat operands, Bits a, Bits b);
Rounded square_root(const Arithmetic& result, FloatFormat operands, Bits a);
Rounded convert(const Arithmetic& result, FloatFormat operands, Bits a);

/// One term of a fused sum: a * b, or -(a * b). A term without a factor b has b = 1.
struct FusedOperands {
  Bits a;
  Bits b;
  bool negated = false;
};

/// A sum of two or more terms, rounded once. A term's exponent is the sum of its factors'
/// exponents. E is the largest exponent of a term that is not zero; with gradual underflow it is at
/// least min_exponent. Each term is cut toward zero to a multiple of 2^(E - P -
/// fused_guard_digits). The cut terms are added exactly, and that sum is rounded; `exceptional`
/// refers to it. A zero is negative if all terms are negative, zeros included.
Rounded fused_sum(const Arithmetic& result, FloatFormat operands,
                  std::span<const FusedOperands> terms);

/// The order of zero and a sum of terms cut as in fused_sum; the sum is not rounded. Unordered if a
/// term is a NaN or if infinities have unlike signs.
Verdict fused_comparison(const Arithmetic& arithmetic, FloatFormat operands,
                         std::span<const FusedOperands> terms);

/// IEEE 754-2019 minimum and maximum, operands and result in one format.
Rounded minimum(const Arithmetic& result, Bits a, Bits b);
Rounded maximum(const Arithmetic& result, Bits a, Bits b);

/// -0 equals +0; `flush` compares subnormals as zeros.
Verdict compare(FloatFormat format, Subnormals subnormals, Bits a, Bits b);

/// An exact rational rounded to nearest, ties to even, gradual subnormals.
Bits from_rational(FloatFormat format, const mpq_class& value);
/// The exact value of a finite encoding.
mpq_class to_rational(FloatFormat format, Bits bits);

}  // namespace mixcmp::golden
