#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>

#include "model/base/common/result.hpp"
#include "model/base/number/float_format.hpp"

namespace mixcmp::inline number {

/// How many digits of each operand reach the first operators of a reduced lane: a number N from the
/// lane's own digits (`rounded`) to the reference's (`exact`). An operand with more digits is first
/// rounded to N, in the lane's exponent bits; with `exact` it stays unchanged.
///
/// First operators are those whose operands are only inputs and constants. Negate, absolute,
/// minimum and maximum of such operands are exact: their results count as inputs for later
/// operators. All other operators take operands rounded to the lane's format.
class LaneInputs {
public:
  static const LaneInputs rounded;  ///< N is the lane's precision
  static const LaneInputs exact;    ///< N is the reference's precision

  /// N digits, or the lane's digits if these are more, but at most the reference's.
  static constexpr LaneInputs of_digits(int digits) { return LaneInputs(digits); }
  /// Reads "rounded", "exact" or a number of digits. `least` and `most` limit the number.
  static Result<LaneInputs> parse(std::string_view word, int least, int most);

  /// N in a lane of one precision with a reference of another precision.
  int digits(int lane_precision, int reference_precision) const;
  /// The name of this choice in a lane of one precision with a reference of another precision. A
  /// number may stand for `rounded` or `exact`.
  LaneInputs in_lane(int lane_precision, int reference_precision) const;
  /// The requested number; none for `rounded` and `exact`.
  std::optional<int> number() const;

  friend constexpr bool operator==(LaneInputs, LaneInputs) = default;
  /// `exact` comes first, then ever fewer digits.
  friend constexpr auto operator<=>(LaneInputs a, LaneInputs b) { return b.digits_ <=> a.digits_; }

private:
  constexpr explicit LaneInputs(int digits) : digits_(digits) {}

  int digits_;
};

inline constexpr LaneInputs LaneInputs::rounded{0};
inline constexpr LaneInputs LaneInputs::exact{FloatFormat::max_precision};

/// "rounded", "exact", "20".
std::string to_string(LaneInputs inputs);
/// The text of `inputs`; empty if there is no value.
std::string to_string(std::optional<LaneInputs> inputs);
/// "rounded inputs", "exact inputs", "inputs of 20 digits".
std::string describe(LaneInputs inputs);

}  // namespace mixcmp::inline number
