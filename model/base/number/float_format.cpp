#include "model/base/number/float_format.hpp"

#include <fmt/core.h>

#include <array>
#include <utility>

#include "model/base/number/whole_number.hpp"

namespace mixcmp::inline number {
namespace {

struct NamedFormat {
  std::string_view name;
  int precision;
  int exponent_bits;
};

constexpr std::array<NamedFormat, 5> named_formats = {{
    {"binary16", 11, 5},
    {"bfloat16", 8, 8},
    {"binary32", 24, 8},
    {"binary64", 53, 11},
    {"binary128", 113, 15},
}};

Error format_error(std::string received) {
  return {.message = "not a floating-point format",
          .received = std::move(received),
          .accepted = FloatFormat::accepted()};
}

}  // namespace

Result<FloatFormat> FloatFormat::make(int precision, int exponent_bits, Specials specials) {
  const bool valid = min_precision <= precision && precision <= max_precision &&
                     min_exponent_bits <= exponent_bits && exponent_bits <= max_exponent_bits;
  if (!valid) return format_error(fmt::format("s{}e{}", precision, exponent_bits));
  return FloatFormat(precision, exponent_bits, specials);
}

std::string FloatFormat::accepted(int least, int most) {
  std::string names;
  for (const NamedFormat& named : named_formats) {
    if (named.precision < least || named.precision > most) continue;
    names += fmt::format("{}{}", names.empty() ? ", or " : ", ", named.name);
  }
  return fmt::format("sPeE with P {}..{} and E {}..{}{}", least, most, min_exponent_bits,
                     max_exponent_bits, names);
}

Result<FloatFormat> FloatFormat::parse(std::string_view text) {
  for (const NamedFormat& named : named_formats) {
    if (text == named.name) return make(named.precision, named.exponent_bits);
  }
  if (text == "E4M3") {
    return Error{.message = "a format of operands only, since it has no infinities",
                 .received = "\"E4M3\"",
                 .accepted = FloatFormat::accepted()};
  }
  const size_t e = text.find('e');
  if (text.empty() || text[0] != 's' || e == std::string_view::npos) {
    return format_error(fmt::format("\"{}\"", text));
  }
  const int precision = whole_number(text.substr(1, e - 1)).value_or(0);
  const int exponent_bits = whole_number(text.substr(e + 1)).value_or(0);
  Result<FloatFormat> format = make(precision, exponent_bits);
  if (!format.ok() || format->name() != text) return format_error(fmt::format("\"{}\"", text));
  return format;
}

std::string FloatFormat::name() const {
  if (!has_infinities()) return fmt::format("E{}M{}", exponent_bits_, fraction_bits());
  return fmt::format("s{}e{}", precision_, exponent_bits_);
}

std::string_view to_string(Rounding rounding) {
  switch (rounding) {
    case Rounding::nearest_even: return "nearest_even";
    case Rounding::toward_zero: return "toward_zero";
  }
  MIXCMP_CHECK(false);
}

std::string_view to_string(Subnormals subnormals) {
  switch (subnormals) {
    case Subnormals::flush: return "flush";
    case Subnormals::gradual: return "gradual";
  }
  MIXCMP_CHECK(false);
}

std::string_view to_string(Sums sums) {
  switch (sums) {
    case Sums::composed: return "composed";
    case Sums::fused: return "fused";
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::inline number
