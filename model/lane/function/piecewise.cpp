#include "model/lane/function/piecewise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/common/memo.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/lane/function/piece_polynomial.hpp"
#include "model/lane/function/pieces.hpp"
#include "model/lane/function/taylor.hpp"

namespace mixcmp::function {
namespace {

constexpr int most_degree = 8;

/// By this factor a degree's area is so much larger that higher degrees are not tried.
constexpr double much_larger = 1.5;

/// The unit of s[0] is at most so many bits finer than that of the result: every coefficient and
/// every cut adds an error of about a unit of s[0], all together at most half a unit of the result.
/// A word that is the result needs none.
int most_guard_bits(int degree) {
  return degree == 0 ? 0 : 2 + std::bit_width(static_cast<unsigned>(degree));
}

/// The look-up tables that one multiplier block is worth. Logic of the same width takes some 80
/// (12-bit factors), but has no sum behind it that would be there anyway.
constexpr double luts_of_block = 40;

/// Look-up tables of a product of logic, fitted to fixed_logic_product after Yosys' synth_xilinx
/// (model/cost/units/xilinx_7.csv): a row for every two bits of the narrower factor, two more, and
/// two bits more than the wider one in each.
double product_luts(ProductKind kind, int a_bits, int b_bits) {
  if (kind == ProductKind::embedded) return luts_of_block;
  const int rows = std::min(a_bits, b_bits) / 2 + 2;
  return 1.08 * rows * (std::max(a_bits, b_bits) + 2);
}

/// Look-up tables of six inputs for so many words from `least` to `greatest`, which follow a smooth
/// curve: each bit takes one for 64 words, but a high bit changes only in few of these blocks.
double rough_table_luts(double words, const mpz_class& least, const mpz_class& greatest) {
  const double range = mpz_class(greatest - least).get_d();
  const double blocks = std::max(1.0, words / 64);
  double luts = 0;
  for (double period = 1; period <= range; period *= 2) {
    luts += std::min(blocks, range / period + 1);
  }
  return luts;
}

mpq_class power(const mpq_class& base, int exponent) {
  mpq_class result = 1;
  for (int k = 0; k < exponent; ++k) result *= base;
  return result;
}

/// A table with words that nobody reads: each is that of an address that differs in one bit, the
/// highest possible. Where half of a table is not read, the halves become equal.
std::vector<mpz_class> completed(std::vector<std::optional<mpz_class>> table) {
  for (std::size_t bit = table.size() / 2; bit > 0; bit /= 2) {
    const std::vector<std::optional<mpz_class>> known = table;
    for (std::size_t address = 0; address < table.size(); ++address) {
      if (!known[address]) table[address] = known[address ^ bit];
    }
  }
  std::vector<mpz_class> words;
  for (std::optional<mpz_class>& word : table) words.push_back(std::move(*word));
  return words;
}

/// Piecewise polynomials of one degree, with pieces of so many bits.
class Candidate {
public:
  /// `arguments`: those of the pieces, as numbers.
  Candidate(Function function, Range arguments, Pieces pieces, int degree, int guard_bits,
            int unit_exponent, int coarse_bits = 0)
      : function_(std::move(function)),
        arguments_(std::move(arguments)),
        pieces_(std::move(pieces)),
        degree_(degree),
        guard_bits_(guard_bits),
        coarse_bits_(coarse_bits),
        unit_(unit_exponent) {
    // Powers of t below 1 in magnitude need no coarser units for higher coefficients.
    const int span_exponent =
        pieces_.span() == 0 ? 0 : static_cast<int>(floor_log2(pieces_.span())) + 1;
    for (int k = 0; k <= degree_; ++k) {
      units_.push_back(unit_ - guard_bits_ - k * span_exponent + (k > 0 ? coarse_bits_ : 0));
    }
  }

  int degree() const { return degree_; }
  int guard_bits() const { return guard_bits_; }
  int coarse_bits() const { return coarse_bits_; }
  bool is_floating() const { return pieces_.is_floating; }
  bool has_starts() const { return !pieces_.starts.empty(); }
  int address_bits() const { return pieces_.address_bits(); }

