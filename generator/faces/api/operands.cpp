#include "generator/faces/api/operands.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace mixcmp::api {
namespace {

/// None for an infinity that the format lacks.
std::optional<Operand> special_operand(FloatFormat format, double value) {
  const bool negative = std::signbit(value);
  if (std::isnan(value)) return Operand{format.quiet_nan(), value};
  if (!std::isinf(value)) return Operand{format.zero(negative), value};
  if (!format.has_infinities()) return std::nullopt;
  return Operand{format.infinity(negative), value};
}

}  // namespace

std::optional<Operand> nearest_operand(FloatFormat format, double value) {
  if (value == 0 || !std::isfinite(value)) return special_operand(format, value);
  const int exponent = std::max(std::ilogb(value), format.min_exponent());
  if (exponent > format.max_exponent()) return std::nullopt;
  // The number counts units of its last place: at most 2^P. nearbyint rounds the rest of a unit
  // off, ties to even.
  const int unit_exponent = exponent - format.fraction_bits();
  const double units = std::nearbyint(std::ldexp(std::fabs(value), -unit_exponent));
  // A carry into the next binade, or out of the subnormal numbers, is right as a sum: the fraction
  // overflows into the biased exponent.
  const Bits binade = Bits(exponent - format.min_exponent()) << format.fraction_bits();
  const Bits magnitude = binade + static_cast<Bits>(units);
  if (magnitude >= format.beyond_largest(false)) return std::nullopt;
  return Operand{magnitude | format.zero(std::signbit(value)),
                 std::copysign(std::ldexp(units, unit_exponent), value)};
}

Result<OperandRows> OperandRows::make(std::span<const double> numbers,
                                      const std::vector<std::string>& inputs, FloatFormat format,
                                      std::span<const OperandFormat> formats) {
  if (inputs.empty() || numbers.size() % inputs.size() != 0) {
    return mixcmp::Error{
        .field = "operands",
        .message = "the numbers fill no whole row",
        .received = fmt::format("{} numbers", numbers.size()),
        .accepted = fmt::format("a multiple of {}, one for each input", inputs.size())};
  }
  OperandRows rows(inputs.size(), format);
  rows.values_.reserve(numbers.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const OperandFormat& arrives = formats[k % inputs.size()];
    const FloatFormat rounded_to = arrives.fixed() != nullptr ? format : *arrives.floating();
    const auto operand = nearest_operand(rounded_to, numbers[k]);
    if (!operand) {
      return mixcmp::Error{
          .field =
              fmt::format("operands, row {}, {}", k / inputs.size(), inputs[k % inputs.size()]),
          .message = "out of range",
          .received = fmt::format("{}, beyond the largest of {}", numbers[k], rounded_to.name()),
          .accepted = "a smaller one, or a format with more exponent bits"};
    }
    const bool is_held = arrives.fixed() == nullptr ||
                         (operand->value == numbers[k] && arrives.holds(format, operand->bits));
    if (!is_held) {
      return mixcmp::Error{.field = fmt::format("operands, row {}, {}", k / inputs.size(),
                                                inputs[k % inputs.size()]),
                           .message = "not a number of the input's format",
                           .received = fmt::format("{}", numbers[k]),
                           .accepted = fmt::format("a number of {}", arrives.name())};
    }
    rows.values_.push_back(operand->value);
  }
  return rows;
}

void OperandRows::fetch(std::size_t row, std::span<Bits> operands) const {
  for (std::size_t input = 0; input < inputs_; ++input) {
    operands[input] = nearest_operand(format_, value(row, input))->bits;
  }
}

}  // namespace mixcmp::api
