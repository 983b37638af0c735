#include "model/base/number/lane_inputs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

#include "model/base/common/quote.hpp"

namespace mixcmp::inline number {

Result<LaneInputs> LaneInputs::parse(std::string_view word, int least, int most) {
  for (const LaneInputs named : {rounded, exact}) {
    if (word == to_string(named)) return named;
  }
  unsigned short digits = 0;  // unsigned: takes no sign
  const char* const end = word.data() + word.size();
  const auto read = std::from_chars(word.data(), end, digits);
  const bool is_number = read.ec == std::errc() && read.ptr == end && !word.starts_with('0');
  if (is_number && least <= digits && digits <= most) return of_digits(digits);
  return Error{
      .message = is_number ? "digits out of range" : "not a choice",
      .received = in_quotes(word),
      .accepted = fmt::format("exact, rounded, or a number of digits {}..{}", least, most)};
}

int LaneInputs::digits(int lane_precision, int reference_precision) const {
  return std::min(std::max(digits_, lane_precision), reference_precision);
}

LaneInputs LaneInputs::in_lane(int lane_precision, int reference_precision) const {
  if (!number()) return *this;
  if (digits_ >= reference_precision) return exact;
  return digits_ <= lane_precision ? rounded : *this;
}

std::optional<int> LaneInputs::number() const {
  if (*this == rounded || *this == exact) return std::nullopt;
  return digits_;
}

std::string to_string(LaneInputs inputs) {
  if (inputs == LaneInputs::rounded) return "rounded";
  if (inputs == LaneInputs::exact) return "exact";
  return fmt::format("{}", *inputs.number());
}

std::string to_string(std::optional<LaneInputs> inputs) {
  return inputs ? to_string(*inputs) : "";
}

std::string describe(LaneInputs inputs) {
  const auto number = inputs.number();
  return number ? fmt::format("inputs of {} digits", *number) : to_string(inputs) + " inputs";
}

}  // namespace mixcmp::inline number
