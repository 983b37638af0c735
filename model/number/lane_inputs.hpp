#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>

#include "model/common/result.hpp"
#include "model/number/float_format.hpp"

namespace mixcmp::inline number {

/// How many digits of each operand reach the first operators of a reduced lane: a number N from the
/// lane's own digits (`rounded`) to the reference's (`exact`). An operand with more digits is
/// rounded to N first, in the lane's exponent bits; for `exact` nothing is done to it.
///
/// First operators are those on inputs and constants alone. Negate, absolute, minimum and maximum
/// of such operands are exact themselves: their results count as inputs for what follows. All other
/// operators take operands rounded to the lane's format.
class LaneInputs {
public:
  static const LaneInputs rounded;  ///< N is the lane's precision
  static const LaneInputs exact;    ///< N is the reference's precision

  /// N digits, or as many as the lane has where that is more, but at most the reference's.
  static constexpr LaneInputs of_digits(int digits) { return LaneInputs(digits); }
  /// Reads "rounded", "exact" or a number of digits. `least` and `most` limit the number.
  static Result<LaneInputs> parse(std::string_view word, int least, int most);

  /// N in a lane of one precision beside a reference of another.
  int digits(int lane_precision, int reference_precision) const;
  /// The name of this choice in such a lane, where a number may stand for `rounded` or `exact`.
  LaneInputs in_lane(int lane_precision, int reference_precision) const;
  /// The number that was asked for; none for `rounded` and `exact`.
  std::optional<int> number() const;

  friend constexpr bool operator==(LaneInputs, LaneInputs) = default;
  /// `exact` comes first, then fewer and fewer digits.
  friend constexpr auto operator<=>(LaneInputs a, LaneInputs b) { return b.digits_ <=> a.digits_; }

private:
  constexpr explicit LaneInputs(int digits) : digits_(digits) {}

  int digits_;
};

inline constexpr LaneInputs LaneInputs::rounded{0};
inline constexpr LaneInputs LaneInputs::exact{FloatFormat::max_precision};

/// "rounded", "exact", "20".
std::string to_string(LaneInputs inputs);
/// The text of `inputs`; empty where there is no value.
std::string to_string(std::optional<LaneInputs> inputs);
/// "rounded inputs", "exact inputs", "inputs of 20 digits".
std::string describe(LaneInputs inputs);

}  // namespace mixcmp::inline number
