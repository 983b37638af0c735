#include "model/judge/golden/separation.hpp"

#include <algorithm>

namespace mixcmp::golden {
namespace {

constexpr std::int64_t limit = std::int64_t{1} << 40;
/// (2^20 - 1) 2^40 still fits an int64_t; precision runs out long before.
constexpr std::size_t most_roots = 20;

bool is_zero(const Separation& value) {
  return value.bounded && value.numerator_bits == 0;
}

Separation checked(Separation value) {
  value.bounded = value.bounded && value.numerator_bits < limit && value.denominator_bits < limit &&
                  value.exponent < limit && value.exponent > -limit;
  return value.bounded ? value : no_separation();
}

/// The parts of a separation that every value computed from two operands inherits: the roots, and
/// whether it is bounded.
Separation joined(const Separation& a, const Separation& b) {
  Separation joined{.bounded = a.bounded && b.bounded, .roots = a.roots};
  joined.roots.insert(b.roots.begin(), b.roots.end());
  return joined;
}

/// The least number of bits, and no less than `least`, with |n| <= 2^bits.
std::int64_t bits_of(const mpz_class& n, std::int64_t least) {
  if (abs(n) == 1) return least;
  return static_cast<std::int64_t>(mpz_sizeinbase(n.get_mpz_t(), 2));
}

/// Divides a number that is not zero by the largest power of two in it; returns its exponent.
std::int64_t take_powers_of_two(mpz_class& n) {
  const mp_bitcnt_t zeros = mpz_scan1(n.get_mpz_t(), 0);
  mpz_tdiv_q_2exp(n.get_mpz_t(), n.get_mpz_t(), zeros);
  return static_cast<std::int64_t>(zeros);
}

}  // namespace

std::optional<std::int64_t> Separation::least_exponent() const {
  if (!bounded || roots.size() > most_roots) return std::nullopt;
  const std::int64_t conjugates = std::int64_t{1} << roots.size();
  return exponent - denominator_bits - (conjugates - 1) * numerator_bits;
}

Separation no_separation() {
  return {.bounded = false, .numerator_bits = 1, .roots = {}};
}

Separation separation_of(const BigFloat& number) {
  if (mpfr_zero_p(number.get())) return {};
  const auto bits = static_cast<std::int64_t>(mpfr_min_prec(number.get()));
  return checked(
      {.numerator_bits = bits, .exponent = mpfr_get_exp(number.get()) - bits, .roots = {}});
}

Separation separation_of(const mpq_class& number) {
  if (number == 0) return {};
  mpz_class numerator = number.get_num(), denominator = number.get_den();
  const std::int64_t exponent = take_powers_of_two(numerator) - take_powers_of_two(denominator);
  return checked({.numerator_bits = bits_of(numerator, 1),
                  .denominator_bits = bits_of(denominator, 0),
                  .exponent = exponent,
                  .roots = {}});
}

Separation separation_of_sum(const Separation& a, const Separation& b) {
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  Separation sum = joined(a, b);
  sum.exponent = std::min(a.exponent, b.exponent);
  sum.numerator_bits = 1 +
                       std::max(a.numerator_bits + b.denominator_bits + a.exponent,
                                b.numerator_bits + a.denominator_bits + b.exponent) -
                       sum.exponent;
  sum.denominator_bits = a.denominator_bits + b.denominator_bits;
  return checked(std::move(sum));
}

Separation separation_of_product(const Separation& a, const Separation& b) {
  if (is_zero(a) || is_zero(b)) return {};
  Separation product = joined(a, b);
  product.exponent = a.exponent + b.exponent;
  product.numerator_bits = a.numerator_bits + b.numerator_bits;
  product.denominator_bits = a.denominator_bits + b.denominator_bits;
  return checked(std::move(product));
}

Separation separation_of_quotient(const Separation& a, const Separation& b) {
  if (is_zero(a)) return {};
  Separation quotient = joined(a, b);
  quotient.exponent = a.exponent - b.exponent;
  quotient.numerator_bits = a.numerator_bits + b.denominator_bits;
  quotient.denominator_bits = a.denominator_bits + b.numerator_bits;
  return checked(std::move(quotient));
}

/// sqrt(2^e U/L) = 2^(e'/2) sqrt(2^(e - e') U L) / L, where e' is e or e - 1, an even number.
Separation separation_of_root(const Separation& radicand, NodeId id) {
  if (is_zero(radicand)) return {};
  Separation root = radicand;
  const std::int64_t odd = radicand.exponent & 1;
  root.exponent = (radicand.exponent - odd) / 2;
  root.numerator_bits = (radicand.numerator_bits + radicand.denominator_bits + odd + 1) / 2;
  root.roots.insert(id);
  return checked(std::move(root));
}

Separation separation_of_either(const Separation& a, const Separation& b) {
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  Separation either = joined(a, b);
  either.exponent = std::min(a.exponent, b.exponent);
  either.numerator_bits =
      std::max(a.numerator_bits + a.exponent, b.numerator_bits + b.exponent) - either.exponent;
  either.denominator_bits = std::max(a.denominator_bits, b.denominator_bits);
  return checked(std::move(either));
}

}  // namespace mixcmp::golden
