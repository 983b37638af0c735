#include "model/base/number/operand_format.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "model/base/common/check.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/number/double.hpp"
#include "model/base/number/whole_number.hpp"

namespace mixcmp::inline number {
namespace {

/// Bits before and behind the point; an integer has none behind it.
struct Places {
  int before;
  int behind;
};

std::optional<Places> places_of(std::string_view word, bool has_point) {
  if (!has_point) {
    const std::optional<int> bits = whole_number(word);
    return bits ? std::optional(Places{*bits, 0}) : std::nullopt;
  }
  const std::size_t point = word.find('.');
  if (point == std::string_view::npos) return std::nullopt;
  const std::optional<int> before = whole_number(word.substr(0, point));
  const std::optional<int> behind = whole_number(word.substr(point + 1));
  return before && behind ? std::optional(Places{*before, *behind}) : std::nullopt;
}

/// A kind of names: `prefix` and then the number of bits.
struct Kind {
  std::string_view prefix;
  bool has_point;
  bool is_signed;
};

constexpr Kind kinds[] = {
    {"uint", false, false}, {"int", false, true}, {"uq", true, false}, {"q", true, true}};

std::optional<FixedFormat> parsed(const Kind& kind, std::string_view name) {
  if (!name.starts_with(kind.prefix)) return std::nullopt;
  const std::optional<Places> places = places_of(name.substr(kind.prefix.size()), kind.has_point);
  if (!places) return std::nullopt;
  const int sign_bits = kind.is_signed && kind.has_point ? 1 : 0;
  const FixedFormat format{.width = sign_bits + places->before + places->behind,
                           .unit_exponent = -places->behind,
                           .is_signed = kind.is_signed};
  const int fewest = kind.is_signed ? 2 : 1;
  const bool is_possible = format.width >= fewest && format.width <= OperandFormat::most_fixed_bits;
  return is_possible ? std::optional(format) : std::nullopt;
}

/// A finite number as negative, significand and the exponent of the significand's unit.
struct Scientific {
  bool is_negative;
  Bits significand;
  int unit_exponent;
};

Scientific scientific(FloatFormat format, Bits number) {
  const int exponent = format.biased_exponent(number);
  const Bits leading = exponent == 0 ? Bits{0} : Bits{1} << format.fraction_bits();
  return {.is_negative = format.sign(number),
          .significand = format.fraction(number) | leading,
          .unit_exponent = std::max(exponent, 1) - format.bias() - format.fraction_bits()};
}

/// The word of a number in a floating-point format; none if the format lacks it.
std::optional<Bits> floating_word(FloatFormat to, FloatFormat from, Bits number) {
  const bool is_negative = from.sign(number);
  if (from.is_nan(number)) return to.quiet_nan();
  if (from.is_infinite(number)) {
    return to.has_infinities() ? std::optional(to.infinity(is_negative)) : std::nullopt;
  }
  auto [unused, significand, unit_exponent] = scientific(from, number);
  if (significand == 0) return to.zero(is_negative);
  for (; (significand & 1) == 0; ++unit_exponent) significand >>= 1;
  int digits = 0;
  for (Bits rest = significand; rest != 0; rest >>= 1) ++digits;
  const int exponent = unit_exponent + digits - 1;
  const int above_least = unit_exponent - (to.min_exponent() - to.fraction_bits());
  if (digits > to.precision() || exponent > to.max_exponent() || above_least < 0) {
    return std::nullopt;
  }
  if (exponent < to.min_exponent()) return to.pack(is_negative, 0, significand << above_least);
  const Bits fraction = (significand << (to.precision() - digits)) & low_mask(to.fraction_bits());
  const Bits word = to.pack(is_negative, exponent + to.bias(), fraction);
  return to.is_finite(word) ? std::optional(word) : std::nullopt;
}

/// The integer that a finite number is in units of 2^unit_exponent; none if it is no integer, or
/// one of more than 64 bits.
std::optional<Bits> magnitude_in_units(const Scientific& number, int unit_exponent) {
  if (number.significand == 0) return Bits{0};
  Bits significand = number.significand;
  int shift = number.unit_exponent - unit_exponent;
  for (; shift < 0 && (significand & 1) == 0; ++shift) significand >>= 1;
  const bool fits = shift >= 0 && shift < OperandFormat::most_fixed_bits &&
                    significand <= (low_mask(OperandFormat::most_fixed_bits) >> shift);
  return fits ? std::optional(significand << shift) : std::nullopt;
}

}  // namespace

Result<OperandFormat> OperandFormat::parse_fixed(std::string_view name) {
  for (const Kind& kind : kinds) {
    const std::optional<FixedFormat> format = parsed(kind, name);
    if (format && OperandFormat(*format).name() == name) return OperandFormat(*format);
  }
  return Error{.message = "not a format of operands in fixed point",
               .received = in_quotes(name),
               .accepted = accepted_fixed()};
}

Result<OperandFormat> OperandFormat::parse(std::string_view name) {
  if (auto fixed = parse_fixed(name); fixed.ok()) return fixed;
  if (name == "E4M3") return OperandFormat(FloatFormat::e4m3());
  if (name == "E5M2") return OperandFormat(FloatFormat::make(3, 5).value());
  const Result<FloatFormat> floating = FloatFormat::parse(name);
  if (floating.ok()) return OperandFormat(*floating);
  const std::string_view standard = FloatFormat::standard_name(name);
  return Error{.message = "not a format of operands",
               .received = in_quotes(name),
               .accepted = standard.empty()
                               ? accepted()
                               : fmt::format("{} (the same format); {}", standard, accepted())};
}

std::string OperandFormat::accepted() {
  return accepted_fixed() + "; " + FloatFormat::accepted() + ", E4M3, E5M2";
}

std::string OperandFormat::accepted_fixed() {
  return fmt::format(
      "uint1..uint{0}, int2..int{0}, qI.F or uqI.F with I bits before the point and F of at least "
      "1 behind it, such as q3.12, at most {0} bits with the sign",
      most_fixed_bits);
}

int OperandFormat::width() const {
  if (const FixedFormat* fixed_point = fixed()) return fixed_point->width;
  return std::get<FloatFormat>(format_).width();
}

std::string OperandFormat::name() const {
  const FixedFormat* format = fixed();
  if (format == nullptr) return std::get<FloatFormat>(format_).name();
  const int behind = -format->unit_exponent;
  if (behind == 0) return fmt::format("{}int{}", format->is_signed ? "" : "u", format->width);
  return fmt::format("{}q{}.{}", format->is_signed ? "" : "u", format->magnitude_bits() - behind,
                     behind);
}

bool OperandFormat::is_held_by(FloatFormat other) const {
  if (const FixedFormat* format = fixed()) {
    return other.precision() >= format->magnitude_bits() &&
           format->unit_exponent + format->magnitude_bits() <= other.max_exponent() &&
           format->unit_exponent >= other.min_exponent();
  }
  return other.precision() >= floating()->precision() &&
         other.max_exponent() >= floating()->max_exponent() &&
         other.min_exponent() <= floating()->min_exponent();
}

bool OperandFormat::holds(FloatFormat from, Bits number) const {
  const FixedFormat* format = fixed();
  if (format == nullptr) return floating_word(*floating(), from, number).has_value();
  if (from.is_nan(number) || from.is_infinite(number)) return false;
  const Scientific parts = scientific(from, number);
  const std::optional<Bits> magnitude = magnitude_in_units(parts, format->unit_exponent);
  if (!magnitude) return false;
  const Bits below = Bits{1} << format->magnitude_bits();
  if (!parts.is_negative || *magnitude == 0) return *magnitude < below;
  return format->is_signed && *magnitude <= below;
}

Bits OperandFormat::word_of(FloatFormat from, Bits number) const {
  if (floating() != nullptr) {
    if (*floating() == from) return number;
    const std::optional<Bits> word = floating_word(*floating(), from, number);
    MIXCMP_CHECK(word);
    return *word;
  }
  const FixedFormat* format = fixed();
  const Scientific parts = scientific(from, number);
  const std::optional<Bits> magnitude = magnitude_in_units(parts, format->unit_exponent);
  MIXCMP_CHECK(magnitude);
  const Bits word = parts.is_negative ? Bits{0} - *magnitude : *magnitude;
  return word & low_mask(format->width);
}

ScaledFloat OperandFormat::scaled_float() const {
  if (const FloatFormat* const own = floating()) {
    if (own->has_infinities()) return {*own, 0};
    const auto wider = FloatFormat::make(own->precision(), own->exponent_bits() + 1).value();
    return {wider, wider.bias() - own->bias()};
  }
  const int precision = std::max(FloatFormat::min_precision, fixed()->width);
  int exponent_bits = FloatFormat::min_exponent_bits;
  const auto scaled = [&] {
    const auto format = FloatFormat::make(precision, exponent_bits).value();
    const int exponent_of_last_bit = format.min_exponent() - format.fraction_bits();
    return ScaledFloat{format, fixed()->unit_exponent - exponent_of_last_bit};
  };
  while (std::abs(scaled().scale) >= 1 << exponent_bits) ++exponent_bits;
  return scaled();
}

FloatFormat format_holding(std::span<const OperandFormat> formats) {
  int precision = FloatFormat::min_precision, exponent_bits = FloatFormat::min_exponent_bits;
  for (const OperandFormat& format : formats) {
    const FixedFormat* fixed = format.fixed();
    precision =
        std::max(precision, fixed == nullptr ? format.floating()->precision()
                                             : std::max(double_digits, fixed->magnitude_bits()));
    if (fixed != nullptr) exponent_bits = std::max(exponent_bits, double_exponent_bits);
  }
  const auto holds_all = [&] {
    const FloatFormat made = FloatFormat::make(precision, exponent_bits).value();
    return std::all_of(formats.begin(), formats.end(),
                       [&](const OperandFormat& format) { return format.is_held_by(made); });
  };
  while (!holds_all()) ++exponent_bits;
  return FloatFormat::make(precision, exponent_bits).value();
}

int total_width(std::span<const OperandFormat> formats) {
  int bits = 0;
  for (const OperandFormat& format : formats) bits += format.width();
  return bits;
}

}  // namespace mixcmp::inline number
