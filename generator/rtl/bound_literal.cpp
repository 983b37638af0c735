#include "generator/rtl/bound_literal.hpp"

#include "model/common/check.hpp"

namespace mixcmp::gen {
namespace {

using model::Bits;
using model::BoundFormat;

mpq_class scaled(const mpq_class& value, long power) {
  mpq_class result;
  if (power >= 0) {
    mpq_mul_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<unsigned long>(power));
  } else {
    mpq_div_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<unsigned long>(-power));
  }
  return result;
}

/// floor(log2 value), value > 0: the lengths of its parts are at most one off.
long exponent_of(const mpq_class& value) {
  const long guess = static_cast<long>(mpz_sizeinbase(value.get_num_mpz_t(), 2)) -
                     static_cast<long>(mpz_sizeinbase(value.get_den_mpz_t(), 2));
  return scaled(value, -guess) < 1 ? guess - 1 : guess;
}

mpz_class rounded_up(const mpq_class& value) {
  mpz_class quotient;
  mpz_cdiv_q(quotient.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
  return quotient;
}

/// Below 2^114: in two halves.
Bits to_bits(const mpz_class& value) {
  const mpz_class upper = value >> 64;
  const mpz_class lower = value - (upper << 64);
  return Bits{upper.get_ui()} << 64 | lower.get_ui();
}

}  // namespace

Bits bound_literal(BoundFormat format, const mpq_class& value) {
  MIXCMP_CHECK(value >= 0);
  if (value == 0) return 0;
  const long exponent = exponent_of(value);
  const long field = exponent + format.bias();
  if (field < 1) return format.smallest();
  if (field >= (1L << format.exponent_bits) - 1) return format.infinity();
  // From 1 to all ones, or one more: that is the next power of two, at last infinity.
  const mpz_class significand = rounded_up(scaled(value, format.precision - 1 - exponent));
  const Bits below_field = Bits(field - 1) << (format.precision - 1);
  return below_field + to_bits(significand);
}

}  // namespace mixcmp::gen
