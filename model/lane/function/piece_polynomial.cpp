#include "model/lane/function/piece_polynomial.hpp"

#include <algorithm>
#include <cmath>

#include "model/lane/function/taylor.hpp"

namespace mixcmp::function {
namespace {

/// Bounds are taken on so many parts of a piece, so that the Taylor coefficients of the difference
/// of function and polynomial are small.
constexpr int parts = 4;

/// Taylor coefficients beyond those of the polynomial that a bound looks at; the next one bounds
/// what is left.
constexpr int further_terms = 4;

/// The polynomial's coefficients around t = at.
Polynomial moved(Polynomial coefficients, const Interval& at) {
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    for (std::size_t i = coefficients.size() - 1; i-- > k;) {
      coefficients[i] = coefficients[i] + coefficients[i + 1] * at;
    }
  }
  return coefficients;
}

/// A part of a piece's places where the function has all derivatives. On a table of points it is a
/// polynomial there, in x - knot.
struct SmoothPart {
  Range places;
  std::optional<Polynomial> polynomial = {};
  mpq_class knot = 0;

  /// The function's Taylor coefficients in t around x; the last one is enclosed for all numbers
  /// within `reach` of x.
  Polynomial series(const Function& function, const mpq_class& x, const mpq_class& reach, int count,
                    const mpq_class& slope) const {
    if (polynomial) {
      Polynomial around = moved(*polynomial, Interval(x - knot));
      around.resize(static_cast<std::size_t>(count), 0);
      return composed(around, line(x, slope, around.size()));
    }
    Polynomial around = taylor(function, Interval(x), count - 1, slope);
    const Interval all(Range{x - reach, x + reach});
    around.push_back(taylor(function, all, count, slope).back());
    return around;
  }
};

/// The parts of a piece between the points of a table, and beyond them, where it is constant.
std::vector<SmoothPart> smooth_parts(const Function& function, const Line& line,
                                     const Range& places) {
  if (function.kind() != Function::table) return {{places}};
  const Interpolation& table = function.interpolation();
  const std::vector<mpq_class>& knots = table.knots();
  std::vector<SmoothPart> all;
  const auto add = [&](const mpq_class& from, const mpq_class& to) {
    const mpq_class inside = line.at((from + to) / 2);
    if (inside < knots.front() || inside > knots.back()) {
      all.push_back({{from, to}, Polynomial{table.at(inside)}});
      return;
    }
    const std::size_t segment = table.segment_of(inside);
    const std::vector<mpq_class>& exact = table.polynomial(segment);
    all.push_back({{from, to}, Polynomial(exact.begin(), exact.end()), knots[segment]});
  };
  mpq_class from = places.low;
  const auto first = std::upper_bound(knots.begin(), knots.end(), line.at(from));
  for (auto knot = first; knot != knots.end(); ++knot) {
    const mpq_class place = (*knot - line.start) / line.slope;
    if (place >= places.high) break;
    add(from, place);
    from = place;
  }
  add(from, places.high);
  return all;
}

/// Encloses polynomial less function for all real t within `radius` of `centre`; none where the
/// function has no value.
std::optional<Range> difference_around(const Function& function, const SmoothPart& smooth,
                                       const Polynomial& polynomial, const Line& line,
                                       const mpq_class& centre, const mpq_class& radius) {
  if (radius == 0) {
    const Interval number = moved(polynomial, Interval(centre)).front();
    return (number - value(function, Interval(line.at(centre)))).range();
  }
  const auto terms = polynomial.size() + further_terms;
  const Polynomial here = smooth.series(function, line.at(centre), line.slope * radius,
                                        static_cast<int>(terms) + 1, line.slope);
  if (!here.back().is_bounded()) return std::nullopt;
  const Polynomial around = moved(polynomial, Interval(centre));
  const Interval reach(radius);
  Interval most = here.back().magnitude();
  for (std::size_t k = terms; k-- > 1;) {
    const Interval difference = k < around.size() ? around[k] - here[k] : here[k];
    most = difference.magnitude() + reach * most;
  }
  most = reach * most;
  const Interval middle = around.front() - here.front();
  return Range{(middle - most).range().low, (middle + most).range().high};
}

}  // namespace

std::vector<mpf_class> interpolated(const Function& function, const Line& line, const Range& places,
                                    int degree) {
  const auto count = static_cast<std::size_t>(degree) + 1;
  const mpf_class zero(0, Interval::digits);
  std::vector<mpf_class> points, differences;
  for (std::size_t k = 0; k < count; ++k) {
    const double part = 0.5 - 0.5 * std::cos(double(2 * k + 1) * M_PI / double(2 * count));
    const mpq_class point = places.low + (places.high - places.low) * mpq_class(part);
    points.push_back(zero + point);
    differences.push_back(value(function, Interval(line.at(point))).middle());
  }
  std::vector<mpf_class> coefficients(count, zero);
  if (places.low == places.high) {
    coefficients[0] = differences[0];
    return coefficients;
  }
  for (std::size_t order = 1; order < count; ++order) {
    for (std::size_t k = count - 1; k >= order; --k) {
      differences[k] = (differences[k] - differences[k - 1]) / (points[k] - points[k - order]);
    }
  }
  for (std::size_t k = count; k-- > 0;) {  // times (t - point), plus the next difference
    for (std::size_t i = count - 1; i > 0; --i) {
      coefficients[i] = coefficients[i - 1] - coefficients[i] * points[k];
    }
    coefficients[0] = differences[k] - coefficients[0] * points[k];
  }
  return coefficients;
}

std::optional<Range> difference_on_piece(const Function& function, const Polynomial& polynomial,
                                         const Line& line, const Range& places) {
  std::optional<Range> all;
  for (const SmoothPart& smooth : smooth_parts(function, line, places)) {
    const mpq_class span = smooth.places.high - smooth.places.low, radius = span / (2 * parts);
    for (int part = 0; part < parts; ++part) {
      const mpq_class centre = smooth.places.low + span * mpq_class(2 * part + 1, 2 * parts);
      const auto found = difference_around(function, smooth, polynomial, line, centre, radius);
      if (!found) return std::nullopt;
      all = all ? Range{std::min(all->low, found->low), std::max(all->high, found->high)} : *found;
      if (radius == 0) break;
    }
  }
  return all;
}

}  // namespace mixcmp::function
