#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/common/result.hpp"
#include "model/number/float_format.hpp"

namespace mixcmp::inline number {

/// The format of the operands of a lane in fixed point.
struct FixedPoint {
  int bits = 0;  ///< W
  /// Block floating point: the largest exponent among the operands of a comparison sets the unit of
  /// all of them. Otherwise each input has its own, which its range sets.
  bool is_block = false;
  /// Digits of operands below those W, for differences in which the leading ones cancel; 0: none.
  int guard_digits = 0;

  /// Bits of an operand's magnitude.
  int operand_bits() const { return bits + guard_digits; }

  std::string name() const;  ///< "q13", "block13", with guard digits "q13g3"
  /// None where the word is no such name.
  static std::optional<FixedPoint> parse(std::string_view word);

  friend bool operator==(const FixedPoint&, const FixedPoint&) = default;
};

/// The format of a lane, as tables and signatures name it: "s17e8", or in fixed point "q13",
/// "block13", "q13g3".
struct LaneFormat {
  /// One of the two is set.
  std::optional<FloatFormat> floating;
  std::optional<FixedPoint> fixed_point;

  int precision() const;  ///< L; of fixed point W

  static Result<LaneFormat> parse(std::string_view name);
};

}  // namespace mixcmp::inline number
