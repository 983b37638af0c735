#include "model/judge/golden/arithmetic.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "model/comparison/expression/typed_graph.hpp"
#include "model/judge/golden/encoding.hpp"

namespace mixcmp::golden {
namespace {

/// MPFR numbers that outlive a call, so that an operation allocates nothing.
struct Scratch {
  BigFloat a{encoding_precision};
  BigFloat b{encoding_precision};
  BigFloat y{encoding_precision};
};

Scratch& scratch() {
  thread_local Scratch numbers;
  return numbers;
}

mpfr_rnd_t mpfr_rounding(Rounding rounding) {
  switch (rounding) {
    case Rounding::nearest_even: return MPFR_RNDN;
    case Rounding::toward_zero: return MPFR_RNDZ;
  }
  MIXCMP_CHECK(false);
}

/// Sets x to the operand as an operation reads it; returns whether it makes the result exceptional.
bool load(BigFloat& x, FloatFormat format, Subnormals subnormals, Bits bits) {
  const bool flushed = subnormals == Subnormals::flush && format.is_subnormal(bits);
  decode(x, format, flushed ? format.zero(format.sign(bits)) : bits);
  return flushed || !mpfr_number_p(x.get());
}

/// Brings `y`, rounded to the format's precision with this ternary value and below the normal
/// range, into the format.
Rounded underflow(const Arithmetic& result, BigFloat& y, int ternary) {
  const FloatFormat format = result.format;
  const bool negative = mpfr_signbit(y.get()) != 0;
  if (result.subnormals == Subnormals::flush) return {format.zero(negative), true};
  // MPFR's significands are in [1/2, 1): its exponents are one above ours.
  const ExponentRange range(format.min_exponent() - format.fraction_bits() + 1,
                            format.max_exponent() + 1);
  const mpfr_rnd_t rounding = mpfr_rounding(result.rounding);
  ternary = mpfr_check_range(y.get(), ternary, rounding);
  ternary = mpfr_subnormalize(y.get(), ternary, rounding);
  return {encode(format, y), ternary != 0};
}

Bits overflow(const Arithmetic& result, bool negative) {
  switch (result.rounding) {
    case Rounding::nearest_even: return result.format.infinity(negative);
    case Rounding::toward_zero: return result.format.largest_finite(negative);
  }
  MIXCMP_CHECK(false);
}

/// Brings `y`, rounded once to the format's precision in MPFR's wide exponent range, into the
/// format's own range.
Rounded fit(const Arithmetic& result, BigFloat& y, int ternary) {
  const FloatFormat format = result.format;
  const bool negative = mpfr_signbit(y.get()) != 0;
  if (mpfr_nan_p(y.get())) return {format.quiet_nan(), true};
  if (mpfr_inf_p(y.get())) return {format.infinity(negative), true};
  if (mpfr_zero_p(y.get())) return {format.zero(negative), false};
  const mpfr_exp_t exponent = mpfr_get_exp(y.get()) - 1;
  if (exponent > format.max_exponent()) return {overflow(result, negative), true};
  if (exponent < format.min_exponent()) return underflow(result, y, ternary);
  return {encode(format, y), false};
}

/// `operate` writes y from a in the given rounding and returns the ternary value.
template <class Operate>
Rounded apply_unary(const Arithmetic& result, FloatFormat operands, Bits a, Operate operate) {
  Scratch& numbers = scratch();
  const bool exceptional = load(numbers.a, operands, result.subnormals, a);
  numbers.y.reset(result.format.precision());
  const int ternary = operate(numbers.y.get(), numbers.a.get(), mpfr_rounding(result.rounding));
  Rounded rounded = fit(result, numbers.y, ternary);
  rounded.exceptional |= exceptional;
  return rounded;
}

/// `operate` writes y from a and b, as in apply_unary.
template <class Operate>
Rounded apply_binary(const Arithmetic& result, FloatFormat operands, Bits a, Bits b,
                     Operate operate) {
  BigFloat& second = scratch().b;
  const bool exceptional = load(second, operands, result.subnormals, b);
  Rounded rounded =
      apply_unary(result, operands, a, [&](mpfr_ptr y, mpfr_srcptr first, mpfr_rnd_t rounding) {
        return operate(y, first, second.get(), rounding);
      });
  rounded.exceptional |= exceptional;
  return rounded;
}

/// MPFR's own minimum and maximum ignore a NaN beside a number; IEEE 754-2019's do not.
template <class Operate>
Rounded choose(const Arithmetic& result, Bits a, Bits b, Operate operate) {
  return apply_binary(result, result.format, a, b,
                      [&](mpfr_ptr y, mpfr_srcptr first, mpfr_srcptr second, mpfr_rnd_t rounding) {
                        if (!mpfr_unordered_p(first, second)) {
                          return operate(y, first, second, rounding);
                        }
                        mpfr_set_nan(y);
                        return 0;
                      });
}

/// A precision that holds a product of two significands, or a sum of cut terms.
constexpr mpfr_prec_t product_precision = 2 * encoding_precision;

/// A term of a fused sum as a number.
struct Term {
  BigFloat value{product_precision};
  mpfr_exp_t exponent = 0;  ///< sum of its factors' exponents; if it is finite and not 0
  bool exceptional = false;

