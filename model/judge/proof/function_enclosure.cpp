#include "model/judge/proof/function_enclosure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "model/base/number/dyadic.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/judge/proof/jump_enclosure.hpp"
#include "model/lane/fixed/node_enclosure.hpp"
#include "model/lane/function/taylor.hpp"

namespace mixcmp::proof {
namespace {

using fixed::Conversion;
using fixed::FixedNode;
using function::FloatingCode;
using function::Interval;

/// A piece is bounded on so many parts, with so many terms of the series beyond the polynomial's.
constexpr int parts = 4;
constexpr std::size_t further_terms = 4;

/// A lane with more pieces than a table has words is no lane of this program.
constexpr int most_pieces = 1 << function::most_address_bits;

using Polynomial = std::vector<mpq_class>;  ///< [k]: the coefficient of t^k

Range values_of(const Polynomial& polynomial, const Range& t) {
  Range values = {0, 0};
  for (std::size_t k = polynomial.size(); k-- > 0;) {
    values = sum(product(values, t), {polynomial[k], polynomial[k]});
  }
  return values;
}

Polynomial sum_of(Polynomial a, const Polynomial& b) {
  a.resize(std::max(a.size(), b.size()));
  for (std::size_t k = 0; k < b.size(); ++k) a[k] += b[k];
  return a;
}

Polynomial product_of(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) result[i + k] += a[i] * b[k];
  }
  return result;
}

/// The polynomial's coefficients around t = at.
Polynomial around(Polynomial polynomial, const mpq_class& at) {
  for (std::size_t k = 0; k + 1 < polynomial.size(); ++k) {
    for (std::size_t i = polynomial.size() - 1; i-- > k;) polynomial[i] += polynomial[i + 1] * at;
  }
  return polynomial;
}

/// A computed number: a polynomial in t, plus what cuts have changed.
struct Computed {
  Polynomial polynomial;
  Range cut;
};

/// The arguments start + slope t of a piece.
struct Piece {
  mpz_class number;
  Range t;
  mpq_class start, slope;

  mpq_class at(const mpq_class& place) const { return start + slope * place; }
};

/// Encloses polynomial less function within `radius` of t = centre.
std::optional<Range> difference_around(const Function& function, const Polynomial& polynomial,
                                       const Piece& piece, const mpq_class& centre,
                                       const mpq_class& radius) {
  const mpq_class x = piece.at(centre), reach = piece.slope * radius;
  const Polynomial here = around(polynomial, centre);
  if (radius == 0) {
    return (Interval(here.front()) - function::value(function, Interval(x))).range();
  }
  const std::size_t terms = polynomial.size() + further_terms;
  const auto count = static_cast<int>(terms);
  const std::vector<Interval> series = function::taylor(function, Interval(x), count, piece.slope);
  const Interval rest =
      function::taylor(function, Interval(Range{x - reach, x + reach}), count + 1, piece.slope)
          .back();
  if (!series.back().is_bounded() || !rest.is_bounded()) return std::nullopt;
  const auto difference = [&](std::size_t k) {
    return k < here.size() ? Interval(here[k]) - series[k] : series[k];
  };
  Interval most = rest.magnitude() * Interval(radius);
  for (std::size_t k = terms - 1; k > 0; --k) {
    most = (difference(k).magnitude() + most) * Interval(radius);
  }
  return Range{(difference(0) - most).range().low, (difference(0) + most).range().high};
}

/// The ends of the parts of a piece. Each has the same part of what lies between two points of a
/// table.
std::vector<mpq_class> ends_of_parts(const Function& function, const Piece& piece) {
  std::vector<mpq_class> smooth = {piece.t.low, piece.t.high}, ends;
  if (function.kind() == Function::table) {
    for (const mpq_class& knot : function.interpolation().knots()) {
      const mpq_class t = (knot - piece.start) / piece.slope;
      if (piece.t.low < t && t < piece.t.high) smooth.push_back(t);
    }
  }
  std::sort(smooth.begin(), smooth.end());
  for (std::size_t k = 0; k + 1 < smooth.size(); ++k) {
    for (int part = 0; part < parts; ++part) {
      ends.push_back(smooth[k] + (smooth[k + 1] - smooth[k]) * mpq_class(part, parts));
    }
  }
  ends.push_back(piece.t.high);
  return ends;
}

std::optional<Range> difference_on(const Function& function, const Polynomial& polynomial,
                                   const Piece& piece) {
  const std::vector<mpq_class> ends = ends_of_parts(function, piece);
  std::optional<Range> all;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const mpq_class centre = (ends[k] + ends[k + 1]) / 2, radius = (ends[k + 1] - ends[k]) / 2;
    const auto found = difference_around(function, polynomial, piece, centre, radius);
    if (!found) return std::nullopt;
    all = all ? hull({all->low, all->high, found->low, found->high}) : *found;
  }
  return all;
}

