#include "model/comparison/data/number.hpp"

#include <fmt/core.h>

#include <cmath>

#include "model/base/common/quote.hpp"
#include "model/base/number/decimal.hpp"
#include "model/base/number/exact.hpp"

namespace mixcmp::data {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

Result<Bits> read_number(FloatFormat format, std::string_view text) {
  const std::string_view number = trimmed(text);
  Result<Bits> bits = from_text(format, number);
  if (!bits.ok()) {
    Error error = bits.error();
    error.received = in_quotes(text);
    return error;
  }
  const bool has_digits = number.find_first_of("0123456789") != std::string_view::npos;
  if (format.is_infinite(*bits) && has_digits) {
    return Error{.message = fmt::format("beyond the largest number of {}", format.name()),
                 .received = in_quotes(number),
                 .accepted = "a smaller number, or a format with more exponent bits"};
  }
  return bits;
}

bool is_lost(FloatFormat format, std::string_view text, Bits number) {
  std::string_view digits = trimmed(text);
  if (digits.starts_with('-') || digits.starts_with('+')) digits.remove_prefix(1);
  if (format.is_nan(number)) return !digits.starts_with('n') && !digits.starts_with('N');
  if (format.is_zero(number)) {
    const bool is_hex = digits.starts_with("0x") || digits.starts_with("0X");
    if (is_hex) digits.remove_prefix(2);
    const std::string_view significand =
        digits.substr(0, digits.find_first_of(is_hex ? "pP" : "eE"));
    return significand.find_first_not_of("0.") != std::string_view::npos;
  }
  const double kept_digits = (format.precision() - 1) * std::log10(2.0);
  if (static_cast<double>(digits.size()) <= kept_digits) return false;
  const std::size_t point = digits.find('.');
  if (point != std::string_view::npos && digits.find_first_not_of('0', point + 1) == digits.npos) {
    digits = digits.substr(0, point);
  }
  if (digits.empty() || digits.find_first_not_of("0123456789") != digits.npos) return false;
  return to_rational(format, format.magnitude(number)) != mpz_class(std::string(digits), 10);
}

}  // namespace mixcmp::data
