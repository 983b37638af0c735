#pragma once

#include <gmpxx.h>

#include <optional>
#include <string_view>

namespace mixcmp::model {

/// Constants longer than this many bits (numerator or denominator) are refused: no format holds
/// them, and exact arithmetic on them would only cost memory.
constexpr std::size_t max_constant_bits = 1 << 17;
bool is_too_long(const mpq_class& value);

/// The exact value of an unsigned decimal ("12", "0.1", ".5e-3") or C hex-float ("0x1.8p-3", also
/// without exponent) that fills `text`; none if it is neither, or longer than max_constant_bits.
std::optional<mpq_class> parse_literal(std::string_view text);
/// Reads a literal with an optional leading sign.
std::optional<mpq_class> parse_signed_literal(std::string_view text);

}  // namespace mixcmp::model
