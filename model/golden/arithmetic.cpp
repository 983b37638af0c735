#include "model/golden/arithmetic.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "model/golden/encoding.hpp"

namespace mixcmp::model::golden {
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

/// Sets x to the value an operation sees; says whether the operand makes the result exceptional.
bool load(BigFloat& x, FloatFormat format, Subnormals subnormals, Bits bits) {
  const bool flushed = subnormals == Subnormals::flush && format.is_subnormal(bits);
  decode(x, format, flushed ? format.zero(format.sign(bits)) : bits);
  return flushed || !mpfr_number_p(x.get());
}

/// `y`, rounded to the precision with the given ternary value, is below the normal range.
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

constexpr std::string_view accepted_text =
    "a decimal number (12.5, -1e-7), a hexadecimal one (0x1.8p3), inf or nan";

bool is_digit(char c, int base) {
  const char lower = static_cast<char>(c | 0x20);
  return ('0' <= c && c <= '9') || (base == 16 && 'a' <= lower && lower <= 'f');
}

/// Drops the digits that `text` begins with; returns how many there were.
size_t skip_digits(std::string_view& text, int base) {
  const auto end =
      std::find_if_not(text.begin(), text.end(), [base](char c) { return is_digit(c, base); });
  const auto count = static_cast<size_t>(end - text.begin());
  text.remove_prefix(count);
  return count;
}

bool skip_any_of(std::string_view& text, std::string_view characters) {
  if (text.empty() || characters.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

/// Digits with at most one point and an optional exponent, without sign or prefix; MPFR alone
/// would also take bases, "@" and blanks.
bool is_unsigned_number(std::string_view text, int base) {
  size_t digits = skip_digits(text, base);
  if (skip_any_of(text, ".")) digits += skip_digits(text, base);
  if (digits == 0) return false;
  if (!skip_any_of(text, base == 16 ? "pP" : "eE")) return text.empty();
  skip_any_of(text, "+-");
  return skip_digits(text, 10) > 0 && text.empty();
}

Bits round_text(FloatFormat format, const std::string& digits, int base) {
  BigFloat& y = scratch().y;
  y.reset(format.precision());
  const int ternary = mpfr_strtofr(y.get(), digits.c_str(), nullptr, base, MPFR_RNDN);
  return fit({.format = format}, y, ternary).bits;
}

/// Significant decimal digits d1 d2 d3 ... of the number 0.d1d2d3... * 10^exponent.
struct Decimal {
  std::string digits;
  mpfr_exp_t exponent;
};

Decimal to_decimal(const BigFloat& magnitude, size_t digit_count, mpfr_rnd_t rounding) {
  Decimal decimal;
  const std::unique_ptr<char, void (*)(char*)> digits(
      mpfr_get_str(nullptr, &decimal.exponent, 10, digit_count, magnitude.get(), rounding),
      mpfr_free_str);
  decimal.digits = digits.get();
  return decimal;
}

/// Below a power of two the encodings lie twice as dense, so that the decimal nearest to it may
/// read back as its lower neighbour where one above reads back well: both are tried.
Decimal shortest_decimal(FloatFormat format, Bits magnitude) {
  BigFloat value(encoding_precision);
  decode(value, format, magnitude);
  for (size_t digit_count = 1;; ++digit_count) {
    for (const mpfr_rnd_t rounding : {MPFR_RNDN, MPFR_RNDU}) {
      Decimal decimal = to_decimal(value, digit_count, rounding);
      const std::string text = fmt::format("0.{}e{}", decimal.digits, decimal.exponent);
      if (round_text(format, text, 10) == magnitude) return decimal;
    }
  }
}

/// Plain for exponents that read well, scientific beyond.
std::string print(const Decimal& decimal) {
  constexpr mpfr_exp_t plain_low = -4, plain_high = 17;
  std::string digits = decimal.digits.substr(0, decimal.digits.find_last_not_of('0') + 1);
  if (decimal.exponent < plain_low || decimal.exponent > plain_high) {
    const std::string_view point = digits.size() > 1 ? "." : "";
    return fmt::format("{}{}{}e{}", digits[0], point, digits.substr(1), decimal.exponent - 1);
  }
  if (decimal.exponent <= 0) return fmt::format("0.{:0<{}}{}", "", -decimal.exponent, digits);
  const auto whole = static_cast<size_t>(decimal.exponent);
  if (digits.size() <= whole) return fmt::format("{:0<{}}", digits, whole);
  return fmt::format("{}.{}", digits.substr(0, whole), digits.substr(whole));
}

}  // namespace

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::less: return "less";
    case Verdict::equal: return "equal";
    case Verdict::greater: return "greater";
    case Verdict::unordered: return "unordered";
  }
  MIXCMP_CHECK(false);
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

Result<Bits> from_text(FloatFormat format, std::string_view text) {
  std::string_view rest = text;
  const bool negative = rest.starts_with('-');
  skip_any_of(rest, "+-");
  const Bits sign = format.zero(negative);
  if (rest == "inf") return sign | format.infinity(false);
  if (rest == "nan") return format.quiet_nan();
  const int base = rest.starts_with("0x") || rest.starts_with("0X") ? 16 : 10;
  if (base == 16) rest.remove_prefix(2);
  if (!is_unsigned_number(rest, base)) {
    return Error{.message = "not a number",
                 .received = fmt::format("\"{}\"", text),
                 .accepted = std::string(accepted_text)};
  }
  return sign | round_text(format, std::string(rest), base);
}

std::string to_text(FloatFormat format, Bits bits) {
  if (format.is_nan(bits)) return "nan";
  const std::string sign = format.sign(bits) ? "-" : "";
  if (format.is_infinite(bits)) return sign + "inf";
  if (format.is_zero(bits)) return sign + "0";
  return sign + print(shortest_decimal(format, format.magnitude(bits)));
}

}  // namespace mixcmp::model::golden
