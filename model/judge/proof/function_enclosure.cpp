#include "model/judge/proof/function_enclosure.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "model/base/number/dyadic.hpp"
#include "model/comparison/expression/text.hpp"
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

bool is_place(const FixedNode& node) {
  return node.conversion == Conversion::place;
}

/// Whether a node takes the argument of a polynomial apart.
bool reads_argument(const FixedNode& node) {
  return node.operation == Operation::look_up || is_place(node);
}

/// Collects the nodes below a result.
class Below {
public:
  Below(const std::vector<FixedNode>& nodes, NodeId result)
      : nodes_(nodes), found_{result, -1, {}} {
    const FixedNode& node = nodes[result];
    is_right_ = node.operation == Operation::look_up ? from_argument(node.operands[0])
                                                     : inside(node.operands[0]);
  }

  std::optional<FunctionNodes> found() const {
    return is_right_ && found_.argument >= 0 ? std::optional(found_) : std::nullopt;
  }

private:
  /// The argument itself or its floating-point code.
  bool from_argument(NodeId id) {
    if (fixed::is_floating_code(nodes_[id])) {
      found_.inside.insert(id);
      id = nodes_[id].operands[0];
    }
    if (found_.argument < 0) found_.argument = id;
    return found_.argument == id;
  }

  bool inside(NodeId id) {
    const FixedNode& node = nodes_[id];
    if (node.operation == Operation::constant) return true;
    found_.inside.insert(id);
    if (reads_argument(node)) return from_argument(node.operands[0]);
    if (node.operation != Operation::multiply && node.operation != Operation::add) return false;
    return inside(node.operands[0]) && inside(node.operands[1]);
  }

  const std::vector<FixedNode>& nodes_;
  FunctionNodes found_;
  bool is_right_;
};

/// The inside nodes that the lane's criteria read, or nodes outside.
bool any_read_outside(const fixed::FixedLane& lane, const std::set<NodeId>& inside,
                      const std::set<NodeId>& results) {
  for (NodeId id = 0; id < static_cast<NodeId>(lane.nodes.size()); ++id) {
    if (inside.contains(id) || results.contains(id)) continue;
    const FixedNode& node = lane.nodes[id];
    for (int k = 0; k < arity(node.operation); ++k) {
      if (inside.contains(node.operands[k])) return true;
    }
  }
  return std::any_of(lane.parts.begin(), lane.parts.end(), [&](const fixed::FixedPart& part) {
    const std::vector<NodeId> read = fixed::read_by(part.criterion);
    return inside.contains(part.difference) ||
           std::any_of(read.begin(), read.end(), [&](NodeId id) { return inside.contains(id); });
  });
}

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
std::optional<Range> difference_around(Function function, const Polynomial& polynomial,
                                       const Piece& piece, const mpq_class& centre,
                                       const mpq_class& radius) {
  const std::size_t terms = polynomial.size() + further_terms;
  const mpq_class x = piece.at(centre), reach = piece.slope * radius;
  const auto count = static_cast<int>(terms);
  const std::vector<Interval> series = function::taylor(function, Interval(x), count, piece.slope);
  const Interval rest =
      function::taylor(function, Interval(Range{x - reach, x + reach}), count + 1, piece.slope)
          .back();
  if (!series.back().is_bounded() || !rest.is_bounded()) return std::nullopt;
  const Polynomial here = around(polynomial, centre);
  const auto difference = [&](std::size_t k) {
    return k < here.size() ? Interval(here[k]) - series[k] : series[k];
  };
  Interval most = rest.magnitude() * Interval(radius);
  for (std::size_t k = terms - 1; k > 0; --k) {
    most = (difference(k).magnitude() + most) * Interval(radius);
  }
  return Range{(difference(0) - most).range().low, (difference(0) + most).range().high};
}

std::optional<Range> difference_on(Function function, const Polynomial& polynomial,
                                   const Piece& piece) {
  const mpq_class part = (piece.t.high - piece.t.low) / parts;
  std::optional<Range> all;
  for (int k = 0; k < parts; ++k) {
    const mpq_class centre = piece.t.low + part * mpq_class(2 * k + 1, 2);
    const auto found = difference_around(function, polynomial, piece, centre, part / 2);
    if (!found) return std::nullopt;
    all = all ? hull({all->low, all->high, found->low, found->high}) : *found;
    if (part == 0) break;
  }
  return all;
}

