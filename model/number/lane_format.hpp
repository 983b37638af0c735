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

  std::string name() const;  ///< "q13", or "block13"
  /// None where the word is no such name.
  static std::optional<FixedPoint> parse(std::string_view word);

  friend bool operator==(const FixedPoint&, const FixedPoint&) = default;
};

/// The format of a lane, as tables and signatures name it: "s17e8", or "q13" or "block13" in fixed
/// point.
struct LaneFormat {
  /// One of the two is set.
  std::optional<FloatFormat> floating;
  std::optional<FixedPoint> fixed_point;

  int precision() const;  ///< L; of fixed point W

  static Result<LaneFormat> parse(std::string_view name);
};

}  // namespace mixcmp::inline number
