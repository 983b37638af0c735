#include "model/number/lane_format.hpp"

#include <charconv>

#include "model/common/quote.hpp"

namespace mixcmp::inline number {
namespace {

/// W of "q13"; none for another word.
std::optional<int> fixed_bits(std::string_view name) {
  if (!name.starts_with('q')) return std::nullopt;
  int bits = 0;
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + 1, end, bits);
  const bool whole = read.ec == std::errc() && read.ptr == end && bits > 0;
  return whole ? std::optional(bits) : std::nullopt;
}

}  // namespace

Result<LaneFormat> LaneFormat::parse(std::string_view name) {
  if (const auto bits = fixed_bits(name)) return LaneFormat{.floating = {}, .precision = *bits};
  const Result<FloatFormat> floating = FloatFormat::parse(name);
  if (floating.ok()) return LaneFormat{.floating = *floating, .precision = floating->precision()};
  return Error{.message = "not a format of lanes",
               .received = in_quotes(name),
               .accepted = "s<digits>e<exponent bits>, such as s17e8, or q<bits>, such as q13"};
}

}  // namespace mixcmp::inline number
