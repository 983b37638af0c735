#include "model/expression/literal.hpp"

#include <algorithm>
#include <charconv>
#include <string>

namespace mixcmp::model {
namespace {

bool is_digit_of(int base, char c) {
  const bool decimal = '0' <= c && c <= '9';
  const bool letter = ('a' <= c && c <= 'f') || ('A' <= c && c <= 'F');
  return decimal || (base == 16 && letter);
}

/// Takes the digits at the front of `text` away from it.
std::string_view take_digits(std::string_view& text, int base) {
  const auto other = [base](char c) { return !is_digit_of(base, c); };
  const auto end = std::find_if(text.begin(), text.end(), other);
  const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(digits.size());
  return digits;
}

/// The exponent after its letter, which must fill `text`; none if malformed or absurdly large.
std::optional<long> parse_exponent(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  long exponent = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), exponent);
  const bool whole = status == std::errc{} && end == text.data() + text.size();
  constexpr long limit = static_cast<long>(max_constant_bits);
  if (!whole || exponent > limit || exponent < -limit) return std::nullopt;
  return exponent;
}

mpq_class power(unsigned long base, unsigned long exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), base, exponent);
  return mpq_class(result);
}

/// significand * base^exponent.
mpq_class scale(const mpz_class& significand, unsigned long base, long exponent) {
  const mpq_class factor = power(base, static_cast<unsigned long>(std::abs(exponent)));
  return exponent < 0 ? mpq_class(significand / factor) : mpq_class(significand * factor);
}

}  // namespace

bool is_too_long(const mpq_class& value) {
  return mpz_sizeinbase(value.get_num_mpz_t(), 2) > max_constant_bits ||
         mpz_sizeinbase(value.get_den_mpz_t(), 2) > max_constant_bits;
}

std::optional<mpq_class> parse_literal(std::string_view text) {
  const bool hex = text.starts_with("0x") || text.starts_with("0X");
  const int base = hex ? 16 : 10;
  if (hex) text.remove_prefix(2);
  std::string digits(take_digits(text, base));
  std::size_t fraction_digits = 0;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    const std::string_view fraction = take_digits(text, base);
    fraction_digits = fraction.size();
    digits += fraction;
  }
  if (digits.empty() || digits.size() > max_constant_bits) return std::nullopt;
  long exponent = 0;
  if (!text.empty()) {
    const char letter = text[0];
    if (hex ? letter != 'p' && letter != 'P' : letter != 'e' && letter != 'E') return std::nullopt;
    const std::optional<long> written = parse_exponent(text.substr(1));
    if (!written) return std::nullopt;
    exponent = *written;
  }
  const long point = static_cast<long>(fraction_digits) * (hex ? 4 : 1);
  mpq_class value = scale(mpz_class(digits, base), hex ? 2 : 10, exponent - point);
  value.canonicalize();
  if (is_too_long(value)) return std::nullopt;
  return value;
}

std::optional<mpq_class> parse_signed_literal(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  std::optional<mpq_class> value = parse_literal(text);
  if (value && negative) *value = -*value;
  return value;
}

}  // namespace mixcmp::model