/// By how much a function of computed numbers changes if they move by an error.
std::optional<Range> moved_by(const Function& function, const Range& computed, const Range& error) {
  const Range real = difference(computed, error);
  const Range both = hull({computed.low, computed.high, real.low, real.high});
  const std::vector<Interval> series = function::taylor_on(function, both, 2);
  if (!series.front().is_bounded()) return std::nullopt;
  if (error == Range{0, 0}) return error;
  std::optional<Range> moved;
  if (series.back().is_bounded()) moved = product(series.back().range(), error);
  if (function.kind() == Function::power && 0 < function.parameter() && function.parameter() < 1) {
    const mpq_class furthest = absolute(error).high;  // |a^p - b^p| <= |a - b|^p
    const mpq_class most = function::value(function, Interval(furthest)).range().high;
    if (!moved) moved = {-most, most};
    fixed::narrow(*moved, {-most, most});
  }
  return moved;
}

/// How codes stand for numbers: the code (k + f) in units of a fraction's last bit, with a whole k
/// and 0 <= f < 1, for 2^(k + exponent_of_0) (1 + f). Codes with a k below `least_field` stand
/// for 0.
struct Binades {
  int exponent_of_0 = 0;
  int fraction_bits = 0;
  int least_field = 0;
};

class Pieces {
public:
  Pieces(const fixed::FixedLane& lane, const std::vector<FixedNode>& nodes,
         const FunctionNodes& function)
      : lane_(lane),
        nodes_(nodes),
        function_(function),
        argument_(nodes[function.argument]),
        code_(function.argument) {
    for (const NodeId id : function.inside) {
      if (fixed::is_floating_code(nodes[id])) {
        code_ = id;
        const FloatingCode code{argument_.format.width};
        binades_ = {argument_.format.unit_exponent - code.offset(), code.fraction_bits(),
                    code.offset()};
      } else if (fixed::is_code_of_encoding(nodes, nodes[id])) {
        code_ = id;
        binades_ = {first_exponent() - lane.input_format.bias(), -argument_.format.unit_exponent,
                    0};
      }
    }
    const mpq_class per_unit = power_of_two(-argument_.format.unit_exponent);
    least_ = ceiling_of(argument_.value.low * per_unit);
    greatest_ = floor_of(argument_.value.high * per_unit);
    const FixedNode& result = nodes[function.result];
    if (result.operation == Operation::look_up) piece_bits_ = fixed::piece_bits(nodes, result);
    for (const NodeId id : function.inside) {
      if (id == code_) continue;
      if (is_place(nodes[id])) piece_bits_ = nodes[id].format.width;
      if (nodes[id].operation == Operation::look_up && is_step(nodes[id])) {
        starts_.push_back(start_of(nodes[id]));
      }
    }
    std::sort(starts_.begin(), starts_.end());
    starts_.erase(std::unique(starts_.begin(), starts_.end()), starts_.end());
  }

  /// The pieces that hold arguments.
  mpz_class count() const { return piece_of(code_of(greatest_)) - piece_of(code_of(least_)) + 1; }

  std::optional<FunctionEnclosure> enclose() {
    if (!are_alike()) return std::nullopt;
    const FixedNode& result = nodes_[function_.result];
    const auto moved = this->moved();
    const Interval values = function::value_on(*result.function, arguments());
    if (!moved || !values.is_bounded()) return std::nullopt;
    const mpz_class first = piece_of(code_of(least_)), last = piece_of(code_of(greatest_));
    if (last - first >= most_pieces) return std::nullopt;
    std::optional<Range> error, computed;
    for (mpz_class number = first; number <= last; ++number) {
      const auto found = add(piece(number));
      if (!found) return std::nullopt;
      join(error, found->error);
      join(computed, found->value);
    }
    Range value = sum(values.range(), *error);
    fixed::narrow(value, *computed);
    if (is_floating()) {
      const mpq_class unit = nodes_[code_].format.unit();
      inside_[code_] = {code_of(least_) * unit, code_of(greatest_) * unit};
    }
    return FunctionEnclosure{
        .value = multiples_in(value, result.format.unit()),
        .error = sum(*error, *moved),
        .inside = inside_,
        .reason = fmt::format("by theorem 10, {} pieces of degree {}", count().get_str(), degree_)};
  }