  /// Whether the piece of this argument errs by a unit or more. Works on a copy, because `add` also
  /// counts the piece in `area`.
  bool fails_at(const mpz_class& argument) const {
    Candidate copy = *this;
    return !copy.add(pieces_.of(argument));
  }

  /// Tries the pieces at both ends and in the middle. False: the error is not less than a unit.
  bool may_do() {
    const mpz_class middle = floor_of(mpq_class(pieces_.first + pieces_.last) / 2);
    return add(pieces_.last) && add(pieces_.first) && add(middle);
  }

  /// Tables of all pieces. If a piece errs by a unit or more: none, and `failing_argument` becomes
  /// its first argument.
  std::optional<Piecewise> certified(std::optional<mpz_class>& failing_argument) {
    forget();
    for (mpz_class piece = pieces_.first; piece <= pieces_.last; ++piece) {
      if (add(piece)) continue;
      failing_argument = pieces_.first_argument(piece);
      return std::nullopt;
    }
    return made();
  }

  /// Look-up tables of six inputs, roughly: of tables, products and sums. Of the pieces that were
  /// tried.
  double area(ProductKind products) const {
    const int bits = pieces_.argument.format.width;
    double luts = is_floating() ? 0.5 * bits * std::bit_width(static_cast<unsigned>(bits)) : 0;
    luts += static_cast<double>(pieces_.starts.size()) * bits;
    for (std::size_t k = 0; k < units_.size(); ++k) {
      const int width = FixedFormat::holding(least_[k], greatest_[k], 0).width;
      luts += table_area(k);
      if (k > 0) luts += product_luts(products, width + 1, pieces_.piece_bits + 1);
      if (k + 1 < units_.size()) luts += width;
    }
    return luts;
  }

private:
  void forget() {
    error_.reset();
    words_.clear();
    least_.clear();
    greatest_.clear();
  }

  /// Look-up tables of the table of t^k. The logarithm of base 2 is a whole number more in the next
  /// binade, so that its tables are those of one binade, with the exponent in front.
  double table_area(std::size_t k) const {
    double words = mpz_class(pieces_.last - pieces_.first + 1).get_d();
    mpz_class greatest = greatest_[k];
    const bool is_in_binades = function_.kind() == Function::log2 && pieces_.encoding;
    if (is_in_binades && function_.inner().offset == 0) {
      words = std::ldexp(1.0, pieces_.encoding->fraction_bits - pieces_.piece_bits);
      const mpz_class one = scaled(mpq_class(1), -units_[k]).get_num();
      if (k == 0) greatest = std::min<mpz_class>(greatest, least_[k] + one);
    }
    return rough_table_luts(words, least_[k], greatest);
  }

  bool add(const mpz_class& piece) {
    if (words_.empty()) forget();
    const Line line{pieces_.start(piece), pieces_.slope(piece)};
    const Range places = pieces_.places(piece);
    const Range arguments = {line.at(places.low), line.at(places.high)};
    if (!value(function_, Interval(arguments)).is_bounded()) return false;
    const std::vector<mpf_class> wanted = interpolated(function_, line, places, degree_);
    Polynomial rounded;
    std::vector<mpz_class> words;
    for (std::size_t k = 0; k < units_.size(); ++k) {
      // Cuts lower the result by half a unit of each coefficient's on average, and by half a unit
      // of the result.
      mpq_class raised = scaled(mpq_class(wanted[k]), -units_[k]) + mpq_class(1, 2);
      if (k + 1 < units_.size()) raised += mpq_class(1, 2);
      if (k == 0) raised += (mpq_class(1 << guard_bits_) - 1) / 2;
      words.push_back(floor_of(raised));
      rounded.emplace_back(scaled(mpq_class(words.back()), units_[k]));
    }
    if (words_.empty()) least_ = greatest_ = words;
    for (std::size_t k = 0; k < units_.size(); ++k) {
      least_[k] = std::min(least_[k], words[k]);
      greatest_[k] = std::max(greatest_[k], words[k]);
    }
    const auto error = difference_on_piece(function_, rounded, line, places);
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
                   .is_floating = is_floating(),
                   .piece_bits = pieces_.piece_bits,
                   .starts = pieces_.starts,
                   .coefficients = {},
                   .result = {},
                   .error = *error_};
    for (std::size_t k = 0; k < units_.size(); ++k) {
      std::vector<std::optional<mpz_class>> table(std::size_t{1} << address_bits());
      for (const auto& [address, words] : words_) table[address] = words[k];
      made.coefficients.push_back({FixedFormat::holding(least_[k], greatest_[k], units_[k]),
                                   Words(completed(std::move(table)))});
    }
    const Range values = value_on(function_, arguments_).range();
    made.result =
        FixedFormat::holding(floor_of(scaled(values.low + error_->low, -unit_)),
                             ceiling_of(scaled(values.high + error_->high, -unit_)), unit_);
    return made;
  }

