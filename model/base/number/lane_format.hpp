#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/base/common/result.hpp"
#include "model/base/number/float_format.hpp"

namespace mixcmp::inline number {

/// The format of a fixed-point lane's operands.
struct FixedPoint {
  int bits = 0;  ///< W
  /// Block floating point: the largest exponent among the operands of a comparison sets the unit of
  /// all of them. Otherwise each input has its own unit, which its range sets.
  bool is_block = false;
  /// Digits of operands below the W bits, for differences whose leading digits cancel; 0: none.
  int guard_digits = 0;

  /// Whether each operand has a unit that is known before it arrives, and no digits are cut later.
  bool is_plain() const { return !is_block && guard_digits == 0; }
  /// Bits of an operand's magnitude.
  int operand_bits() const { return bits + guard_digits; }

  std::string name() const;  ///< "q13", "block13", with guard digits "q13g3"
  /// None if the word is no such name.
  static std::optional<FixedPoint> parse(std::string_view word);

  friend bool operator==(const FixedPoint&, const FixedPoint&) = default;
};

/// The format of a lane, as named in tables and signatures: "s17e8", or in fixed point "q13",
/// "block13", "q13g3".
struct LaneFormat {
  /// One of the two is set.
  std::optional<FloatFormat> floating;
  std::optional<FixedPoint> fixed_point;

  int precision() const;  ///< L, or W in fixed point
  std::string name() const;

  static Result<LaneFormat> parse(std::string_view name);

  friend bool operator==(const LaneFormat&, const LaneFormat&) = default;
};

}  // namespace mixcmp::inline number
