#pragma once

#include <gmpxx.h>

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

#include "model/base/common/result.hpp"

namespace mixcmp::inline expression {

/// The function through measured points, which is continuous: between two neighbours it is the
/// polynomial of one degree through them and their neighbours on both sides (one more on the right
/// if the degree is even; at the ends of the table, through the outermost points). Degree 1 is
/// piecewise linear.
class Interpolation {
public:
  static constexpr int most_degree = 7;
  static constexpr std::size_t most_points = 1 << 12;

  /// The coordinates of the points, x growing. Errors: fewer points than the degree needs, more
  /// than most_points, an x that is not above the one before.
  static Result<Interpolation> through(std::vector<mpq_class> x, std::vector<mpq_class> y,
                                       int degree);

  int degree() const { return degree_; }
  /// The places of the points.
  const std::vector<mpq_class>& knots() const { return x_; }
  /// The segment whose interval [knots()[k], knots()[k + 1]] holds x, the last one that does; the
  /// nearest if none does.
  std::size_t segment_of(const mpq_class& x) const;
  /// The coefficients of the segment's polynomial in powers of x - knots()[segment].
  const std::vector<mpq_class>& polynomial(std::size_t segment) const {
    return polynomials_[segment];
  }
  /// The value at x; beyond the first and the last point, their values.
  mpq_class at(const mpq_class& x) const;

  friend std::strong_ordering operator<=>(const Interpolation& a, const Interpolation& b);

private:
  Interpolation(std::vector<mpq_class> x, std::vector<mpq_class> y, int degree);
  /// The first point of a segment's polynomial.
  std::size_t first_point(std::size_t segment) const;

  std::vector<mpq_class> x_, y_;
  int degree_;
  std::vector<std::vector<mpq_class>> polynomials_;  ///< [segment][power]
};

}  // namespace mixcmp::inline expression
