#include "model/base/number/float_format.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "model/base/number/whole_number.hpp"

namespace mixcmp::inline number {
namespace {

struct NamedFormat {
  std::string_view name;
  int precision;
  int exponent_bits;
  std::array<std::string_view, 4> elsewhere;  ///< names that languages and libraries have for it
};

constexpr std::array<NamedFormat, 5> named_formats = {{
    {"binary16", 11, 5, {"float16", "fp16", "half"}},
    {"bfloat16", 8, 8, {"bf16"}},
    {"binary32", 24, 8, {"float32", "fp32", "single", "float"}},
    {"binary64", 53, 11, {"float64", "fp64", "double"}},
    {"binary128", 113, 15, {"float128", "fp128", "quad"}},
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

std::string_view FloatFormat::standard_name(std::string_view elsewhere) {
  for (const NamedFormat& named : named_formats) {
    const auto& names = named.elsewhere;
    const bool is_one = std::find(names.begin(), names.end(), elsewhere) != names.end();
    if (!elsewhere.empty() && is_one) return named.name;
  }
  return "";
}

std::string_view FloatFormat::standard_name() const {
  for (const NamedFormat& named : named_formats) {
    if (make(named.precision, named.exponent_bits).value() == *this) return named.name;
  }
  return "";
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
