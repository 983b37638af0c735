#pragma once

#include <gmpxx.h>

#include "model/format/float_format.hpp"

/// Exact arithmetic with binary fractions, for making data.
namespace mixcmp::model {

mpz_class shifted_left(const mpz_class& value, int count);
/// 2^exponent; zero for a negative exponent.
mpz_class power_of_two(int exponent);
/// The largest multiple of 2^quantum_bits that is not above `value` >= 0.
mpz_class quantized(const mpz_class& value, int quantum_bits);
/// The number of binary digits of |value|; 1 for zero.
int digits_of(const mpz_class& value);
/// The square root rounded down; value >= 0.
mpz_class root_of(const mpz_class& value);
/// To `precision` digits, ties to even, exponents unbounded.
mpz_class rounded(const mpz_class& value, int precision, Rounding rounding);

/// value * 2^exponent.
mpq_class scaled(mpq_class value, int exponent);
/// The square root of value >= 0, to `digits` digits or more, rounded down.
mpq_class root_of(const mpq_class& value, int digits);

}  // namespace mixcmp::model
