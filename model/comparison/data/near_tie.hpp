#pragma once

#include <gmpxx.h>

#include <array>

#include "model/base/number/float_format.hpp"
#include "model/base/number/lane_inputs.hpp"
#include "model/comparison/data/row_random.hpp"

namespace mixcmp::data {

/// The direction and the length of the line between the two centres.
enum class NearTieShape {
  along_axis,  ///< length just above 1: the largest relative errors
  diagonal,    ///< (1, sqrt(1/2), sqrt(1/2)), length just below sqrt(2): the largest errors in ulp
};

/// The lane for which a near tie is made: (dx^2 + dy^2) + dz^2 against (ri + rj)^2, in this order.
struct NearTieTarget {
  int precision;  ///< L
  LaneInputs inputs;
  Rounding rounding;
  NearTieShape shape;     ///< used only with exact inputs
  FloatFormat reference;  ///< format of the operands; L digits or more
};

/// cxi, cxj, cyi, cyj, czi, czj, ri, rj: integer * 2^exponent, each of them a number of the
/// reference format.
struct DyadicPair {
  std::array<mpz_class, 8> numbers;
  int exponent;
};

struct NearTieEffort {
  int attempts;       ///< 1 or more
  double enough_ulp;  ///< no more attempts once contradiction_ulp reaches this
};

struct NearTie {
  DyadicPair pair;
  /// (f_L - g_L) / max(f_L, g_L) in units of 2^-L, positive if the lane's order contradicts the
  /// truth. With exact inputs it is below the sum of all rounding errors: 8 for rounding to
  /// nearest, 10 toward zero.
  double contradiction_ulp;
};

/// The most misleading of several constructed pairs. Their exact f and g differ by about the last
/// place of the operands or less, while the lane's roundings all err towards the wrong order.
///
/// With exact inputs, significands lie just above 1, where half a last place, u = 2^-L, is largest
/// relative to the number. A hair is an amount much smaller than u. x = X - (u - a hair) rounds to
/// X = 1 + 2um, whose square is just above a midpoint (4u^2m^2 = (2k + 1)u modulo 2u). y^2 and z^2
/// are odd multiples of u plus a hair, so both sums round up as well: f_L is nearly f(1 + 5u). The
/// radii are built in the same way with another k but round down: g_L is nearly g(1 - 3u). For the
/// other wrong order all signs are reversed.
///
/// If inputs are rounded, every coordinate lies a hair from a midpoint of their digits, so the
/// errors of each difference add up in the same direction.
NearTie near_tie(const NearTieTarget& target, const NearTieEffort& effort, RowRandom& random);

/// Makes a near tie and then moves its radii by up to 10 * 2^-L of their sum, so that pairs lie on
/// either side of the limit of a lane's decisions.
DyadicPair near_edge(const NearTieTarget& target, RowRandom& random);

}  // namespace mixcmp::data