  bool is_zero() const { return mpfr_zero_p(value.get()) != 0; }
  bool is_negative() const { return mpfr_signbit(value.get()) != 0; }
};

Term term_of(const Arithmetic& result, FloatFormat operands, const FusedOperands& term) {
  BigFloat &a = scratch().a, &b = scratch().b;
  Term made;
  made.exceptional = load(a, operands, result.subnormals, term.a);
  made.exceptional |= load(b, operands, result.subnormals, term.b);
  mpfr_mul(made.value.get(), a.get(), b.get(), MPFR_RNDN);  // exact
  if (term.negated) mpfr_neg(made.value.get(), made.value.get(), MPFR_RNDN);
  if (mpfr_regular_p(made.value.get())) {
    // MPFR's significands are in [1/2, 1): its exponents are one above ours.
    made.exponent = mpfr_get_exp(a.get()) + mpfr_get_exp(b.get()) - 2;
  }
  return made;
}

/// The exponent of the last digit that terms keep.
mpfr_exp_t cut_exponent(const Arithmetic& result, const std::vector<Term>& terms) {
  std::optional<mpfr_exp_t> largest;
  if (result.subnormals == Subnormals::gradual) largest = result.format.min_exponent();
  for (const Term& term : terms) {
    if (term.is_zero()) continue;
    largest = largest ? std::max(*largest, term.exponent) : term.exponent;
  }
  return largest.value_or(0) - result.format.precision() - fused_guard_digits(terms.size());
}

/// The sum of the terms, each cut to a multiple of 2^exponent.
BigFloat sum_of_cut(const std::vector<Term>& terms, mpfr_exp_t exponent) {
  BigFloat sum(product_precision), cut(product_precision);
  mpfr_set_zero(sum.get(), 1);
  for (const Term& term : terms) {
    mpfr_mul_2si(cut.get(), term.value.get(), -exponent, MPFR_RNDN);
    mpfr_rint_trunc(cut.get(), cut.get(), MPFR_RNDN);
    const int ternary = mpfr_add(sum.get(), sum.get(), cut.get(), MPFR_RNDN);
    MIXCMP_CHECK(ternary == 0);
  }
  mpfr_mul_2si(sum.get(), sum.get(), exponent, MPFR_RNDN);
  return sum;
}

std::vector<Term> terms_of(const Arithmetic& result, FloatFormat operands,
                           std::span<const FusedOperands> terms) {
  MIXCMP_CHECK(terms.size() >= 2);
  std::vector<Term> values;
  for (const FusedOperands& term : terms) values.push_back(term_of(result, operands, term));
  return values;
}

}  // namespace

Rounded fused_sum(const Arithmetic& result, FloatFormat operands,
                  std::span<const FusedOperands> terms) {
  const std::vector<Term> values = terms_of(result, operands, terms);
  const bool exceptional =
      std::any_of(values.begin(), values.end(), [](const Term& term) { return term.exceptional; });
  const BigFloat sum = sum_of_cut(values, cut_exponent(result, values));
  if (mpfr_zero_p(sum.get())) {
    const bool negative = std::all_of(values.begin(), values.end(),
                                      [](const Term& term) { return term.is_negative(); });
    return {result.format.zero(negative), exceptional};
  }
  BigFloat y(result.format.precision());
  const int ternary = mpfr_set(y.get(), sum.get(), mpfr_rounding(result.rounding));
  Rounded rounded = fit(result, y, ternary);
  rounded.exceptional |= exceptional;
  return rounded;
}

Verdict fused_comparison(const Arithmetic& arithmetic, FloatFormat operands,
                         std::span<const FusedOperands> terms) {
  const std::vector<Term> values = terms_of(arithmetic, operands, terms);
  const BigFloat sum = sum_of_cut(values, cut_exponent(arithmetic, values));
  if (mpfr_nan_p(sum.get()) != 0) return Verdict::unordered;
  const int order = mpfr_sgn(sum.get());
  if (order == 0) return Verdict::equal;
  return order < 0 ? Verdict::less : Verdict::greater;
}

Rounded add(const Arithmetic& result, FloatFormat operands, Bits a, Bits b) {
  return apply_binary(result, operands, a, b, mpfr_add);
}

Rounded subtract(const Arithmetic& result, FloatFormat operands, Bits a, Bits b) {
  return apply_binary(result, operands, a, b, mpfr_sub);
}

Rounded multiply(const Arithmetic& result, FloatFormat operands, Bits a, Bits b) {
  return apply_binary(result, operands, a, b, mpfr_mul);
}

Rounded square(const Arithmetic& result, FloatFormat operands, Bits a) {
  return apply_unary(result, operands, a, mpfr_sqr);
}

Rounded divide(const Arithmetic& result, FloatFormat operands, Bits a, Bits b) {
  return apply_binary(result, operands, a, b, mpfr_div);
}

Rounded square_root(const Arithmetic& result, FloatFormat operands, Bits a) {
  return apply_unary(result, operands, a, mpfr_sqrt);
}

Rounded convert(const Arithmetic& result, FloatFormat operands, Bits a) {
  return apply_unary(result, operands, a, [](mpfr_ptr y, mpfr_srcptr value, mpfr_rnd_t rounding) {
    return mpfr_set(y, value, rounding);
  });
}

Rounded minimum(const Arithmetic& result, Bits a, Bits b) {
  return choose(result, a, b, mpfr_min);
}

Rounded maximum(const Arithmetic& result, Bits a, Bits b) {
  return choose(result, a, b, mpfr_max);
}

Verdict compare(FloatFormat format, Subnormals subnormals, Bits a, Bits b) {
  Scratch& numbers = scratch();
  load(numbers.a, format, subnormals, a);
  load(numbers.b, format, subnormals, b);
  if (mpfr_unordered_p(numbers.a.get(), numbers.b.get())) return Verdict::unordered;
  const int order = mpfr_cmp(numbers.a.get(), numbers.b.get());
  if (order == 0) return Verdict::equal;
  return order < 0 ? Verdict::less : Verdict::greater;
}

Bits from_rational(FloatFormat format, const mpq_class& value) {
  BigFloat& y = scratch().y;
  y.reset(format.precision());
  const int ternary = mpfr_set_q(y.get(), value.get_mpq_t(), MPFR_RNDN);
  return fit({.format = format}, y, ternary).bits;
}

mpq_class to_rational(FloatFormat format, Bits bits) {
  BigFloat& x = scratch().a;
  decode(x, format, bits);
  MIXCMP_CHECK(mpfr_number_p(x.get()));
  mpq_class value;
  mpfr_get_q(value.get_mpq_t(), x.get());
  return value;
}

}  // namespace mixcmp::golden
