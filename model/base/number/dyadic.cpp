#include "model/base/number/dyadic.hpp"

namespace mixcmp::inline number {

bool is_power_of_two(const mpq_class& value) {
  return value > 0 && mpz_popcount(value.get_num_mpz_t()) == 1 &&
         mpz_popcount(value.get_den_mpz_t()) == 1;
}

mpq_class power_of_two(long exponent) {
  return scaled(1, exponent);
}

mpq_class scaled(mpq_class value, long exponent) {
  if (exponent >= 0) {
    mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return value;
}

/// The difference of the operands' lengths is the logarithm or one more.
long floor_log2(const mpz_class& numerator, const mpz_class& denominator) {
  const long estimate = digits_of(numerator) - digits_of(denominator);
  const int order = estimate >= 0 ? cmp(numerator, shifted_left(denominator, estimate))
                                  : cmp(shifted_left(numerator, -estimate), denominator);
  return order < 0 ? estimate - 1 : estimate;
}

long floor_log2(const mpq_class& value) {
  return floor_log2(value.get_num(), value.get_den());
}

long lowest_digit(const mpq_class& value) {
  const auto zeros = [](const mpz_class& number) {
    return static_cast<long>(mpz_scan1(number.get_mpz_t(), 0));
  };
  return zeros(value.get_num()) - zeros(value.get_den());
}

mpz_class floor_of(const mpq_class& value) {
  mpz_class quotient;
  mpz_fdiv_q(quotient.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
  return quotient;
}

mpz_class ceiling_of(const mpq_class& value) {
  mpz_class quotient;
  mpz_cdiv_q(quotient.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
  return quotient;
}

mpz_class shifted_left(const mpz_class& value, long count) {
  mpz_class result;
  mpz_mul_2exp(result.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(count));
  return result;
}

mpz_class quantized(const mpz_class& value, int quantum_bits) {
  mpz_class quanta;
  mpz_tdiv_q_2exp(quanta.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(quantum_bits));
  return shifted_left(quanta, quantum_bits);
}

int digits_of(const mpz_class& value) {
  return static_cast<int>(mpz_sizeinbase(value.get_mpz_t(), 2));
}

mpz_class root_of(const mpz_class& value) {
  mpz_class root;
  mpz_sqrt(root.get_mpz_t(), value.get_mpz_t());
  return root;
}

mpz_class rounded(const mpz_class& value, int precision, Rounding rounding) {
  const int drop = digits_of(value) - precision;
  if (drop <= 0) return value;
  const auto half_place = static_cast<mp_bitcnt_t>(drop - 1);
  mpz_class magnitude = abs(value);  // GMP tests the bits of negative numbers in two's complement
  const bool half = mpz_tstbit(magnitude.get_mpz_t(), half_place) != 0;
  const bool odd = mpz_tstbit(magnitude.get_mpz_t(), half_place + 1) != 0;
  const bool more = mpz_scan1(magnitude.get_mpz_t(), 0) < half_place;
  mpz_tdiv_q_2exp(magnitude.get_mpz_t(), magnitude.get_mpz_t(), half_place + 1);
  if (rounding == Rounding::nearest_even && half && (more || odd)) ++magnitude;
  return shifted_left(value < 0 ? mpz_class(-magnitude) : magnitude, drop);
}

mpq_class root_of(const mpq_class& value, int digits) {
  if (value == 0) return 0;
  const int exponent = digits_of(value.get_num()) - digits_of(value.get_den());
  const int shift = digits + 1 - exponent / 2;
  const mpq_class shifted = scaled(value, 2L * shift);
  return scaled(root_of(mpz_class(shifted.get_num() / shifted.get_den())), -shift);
}

mpq_class root_above(const mpq_class& value, int digits) {
  const mpq_class root = root_of(value, digits);
  return root * root == value ? root : root * (1 + power_of_two(1 - digits));
}

}  // namespace mixcmp::inline number
