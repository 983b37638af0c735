#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/emulator/block.hpp"

/// Lanes in fixed point on columns of doubles; compiled once per instruction set. A column holds
/// the number that an integer stands for, n u: that is exact up to 53 bits, and needs no alignment.
namespace mixcmp::emulator {

/// How a lane takes an operand. What it does not take becomes a NaN.
struct FixedConversion {
  double unit = 1;   ///< u, a power of two
  double limit = 0;  ///< the magnitudes taken are below this power of two
  bool is_signed = false;
};

/// Block floating point: divides the operands of each comparison, in place, by the least power of
/// two above all their magnitudes, or by 2^`least_exponent` where that is more. Where one is no
/// number, all become NaNs. `count`: a multiple of block_granularity.
void divide_by_common_power(std::span<double* const> operands, std::size_t count,
                            int least_exponent);

enum class FixedKernel : std::uint8_t {
  negate,
  absolute,
  add,
  subtract,
  multiply,
  minimum,
  maximum,
  add_product,                    ///< c + a b
  subtract_product,               ///< c - a b
  square_of_difference,           ///< (a - b)^2
  add_square_of_difference,       ///< c + (a - b)^2
  subtract_square_of_difference,  ///< c - (a - b)^2
  square_root,                    ///< of a, rounded to nearest
  truncate,                       ///< a, rounded down to a multiple of `unit`
  limit,                          ///< a if it is from `low` to `high`, a NaN otherwise
  /// 2^k `unit` for the least k >= 0 with a < 4^k `square_unit`; of a NaN anything.
  power_above_root,
};

struct FixedInstruction {
  FixedKernel kernel;
  int result = -1;
  int a = -1;
  int b = -1;
  int c = -1;
  double unit = 1;
  double square_unit = 1;
  double low = 0, high = 0;
};

/// Greater iff D >= slope_above s + offset_above, less iff -D > slope_below s + offset_below, where
/// D is the difference; `otherwise` elsewhere. A NaN leaves the comparison undecided. `greater`,
/// `less` and `otherwise` are codes of Decision.
struct FixedCriterion {
  int difference = -1;
  int radius = -1;  ///< column of s
  double slope_above = 0, offset_above = 0;
  double slope_below = 0, offset_below = 0;
  std::uint8_t greater = 2, less = 0, otherwise = 4;
};

/// `count`: a multiple of block_granularity.
void convert(const FixedConversion& conversion, const double* operands, std::size_t count,
             double* converted);
void execute(const std::vector<FixedInstruction>& instructions, const Block& block);
/// Writes one code of Decision per comparison.
void decide(const FixedCriterion& criterion, const Block& block, std::uint8_t* codes);

}  // namespace mixcmp::emulator
