#include "model/lane/function/piecewise.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/lane/function/taylor.hpp"

namespace mixcmp::function {
namespace {

constexpr int most_degree = 5;

/// The unit of s[0] is so many bits finer than that of the result: every coefficient and every cut
/// adds an error of about a unit of s[0]. A word that is the result needs none.
int guard_bits(int degree) {
  return degree == 0 ? 0 : 3;
}

/// Bounds are taken on so many parts of a piece, so that the Taylor coefficients of the difference
/// of function and polynomial are small.
constexpr int parts = 4;

/// Taylor coefficients beyond those of the polynomial that a bound looks at; the next one bounds
/// what is left.
constexpr int further_terms = 4;

mpq_class power(const mpq_class& base, int exponent) {
  mpq_class result = 1;
  for (int k = 0; k < exponent; ++k) result *= base;
  return result;
}

/// The pieces of the arguments with so many lower bits.
struct Pieces {
  FixedFormat argument;
  int piece_bits;
  mpz_class least, greatest;  ///< arguments
  mpz_class first, last;      ///< of the pieces that hold arguments: X / 2^piece_bits, rounded down

  Pieces(const FixedFormat& format, int bits, const mpz_class& from, const mpz_class& to)
      : argument(format),
        piece_bits(bits),
        least(from),
        greatest(to),
        first(upper(from)),
        last(upper(to)) {}