  /// By how much the function changes if its argument moves by the argument's error. The operands
  /// of an encoding have lost the fraction's low bits.
  std::optional<Range> moved() const {
    const Function& function = *nodes_[function_.result].function;
    if (!is_encoded()) return moved_by(function, argument_.value, argument_.error);
    const FixedNode& operand = nodes_[argument_.operands[0]];
    const OperandFormat format = fixed::operand_format(lane_, operand.input);
    const FloatFormat* arriving = format.floating();
    if (arriving == nullptr) return std::nullopt;
    std::optional<Range> all;
    for (mpz_class from = code_of(least_), last = code_of(greatest_); from <= last;) {
      const mpz_class field = floor_of(scaled(mpq_class(from), -binades_.fraction_bits));
      const mpz_class next = shifted_left(field + 1, binades_.fraction_bits);
      const mpz_class to = std::min<mpz_class>(next - 1, last);
      const int exponent = static_cast<int>(field.get_si()) + binades_.exponent_of_0;
      const mpq_class lost = power_of_two(exponent - binades_.fraction_bits) -
                             power_of_two(exponent - arriving->fraction_bits());
      const auto found = moved_by(function, {number_of(from), number_of(to)}, {-lost, 0});
      if (!found) return std::nullopt;
      join(all, *found);
      from = next;
    }
    return all;
  }

private:
  static void join(std::optional<Range>& all, const Range& range) {
    all = all ? hull({all->low, all->high, range.low, range.high}) : range;
  }

  static Range multiples_in(const Range& range, const mpq_class& unit) {
    return {ceiling_of(range.low / unit) * unit, floor_of(range.high / unit) * unit};
  }

  /// Whether all arguments have an address, and every table has a word at each.
  bool are_alike() const {
    const FixedFormat &format = argument_.format, &code = nodes_[code_].format;
    if (least_ > greatest_ || least_ < format.smallest() || greatest_ > format.largest()) {
      return false;
    }
    if (!starts_.empty()) return !is_floating() && piece_bits_ == 0;
    if (is_floating() &&
        (format.is_signed || least_ < 0 || !has_code() || piece_bits_ > binades_.fraction_bits)) {
      return false;
    }
    if (piece_bits_ < 0 || piece_bits_ + (code.is_signed ? 1 : 0) > code.width) return false;
    std::set<NodeId> all = function_.inside;
    all.insert(function_.result);
    return std::all_of(all.begin(), all.end(), [&](NodeId id) {
      const FixedNode& node = nodes_[id];
      if (id == code_ || !reads_argument(node)) return true;
      const int bits = is_place(node) ? node.format.width : fixed::piece_bits(nodes_, node);
      return node.operands[0] == code_ && bits == piece_bits_ &&
             !(is_place(node) && node.format.is_signed);
    });
  }

  bool is_floating() const { return code_ != function_.argument; }
  bool is_encoded() const { return fixed::is_code_of_encoding(nodes_, nodes_[code_]); }
  /// Whether the code's format holds the codes of all arguments, as numbers that grow with them.
  bool has_code() const {
    const FixedFormat& format = nodes_[code_].format;
    if (!is_encoded()) return format == FloatingCode{argument_.format.width}.format();
    const FixedNode& operand = nodes_[argument_.operands[0]];
    const int fraction_bits = lane_.input_format.fraction_bits() - operand.dropped_bits;
    return fraction_bits == binades_.fraction_bits && format.unit_exponent == -fraction_bits &&
           operand.format.width == lane_.input_format.width() - operand.dropped_bits &&
           !format.is_signed && code_of(least_) >= 0 && code_of(greatest_) <= format.largest() &&
           is_normal(least_) && is_normal(greatest_);
  }
  /// Whether an encoding is that of a finite normal number above 0.
  bool is_normal(const mpz_class& encoding) const {
    const mpz_class field = floor_of(scaled(mpq_class(encoding), -binades_.fraction_bits));
    return field >= 1 && field < lane_.input_format.max_biased_exponent();
  }
  /// The biased exponent of the arguments whose code has the exponent 0.
  int first_exponent() const {
    const FixedNode& code = nodes_[code_];
    if (code.operation == Operation::subtract) {
      const FixedNode& first = nodes_[code.operands[1]];
      return static_cast<int>(mpz_class(floor_of(first.constant * first.format.unit())).get_si());
    }
    const mpz_class codes = shifted_left(1, code.format.width);
    const mpz_class least = floor_of(argument_.value.low / argument_.format.unit());
    const mpq_class first = (least - least % codes) * argument_.format.unit();
    return static_cast<int>(mpz_class(floor_of(first)).get_si());
  }