/// By how much a function changes if its argument moves by the argument's error.
std::optional<Range> moved_by(Function function, const FixedNode& argument) {
  const Range real = difference(argument.value, argument.error);
  const Range both = hull({argument.value.low, argument.value.high, real.low, real.high});
  const Interval slope = function::taylor(function, Interval(both), 2).back();
  if (!slope.is_bounded()) return std::nullopt;
  return product(slope.range(), argument.error);
}

class Pieces {
public:
  Pieces(const std::vector<FixedNode>& nodes, const FunctionNodes& function)
      : nodes_(nodes),
        function_(function),
        argument_(nodes[function.argument]),
        code_(function.argument) {
    for (const NodeId id : function.inside) {
      if (fixed::is_floating_code(nodes[id])) code_ = id;
    }
    const mpq_class per_unit = power_of_two(-argument_.format.unit_exponent);
    least_ = ceiling_of(argument_.value.low * per_unit);
    greatest_ = floor_of(argument_.value.high * per_unit);
    const FixedNode& result = nodes[function.result];
    if (result.operation == Operation::look_up) piece_bits_ = fixed::piece_bits(nodes, result);
    for (const NodeId id : function.inside) {
      if (is_place(nodes[id])) piece_bits_ = nodes[id].format.width;
    }
  }

  /// The pieces that hold arguments.
  mpz_class count() const { return piece_of(code_of(greatest_)) - piece_of(code_of(least_)) + 1; }

  std::optional<FunctionEnclosure> enclose() {
    if (!are_alike()) return std::nullopt;
    const FixedNode& result = nodes_[function_.result];
    const auto moved = moved_by(*result.function, argument_);
    const Interval values = function::value(*result.function, Interval(argument_.value));
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
    return FunctionEnclosure{.value = multiples_in(value, result.format.unit()),
                             .error = sum(*error, *moved),
                             .degree = degree_,
                             .pieces = count()};
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
    if (is_floating() && (format.is_signed || least_ <= 0 || !has_code() ||
                          piece_bits_ > FloatingCode{format.width}.fraction_bits())) {
      return false;
    }
    if (piece_bits_ < 0 || piece_bits_ + (code.is_signed ? 1 : 0) > code.width) return false;
    std::set<NodeId> all = function_.inside;
    all.insert(function_.result);
    return std::all_of(all.begin(), all.end(), [&](NodeId id) {
      const FixedNode& node = nodes_[id];
      if (!reads_argument(node)) return true;
      const int bits = is_place(node) ? node.format.width : fixed::piece_bits(nodes_, node);
      return node.operands[0] == code_ && bits == piece_bits_ &&
             !(is_place(node) && node.format.is_signed);
    });
  }

  bool is_floating() const { return code_ != function_.argument; }
  bool has_code() const {
    return nodes_[code_].format == FloatingCode{argument_.format.width}.format();
  }

  mpz_class code_of(const mpz_class& number) const {
    return is_floating() ? FloatingCode{argument_.format.width}.of(number) : number;
  }
  mpz_class piece_of(const mpz_class& code) const {
    return floor_of(scaled(mpq_class(code), -piece_bits_));
  }

  /// The arguments of a piece, t in units of the code.
  Piece piece(const mpz_class& number) const {
    const mpz_class start = shifted_left(number, piece_bits_);
    const mpz_class from = code_of(least_) - start, to = code_of(greatest_) - start;
    const mpz_class last = shifted_left(1, piece_bits_) - 1;
    const mpq_class unit = nodes_[code_].format.unit();
    Piece piece{.number = number,
                .t = {std::max<mpz_class>(from, 0) * unit, std::min(to, last) * unit},
                .start = start * unit,
                .slope = 1};
    if (!is_floating()) return piece;
    // The code is an exponent and a fraction, in units of the fraction's last bit.
    const FloatingCode code{argument_.format.width};
    const mpz_class field = floor_of(piece.start);
    const auto exponent = static_cast<int>(field.get_si()) - code.offset();
    piece.slope = power_of_two(exponent + argument_.format.unit_exponent);
    piece.start = (1 + piece.start - field) * piece.slope;
    return piece;
  }