  mpz_class upper(const mpz_class& number) const {
    return floor_of(scaled(mpq_class(number), -piece_bits));
  }
  std::size_t address(const mpz_class& piece) const {
    mpz_class address;
    mpz_fdiv_r_2exp(address.get_mpz_t(), piece.get_mpz_t(),
                    static_cast<mp_bitcnt_t>(argument.width - piece_bits));
    return address.get_ui();
  }
  mpq_class start(const mpz_class& piece) const {
    return scaled(mpq_class(piece), piece_bits + argument.unit_exponent);
  }
  /// The t of the arguments in a piece.
  Range places(const mpz_class& piece) const {
    const mpz_class start = shifted_left(piece, piece_bits), most = shifted_left(1, piece_bits) - 1;
    const mpz_class from = least - start, to = greatest - start;
    return {scaled(mpq_class(std::max<mpz_class>(0, from)), argument.unit_exponent),
            scaled(mpq_class(std::min(most, to)), argument.unit_exponent)};
  }
  /// The greatest t of any piece.
  mpq_class span() const {
    return scaled(mpq_class(shifted_left(1, piece_bits) - 1), argument.unit_exponent);
  }
};

/// The polynomial in t that has the function's values at Chebyshev's points of the places, by
/// Newton's divided differences. Its coefficients are near those numbers; no proof relies on them.
std::vector<mpf_class> interpolated(Function function, const mpq_class& start, const Range& places,
                                    int degree) {
  const auto count = static_cast<std::size_t>(degree) + 1;
  const mpf_class zero(0, Interval::digits);
  std::vector<mpf_class> points, differences;
  for (std::size_t k = 0; k < count; ++k) {
    const double part = 0.5 - 0.5 * std::cos(double(2 * k + 1) * M_PI / double(2 * count));
    const mpq_class point = places.low + (places.high - places.low) * mpq_class(part);
    points.push_back(zero + point);
    differences.push_back(value(function, Interval(mpq_class(start + point))).middle());
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

using Polynomial = std::vector<Interval>;

/// The polynomial's coefficients around t = at.
Polynomial moved(Polynomial coefficients, const Interval& at) {
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    for (std::size_t i = coefficients.size() - 1; i-- > k;) {
      coefficients[i] = coefficients[i] + coefficients[i + 1] * at;
    }
  }
  return coefficients;
}

/// Encloses polynomial less function for all real t within `radius` of `centre`; none where the
/// function has no value.
std::optional<Range> difference_around(Function function, const Polynomial& polynomial,
                                       const mpq_class& start, const mpq_class& centre,
                                       const mpq_class& radius) {
  const auto terms = polynomial.size() + further_terms;
  const mpq_class x = start + centre;
  const Polynomial here = taylor(function, Interval(x), static_cast<int>(terms));
  const Interval rest =
      taylor(function, Interval(Range{x - radius, x + radius}), static_cast<int>(terms) + 1).back();
  if (!rest.is_bounded()) return std::nullopt;
  const Polynomial around = moved(polynomial, Interval(centre));
  const Interval reach(radius);
  Interval most = rest.magnitude();
  for (std::size_t k = terms; k-- > 1;) {
    const Interval difference = k < around.size() ? around[k] - here[k] : here[k];
    most = difference.magnitude() + reach * most;
  }
  most = reach * most;
  const Interval middle = around.front() - here.front();
  return Range{(middle - most).range().low, (middle + most).range().high};
}

/// The same for all real t of the places.
std::optional<Range> difference_on_piece(Function function, const Polynomial& polynomial,
                                         const mpq_class& start, const Range& places) {
  const mpq_class span = places.high - places.low, radius = span / (2 * parts);
  std::optional<Range> all;
  for (int part = 0; part < parts; ++part) {
    const mpq_class centre = places.low + span * mpq_class(2 * part + 1, 2 * parts);
    const auto found = difference_around(function, polynomial, start, centre, radius);
    if (!found) return std::nullopt;
    all = all ? Range{std::min(all->low, found->low), std::max(all->high, found->high)} : *found;
    if (radius == 0) break;
  }
  return all;
}

/// Piecewise polynomials of one degree, with pieces of so many bits.
class Candidate {
public:
  Candidate(Function function, Pieces pieces, int degree, int unit_exponent)
      : function_(function), pieces_(std::move(pieces)), degree_(degree), unit_(unit_exponent) {
    // Powers of t below 1 in magnitude need no coarser units for higher coefficients.
    const int span_exponent =
        pieces_.span() == 0 ? 0 : static_cast<int>(floor_log2(pieces_.span())) + 1;
    for (int k = 0; k <= degree_; ++k)
      units_.push_back(unit_ - guard_bits(degree_) - k * span_exponent);
  }

  int degree() const { return degree_; }
  int address_bits() const { return pieces_.argument.width - pieces_.piece_bits; }

  /// Tries the pieces at both ends and in the middle. False: the error is not less than a unit.
  bool may_do() {
    const mpz_class middle = floor_of(mpq_class(pieces_.first + pieces_.last) / 2);
    return add(pieces_.last) && add(pieces_.first) && add(middle);
  }

  /// The table's words with all pieces; none if the error is not less than a unit.
  std::optional<Piecewise> certified() {
    forget();
    for (mpz_class piece = pieces_.first; piece <= pieces_.last; ++piece) {
      if (!add(piece)) return std::nullopt;
    }
    return made();
  }

  /// Look-up tables of six inputs, roughly: 64 bits of a table each, a row of a product for each
  /// bit of t, an adder's bit for each of a sum. Of the pieces that were tried.
  double area() const {
    const double words = std::ldexp(1, address_bits());
    double luts = 0;
    for (std::size_t k = 0; k < units_.size(); ++k) {
      const int width = FixedFormat::holding(least_[k], greatest_[k], 0).width;
      luts += width * std::max(1.0, words / 64);
      if (k > 0) luts += 0.6 * width * pieces_.piece_bits;
      if (k + 1 < units_.size()) luts += width;
    }
    return luts;
  }

private:
  void forget() {
    error_.reset();
    words_.clear();
    least_.assign(units_.size(), 0);
    greatest_.assign(units_.size(), 0);
  }

  bool add(const mpz_class& piece) {
    if (words_.empty()) forget();
    const mpq_class start = pieces_.start(piece);
    const Range places = pieces_.places(piece);
    if (!value(function_, Interval(Range{start + places.low, start + places.high})).is_bounded()) {
      return false;
    }
    const std::vector<mpf_class> wanted = interpolated(function_, start, places, degree_);
    Polynomial rounded;
    std::vector<mpz_class> words;
    for (std::size_t k = 0; k < units_.size(); ++k) {
      // Cuts lower the result by half a unit of each coefficient's on average, and by half a unit
      // of the result.
      mpq_class raised = scaled(mpq_class(wanted[k]), -units_[k]) + mpq_class(1, 2);
      if (k + 1 < units_.size()) raised += mpq_class(1, 2);
      if (k == 0) raised += (mpq_class(1 << guard_bits(degree_)) - 1) / 2;
      words.push_back(floor_of(raised));
      rounded.emplace_back(scaled(mpq_class(words.back()), units_[k]));
      least_[k] = std::min(least_[k], words.back());
      greatest_[k] = std::max(greatest_[k], words.back());
    }
    const auto error = difference_on_piece(function_, rounded, start, places);
    if (!error) return false;
    const Range with_cuts = {error->low - cuts(), error->high};
    error_ =
        error_ ? Range{std::min(error_->low, with_cuts.low), std::max(error_->high, with_cuts.high)}
               : with_cuts;
    words_.emplace_back(pieces_.address(piece), std::move(words));
    const mpq_class unit = power_of_two(unit_);
    return error_->low > -unit && error_->high < unit;
  }

  /// The most that cuts lower a result: by less than a unit of s[k], times a power of t, and at
  /// last by less than a unit of the result.
  mpq_class cuts() const {
    mpq_class sum = power_of_two(unit_) - power_of_two(units_.front());
    for (int k = 0; k < degree_; ++k) {
      sum += power_of_two(units_[static_cast<std::size_t>(k)]) * power(pieces_.span(), k);
    }
    return sum;
  }

  Piecewise made() const {
    Piecewise made{.argument = pieces_.argument,
                   .piece_bits = pieces_.piece_bits,
                   .coefficients = {},
                   .result = {},
                   .error = *error_};
    for (std::size_t k = 0; k < units_.size(); ++k) {
      std::vector<mpz_class> table(std::size_t{1} << address_bits(), 0);
      for (const auto& [address, words] : words_) table[address] = words[k];
      made.coefficients.push_back(
          {FixedFormat::holding(least_[k], greatest_[k], units_[k]), Words(std::move(table))});
    }
    const mpq_class unit = pieces_.argument.unit();
    const Range values =
        value(function_, Interval(Range{pieces_.least * unit, pieces_.greatest * unit})).range();
    made.result =
        FixedFormat::holding(floor_of(scaled(values.low + error_->low, -unit_)),
                             ceiling_of(scaled(values.high + error_->high, -unit_)), unit_);
    return made;
  }

  Function function_;
  Pieces pieces_;
  int degree_, unit_;
  std::vector<int> units_;  ///< of s[k] and c[k]
  std::optional<Range> error_;
  std::vector<std::pair<std::size_t, std::vector<mpz_class>>> words_;  ///< by address, of pieces
  std::vector<mpz_class> least_, greatest_;                            ///< [k]: words
};

/// The candidate of a degree with the fewest pieces, `address_bits` or more, that may do.
std::optional<Candidate> candidate(Function function, const FixedFormat& argument,
                                   const mpz_class& least, const mpz_class& greatest,
                                   int unit_exponent, int degree, int address_bits) {
  const int most = std::min(argument.width, most_address_bits);
  if (argument.is_signed) address_bits = std::max(address_bits, 1);  // no piece has both signs
  for (; address_bits <= most; ++address_bits) {
    const int piece_bits = argument.width - address_bits;
    if (degree > 0 && piece_bits == 0) break;
    Candidate made(function, Pieces(argument, piece_bits, least, greatest), degree, unit_exponent);
    if (made.may_do()) return made;
  }
  return std::nullopt;
}

std::optional<Piecewise> search(Function function, const FixedFormat& argument,
                                const mpz_class& least, const mpz_class& greatest,
                                int unit_exponent) {
  const mpq_class unit = argument.unit();
  // A pole between two arguments may lie in no piece.
  if (!value(function, Interval(Range{least * unit, greatest * unit})).is_bounded()) {
    return std::nullopt;
  }
  std::vector<Candidate> open;
  const auto try_from = [&](int degree, int address_bits) {
    auto found =
        candidate(function, argument, least, greatest, unit_exponent, degree, address_bits);
    if (found) open.push_back(std::move(*found));
  };
  for (int degree = 0; degree <= most_degree; ++degree) try_from(degree, 0);
  while (!open.empty()) {
    const auto best = std::min_element(
        open.begin(), open.end(),
        [](const Candidate& a, const Candidate& b) { return a.area() < b.area(); });
    if (auto made = best->certified()) return made;
    const int degree = best->degree(), address_bits = best->address_bits() + 1;
    open.erase(best);
    try_from(degree, address_bits);
  }
  return std::nullopt;
}

}  // namespace

mpz_class evaluate(const Piecewise& piecewise, const mpz_class& argument) {
  const Pieces pieces(piecewise.argument, piecewise.piece_bits, argument, argument);
  const std::size_t address = pieces.address(pieces.first);
  const mpz_class t = argument - shifted_left(pieces.first, piecewise.piece_bits);
  const auto coefficient = [&](int k) -> const CoefficientTable& {
    return piecewise.coefficients[static_cast<std::size_t>(k)];
  };
  mpz_class sum = coefficient(piecewise.degree()).words[address];
  for (int k = piecewise.degree() - 1; k >= 0; --k) {
    const int exact = coefficient(k + 1).format.unit_exponent + piecewise.argument.unit_exponent;
    const mpq_class product =
        scaled(mpq_class(sum * t), exact - coefficient(k).format.unit_exponent);
    sum = coefficient(k).words[address] + floor_of(product);
  }
  const int finer = coefficient(0).format.unit_exponent - piecewise.result.unit_exponent;
  return floor_of(scaled(mpq_class(sum), finer));
}

std::optional<Piecewise> approximate(Function function, const FixedFormat& argument,
                                     const mpz_class& least, const mpz_class& greatest,
                                     int unit_exponent) {
  using Key = std::tuple<Function, int, int, bool, mpz_class, mpz_class, int>;
  static std::mutex mutex;
  static std::map<Key, std::optional<Piecewise>> known;
  const Key key(function, argument.width, argument.unit_exponent, argument.is_signed, least,
                greatest, unit_exponent);
  const std::scoped_lock lock(mutex);
  const auto found = known.find(key);
  if (found != known.end()) return found->second;
  return known[key] = search(function, argument, least, greatest, unit_exponent);
}

}  // namespace mixcmp::function
