#include "model/lane/function/piecewise.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/lane/function/taylor.hpp"

namespace mixcmp::function {
namespace {

constexpr int most_degree = 5;

/// The unit of s[0] is so many bits finer than that of the result: every coefficient and every cut
/// adds an error of about a unit of s[0].
constexpr int guard_bits = 3;

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

mpq_class magnitude(const Interval& x) {
  const Range range = x.range();
  return std::max<mpq_class>(abs(range.low), abs(range.high));
}

/// The pieces of the arguments with so many lower bits.
struct Pieces {
  FixedFormat argument;
  int piece_bits;
  mpz_class first, last;  ///< of the pieces that hold arguments: X / 2^piece_bits, rounded down

  Pieces(const FixedFormat& format, int bits, const mpz_class& least, const mpz_class& greatest)
      : argument(format), piece_bits(bits), first(upper(least)), last(upper(greatest)) {}

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
  /// The greatest t.
  mpq_class span() const {
    return scaled(mpq_class(shifted_left(1, piece_bits) - 1), argument.unit_exponent);
  }
};

/// The polynomial in t that has the function's values at Chebyshev's points of the piece, by
/// Newton's divided differences. Its coefficients are near those numbers; no proof relies on them.
std::vector<mpq_class> interpolated(Function function, const mpq_class& start,
                                    const mpq_class& span, int degree) {
  std::vector<mpq_class> points, differences;
  for (int k = 0; k <= degree; ++k) {
    const double place = 0.5 - 0.5 * std::cos((2 * k + 1) * M_PI / (2 * degree + 2));
    points.push_back(span * mpq_class(place));
    differences.push_back(value(function, Interval(mpq_class(start + points.back()))).middle());
  }
  for (int order = 1; order <= degree && span > 0; ++order) {
    for (int k = degree; k >= order; --k) {
      differences[static_cast<std::size_t>(k)] =
          (differences[static_cast<std::size_t>(k)] -
           differences[static_cast<std::size_t>(k) - 1]) /
          (points[static_cast<std::size_t>(k)] - points[static_cast<std::size_t>(k - order)]);
    }
  }
  std::vector<mpq_class> coefficients = {differences.back()};
  for (int k = degree - 1; k >= 0; --k) {  // times (t - point), plus the next difference
    coefficients.insert(coefficients.begin(), 0);
    for (std::size_t i = 0; i + 1 < coefficients.size(); ++i) {
      coefficients[i] -= coefficients[i + 1] * points[static_cast<std::size_t>(k)];
    }
    coefficients.front() += differences[static_cast<std::size_t>(k)];
  }
  return coefficients;
}

/// The polynomial's coefficients around t = at.
std::vector<mpq_class> moved(std::vector<mpq_class> coefficients, const mpq_class& at) {
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    for (std::size_t i = coefficients.size() - 1; i-- > k;) {
      coefficients[i] += coefficients[i + 1] * at;
    }
  }
  return coefficients;
}

/// Encloses polynomial less function for all real t of [0, span]; none where the function has no
/// value.
std::optional<Range> difference_on_piece(Function function,
                                         const std::vector<mpq_class>& polynomial,
                                         const mpq_class& start, const mpq_class& span) {
  const int terms = static_cast<int>(polynomial.size()) + further_terms;
  const mpq_class radius = span / (2 * parts);
  std::optional<Range> all;
  for (int part = 0; part < parts; ++part) {
    const mpq_class centre = span * mpq_class(2 * part + 1, 2 * parts);
    const mpq_class x = start + centre;
    const std::vector<Interval> here = taylor(function, Interval(x), terms);
    const Interval rest =
        taylor(function, Interval(Range{x - radius, x + radius}), terms + 1).back();
    if (!rest.is_bounded()) return std::nullopt;
    const std::vector<mpq_class> around = moved(polynomial, centre);
    const Range middle = (Interval(around.front()) - here.front()).range();
    mpq_class most = magnitude(rest) * power(radius, terms);
    for (int k = 1; k < terms; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const Interval coefficient = at < around.size() ? Interval(around[at]) - here[at] : here[at];
      most += magnitude(coefficient) * power(radius, k);
    }
    const Range found = {middle.low - most, middle.high + most};
    all = all ? Range{std::min(all->low, found.low), std::max(all->high, found.high)} : found;
  }
  return all;
}

/// A piecewise polynomial of this degree and with pieces of so many bits; none if its error is not
/// less than a unit.
class Maker {
public:
  Maker(Function function, Pieces pieces, int degree, int unit_exponent)
      : function_(function), pieces_(std::move(pieces)), degree_(degree), unit_(unit_exponent) {}