  mpz_class code_of(const mpz_class& number) const {
    if (is_encoded()) return number - shifted_left(first_exponent(), binades_.fraction_bits);
    return is_floating() ? FloatingCode{argument_.format.width}.of(number) : number;
  }
  /// The number that a floating-point code stands for.
  mpq_class number_of(const mpz_class& code) const {
    const mpz_class field = floor_of(scaled(mpq_class(code), -binades_.fraction_bits));
    if (field < binades_.least_field) return 0;
    const mpq_class fraction = scaled(mpq_class(code), -binades_.fraction_bits) - field;
    return (1 + fraction) * power_of_two(static_cast<int>(field.get_si()) + binades_.exponent_of_0);
  }
  Range arguments() const {
    if (!is_encoded()) return argument_.value;
    return {number_of(code_of(least_)), number_of(code_of(greatest_))};
  }
  mpz_class piece_of(const mpz_class& code) const {
    if (!starts_.empty()) {
      const auto above = std::upper_bound(starts_.begin(), starts_.end(), code);
      return static_cast<unsigned long>(above - starts_.begin());
    }
    return floor_of(scaled(mpq_class(code), -piece_bits_));
  }

  /// The arguments of a piece, t in units of the code.
  Piece piece(const mpz_class& number) const {
    if (!starts_.empty()) return piece_after_start(number.get_ui());
    const mpz_class start = shifted_left(number, piece_bits_);
    const mpz_class from = code_of(least_) - start, to = code_of(greatest_) - start;
    const mpz_class last = shifted_left(1, piece_bits_) - 1;
    const mpq_class unit = nodes_[code_].format.unit();
    Piece piece{.number = number,
                .t = {std::max<mpz_class>(from, 0) * unit, std::min(to, last) * unit},
                .start = start * unit,
                .slope = 1};
    if (!is_floating()) return piece;
    const mpz_class field = floor_of(piece.start);
    if (field < binades_.least_field) {  // the argument is 0
      return {.number = number, .t = {0, 0}, .start = 0, .slope = 1};
    }
    piece.slope = power_of_two(static_cast<int>(field.get_si()) + binades_.exponent_of_0);
    piece.start = number_of(start);
    return piece;
  }

  /// The least argument that a comparison with a start finds at it or beyond, in units.
  mpz_class start_of(const FixedNode& step) const {
    const FixedNode& start = nodes_[nodes_[step.operands[0]].operands[1]];
    return ceiling_of(start.constant * start.format.unit() / argument_.format.unit());
  }

  Piece piece_after_start(std::size_t number) const {
    const mpz_class start = number == 0 ? least_ : std::max(least_, starts_[number - 1]);
    const mpz_class last =
        number == starts_.size() ? greatest_ : std::min<mpz_class>(greatest_, starts_[number] - 1);
    const mpq_class unit = argument_.format.unit();
    return {.number = static_cast<unsigned long>(number),
            .t = {0, (last - start) * unit},
            .start = start * unit,
            .slope = 1};
  }

  std::optional<FunctionEnclosure> add(const Piece& piece) {
    std::map<NodeId, Computed> known;
    for (const NodeId id : function_.inside) {
      if (id == code_) continue;
      const Computed& made = known[id] = computed(id, piece, known);
      const Range values = multiples_in(sum(values_of(made.polynomial, piece.t), made.cut),
                                        nodes_[id].format.unit());
      const auto [found, is_new] = inside_.try_emplace(id, values);
      if (!is_new) {
        found->second = hull({found->second.low, found->second.high, values.low, values.high});
      }
    }
    const Computed result = computed(function_.result, piece, known);
    degree_ = std::max(degree_, static_cast<int>(result.polynomial.size()) - 1);
    const Function function = *nodes_[function_.result].function;
    const auto difference = difference_on(function, result.polynomial, piece);
    if (!difference) return std::nullopt;
    return FunctionEnclosure{.value = sum(values_of(result.polynomial, piece.t), result.cut),
                             .error = sum(*difference, result.cut)};
  }

