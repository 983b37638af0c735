#include "model/base/number/lane_format.hpp"

#include <fmt/core.h>

#include "model/base/common/quote.hpp"
#include "model/base/number/whole_number.hpp"

namespace mixcmp::inline number {
namespace {

constexpr std::string_view fixed_prefix = "q", block_prefix = "block";
constexpr char guard_letter = 'g';

}  // namespace

std::string FixedPoint::name() const {
  const std::string name = fmt::format("{}{}", is_block ? block_prefix : fixed_prefix, bits);
  return guard_digits == 0 ? name : fmt::format("{}{}{}", name, guard_letter, guard_digits);
}

std::optional<FixedPoint> FixedPoint::parse(std::string_view word) {
  for (const bool is_block : {false, true}) {
    const std::string_view prefix = is_block ? block_prefix : fixed_prefix;
    if (!word.starts_with(prefix)) continue;
    const std::string_view digits = word.substr(prefix.size());
    const std::size_t letter = digits.find(guard_letter);
    const bool has_guard_digits = letter != std::string_view::npos;
    const auto bits = whole_number(digits.substr(0, letter));
    const auto guard_digits = has_guard_digits ? whole_number(digits.substr(letter + 1)) : 0;
    if (!bits || !guard_digits) continue;
    const FixedPoint format{*bits, is_block, *guard_digits};
    if (format.name() == word) return format;  // one name each: no "q013", no "q13g0"
  }
  return std::nullopt;
}

int LaneFormat::precision() const {
  return floating ? floating->precision() : fixed_point->bits;
}

std::string LaneFormat::name() const {
  return floating ? floating->name() : fixed_point->name();
}

Result<LaneFormat> LaneFormat::parse(std::string_view name) {
  const std::optional<FixedPoint> fixed_point = FixedPoint::parse(name);
  if (fixed_point && fixed_point->bits > 0) return LaneFormat{{}, fixed_point};
  const Result<FloatFormat> floating = FloatFormat::parse(name);
  if (floating.ok()) return LaneFormat{*floating, {}};
  return Error{.message = "not a format of lanes",
               .received = in_quotes(name),
               .accepted =
                   "s<digits>e<exponent bits>, such as s17e8; q<bits> or block<bits>, such as q13 "
                   "or block13; with guard digits q13g3 or block13g3"};
}

}  // namespace mixcmp::inline number
