#include "model/comparison/expression/interpolation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "model/comparison/expression/text.hpp"

namespace mixcmp::inline expression {
namespace {

/// The coefficients, in powers of x - centre, of the polynomial through points, by Newton's divided
/// differences.
std::vector<mpq_class> through_points(const mpq_class* x, const mpq_class* y, std::size_t count,
                                      const mpq_class& centre) {
  std::vector<mpq_class> differences(y, y + count);
  for (std::size_t order = 1; order < count; ++order) {
    for (std::size_t k = count - 1; k >= order; --k) {
      differences[k] = (differences[k] - differences[k - 1]) / (x[k] - x[k - order]);
    }
  }
  std::vector<mpq_class> coefficients(count);
  for (std::size_t k = count; k-- > 0;) {  // times (x - x[k]), plus the next difference
    const mpq_class root = x[k] - centre;
    for (std::size_t i = count - 1; i > 0; --i) {
      coefficients[i] = coefficients[i - 1] - coefficients[i] * root;
    }
    coefficients[0] = differences[k] - coefficients[0] * root;
  }
  return coefficients;
}

std::strong_ordering order_of(const std::vector<mpq_class>& a, const std::vector<mpq_class>& b) {
  if (a.size() != b.size()) return a.size() <=> b.size();
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] != b[k]) return cmp(a[k], b[k]) <=> 0;
  }
  return std::strong_ordering::equal;
}

}  // namespace

Result<Interpolation> Interpolation::through(std::vector<mpq_class> x, std::vector<mpq_class> y,
                                             int degree) {
  const auto least = static_cast<std::size_t>(degree) + 1;
  if (x.size() < least || x.size() > most_points) {
    return Error{.message = fmt::format("{} points for a table of degree {}",
                                        x.size() < least ? "too few" : "too many", degree),
                 .received = std::to_string(x.size()),
                 .accepted = fmt::format("{}..{} points", least, most_points)};
  }
  for (std::size_t k = 1; k < x.size(); ++k) {
    if (x[k - 1] < x[k]) continue;
    return Error{.message = fmt::format("x of point {} is not above that of the point before", k),
                 .received = fmt::format("{} after {}", to_text(x[k]), to_text(x[k - 1])),
                 .accepted = "points in the order of growing x, each x once"};
  }
  return Interpolation(std::move(x), std::move(y), degree);
}

Interpolation::Interpolation(std::vector<mpq_class> x, std::vector<mpq_class> y, int degree)
    : x_(std::move(x)), y_(std::move(y)), degree_(degree) {
  for (std::size_t segment = 0; segment + 1 < x_.size(); ++segment) {
    const std::size_t first = first_point(segment);
    polynomials_.push_back(
        through_points(&x_[first], &y_[first], static_cast<std::size_t>(degree) + 1, x_[segment]));
  }
}

std::strong_ordering operator<=>(const Interpolation& a, const Interpolation& b) {
  if (a.degree_ != b.degree_) return a.degree_ <=> b.degree_;
  if (const auto order = order_of(a.x_, b.x_); order != 0) return order;
  return order_of(a.y_, b.y_);
}

std::size_t Interpolation::first_point(std::size_t segment) const {
  const auto degree = static_cast<std::size_t>(degree_), before = (degree - 1) / 2;
  const std::size_t last_first = x_.size() - 1 - degree;
  return std::min(segment < before ? 0 : segment - before, last_first);
}

std::size_t Interpolation::segment_of(const mpq_class& x) const {
  const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  return static_cast<std::size_t>(above - x_.begin()) - 1;
}

mpq_class Interpolation::at(const mpq_class& x) const {
  if (x <= x_.front()) return y_.front();
  if (x >= x_.back()) return y_.back();
  const std::size_t segment = segment_of(x);
  const mpq_class from_knot = x - x_[segment];
  mpq_class sum = 0;
  for (auto k = polynomials_[segment].rbegin(); k != polynomials_[segment].rend(); ++k) {
    sum = sum * from_knot + *k;
  }
  return sum;
}

}  // namespace mixcmp::inline expression
