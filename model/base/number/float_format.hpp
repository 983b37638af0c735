#pragma once

#include <string>
#include <string_view>

#include "model/base/common/bits.hpp"
#include "model/base/common/check.hpp"
#include "model/base/common/result.hpp"

namespace mixcmp::inline number {

/// The encodings that are no numbers.
enum class Specials {
  ieee,  ///< the largest biased exponent holds the infinities and the NaNs
  /// All ones below the sign are a NaN. The rest of the largest binade is numbers.
  no_infinities,
};

/// One binary floating-point layout, packed like the interchange formats of IEEE 754: sign, biased
/// exponent, trailing fraction. Written sPeE with P digits of significand, including the leading
/// one, and E exponent bits (the paper's notation).
///
/// Only operands arrive in formats without infinities (Specials::no_infinities); all arithmetic is
/// in formats of IEEE 754.
class FloatFormat {
public:
  static constexpr int min_precision = 2, max_precision = 113;
  static constexpr int min_exponent_bits = 2, max_exponent_bits = 15;

  static Result<FloatFormat> make(int precision, int exponent_bits,
                                  Specials specials = Specials::ieee);

  /// OFP8's format of 8 bits without infinities, s4e4 but for that. Its largest number is 448.
  static constexpr FloatFormat e4m3() { return FloatFormat(4, 4, Specials::no_infinities); }

  /// The formats that `parse` accepts, with precisions from `least` to `most`, in a message's
  /// words.
  static std::string accepted(int least = min_precision, int most = max_precision);

  /// Reads "s17e8", or one of binary16, bfloat16, binary32, binary64, binary128.
  static Result<FloatFormat> parse(std::string_view text);

  /// The name that `parse` reads of a format that is called `elsewhere`, as in "float16"; empty if
  /// none is known.
  static std::string_view standard_name(std::string_view elsewhere);
  /// "binary16" or another name of a standard; empty if it has none.
  std::string_view standard_name() const;

  constexpr bool has_infinities() const { return specials_ == Specials::ieee; }
  constexpr int precision() const { return precision_; }
  constexpr int exponent_bits() const { return exponent_bits_; }
  constexpr int fraction_bits() const { return precision_ - 1; }
  constexpr int width() const { return precision_ + exponent_bits_; }
  constexpr int bias() const { return (1 << (exponent_bits_ - 1)) - 1; }
  /// Exponent of the smallest normal number, 2^min_exponent.
  constexpr int min_exponent() const { return 1 - bias(); }
  /// Exponent of the largest finite number, (2 - 2^(1-P)) * 2^max_exponent; without infinities
  /// (2 - 2^(2-P)) * 2^max_exponent.
  constexpr int max_exponent() const { return has_infinities() ? bias() : bias() + 1; }
  /// The largest value of the exponent's field. Without infinities, numbers have it too.
  constexpr int max_biased_exponent() const { return (1 << exponent_bits_) - 1; }

  constexpr Bits pack(bool negative, int biased_exponent, Bits fraction) const {
    return (Bits{negative} << (width() - 1)) | (Bits(biased_exponent) << fraction_bits()) |
           fraction;
  }
  constexpr bool sign(Bits bits) const { return (bits >> (width() - 1) & 1) != 0; }
  constexpr int biased_exponent(Bits bits) const {
    return static_cast<int>(bits >> fraction_bits()) & max_biased_exponent();
  }
  constexpr Bits fraction(Bits bits) const { return bits & low_mask(fraction_bits()); }
  constexpr Bits magnitude(Bits bits) const { return bits & low_mask(width() - 1); }

  constexpr Bits zero(bool negative) const { return pack(negative, 0, 0); }
  /// Only for formats with infinities.
  constexpr Bits infinity(bool negative) const {
    MIXCMP_CHECK(has_infinities());
    return pack(negative, max_biased_exponent(), 0);
  }
  /// The one NaN our units produce: positive, quiet, no payload. Without infinities, the positive
  /// one of the two NaNs.
  constexpr Bits quiet_nan() const {
    const Bits fraction =
        has_infinities() ? Bits{1} << (fraction_bits() - 1) : low_mask(fraction_bits());
    return pack(false, max_biased_exponent(), fraction);
  }
  /// The encoding of an infinity, or of a number beyond the largest: the NaN without infinities.
  constexpr Bits beyond_largest(bool negative) const {
    return has_infinities() ? infinity(negative) : quiet_nan();
  }
  constexpr Bits largest_finite(bool negative) const {
    return (beyond_largest(false) - 1) | zero(negative);
  }
  constexpr Bits smallest_normal(bool negative) const { return pack(negative, 1, 0); }

  constexpr bool is_nan(Bits bits) const {
    return magnitude(bits) > (has_infinities() ? infinity(false) : largest_finite(false));
  }
  constexpr bool is_infinite(Bits bits) const {
    return has_infinities() && magnitude(bits) == infinity(false);
  }
  constexpr bool is_finite(Bits bits) const { return magnitude(bits) < beyond_largest(false); }
  constexpr bool is_zero(Bits bits) const { return magnitude(bits) == 0; }
  constexpr bool is_subnormal(Bits bits) const {
    return biased_exponent(bits) == 0 && fraction(bits) != 0;
  }

  /// "s17e8"; without infinities "E4M3", as the Open Compute Project writes it.
  std::string name() const;

  friend constexpr bool operator==(const FloatFormat&, const FloatFormat&) = default;

private:
  constexpr FloatFormat(int precision, int exponent_bits, Specials specials)
      : precision_(precision), exponent_bits_(exponent_bits), specials_(specials) {}

  int precision_;
  int exponent_bits_;
  Specials specials_;
};

enum class Rounding {
  nearest_even,
  toward_zero,
};

/// The treatment of numbers below the smallest normal number.
enum class Subnormals {
  flush,    ///< operands and results below it become a zero of the same sign, as in vendor cores
  gradual,  ///< IEEE 754
};

/// The rounding of sums of several terms.
enum class Sums {
  composed,  ///< each product and each sum of two is rounded
  fused,     ///< the sum of all products is rounded once
};

/// A format, and how results are rounded into it.
struct Arithmetic {
  FloatFormat format;
  Rounding rounding = Rounding::nearest_even;
  Subnormals subnormals = Subnormals::gradual;
  Sums sums = Sums::composed;

  friend bool operator==(const Arithmetic&, const Arithmetic&) = default;
};

std::string_view to_string(Rounding rounding);
std::string_view to_string(Subnormals subnormals);
std::string_view to_string(Sums sums);

}  // namespace mixcmp::inline number