  Function function_;
  Range arguments_;
  Pieces pieces_;
  int degree_, guard_bits_, coarse_bits_, unit_;
  std::vector<int> units_;  ///< of s[k] and c[k]
  std::optional<Range> error_;
  std::vector<std::pair<std::size_t, std::vector<mpz_class>>> words_;  ///< by address, of pieces
  std::vector<mpz_class> least_, greatest_;                            ///< [k]: words
};

/// The task of a search: a function, its arguments, and the unit of its values.
struct Wanted {
  Function function;
  Argument argument;
  mpz_class least, greatest;
  int unit_exponent;
  ProductKind products;

  friend auto operator<=>(const Wanted& a, const Wanted& b) { return a.key() <=> b.key(); }

  Range arguments() const {
    if (argument.encoding) {
      return {argument.encoding->number(least), argument.encoding->number(greatest)};
    }
    return {least * argument.format.unit(), greatest * argument.format.unit()};
  }
  /// Whether pieces that shrink towards 0 help. They do at 0 itself where the function ends there.
  bool may_be_floating() const {
    const Domain accepted = domain(function);
    const bool ends_at_zero = accepted.low && accepted.low->at == 0;
    return !argument.encoding && argument.format.width > 1 &&
           (least > 0 || (least == 0 && ends_at_zero));
  }

  /// Pieces that begin at the first argument and at the points of a table above it; none if those
  /// are too many.
  std::optional<Pieces> between_points() const {
    std::vector<mpz_class> starts = {least};
    for (const mpq_class& knot : function.interpolation().knots()) {
      const mpz_class start = ceiling_of(scaled(knot, -argument.format.unit_exponent));
      if (starts.back() < start && start <= greatest) starts.push_back(start);
    }
    if (starts.size() > most_starts) return std::nullopt;
    return Pieces(argument, std::move(starts), least, greatest);
  }

private:
  using Key = std::tuple<Function, int, int, bool, std::optional<FloatingEncoding>, std::string,
                         std::string, int, ProductKind>;
  Key key() const {
    const FixedFormat& format = argument.format;
    return {function,          format.width,      format.unit_exponent, format.is_signed,
            argument.encoding, least.get_str(62), greatest.get_str(62), unit_exponent,
            products};
  }
};

/// Candidates differ in these, and in the number of pieces.
struct Shape {
  bool is_floating;
  int degree, guard_bits;
  int coarse_bits;  ///< by which coefficients of t, t^2, ... are coarser than guard bits ask
};

/// The candidate of a shape with the fewest pieces, `address_bits` or more, that may do.
std::optional<Candidate> candidate(const Wanted& wanted, const Shape& shape, int address_bits,
                                   const std::optional<mpz_class>& failing_argument) {
  const Argument& argument = wanted.argument;
  const Pieces whole(argument, shape.is_floating, 0, wanted.least, wanted.greatest);
  const int most = std::min(whole.code.width, most_address_bits);
  // No piece has both signs, or two exponents.
  const int fewest = whole.encoding              ? whole.encoding->exponent_bits
                     : argument.format.is_signed ? 1
                                                 : 0;
  for (int bits = std::max(address_bits, fewest); bits <= most; ++bits) {
    const int piece_bits = whole.code.width - bits;
    if (shape.degree > 0 && piece_bits == 0) break;
    Candidate made(wanted.function, wanted.arguments(),
                   Pieces(argument, shape.is_floating, piece_bits, wanted.least, wanted.greatest),
                   shape.degree, shape.guard_bits, wanted.unit_exponent, shape.coarse_bits);
    if (made.may_do() && !(failing_argument && made.fails_at(*failing_argument))) return made;
  }
  return std::nullopt;
}

/// The shapes of a degree: with one guard bit fewer than the most, tables are narrower, but
/// polynomials must be nearer to the function.
std::vector<Shape> shapes_of(const Wanted& wanted, int degree) {
  std::vector<Shape> shapes;
  for (const bool is_floating : {false, true}) {
    if (is_floating && !wanted.may_be_floating()) continue;
    const int most = most_guard_bits(degree);
    for (int guard_bits = std::max(0, most - 1); guard_bits <= most; ++guard_bits) {
      const int most_coarse = degree > 0 && wanted.products == ProductKind::logic ? 2 : 0;
      for (int coarse_bits = 0; coarse_bits <= most_coarse; ++coarse_bits) {
        shapes.push_back({is_floating, degree, guard_bits, coarse_bits});
      }
    }
  }
  return shapes;
}

/// Looks for the smallest tables: of all candidates, the one of the least estimated area is made
/// whole. If it errs too much, the same shape with more pieces takes its place.
class Search {
public:
  explicit Search(const Wanted& wanted)
      : wanted_(wanted),
        // A polynomial of a higher degree than a table's follows its corners no better.
        highest_degree_(is_table() ? wanted.function.interpolation().degree() : most_degree) {}

