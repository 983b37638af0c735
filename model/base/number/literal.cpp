#include "model/base/number/literal.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace mixcmp::inline number {
namespace {

bool is_digit_of(int base, char c) {
  const bool decimal = '0' <= c && c <= '9';
  const bool letter = ('a' <= c && c <= 'f') || ('A' <= c && c <= 'F');
  return decimal || (base == 16 && letter);
}

/// Removes the digits at the front of `text` and returns them.
std::string_view take_digits(std::string_view& text, int base) {
  const auto other = [base](char c) { return !is_digit_of(base, c); };
  const auto end = std::find_if(text.begin(), text.end(), other);
  const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(digits.size());
  return digits;
}

/// Removes the first character of `text` if it is one of these two, and tells whether it was.
bool take_either(std::string_view& text, char one, char other) {
  if (!text.starts_with(one) && !text.starts_with(other)) return false;
  text.remove_prefix(1);
  return true;
}

/// Reads the digits and sign of an exponent, without its letter; none if they do not fill `text`.
std::optional<long> read_exponent(std::string_view text) {
  constexpr long most = 1L << 48;
  const bool negative = text.starts_with('-');
  take_either(text, '+', '-');
  const std::string_view digits = take_digits(text, 10);
  if (digits.empty() || !text.empty()) return std::nullopt;
  long magnitude = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), magnitude);
  const bool beyond = read.ec == std::errc::result_out_of_range || magnitude > most;
  if (beyond) magnitude = most;
  return negative ? -magnitude : magnitude;
}

}  // namespace

std::optional<Literal> read_literal(std::string_view text) {
  Literal literal;
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) {
    text.remove_prefix(2);
    literal.base = 16;
    literal.radix = 2;
  }
  literal.digits = take_digits(text, literal.base);
  std::string_view fraction;
  if (take_either(text, '.', '.')) fraction = take_digits(text, literal.base);
  literal.digits += fraction;
  if (literal.digits.empty()) return std::nullopt;
  literal.exponent = static_cast<long>(fraction.size()) * (hexadecimal ? -4 : -1);
  if (text.empty()) return literal;
  if (!take_either(text, hexadecimal ? 'p' : 'e', hexadecimal ? 'P' : 'E')) return std::nullopt;
  const std::optional<long> exponent = read_exponent(text);
  if (!exponent) return std::nullopt;
  literal.exponent += *exponent;
  return literal;
}

mpz_class power_of(int radix, long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), static_cast<unsigned long>(radix),
                static_cast<unsigned long>(exponent));
  return power;
}

bool is_too_long(const mpq_class& value) {
  return mpz_sizeinbase(value.get_num_mpz_t(), 2) > max_constant_bits ||
         mpz_sizeinbase(value.get_den_mpz_t(), 2) > max_constant_bits;
}

std::optional<mpq_class> parse_literal(std::string_view text) {
  const std::optional<Literal> literal = read_literal(text);
  constexpr auto most = static_cast<long>(max_constant_bits);
  if (!literal || literal->digits.size() > max_constant_bits) return std::nullopt;
  // The point may have moved the exponent by as many places as there are digits.
  if (std::abs(literal->exponent) > 5 * most) return std::nullopt;
  const mpz_class digits(literal->digits, literal->base);
  const mpz_class power = power_of(literal->radix, std::abs(literal->exponent));
  mpq_class value = literal->exponent < 0 ? mpq_class(digits, power) : mpq_class(digits * power);
  value.canonicalize();
  if (is_too_long(value)) return std::nullopt;
  return value;
}

bool is_signed_literal(std::string_view text) {
  take_either(text, '-', '+');
  return read_literal(text).has_value();
}

std::optional<mpq_class> parse_signed_literal(std::string_view text) {
  const bool negative = text.starts_with('-');
  take_either(text, '-', '+');
  std::optional<mpq_class> value = parse_literal(text);
  if (value && negative) *value = -*value;
  return value;
}

}  // namespace mixcmp::inline number