  /// A node of a piece, by its operands.
  Computed computed(NodeId id, const Piece& piece, const std::map<NodeId, Computed>& known) const {
    const FixedNode& node = nodes_[id];
    if (node.operation == Operation::look_up) return {{word(node, piece, known)}, {0, 0}};
    if (is_place(node)) return {{0, 1}, {0, 0}};
    const auto operand = [&](int k) {
      if (node.operands[k] == function_.argument) return Computed{{piece.start, 1}, {0, 0}};
      const FixedNode& read = nodes_[node.operands[k]];
      if (read.operation != Operation::constant) return known.at(node.operands[k]);
      return Computed{{read.constant * read.format.unit()}, {0, 0}};
    };
    Computed made = operand(0);
    if (node.operation == Operation::add || node.operation == Operation::subtract) {
      Computed second = operand(1);
      if (node.operation == Operation::subtract) second = negated(second);
      made = {sum_of(made.polynomial, second.polynomial), sum(made.cut, second.cut)};
    } else if (node.operation == Operation::multiply) {
      const Computed second = operand(1);
      const Range a = values_of(made.polynomial, piece.t);
      const Range b = values_of(second.polynomial, piece.t);
      made = {
          product_of(made.polynomial, second.polynomial),
          sum(sum(product(a, second.cut), product(b, made.cut)), product(made.cut, second.cut))};
    }
    made.cut.low -= node.format.unit() * (1 - power_of_two(-node.dropped_bits));
    return made;
  }

  static Computed negated(Computed number) {
    for (mpq_class& coefficient : number.polynomial) coefficient = -coefficient;
    return {number.polynomial, {-number.cut.high, -number.cut.low}};
  }

  mpq_class word(const FixedNode& look_up, const Piece& piece,
                 const std::map<NodeId, Computed>& known) const {
    mpz_class address = piece.number;
    if (is_step(look_up)) {
      address = piece.start < start_of(look_up) * argument_.format.unit() ? 1 : 0;
    } else if (const auto index = known.find(look_up.operands[0]); index != known.end()) {
      const mpq_class count =
          index->second.polynomial.front() / nodes_[look_up.operands[0]].format.unit();
      address = floor_of(scaled(count, -fixed::piece_bits(nodes_, look_up)));
    }
    address &= mpz_class(look_up.words.size() - 1);
    return look_up.words[address.get_ui()] * look_up.format.unit();
  }

  const fixed::FixedLane& lane_;
  const std::vector<FixedNode>& nodes_;
  const FunctionNodes& function_;
  const FixedNode& argument_;
  NodeId code_;      ///< the argument or its floating-point code
  Binades binades_;  ///< of that code
  int piece_bits_ = 0;
  mpz_class least_, greatest_;     ///< arguments, in units
  std::vector<mpz_class> starts_;  ///< of pieces but the first, in units of the argument
  std::map<NodeId, Range> inside_;
  int degree_ = 0;
};

}  // namespace

std::optional<FunctionEnclosure> enclose_function(const fixed::FixedLane& lane,
                                                  const std::vector<FixedNode>& nodes,
                                                  const FunctionNodes& function) {
  const auto& applied = nodes[function.result].function;
  if (!applied) return std::nullopt;
  if (has_jumps(*applied)) return enclose_jump(nodes, function);
  return Pieces(lane, nodes, function).enclose();
}

std::vector<Node> expression_of(const fixed::FixedLane& lane,
                                const std::vector<FunctionNodes>& functions) {
  std::vector<Node> nodes;
  for (const FixedNode& node : lane.nodes) {
    nodes.push_back(Node{.operation = node.operation,
                         .operands = node.operands,
                         .input = node.input,
                         .value = node.format.unit() * node.constant});
  }
  for (const FunctionNodes& each : functions) {
    nodes[each.result] = Node{.operation = Operation::function,
                              .operands = {each.argument, -1},
                              .function = lane.nodes[each.result].function};
  }
  return nodes;
}

std::vector<StatedFunction> stated_functions(const fixed::FixedLane& lane) {
  constexpr std::size_t most_characters = 60;
  const auto functions = functions_of(lane);
  if (!functions) return {};
  const std::vector<Node> nodes = expression_of(lane, *functions);
  std::map<NodeId, StatedFunction> stated;
  for (const FunctionNodes& each : *functions) {
    const FixedNode& result = lane.nodes[each.result];
    if (has_jumps(*result.function)) continue;
    const Pieces pieces(lane, lane.nodes, each);
    const auto moved = pieces.moved();
    if (!moved) continue;
    StatedFunction& found = stated[each.result];
    found.text = to_text(nodes, lane.input_names, each.result, most_characters);
    found.error = result.error;
    found.own_error = {result.error.low - moved->low, result.error.high - moved->high};
    found.degree =
        static_cast<int>(std::count_if(each.inside.begin(), each.inside.end(), [&](NodeId id) {
          return lane.nodes[id].operation == Operation::multiply;
        }));
    found.pieces = pieces.count();
  }
  std::vector<StatedFunction> in_order;
  for (auto& [result, found] : stated) in_order.push_back(std::move(found));
  return in_order;
}

}  // namespace mixcmp::proof
