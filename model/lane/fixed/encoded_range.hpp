#pragma once

#include <gmpxx.h>

#include <optional>

#include "model/base/number/float_format.hpp"
#include "model/comparison/expression/function.hpp"
#include "model/comparison/expression/range.hpp"
#include "model/lane/function/piecewise.hpp"

/// Operands that a function reads as their encodings in floating point, so that their error is in
/// proportion to them. Proof: docs/fixed_point.md, theorem 10.
namespace mixcmp::fixed {

/// The operands above 0 that a lane reads as their encodings without low bits.
struct EncodedRange {
  FloatFormat format;
  int fraction_bits;          ///< fraction bits that the encoding keeps
  int exact_fraction_bits;    ///< fraction bits that operands have
  mpz_class least, greatest;  ///< biased exponent and fraction

  /// From the first to the last encoding whose numbers lie in `numbers`, which is above 0 and
  /// within the format's normal numbers.
  static EncodedRange of(FloatFormat format, int fraction_bits, int exact_fraction_bits,
                         const Range& numbers);
  /// With all numbers that have the exponent of the first or of the last.
  EncodedRange with_whole_binades() const;

  /// Bits of a code's exponent field, and the biased exponent that codes count from.
  int exponent_bits() const;
  int first_exponent() const;
  /// The encoding of the argument's codes.
  function::FloatingEncoding encoding() const;
  mpz_class first_code() const;
  mpz_class last_code() const;

  /// The numbers that the encodings stand for.
  Range numbers() const;
  /// By how much a function's value changes if an operand loses its low bits. None if there is no
  /// bound.
  std::optional<Range> moved_by(const Function& function) const;
};

}  // namespace mixcmp::fixed
