#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>

#include "model/base/number/float_format.hpp"
#include "model/comparison/data/near_tie.hpp"
#include "model/comparison/data/row_random.hpp"

namespace mixcmp::data {

/// Makes one row of one family of sphere pairs. Call one family's function, and only once.
class SpherePairMaker {
public:
  /// cxi, cxj, cyi, cyj, czi, czj, ri, rj.
  using Row = std::array<Bits, 8>;
  /// The precisions for which counterexamples are made.
  static constexpr int first_counterexample = 11, last_counterexample = 32;

  SpherePairMaker(FloatFormat format, std::uint64_t row, RowRandom random)
      : format_(format), row_(row), random_(random) {}

  /// Centres in [0, 100)^3, radii in [0, 25).
  Row uniform();
  /// Touching spheres: x^2 + y^2 + z^2 = (ri + rj)^2. All distances and radii are integers times
  /// one power of two, which is exact if the format has 11 digits or more. In a third of the rows
  /// one number is moved to the next encoding.
  Row tangent();
  /// Equal centres: f = 0. A quarter of the rows have radii of zero (a tie), a quarter radii whose
  /// square underflows or nearly does, the others any radii.
  Row coincident();
  /// The second sphere lies deep inside the first, its centre nearby.
  Row nested();
  /// Every coordinate is about 10^decimal_exponent, where the last place is coarse. In half of the
  /// rows the spheres nearly touch.
  template <int decimal_exponent>
  Row offset() {
    return far_from_origin(decimal_exponent);
  }
  /// Numbers around the smallest subnormal or the smallest normal number; or touching spheres with
  /// squared distances around the smallest normal number.
  Row smallest();
  /// Numbers around the largest finite one; or touching spheres with coordinates of that size, or
  /// with squared distances of that size.
  Row largest();
  /// Nearly touching spheres, scaled by any power of two in the format.
  Row scales();
  /// In half of the rows every number has its own random exponent. In the others the radii sum to
  /// exactly one huge difference; compared with it the other two differences are so small that they
  /// vanish, although they decide.
  Row mixed_scales();
  /// Points: radii of zero, of either sign, so that g = 0. The centres coincide, differ in one last
  /// place, or lie anywhere.
  Row zero_radii();
  /// Nearly touching spheres, one radius or both negated.
  Row negative_radii();
  /// Whole numbers 0..15 of one power of two, radii to 25 of it: many exact ties.
  Row grid();
  /// One to three numbers are not finite or at the ends of the format; one at least is not finite.
  Row infinities_and_nans();
  /// Makes a near tie for a lane with exact inputs that rounds to nearest, of 11 + row mod 22
  /// digits (a smaller modulus if the format has less than 32 digits). The lane's error on it is
  /// near the proven bound, far beyond the errors of random samples.
  Row counterexample();
  /// Makes a row that misleads a lane of this precision. Odd rows are made for a lane with rounded
  /// inputs. Rows 0 and 1 of four are made for a lane that rounds to nearest, rows 2 and 3 for one
  /// that rounds toward zero. A random half of the rows are near ties (data::near_tie). The others
  /// lie near the limit of the lane's decisions (near_edge).
  Row near_tie(int precision);

  /// A finite number did not fit the format.
  bool overflowed() const { return overflowed_; }

private:
  Bits encode(const mpq_class& value);
  Row encode(const DyadicPair& pair);
  /// The value of an encoding; zero for an infinity, since a row that overflows is an error anyway.
  mpq_class decode(Bits bits) const;
  /// A random number in [0, limit): limit times a fraction of as many digits as the format has.
  mpq_class unit(const mpq_class& limit);
  /// A random coordinate in [0, 100 * 2^exponent).
  Bits coordinate(int exponent);
  mpq_class any_exponent();
  /// The next encoding away from zero (steps = 1) or towards it (steps = -1). The largest finite
  /// number and zero, which have none, are returned unchanged.
  Bits next(Bits value, int steps) const;
  Bits signed_randomly(Bits magnitude);

  /// Sets the radii so that their sum is the distance, as nearly as the format can, or is close to
  /// it.
  void touch(Row& row);
  /// Touching spheres in a cube of side 100 * 2^exponent.
  Row touching(int exponent);
  Row far_from_origin(int decimal_exponent);
  /// Every number lies at most `reach` encodings from `middle`. Coordinates have random signs.
  Row encodings_around(Bits middle, int reach);
  /// The radii sum to exactly the distance along one axis; the other two vanish compared with it.
  Row vanishing();

  FloatFormat format_;
  std::uint64_t row_;
  RowRandom random_;
  bool overflowed_ = false;
};

}  // namespace mixcmp::data