  std::optional<FunctionEnclosure> add(const Piece& piece) {
    std::map<NodeId, Computed> known;
    for (const NodeId id : function_.inside) {
      if (!fixed::is_floating_code(nodes_[id])) known[id] = computed(id, piece, known);
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
    if (node.operation == Operation::look_up) return {{word(node, piece)}, {0, 0}};
    if (is_place(node)) return {{0, 1}, {0, 0}};
    const auto operand = [&](int k) {
      const FixedNode& read = nodes_[node.operands[k]];
      if (read.operation != Operation::constant) return known.at(node.operands[k]);
      return Computed{{read.constant * read.format.unit()}, {0, 0}};
    };
    Computed made = operand(0);
    if (node.operation == Operation::add) {
      const Computed second = operand(1);
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

  static mpq_class word(const FixedNode& look_up, const Piece& piece) {
    const mpz_class address = piece.number & mpz_class(look_up.words.size() - 1);
    return look_up.words[address.get_ui()] * look_up.format.unit();
  }

  const std::vector<FixedNode>& nodes_;
  const FunctionNodes& function_;
  const FixedNode& argument_;
  NodeId code_;  ///< the argument or its floating-point code
  int piece_bits_ = 0;
  mpz_class least_, greatest_;  ///< arguments, in units
  int degree_ = 0;
};

}  // namespace

std::optional<std::vector<FunctionNodes>> functions_of(const fixed::FixedLane& lane) {
  std::vector<FunctionNodes> functions;
  std::set<NodeId> inside, results;
  const auto add = [&](NodeId result) {
    const auto found = Below(lane.nodes, result).found();
    if (!found) return false;
    inside.insert(found->inside.begin(), found->inside.end());
    results.insert(result);
    functions.push_back(*found);
    return true;
  };
  const auto count = static_cast<NodeId>(lane.nodes.size());
  for (NodeId id = 0; id < count; ++id) {
    if (lane.nodes[id].conversion == Conversion::function_value && !add(id)) return std::nullopt;
  }
  for (NodeId id = 0; id < count; ++id) {  // other tables have the values themselves
    const bool is_table = lane.nodes[id].operation == Operation::look_up;
    if (is_table && !inside.contains(id) && !add(id)) return std::nullopt;
  }
  if (any_read_outside(lane, inside, results)) return std::nullopt;
  return functions;
}

std::optional<FunctionEnclosure> enclose_function(const std::vector<FixedNode>& nodes,
                                                  const FunctionNodes& function) {
  if (!nodes[function.result].function) return std::nullopt;
  return Pieces(nodes, function).enclose();
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
    const auto moved = moved_by(*result.function, lane.nodes[each.argument]);
    if (!moved) continue;
    StatedFunction& found = stated[each.result];
    found.text = to_text(nodes, lane.input_names, each.result, most_characters);
    found.error = result.error;
    found.own_error = {result.error.low - moved->low, result.error.high - moved->high};
    found.degree =
        static_cast<int>(std::count_if(each.inside.begin(), each.inside.end(), [&](NodeId id) {
          return lane.nodes[id].operation == Operation::multiply;
        }));
    found.pieces = Pieces(lane.nodes, each).count();
  }
  std::vector<StatedFunction> in_order;
  for (auto& [result, found] : stated) in_order.push_back(std::move(found));
  return in_order;
}

Range words_of(const FixedNode& look_up) {
  mpz_class least = look_up.words[0], greatest = look_up.words[0];
  for (std::size_t k = 1; k < look_up.words.size(); ++k) {
    least = std::min(least, look_up.words[k]);
    greatest = std::max(greatest, look_up.words[k]);
  }
  return {least * look_up.format.unit(), greatest * look_up.format.unit()};
}

}  // namespace mixcmp::proof
