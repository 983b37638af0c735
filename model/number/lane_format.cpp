#include "model/number/lane_format.hpp"

#include <fmt/core.h>

#include <charconv>

#include "model/common/quote.hpp"

namespace mixcmp::inline number {
namespace {

constexpr std::string_view fixed_prefix = "q", block_prefix = "block";

}  // namespace

std::string FixedPoint::name() const {
  return fmt::format("{}{}", is_block ? block_prefix : fixed_prefix, bits);
}

std::optional<FixedPoint> FixedPoint::parse(std::string_view word) {
  for (const bool is_block : {false, true}) {
    const std::string_view prefix = is_block ? block_prefix : fixed_prefix;
    if (!word.starts_with(prefix)) continue;
    unsigned short bits = 0;  // unsigned: takes no sign
    const char* const end = word.data() + word.size();
    const auto read = std::from_chars(word.data() + prefix.size(), end, bits);
    if (read.ec == std::errc() && read.ptr == end) return FixedPoint{bits, is_block};
  }
  return std::nullopt;
}

int LaneFormat::precision() const {
  return floating ? floating->precision() : fixed_point->bits;
}

Result<LaneFormat> LaneFormat::parse(std::string_view name) {
  const std::optional<FixedPoint> fixed_point = FixedPoint::parse(name);
  if (fixed_point && fixed_point->bits > 0) return LaneFormat{{}, fixed_point};
  const Result<FloatFormat> floating = FloatFormat::parse(name);
  if (floating.ok()) return LaneFormat{*floating, {}};
  return Error{.message = "not a format of lanes",
               .received = in_quotes(name),
               .accepted =
                   "s<digits>e<exponent bits>, such as s17e8, q<bits>, such as q13, or "
                   "block<bits>, such as block13"};
}

}  // namespace mixcmp::inline number
