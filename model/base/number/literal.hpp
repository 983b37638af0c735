#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <string_view>

namespace mixcmp::inline number {

/// An unsigned decimal ("12", "0.1", ".5e-3") or C hex-float ("0x1.8p-3", also without exponent) as
/// written: the number digits * radix^exponent.
struct Literal {
  std::string digits;  ///< without the point; at least one
  int base = 10;       ///< base of the digits: 10 or 16
  int radix = 10;      ///< base of the exponent: 10, or 2 for hexadecimal digits
  long exponent = 0;   ///< clamped to about +-2^48, which no digits in memory offset
};

/// Reads a literal that fills `text`; none if it is malformed.
std::optional<Literal> read_literal(std::string_view text);

/// radix^exponent for exponent >= 0.
mpz_class power_of(int radix, long exponent);

/// Constants longer than this many bits (numerator or denominator) are refused: no format holds
/// them, and exact arithmetic on them would only cost memory.
constexpr std::size_t max_constant_bits = 1 << 17;
bool is_too_long(const mpq_class& value);

/// The exact value of a literal that fills `text`; none if it is malformed or longer than
/// max_constant_bits.
std::optional<mpq_class> parse_literal(std::string_view text);
/// Reads a literal with an optional leading sign.
std::optional<mpq_class> parse_signed_literal(std::string_view text);
/// Whether `text` is a literal with an optional leading sign, however long its value is.
bool is_signed_literal(std::string_view text);

}  // namespace mixcmp::inline number
