#pragma once

#include <gmpxx.h>

#include "model/base/number/float_format.hpp"

/// Exact arithmetic with powers of two.
namespace mixcmp::inline number {

/// Whether a canonical rational is 2^k for an integer k: 1/4, 1, 1024, ...
bool is_power_of_two(const mpq_class& value);

mpq_class power_of_two(long exponent);
/// value * 2^exponent.
mpq_class scaled(mpq_class value, long exponent);

/// floor(log2 value), value > 0.
long floor_log2(const mpq_class& value);
/// The place of the last binary digit of a dyadic number other than 0: the value is an odd multiple
/// of 2^place.
long lowest_digit(const mpq_class& value);
/// floor(log2 (numerator / denominator)) for positive operands with any common factors.
long floor_log2(const mpz_class& numerator, const mpz_class& denominator);

mpz_class floor_of(const mpq_class& value);
mpz_class ceiling_of(const mpq_class& value);

/// value * 2^count, count >= 0.
mpz_class shifted_left(const mpz_class& value, long count);
/// The largest multiple of 2^quantum_bits that is at most `value` >= 0.
mpz_class quantized(const mpz_class& value, int quantum_bits);
/// The number of binary digits of |value|; 1 for zero.
int digits_of(const mpz_class& value);
/// The square root rounded down; value >= 0.
mpz_class root_of(const mpz_class& value);
/// `value` rounded to `precision` digits (to nearest: ties to even), exponents unbounded.
mpz_class rounded(const mpz_class& value, int precision, Rounding rounding);

/// The square root of value >= 0, rounded down to at least `digits` digits.
mpq_class root_of(const mpq_class& value, int digits);
/// The square root of value >= 0, rounded up to at least `digits` digits.
mpq_class root_above(const mpq_class& value, int digits);

}  // namespace mixcmp::inline number
