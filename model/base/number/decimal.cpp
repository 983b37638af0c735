#include "model/base/number/decimal.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/base/number/literal.hpp"

namespace mixcmp::inline number {
namespace {

/// A number above 2^beyond_all_formats is infinite in every format, and one below its reciprocal
/// is zero.
constexpr long beyond_all_formats = 1 << 20;

Bits round_literal(FloatFormat format, const Literal& literal) {
  mpz_class numerator(literal.digits, literal.base), denominator = 1;
  if (numerator == 0) return format.zero(false);
  const double logarithm =
      digits_of(numerator) + std::log2(literal.radix) * static_cast<double>(literal.exponent);
  if (logarithm > beyond_all_formats) return format.beyond_largest(false);
  if (logarithm < -beyond_all_formats) return format.zero(false);
  (literal.exponent > 0 ? numerator : denominator) *=
      power_of(literal.radix, std::abs(literal.exponent));
  return from_ratio(format, numerator, denominator);
}

/// Significant decimal digits d1 d2 d3 ... of the number 0.d1d2d3... * 10^exponent.
struct Decimal {
  std::string digits;
  long exponent;
};

mpq_class times_power_of_ten(const mpq_class& value, long exponent) {
  const mpz_class power = power_of(10, std::abs(exponent));
  return exponent >= 0 ? mpq_class(value * power) : mpq_class(value / power);
}

/// The exponent of 0.d1d2d3..., d1 not zero: floor(log10 value) + 1.
long decimal_exponent(const mpq_class& value) {
  auto exponent =
      static_cast<long>(std::floor(static_cast<double>(floor_log2(value)) * std::log10(2)));
  while (times_power_of_ten(value, -exponent) >= 1) ++exponent;
  return exponent;
}

enum class DecimalRounding { nearest_even, up };

Decimal to_decimal(const mpq_class& value, long exponent, int digit_count,
                   DecimalRounding rounding) {
  const mpq_class shifted = times_power_of_ten(value, digit_count - exponent);
  mpz_class digits = floor_of(shifted);
  const mpq_class rest = shifted - digits;
  const int half = cmp(rest, mpq_class(1, 2));
  const bool odd = mpz_odd_p(digits.get_mpz_t()) != 0;
  const bool nearest_is_above = half > 0 || (half == 0 && odd);
  if (rounding == DecimalRounding::up ? rest > 0 : nearest_is_above) ++digits;
  const std::string text = digits.get_str();
  // A carry may have made one digit more.
  return {text, exponent + static_cast<long>(text.size()) - digit_count};
}

Bits round_decimal(FloatFormat format, const Decimal& decimal) {
  const long exponent = decimal.exponent - static_cast<long>(decimal.digits.size());
  return round_literal(format, {.digits = decimal.digits, .exponent = exponent});
}

/// Below a power of two the encodings are twice as dense. So the decimal nearest to it may read
/// back as its lower neighbour although the next decimal above reads back as the power of two. Both
/// are tried.
Decimal shortest_decimal(FloatFormat format, Bits magnitude) {
  const mpq_class value = to_rational(format, magnitude);
  const long exponent = decimal_exponent(value);
  constexpr int enough = 36;  // ceil(1 + 113 log10(2)): any number of 113 digits reads back
  for (int digit_count = 1; digit_count <= enough; ++digit_count) {
    for (const DecimalRounding rounding : {DecimalRounding::nearest_even, DecimalRounding::up}) {
      Decimal decimal = to_decimal(value, exponent, digit_count, rounding);
      if (round_decimal(format, decimal) == magnitude) return decimal;
    }
  }
  MIXCMP_CHECK(!"a decimal of 36 digits reads back");
}

/// Prints a decimal in plain notation if its exponent is small, else in scientific notation.
std::string print(const Decimal& decimal) {
  constexpr long plain_low = -4, plain_high = 17;
  std::string digits = decimal.digits.substr(0, decimal.digits.find_last_not_of('0') + 1);
  if (decimal.exponent < plain_low || decimal.exponent > plain_high) {
    const std::string_view point = digits.size() > 1 ? "." : "";
    return fmt::format("{}{}{}e{}", digits[0], point, digits.substr(1), decimal.exponent - 1);
  }
  if (decimal.exponent <= 0) return fmt::format("0.{:0<{}}{}", "", -decimal.exponent, digits);
  const auto whole = static_cast<std::size_t>(decimal.exponent);
  if (digits.size() <= whole) return fmt::format("{:0<{}}", digits, whole);
  return fmt::format("{}.{}", digits.substr(0, whole), digits.substr(whole));
}

/// Whether `text` is the word, in letters of either case.
bool is_word(std::string_view text, std::string_view word) {
  return std::equal(text.begin(), text.end(), word.begin(), word.end(), [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == b;
  });
}

}  // namespace

Result<Bits> from_text(FloatFormat format, std::string_view text) {
  std::string_view rest = text;
  const bool negative = rest.starts_with('-');
  if (negative || rest.starts_with('+')) rest.remove_prefix(1);
  if (is_word(rest, "inf") || is_word(rest, "infinity")) return format.beyond_largest(negative);
  if (is_word(rest, "nan")) return format.quiet_nan();
  if (const std::optional<Literal> literal = read_literal(rest)) {
    return with_sign(format, negative, round_literal(format, *literal));
  }
  return Error{
      .message = "not a number",
      .received = fmt::format("\"{}\"", text),
      .accepted =
          "a decimal number (12.5, -1e-7), a hexadecimal one (0x1.8p3), inf, infinity or nan"};
}

std::string to_text(FloatFormat format, Bits bits) {
  if (format.is_nan(bits)) return "nan";
  const std::string sign = format.sign(bits) ? "-" : "";
  if (format.is_infinite(bits)) return sign + "inf";
  if (format.is_zero(bits)) return sign + "0";
  return sign + print(shortest_decimal(format, format.magnitude(bits)));
}

}  // namespace mixcmp::inline number
