#include "model/lane/error/relative_bound.hpp"

#include <algorithm>

#include "model/base/common/check.hpp"

namespace mixcmp::error {
namespace {

/// A rational just below the root (with `up`: just above), off by less than 2^-256 of it.
mpq_class root(const mpq_class& value, int up) {
  const unsigned long shift = 256 + mpz_sizeinbase(value.get_den_mpz_t(), 2);
  const mpz_class scaled = (value.get_num() << (2 * shift)) / value.get_den();
  mpq_class result(sqrt(scaled) + up, mpz_class(1) << shift);
  result.canonicalize();
  return result;
}

long bit_length(const mpz_class& value) {
  return static_cast<long>(mpz_sizeinbase(value.get_mpz_t(), 2));
}

/// `value` rounded down (with `up`: up) to some 512 binary digits if it has more than 1024.
mpq_class shortened(const mpq_class& value, int up) {
  constexpr long short_enough = 1024, kept = 512;
  const mpz_class &num = value.get_num(), &den = value.get_den();
  if (bit_length(num) <= short_enough && bit_length(den) <= short_enough) return value;
  const long shift = kept + bit_length(den) - bit_length(num);
  const mpz_class dividend = shift > 0 ? num << shift : num;
  const mpz_class divisor = shift < 0 ? den << -shift : den;
  mpz_class digits = dividend / divisor + up;
  mpq_class result(digits);
  if (shift > 0) mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), shift);
  if (shift < 0) mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), -shift);
  return result;
}

/// A distance in ulps that no two numbers of any format have.
constexpr Bits unreachable = ~Bits{0};

Bits to_bits(const mpz_class& value) {
  const mpz_class high = value >> 64;
  return Bits{high.get_ui()} << 64 | mpz_class(value - (high << 64)).get_ui();
}

/// The largest ratio that the true values of f and g can have, either way, when their computed
/// values are equal.
mpq_class worst_ratio(const RelativeBound& f, const RelativeBound& g) {
  return std::max<mpq_class>(g.high / f.low, f.high / g.low);
}

}  // namespace

RelativeBound rounding_bound(int precision, Rounding rounding) {
  const mpq_class u(1, mpz_class(1) << precision);
  switch (rounding) {
    case Rounding::nearest_even: return {1 - u, 1 + u};
    case Rounding::toward_zero: return {1, 1 + 2 * u};
  }
  MIXCMP_CHECK(false);
}

RelativeBound product(const RelativeBound& a, const RelativeBound& b) {
  return {a.low * b.low, a.high * b.high};
}

RelativeBound quotient(const RelativeBound& a, const RelativeBound& b) {
  return {a.low / b.high, a.high / b.low};
}

RelativeBound hull(const RelativeBound& a, const RelativeBound& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

bool is_exact(const RelativeBound& bound) {
  return bound.low == 1 && bound.high == 1;
}

RelativeBound square_root(const RelativeBound& a) {
  if (is_exact(a)) return a;
  return {root(a.low, 0), root(a.high, 1)};
}

mpq_class root_below(const mpq_class& value) {
  return root(value, 0);
}

RelativeBound widened(const RelativeBound& bound) {
  return {shortened(bound.low, 0), shortened(bound.high, 1)};
}

mpq_class widened_up(const mpq_class& value) {
  return shortened(value, 1);
}

bool is_useless(const RelativeBound& bound) {
  constexpr long most_doublings = 2L << FloatFormat::max_exponent_bits;
  const auto doublings = [](const mpq_class& value) {
    return std::abs(bit_length(value.get_num()) - bit_length(value.get_den()));
  };
  return std::max(doublings(bound.low), doublings(bound.high)) > most_doublings;
}

Bits guard_ulp(const RelativeBound& f, const RelativeBound& g, int precision) {
  const mpq_class ratio = worst_ratio(f, g);
  return ratio == 1 ? 0 : steps_beyond(ratio, precision);
}

Bits guard_ulp_before_rounding(const RelativeBound& f, const RelativeBound& g, int precision) {
  const mpq_class ratio = worst_ratio(f, g);
  if (ratio == 1) return 1;
  const Bits steps = steps_beyond(ratio, precision);
  return steps == unreachable ? unreachable : steps + 1;
}

Bits steps_beyond(const mpq_class& ratio, int precision) {
  constexpr int most_doublings = 1 << FloatFormat::max_exponent_bits;
  int doublings = 0;
  mpq_class rest = ratio;  // ratio = rest * 2^doublings, 1 <= rest < 2
  for (; rest >= 2; rest /= 2) {
    if (++doublings == most_doublings) return unreachable;
  }
  const mpq_class steps = (1 - 1 / rest) * (mpz_class(1) << precision);
  const mpz_class whole = steps.get_num() / steps.get_den();
  return (Bits(doublings) << (precision - 1)) + to_bits(whole) + 1;
}

}  // namespace mixcmp::error
