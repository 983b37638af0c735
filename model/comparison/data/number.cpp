#include "model/comparison/data/number.hpp"

#include <fmt/core.h>

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
  if (format.is_infinite(*bits) && !number.ends_with("inf")) {
    return Error{.message = fmt::format("beyond the largest number of {}", format.name()),
                 .received = in_quotes(number),
                 .accepted = "a smaller number, or a format with more exponent bits"};
  }
  return bits;
}

Result<Bits> read_number(FloatFormat format, std::optional<FloatFormat> rounded_to,
                         std::string_view text) {
  MIXCMP_TRY(bits, read_number(rounded_to.value_or(format), text));
  return rounded_to ? converted(format, *rounded_to, bits) : bits;
}

}  // namespace mixcmp::data