  std::optional<Piecewise> make() {
    // Powers of t below 1 in magnitude need no coarser units for higher coefficients.
    const int span_exponent =
        pieces_.span() == 0 ? 0 : static_cast<int>(floor_log2(pieces_.span())) + 1;
    for (int k = 0; k <= degree_; ++k) units_.push_back(unit_ - guard_bits - k * span_exponent);
    for (mpz_class piece = pieces_.first; piece <= pieces_.last; ++piece) {
      if (!add(piece)) return std::nullopt;
    }
    return finished();
  }

private:
  bool add(const mpz_class& piece) {
    const mpq_class start = pieces_.start(piece), span = pieces_.span();
    const Interval whole(Range{start, start + span});
    if (!value(function_, whole).is_bounded()) return false;
    const std::vector<mpq_class> wanted = interpolated(function_, start, span, degree_);
    std::vector<mpq_class> rounded;
    std::vector<mpz_class> words;
    for (int k = 0; k <= degree_; ++k) {
      const int unit = units_[static_cast<std::size_t>(k)];
      // Cuts lower the result by half a unit of each coefficient's on average, and by half a unit
      // of the result.
      mpq_class raised = scaled(wanted[static_cast<std::size_t>(k)], -unit) + mpq_class(1, 2);
      if (k < degree_) raised += mpq_class(1, 2);
      if (k == 0) raised += (mpq_class(1 << guard_bits) - 1) / 2;
      words.push_back(floor_of(raised));
      rounded.push_back(scaled(mpq_class(words.back()), unit));
    }
    const auto error = difference_on_piece(function_, rounded, start, span);
    if (!error) return false;
    const Range with_cuts = {error->low - cuts(), error->high};
    if (with_cuts.high - with_cuts.low >= 2 * power_of_two(unit_)) return false;
    error_ =
        error_ ? Range{std::min(error_->low, with_cuts.low), std::max(error_->high, with_cuts.high)}
               : with_cuts;
    pieces_with_words_.emplace_back(pieces_.address(piece), std::move(words));
    return true;
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

  std::optional<Piecewise> finished() {
    const mpq_class unit = power_of_two(unit_);
    if (error_->low <= -unit || error_->high >= unit) return std::nullopt;
    Piecewise made{.argument = pieces_.argument,
                   .piece_bits = pieces_.piece_bits,
                   .coefficients = {},
                   .result = {},
                   .error = *error_};
    const std::size_t size = std::size_t{1} << (pieces_.argument.width - pieces_.piece_bits);
    for (std::size_t k = 0; k <= static_cast<std::size_t>(degree_); ++k) {
      CoefficientTable& table = made.coefficients.emplace_back();
      table.words.assign(size, 0);
      mpz_class least = 0, greatest = 0;
      for (const auto& [address, words] : pieces_with_words_) {
        table.words[address] = words[k];
        least = std::min(least, words[k]);
        greatest = std::max(greatest, words[k]);
      }
      table.format = FixedFormat::holding(least, greatest, units_[k]);
    }
    const Interval all =
        value(function_, Interval(Range{pieces_.start(pieces_.first),
                                        pieces_.start(pieces_.last) + pieces_.span()}));
    const Range values = all.range();
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
  std::vector<std::pair<std::size_t, std::vector<mpz_class>>> pieces_with_words_;
};

/// Look-up tables of six inputs, roughly: 64 bits of a table each, a row of a product for each bit
/// of t, an adder's bit for each of a sum.
double area(const Piecewise& made) {
  double luts = 0;
  for (const CoefficientTable& table : made.coefficients) {
    luts += table.format.width * std::max(1.0, double(table.words.size()) / 64);
  }
  for (int k = made.degree(); k > 0; --k) {
    const int width = made.coefficients[static_cast<std::size_t>(k)].format.width;
    luts += 0.6 * width * made.piece_bits +
            made.coefficients[static_cast<std::size_t>(k) - 1].format.width;
  }
  return luts;
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
  std::optional<Piecewise> best;
  for (int degree = 0; degree <= most_degree; ++degree) {
    const int most = std::min(argument.width, most_address_bits);
    for (int address_bits = 0; address_bits <= most; ++address_bits) {
      const int piece_bits = argument.width - address_bits;
      if (degree > 0 && piece_bits == 0) break;
      auto made =
          Maker(function, Pieces(argument, piece_bits, least, greatest), degree, unit_exponent)
              .make();
      if (!made) continue;
      if (!best || area(*made) < area(*best)) best = std::move(made);
      break;  // more pieces of this degree only make tables larger
    }
  }
  return best;
}

}  // namespace mixcmp::function
