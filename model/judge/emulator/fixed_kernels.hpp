#pragma once

#include <cstdint>
#include <vector>

#include "model/judge/emulator/block.hpp"

/// Lanes in fixed point on columns of doubles; compiled once per instruction set. A column holds
/// the number n u of an integer n with unit u. It is exact up to 53 bits and needs no alignment.
/// Numbers beyond a reach may be rounded; docs/emulator.md says why that changes no decision.
namespace mixcmp::emulator {

/// One term of a sum: a, a b, (a + b)^2 or (a - b)^2 of columns a and b, or its negative.
struct FixedTerm {
  enum class Kind : std::uint8_t { value, product, square_of_sum, square_of_difference };
  Kind kind = Kind::value;
  int a = -1;
  int b = -1;  ///< any column if the term does not read it
  bool is_negative = false;
};

/// The sum of its terms, added one by one to zero. Each intermediate sum must be a double.
using FixedSum = std::vector<FixedTerm>;

enum class FixedKernel : std::uint8_t {
  /// Block floating point: divides the operands of all `cuts` by the least power of two above all
  /// their magnitudes, or by 2^`least_exponent` if that is larger. If one operand is not a finite
  /// number, all become NaNs.
  common_power,
  /// a, converted as a lane converts an operand to multiples of `unit`. Only magnitudes below
  /// `beyond` are taken, and by convert_unsigned no sign; others become NaNs.
  convert_signed,
  convert_unsigned,
  /// a, if it is a multiple of `unit` with a magnitude below `beyond` and, for
  /// convert_exactly_unsigned, without a sign; others become NaNs.
  convert_exactly_signed,
  convert_exactly_unsigned,
  sum,  ///< the sum of `terms`; the next ones have operands a and b
  absolute,
  minimum,
  maximum,
  square_root,  ///< of a, rounded to nearest
  truncate,     ///< a, rounded down to a multiple of `unit`
  place,        ///< by how much a exceeds that
  /// a, which is 2^e m with 1 <= m < 2, as e + m + `low`, where m is rounded down to a multiple of
  /// `unit`, 2^-52 or more. `high` for 0.
  floating,
  /// The entry of `words` at the address that a, rounded down to units, has in two's complement.
  look_up,
  limit,  ///< a if it is from `low` to `high`, a NaN otherwise
  /// 2^k `unit` for the least k >= 0 with a < 4^k `square_unit`; arbitrary for a NaN.
  power_above_root,
  common_cut,  ///< of all `cuts` at once
  running_threshold,
};

/// One column of an instruction that changes several together. In a common cut, it holds multiples
/// of `unit`.
struct FixedCut {
  int operand = -1;
  int result = -1;
  double unit = 1;
};

/// A column whose magnitude sets the step of a running bound.
struct FixedWatched {
  int column = -1;
  double unit = 1;
  double per_step_0 = 1;  ///< 1 / the power of two below which magnitudes are in step 0
};

struct FixedInstruction {
  FixedKernel kernel;
  int result = -1;
  int a = -1;
  int b = -1;
  double unit = 1;
  double square_unit = 1;
  double low = 0, high = 0;
  FixedSum terms = {};
  std::vector<FixedCut> cuts = {};
  std::vector<FixedWatched> watched = {};  ///< for running_threshold
  std::vector<double> of_steps = {};       ///< [step]: its threshold, a number
  std::vector<double> words = {};          ///< [address]: a number; their count is a power of two
  double beyond = 0;  ///< for common_cut: 2^W, above all results' magnitudes, in units
  int least_exponent = 0;
};

/// Greater iff D >= slope_above s + offset_above, less iff -D > slope_below s + offset_below, where
/// D is the difference; `otherwise` elsewhere. A NaN leaves the comparison undecided. `greater`,
/// `less` and `otherwise` are codes of Decision.
struct FixedCriterion {
  FixedSum difference;
  FixedSum radius;  ///< s; no terms if no slope reads it
  double slope_above = 0, offset_above = 0;
  double slope_below = 0, offset_below = 0;
  std::uint8_t greater = 2, less = 0, otherwise = 4;
};

void execute(const std::vector<FixedInstruction>& instructions, const Block& block);
/// Writes one code of Decision per comparison.
void decide(const FixedCriterion& criterion, const Block& block, std::uint8_t* codes);

}  // namespace mixcmp::emulator