  std::optional<Piecewise> run();

private:
  bool is_table() const { return wanted_.function.kind() == Function::table; }
  double least_area(std::size_t first = 0) const;
  bool needs_a_further_degree() const;
  void add(const Shape& shape, int address_bits);
  void add_degree();
  void add_between_points();
  std::optional<Piecewise> try_smallest();

  const Wanted& wanted_;
  int highest_degree_;
  std::vector<Candidate> open_;
  std::vector<double> first_areas_;            ///< [degree]: the least of its first candidates
  std::optional<mpz_class> failing_argument_;  ///< at which some candidate has failed
};

double Search::least_area(std::size_t first) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = first; k < open_.size(); ++k) {
    least = std::min(least, open_[k].area(wanted_.products));
  }
  return least;
}

/// Two degrees in a row that are much larger than the smallest candidate end the search for now:
/// the next ones are taken to be larger yet.
bool Search::needs_a_further_degree() const {
  const std::size_t degrees = first_areas_.size();
  if (static_cast<int>(degrees) > highest_degree_) return false;
  if (degrees < 2) return true;
  const double least = std::min(first_areas_[degrees - 1], first_areas_[degrees - 2]);
  return least <= much_larger * least_area();
}

void Search::add(const Shape& shape, int address_bits) {
  auto found = candidate(wanted_, shape, address_bits, failing_argument_);
  if (found) open_.push_back(std::move(*found));
}

void Search::add_degree() {
  const std::size_t before = open_.size();
  const auto degree = static_cast<int>(first_areas_.size());
  for (const Shape& shape : shapes_of(wanted_, degree)) add(shape, 0);
  first_areas_.push_back(least_area(before));
}

void Search::add_between_points() {
  auto pieces = wanted_.between_points();
  if (!pieces) return;
  Candidate made(wanted_.function, wanted_.arguments(), std::move(*pieces), highest_degree_,
                 most_guard_bits(highest_degree_), wanted_.unit_exponent);
  if (made.may_do()) open_.push_back(std::move(made));
}

