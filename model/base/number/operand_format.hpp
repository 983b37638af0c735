#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "model/base/common/result.hpp"
#include "model/base/number/fixed_format.hpp"
#include "model/base/number/float_format.hpp"

namespace mixcmp::inline number {

/// Numbers of a format with infinities, each times 2^scale.
struct ScaledFloat {
  FloatFormat format;
  int scale;
};

/// The format in which an operand arrives at the ports of a system: floating point, or fixed point,
/// which includes integers. Fixed-point words have at most 64 bits.
class OperandFormat {
public:
  static constexpr int most_fixed_bits = 64;

  explicit OperandFormat(FloatFormat format) : format_(format) {}
  explicit OperandFormat(FixedFormat format) : format_(format) {}

  /// Reads the name of any format. "E5M2" and "E4M3" are the formats of eight bits in the Open
  /// Compute Project's specification OFP8: s3e5, and s4e4 without infinities, whose largest number
  /// is 448.
  static Result<OperandFormat> parse(std::string_view name);
  /// Reads the name of a fixed-point format: "uint10" and "int8" are integers of 10 and 8 bits;
  /// "q3.12" has a sign, 3 bits before the point and 12 behind it, so 16 bits; "uq4.12" has no
  /// sign.
  static Result<OperandFormat> parse_fixed(std::string_view name);
  /// The names that parse_fixed accepts, in a message's words.
  static std::string accepted_fixed();
  /// The names that parse accepts.
  static std::string accepted();

  int width() const;         ///< bits of a word
  std::string name() const;  ///< "s53e11", "uint10", "q3.12"
  /// Null if the format is the other one of the two.
  const FixedFormat* fixed() const { return std::get_if<FixedFormat>(&format_); }
  const FloatFormat* floating() const { return std::get_if<FloatFormat>(&format_); }

  /// Whether every number of this format is one of `other`: of fixed-point formats a normal number,
  /// so that no treatment of subnormal numbers changes it.
  bool is_held_by(FloatFormat other) const;
  /// Whether a number is one of this format. It is encoded in `from`. Formats in floating point
  /// have NaNs and, but for those without, infinities.
  bool holds(FloatFormat from, Bits number) const;
  /// The word of a number that the format holds. The number is encoded in `from`. A NaN becomes the
  /// quiet NaN, except in `from` itself.
  Bits word_of(FloatFormat from, Bits number) const;
  /// A format with infinities in which a word is its number, but for the scale, as soon as bits are
  /// put in front of its magnitude:
  /// - none, in front of a word of a format with infinities;
  /// - the exponent's first bit, where there are none: it is 1 for the NaN, otherwise 0;
  /// - zeros, in front of a magnitude in fixed point. The number is then subnormal or, if the last
  ///   bit of the exponent is the magnitude's first one, in the least binade.
  ScaledFloat scaled_float() const;

  friend bool operator==(const OperandFormat&, const OperandFormat&) = default;

private:
  std::variant<FloatFormat, FixedFormat> format_;
};

/// The smallest floating-point format that holds all numbers of these formats. Beside one in fixed
/// point it is no smaller than double's.
FloatFormat format_holding(std::span<const OperandFormat> formats);

/// The bits of words of these formats side by side.
int total_width(std::span<const OperandFormat> formats);

}  // namespace mixcmp::inline number
