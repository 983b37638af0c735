#include "model/judge/emulator/fixed_code.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "model/base/common/check.hpp"
#include "model/base/number/double.hpp"
#include "model/base/number/verdict.hpp"

namespace mixcmp::emulator {
namespace {

using fixed::FixedLane;
using fixed::FixedNode;
using fixed::FixedPart;

/// The largest magnitude of exponents. It is far from the ends of double's exponents, even for
/// reciprocals and squares.
constexpr int largest_exponent = 400;

double power(int exponent) {
  return std::ldexp(1, exponent);
}

/// The digits of a double with which an operation is exact. (Sums of a number beyond its reach may
/// be rounded, but stay above the threshold.) A root is rounded to nearest before it is rounded
/// down to its unit; with these digits it never reaches the next unit. Proofs: docs/emulator.md.
int needed_digits(const std::vector<FixedNode>& nodes, const FixedNode& node) {
  if (node.operation == Operation::square_root) {
    return std::max(2 * node.format.width + 1, nodes[node.operands[0]].format.width + 3);
  }
  if (node.is_encoding) return node.format.width;
  return node.format.width + node.dropped_bits;
}

bool fits_double(const std::vector<FixedNode>& nodes, const FixedNode& node) {
  const int digits = needed_digits(nodes, node);
  return digits <= double_digits &&
         std::abs(node.format.unit_exponent) + digits <= largest_exponent;
}

/// A slope below 1 would require rounding; `norm_thresholds` returns none.
bool fits_double(const FixedPart& part) {
  const auto* norm = std::get_if<fixed::NormThresholds>(&part.criterion);
  return norm == nullptr || (norm->shift_above >= 0 && norm->shift_below >= 0);
}

FixedKernel fixed_kernel_of(Operation operation) {
  switch (operation) {
    case Operation::negate:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square: return FixedKernel::sum;
    case Operation::absolute: return FixedKernel::absolute;
    case Operation::minimum: return FixedKernel::minimum;
    case Operation::maximum: return FixedKernel::maximum;
    case Operation::square_root: return FixedKernel::square_root;
    case Operation::input:
    case Operation::constant:
    case Operation::convert:
    case Operation::divide:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(false);
}

mpq_class largest_magnitude(const Range& range) {
  return std::max(mpq_class(abs(range.low)), mpq_class(abs(range.high)));
}

/// A number as a sum of terms.
struct Expansion {
  FixedSum terms;
  mpq_class largest;  ///< the largest magnitude of any sum of some of the terms
  int unit_exponent;  ///< all terms are multiples of this power of two

  bool is_exact_in_double() const {
    return largest <= FixedFormat{.unit_exponent = unit_exponent + double_digits}.unit();
  }
  /// Whether reading the terms costs hardly more than reading one column with their sum.
  bool is_cheap() const {
    return terms.size() <= 2 && std::all_of(terms.begin(), terms.end(), [](const FixedTerm& term) {
             return term.kind == FixedTerm::Kind::value;
           });
  }
};

enum class Sign { plus, minus };

/// a + b or a - b.
Expansion sum(Expansion a, const Expansion& b, Sign sign) {
  for (FixedTerm term : b.terms) {
    term.is_negative = term.is_negative != (sign == Sign::minus);
    a.terms.push_back(term);
  }
  a.largest += b.largest;
  a.unit_exponent = std::min(a.unit_exponent, b.unit_exponent);
  return a;
}

/// Compiles a lane. A reader of a node reads the node's terms instead if the node drops no bits and
/// has no other reader or cheap terms. Nodes that are still read get columns.
class FixedCodeMaker {
public:
  explicit FixedCodeMaker(const FixedLane& lane)
      : lane_(lane), reads_(lane.nodes.size(), 0), has_column_(lane.nodes.size(), false) {
    code_.layout.columns = static_cast<int>(lane.nodes.size());
    count_reads();
    for (NodeId id = 0; id < node_count(); ++id) expansions_.push_back(expansion_of(id));
    choose_columns();
  }

  FixedCode make() {
    add_inputs();
    for (NodeId id = 0; id < node_count(); ++id) add_node(id);
    for (const FixedPart& part : lane_.parts) add_criterion(part);
    return std::move(code_);
  }

private:
  NodeId node_count() const { return static_cast<NodeId>(lane_.nodes.size()); }
  const FixedNode& node(NodeId id) const { return lane_.nodes[id]; }

  void count_reads() {
    for (const FixedNode& node : lane_.nodes) {
      for (int k = 0; k < arity(node.operation); ++k) ++reads_[node.operands[k]];
    }
    for (const FixedPart& part : lane_.parts) {
      ++reads_[part.difference];
      for (const NodeId id : fixed::read_by(part.criterion)) ++reads_[id];
    }
  }

  Expansion of_term(NodeId id, const FixedTerm& term) const {
    return {{term}, largest_magnitude(node(id).value), node(id).format.unit_exponent};
  }

  Expansion of_column(NodeId id) const { return of_term(id, {.a = id, .b = id}); }

  /// A node before bits are dropped: by its operands' terms, or by a column of its own.
  Expansion expansion_of(NodeId id) const {
    const FixedNode& expanded = node(id);
    const NodeId first = expanded.operands[0], second = expanded.operands[1];
    switch (expanded.operation) {
      case Operation::negate:
        return sum({{}, 0, node(id).format.unit_exponent}, read(first), Sign::minus);
      case Operation::add: return sum_of(first, second, Sign::plus);
      case Operation::subtract: return sum_of(first, second, Sign::minus);
      case Operation::multiply:
        return of_term(id, {.kind = FixedTerm::Kind::product, .a = first, .b = second});
      case Operation::square: return of_term(id, square_of(first));
      case Operation::convert: return fixed::is_reach(expanded) ? read(first) : of_column(id);
      case Operation::input:
      case Operation::constant:
      case Operation::absolute:
      case Operation::divide:
      case Operation::square_root:
      case Operation::minimum:
      case Operation::maximum:
      case Operation::look_up:
      case Operation::fused_sum: return of_column(id);
      case Operation::function: break;
    }
    MIXCMP_CHECK(false);
  }

  /// The terms that replace a node for its readers, or the node's own column.
  Expansion read(NodeId id) const {
    const Expansion& expansion = expansions_[id];
    const bool replaces = node(id).dropped_bits == 0 && (reads_[id] == 1 || expansion.is_cheap());
    return replaces ? expansion : of_column(id);
  }

  /// The sum of two terms is the node's value, which is a double. With more terms, each
  /// intermediate sum has to be a double.
  Expansion sum_of(NodeId first, NodeId second, Sign sign) const {
    Expansion terms = sum(read(first), read(second), sign);
    const bool exact = terms.terms.size() <= 2 || terms.is_exact_in_double();
    return exact ? terms : sum(of_column(first), of_column(second), sign);
  }

  FixedTerm square_of(NodeId id) const {
    const FixedSum squared = read(id).terms;
    if (!read(id).is_cheap()) return {.kind = FixedTerm::Kind::product, .a = id, .b = id};
    const FixedTerm &first = squared.front(), &last = squared.back();
    const FixedTerm::Kind kind = squared.size() == 1 ? FixedTerm::Kind::product
                                 : first.is_negative == last.is_negative
                                     ? FixedTerm::Kind::square_of_sum
                                     : FixedTerm::Kind::square_of_difference;
    return {.kind = kind, .a = first.a, .b = last.a};
  }

  /// Goes from the decisions back to the inputs.
  void choose_columns() {
    for (const FixedPart& part : lane_.parts) {
      choose_columns(read(part.difference).terms);
      const auto* norm = std::get_if<fixed::NormThresholds>(&part.criterion);
      if (norm != nullptr) choose_columns(read_radius(*norm).terms);
      const auto* running = std::get_if<fixed::RunningThresholds>(&part.criterion);
      if (running == nullptr) continue;
      for (const NodeId id : running->watched) has_column_[id] = true;
    }
    for (NodeId id = node_count(); id-- > 0;) {
      if (!has_column_[id]) continue;
      choose_columns(expansions_[id].terms);
      if (fixed::is_common_cut(node(id))) choose_cut_columns();
      const bool is_sum = expansions_[id].terms.front().a != id;
      const int operands = is_sum ? 0 : arity(node(id).operation);
      for (int k = 0; k < operands; ++k) has_column_[node(id).operands[k]] = true;
    }
  }

  void choose_columns(const FixedSum& terms) {
    for (const FixedTerm& term : terms) has_column_[term.a] = has_column_[term.b] = true;
  }

  /// All common cuts are made together, so all their operands are.
  void choose_cut_columns() {
    for (NodeId id = 0; id < node_count(); ++id) {
      if (fixed::is_common_cut(node(id)))
        has_column_[id] = has_column_[node(id).operands[0]] = true;
    }
  }

  /// A root is computed from a column.
  Expansion read_radius(const fixed::NormThresholds& norm) const {
    return norm.radius_is_squared ? of_column(norm.radius) : read(norm.radius);
  }

  /// Operands arrive in columns of their own. In block floating point they are first divided by a
  /// power of two, in their nodes' columns.
  void add_inputs() {
    FixedInstruction divide{.kernel = FixedKernel::common_power};
    if (lane_.format.is_block) {
      divide.least_exponent = fixed::least_block_exponent(lane_.input_format);
    }
    std::vector<FixedInstruction> conversions;
    for (NodeId id = 0; id < node_count(); ++id) {
      if (node(id).operation != Operation::input) continue;
      const int arriving = code_.layout.columns++;
      code_.layout.inputs.emplace_back(arriving, node(id).input);
      divide.cuts.push_back({.operand = arriving, .result = id});
      if (node(id).is_encoding) {
        conversions.push_back(encoding(id, arriving));
        continue;
      }
      conversions.push_back(conversion(id, lane_.format.is_block ? id : arriving));
    }
    if (lane_.format.is_block) code_.instructions.push_back(std::move(divide));
    for (FixedInstruction& each : conversions) code_.instructions.push_back(std::move(each));
  }

  /// An operand's encoding as biased exponent and fraction. That of an operand below the normal
  /// numbers is another than the hardware's, but the limit behind it accepts neither.
  FixedInstruction encoding(NodeId id, int arriving) const {
    return {.kernel = FixedKernel::floating,
            .result = id,
            .a = arriving,
            .b = arriving,
            .unit = power(node(id).format.unit_exponent),
            .low = double(lane_.input_format.bias() - 1),
            .high = 0};
  }

  FixedInstruction conversion(NodeId id, int from) const {
    const FixedFormat& format = node(id).format;
    if (fixed::arriving_fixed(lane_, node(id)) != nullptr) {
      return {.kernel = FixedKernel::truncate,
              .result = id,
              .a = from,
              .b = from,
              .unit = power(format.unit_exponent)};
    }
    const FixedKernel truncating =
        format.is_signed ? FixedKernel::convert_signed : FixedKernel::convert_unsigned;
    const FixedKernel exact = format.is_signed ? FixedKernel::convert_exactly_signed
                                               : FixedKernel::convert_exactly_unsigned;
    return {.kernel = node(id).is_promised ? exact : truncating,
            .result = id,
            .a = from,
            .b = from,
            .unit = power(format.unit_exponent),
            .beyond = power(format.unit_exponent + format.magnitude_bits())};
  }

  void add_node(NodeId id) {
    const FixedNode& added = node(id);
    if (added.operation == Operation::constant) {
      const double value = added.constant.get_d() * power(added.format.unit_exponent);
      code_.layout.constants.emplace_back(id, value);
    } else if (added.operation != Operation::input && has_column_[id]) {
      add_instruction(id);
    }
  }

  void add_instruction(NodeId id) {
    const FixedNode& added = node(id);
    if (fixed::is_common_cut(added)) return add_common_cut(id);
    if (fixed::is_reach(added)) return add_sum(id);
    if (added.operation == Operation::look_up) return add_look_up(id);
    if (added.operation == Operation::convert) return add_conversion(id);
    const bool truncates = added.dropped_bits > 0 || added.operation == Operation::square_root;
    const int result = truncates ? code_.layout.columns++ : id;
    code_.instructions.push_back({.kernel = fixed_kernel_of(added.operation),
                                  .result = result,
                                  .a = added.operands[0],
                                  .b = added.operands[arity(added.operation) - 1],
                                  .terms = expansions_[id].terms});
    if (truncates) add_truncation(id, result);
  }

  /// A column with the sum of the node's terms.
  void add_sum(NodeId id) { add_unary(FixedKernel::sum, id, id).terms = expansions_[id].terms; }

  /// The first common cut adds the instruction for all.
  void add_common_cut(NodeId id) {
    const auto is_cut = [&](const FixedInstruction& added) {
      return added.kernel == FixedKernel::common_cut;
    };
    auto& instructions = code_.instructions;
    auto all = std::find_if(instructions.begin(), instructions.end(), is_cut);
    if (all == instructions.end()) {
      all = instructions.insert(
          all, {.kernel = FixedKernel::common_cut, .beyond = power(lane_.format.bits)});
    }
    all->cuts.push_back({.operand = node(id).operands[0],
                         .result = id,
                         .unit = power(node(id).format.unit_exponent)});
  }

  void add_look_up(NodeId id) {
    const FixedNode& added = node(id);
    const FixedFormat& argument = node(added.operands[0]).format;
    FixedInstruction& look_up = add_unary(FixedKernel::look_up, id, added.operands[0]);
    look_up.unit = power(argument.unit_exponent + fixed::piece_bits(lane_.nodes, added));
    const double unit = power(added.format.unit_exponent);
    for (std::size_t address = 0; address < added.words.size(); ++address) {
      look_up.words.push_back(added.words[address].get_d() * unit);
    }
  }

  void add_conversion(NodeId id) {
    const FixedNode& added = node(id);
    if (fixed::is_floating_code(added)) {
      const FixedFormat& number = node(added.operands[0]).format;
      const int of_zero = function::FloatingCode{number.width}.offset() - 1;
      FixedInstruction& made = add_unary(FixedKernel::floating, id, added.operands[0]);
      made.unit = power(-52);  // all bits of a double
      made.low = of_zero - number.unit_exponent;
      made.high = of_zero;
      return;
    }
    if (added.conversion == fixed::Conversion::place) {
      add_unary(FixedKernel::place, id, added.operands[0]).unit =
          power(added.format.unit_exponent + added.format.width);
      return;
    }
    if (!fixed::is_limit(added)) return add_truncation(id, added.operands[0]);
    FixedInstruction& limit = add_unary(FixedKernel::limit, id, added.operands[0]);
    limit.low = added.value.low.get_d();
    limit.high = added.value.high.get_d();
  }

  void add_truncation(NodeId id, int operand) {
    add_unary(FixedKernel::truncate, id, operand).unit = power(node(id).format.unit_exponent);
  }

  void add_criterion(const FixedPart& part) {
    FixedCriterion criterion{.difference = read(part.difference).terms, .radius = {}};
    const double unit = power(node(part.difference).format.unit_exponent);
    std::visit([&](const auto& thresholds) { set(criterion, thresholds, unit); }, part.criterion);
    if (part.swapped) std::swap(criterion.greater, criterion.less);
    code_.criteria.push_back(criterion);
  }

  void set(FixedCriterion& criterion, const fixed::ConstantThresholds& thresholds, double unit) {
    const mpz_class below = -thresholds.less_to - 1;
    criterion.offset_above = thresholds.greater_from.get_d() * unit;
    criterion.offset_below = below.get_d() * unit;
    if (thresholds.decides_ties) criterion.otherwise = static_cast<std::uint8_t>(Decision::equal);
  }

  void set(FixedCriterion& criterion, const fixed::NormThresholds& thresholds, double unit) {
    const double radius_unit = power(thresholds.unit_exponent(lane_.nodes));
    criterion.radius = read_radius(thresholds).terms;
    if (thresholds.radius_is_squared) {
      const int root = add_root(thresholds);
      criterion.radius = {{.a = root, .b = root}};
    }
    criterion.slope_above = power(thresholds.shift_above) * unit / radius_unit;
    criterion.offset_above = thresholds.offset_above.get_d() * unit;
    criterion.slope_below = power(thresholds.shift_below) * unit / radius_unit;
  }

  /// The threshold of a running bound is a column, which the criterion reads with a slope of 1.
  void set(FixedCriterion& criterion, const fixed::RunningThresholds& thresholds, double unit) {
    const int column = code_.layout.columns++;
    FixedInstruction& threshold = code_.instructions.emplace_back(
        FixedInstruction{.kernel = FixedKernel::running_threshold, .result = column});
    const int last = static_cast<int>(thresholds.of_steps.size()) - 1;
    for (const NodeId id : thresholds.watched) {
      const FixedFormat& format = node(id).format;
      const int top = format.unit_exponent + format.magnitude_bits();
      threshold.watched.push_back(
          {.column = id, .unit = power(format.unit_exponent), .per_step_0 = power(last - top)});
    }
    for (const mpz_class& step : thresholds.of_steps) {
      threshold.of_steps.push_back(step.get_d() * unit);
    }
    criterion.radius = {{.a = column, .b = column}};
    criterion.slope_above = criterion.slope_below = 1;
  }

  int add_root(const fixed::NormThresholds& thresholds) {
    const int column = code_.layout.columns++;
    FixedInstruction& root = add_unary(FixedKernel::power_above_root, column, thresholds.radius);
    root.unit = power(thresholds.unit_exponent(lane_.nodes));
    root.square_unit = power(node(thresholds.radius).format.unit_exponent);
    return column;
  }

  FixedInstruction& add_unary(FixedKernel kernel, int result, int operand) {
    return code_.instructions.emplace_back(
        FixedInstruction{.kernel = kernel, .result = result, .a = operand, .b = operand});
  }

  const FixedLane& lane_;
  std::vector<int> reads_;  ///< [node]: by nodes and decisions
  std::vector<Expansion> expansions_;
  std::vector<bool> has_column_;
  FixedCode code_;
};

}  // namespace

std::optional<FixedCode> make_fixed_code(const FixedLane& lane) {
  const bool fits =
      std::all_of(lane.nodes.begin(), lane.nodes.end(),
                  [&](const FixedNode& node) { return fits_double(lane.nodes, node); }) &&
      std::all_of(lane.parts.begin(), lane.parts.end(),
                  [](const FixedPart& part) { return fits_double(part); });
  return fits ? std::optional(FixedCodeMaker(lane).make()) : std::nullopt;
}

}  // namespace mixcmp::emulator