/// The tables of the smallest candidate. If it errs too much: none, and one with more pieces.
std::optional<Piecewise> Search::try_smallest() {
  const auto smallest =
      std::min_element(open_.begin(), open_.end(), [&](const Candidate& a, const Candidate& b) {
        return a.area(wanted_.products) < b.area(wanted_.products);
      });
  if (!(failing_argument_ && smallest->fails_at(*failing_argument_))) {
    if (auto made = smallest->certified(failing_argument_)) return made;
  }
  const Shape shape{smallest->is_floating(), smallest->degree(), smallest->guard_bits(),
                    smallest->coarse_bits()};
  const bool has_starts = smallest->has_starts();
  const int address_bits = smallest->address_bits() + 1;
  open_.erase(smallest);
  if (!has_starts) add(shape, address_bits);
  return std::nullopt;
}

std::optional<Piecewise> Search::run() {
  // A pole between two arguments may lie in no piece.
  if (!value_on(wanted_.function, wanted_.arguments()).is_bounded()) return std::nullopt;
  if (is_table()) add_between_points();
  for (;;) {
    while (needs_a_further_degree()) add_degree();
    if (open_.empty()) return std::nullopt;
    if (auto made = try_smallest()) return made;
  }
}

}  // namespace

FixedFormat FloatingEncoding::format() const {
  return {.width = exponent_bits + fraction_bits, .unit_exponent = -fraction_bits};
}

mpq_class FloatingEncoding::number(const mpz_class& code) const {
  const mpz_class field = floor_of(scaled(mpq_class(code), -fraction_bits));
  if (field < least_field) return 0;
  const mpz_class one = shifted_left(1, fraction_bits);
  const int exponent = static_cast<int>(field.get_si()) + exponent_of_0;
  return scaled(mpq_class(one + code - field * one), exponent - fraction_bits);
}

FloatingEncoding FloatingCode::encoding(int unit_exponent) const {
  return {.fraction_bits = fraction_bits(),
          .exponent_bits = exponent_bits(),
          .exponent_of_0 = unit_exponent - offset(),
          .least_field = offset()};
}

mpz_class FloatingCode::of(const mpz_class& number) const {
  MIXCMP_CHECK(number >= 0);
  if (number == 0) return shifted_left(offset() - 1, fraction_bits());
  const int exponent = digits_of(number) - 1;
  const mpz_class significand = shifted_left(number, fraction_bits() - exponent);
  return shifted_left(exponent + offset() - 1, fraction_bits()) + significand;
}

FixedFormat Piecewise::code() const {
  if (!is_floating) return argument.format;
  return FloatingCode{argument.format.width}.encoding(argument.format.unit_exponent).format();
}

int Piecewise::address_bits() const {
  if (!starts.empty()) return static_cast<int>(std::bit_width(starts.size() - 1));
  return code().width - piece_bits;
}

mpz_class evaluate(const Piecewise& piecewise, const mpz_class& argument) {
  const Pieces pieces = piecewise.starts.empty()
                            ? Pieces(piecewise.argument, piecewise.is_floating,
                                     piecewise.piece_bits, argument, argument)
                            : Pieces(piecewise.argument, piecewise.starts, argument, argument);
  const std::size_t address = pieces.address(pieces.first);
  const mpz_class t = pieces.least - pieces.first_code(pieces.first);
  const auto coefficient = [&](int k) -> const CoefficientTable& {
    return piecewise.coefficients[static_cast<std::size_t>(k)];
  };
  mpz_class sum = coefficient(piecewise.degree()).words[address];
  for (int k = piecewise.degree() - 1; k >= 0; --k) {
    const int exact = coefficient(k + 1).format.unit_exponent + pieces.code.unit_exponent;
    const mpq_class product =
        scaled(mpq_class(sum * t), exact - coefficient(k).format.unit_exponent);
    sum = coefficient(k).words[address] + floor_of(product);
  }
  const int finer = coefficient(0).format.unit_exponent - piecewise.result.unit_exponent;
  return floor_of(scaled(mpq_class(sum), finer));
}

std::optional<Piecewise> approximate(const Function& function, const Argument& argument,
                                     const mpz_class& least, const mpz_class& greatest,
                                     int unit_exponent, ProductKind products) {
  const Wanted wanted{function, argument, least, greatest, unit_exponent, products};
  static Memo<Wanted, std::optional<Piecewise>> known;
  return *known.of(wanted, [&] { return Search(wanted).run(); });
}

}  // namespace mixcmp::function
