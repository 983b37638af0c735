#include "model/judge/proof/fixed_proof.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <set>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/judge/proof/fixed_degrees.hpp"
#include "model/judge/proof/function_enclosure.hpp"
#include "model/judge/proof/norm_conditions.hpp"
#include "model/judge/proof/script.hpp"
#include "model/lane/fixed/node_enclosure.hpp"
#include "model/lane/fixed/root_error.hpp"
#include "model/lane/fixed/running_bound.hpp"

namespace mixcmp::proof {
namespace {

using fixed::FixedLane;
using fixed::FixedNode;

/// Gappa reads only dyadic numbers. If a constant is not dyadic, errors are rounded outward to this
/// many places below the unit.
constexpr int places = 128;

constexpr std::size_t most_characters = 60;

/// Intervals of the lane and of the proof are rounded differently. A function's error exceeds the
/// lane's by at most so small a part of a unit.
constexpr int places_of_function_errors = 16;

mpq_class multiple_of(const mpq_class& grid, const mpz_class& count) {
  return grid * count;
}

bool is_dyadic(const mpq_class& value) {
  return mixcmp::is_power_of_two(mpq_class(value.get_den()));
}

Range rounded_outward(const Range& error, const FixedFormat& format) {
  if (is_dyadic(error.low) && is_dyadic(error.high)) return error;
  const mpq_class grid = power_of_two(format.unit_exponent - places);
  return {multiple_of(grid, floor_of(error.low / grid)),
          multiple_of(grid, ceiling_of(error.high / grid))};
}

/// Whether Gappa finds the error from the identity of `identity`. Theorem 2 proves the others.
bool is_polynomial(Operation operation) {
  switch (operation) {
    case Operation::negate:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square: return true;
    default: return false;
  }
}

bool is_inside(const Range& range, const Range& other) {
  return other.low <= range.low && range.high <= other.high;
}

class FixedProof {
public:
  FixedProof(const FixedLane& lane, const Prove& prove)
      : lane_(lane), nodes_(lane.nodes), prove_(prove) {
    proof_.lane = lane.format.name();
    proof_.kind = "fixed-point";
    find_functions();
  }

  LaneProof run() && {
    if (lane_.format.is_block) {
      add_exact("f and g are homogeneous of one degree", is_homogeneous(nodes_, Scaled::operands));
    }
    if (has_common_cuts()) {
      add_exact("f and g are homogeneous of one degree in what is cut in common",
                is_homogeneous(nodes_, Scaled::cuts));
      add_exact("common cuts drop as many bits as any of their operands needs", cuts_drop_enough());
    }
    for (NodeId id = 0; id < static_cast<NodeId>(nodes_.size()); ++id) prove_node(id);
    add_exact("every result fits its format", results_fit_);
    add_exact("every result counts the unit of its operation", units_are_right_);
    for (const fixed::FixedPart& part : lane_.parts) {
      std::visit([&](const auto& thresholds) { prove_decision(thresholds, part); }, part.criterion);
    }
    add_steps_by_hand();
    return std::move(proof_);
  }

private:
  std::string text(NodeId id) const {
    return to_text(shown_, lane_.input_names, id, most_characters);
  }

  void find_functions() {
    const auto functions = functions_of(lane_);
    if (!functions || !functions->empty()) {
      add_exact("only polynomials read what is inside of them", functions.has_value());
    }
    for (const FunctionNodes& each : functions.value_or(std::vector<FunctionNodes>())) {
      functions_.emplace(each.result, each);
      for (const NodeId id : each.inside) inside_.emplace(id, each.result);
    }
    shown_ = expression_of(lane_, functions.value_or(std::vector<FunctionNodes>()));
  }

  /// The computed number, and its error. The real number that it stands for is their difference.
  static std::string computed(NodeId id) { return fmt::format("x{}", id); }
  static std::string error(NodeId id) { return fmt::format("e{}", id); }
  static std::string truth(NodeId id) { return fmt::format("(x{0} - e{0})", id); }

  static std::string operation_text(Operation operation, const std::string& a,
                                    const std::string& b) {
    switch (operation) {
      case Operation::negate: return "-" + a;
      case Operation::add: return a + " + " + b;
      case Operation::subtract: return a + " - " + b;
      case Operation::multiply: return a + " * " + b;
      case Operation::square: return a + " * " + a;
      default: MIXCMP_CHECK(false);
    }
  }

  /// The error of an operation as a polynomial in the computed operands and their errors.
  static std::string identity(const FixedNode& node) {
    const NodeId a = node.operands[0], b = node.operands[1];
    switch (node.operation) {
      case Operation::negate: return "-" + error(a);
      case Operation::add: return error(a) + " + " + error(b);
      case Operation::subtract: return error(a) + " - " + error(b);
      case Operation::multiply: return fmt::format("x{0} * e{1} + x{1} * e{0} - e{0} * e{1}", a, b);
      case Operation::square: return fmt::format("e{0} * (x{0} + x{0} - e{0})", a);
      default: MIXCMP_CHECK(false);
    }
  }

  void prove_node(NodeId id) {
    prove_enclosure(id);
    results_fit_ = results_fit_ && fits(nodes_[id]);
    units_are_right_ = units_are_right_ && has_right_unit(nodes_[id]);
  }

  /// Whether the format's unit is the one that the operation's hardware has once bits are dropped.
  /// Inputs (except in block floating point), constants and roots may have any unit.
  bool has_right_unit(const FixedNode& node) const {
    const auto unit = [&](int k) { return nodes_[node.operands[k]].format.unit_exponent; };
    const int own = node.format.unit_exponent - node.dropped_bits;
    switch (node.operation) {
      case Operation::input:
        if (node.is_encoding) return own == -lane_.input_format.fraction_bits();
        if (const FixedFormat* arriving = fixed::arriving_fixed(lane_, node)) {
          return own == arriving->unit_exponent;
        }
        if (node.is_promised) return !lane_.format.is_block;
        return !lane_.format.is_block ||
               (own == -lane_.format.operand_bits() && node.format.magnitude_bits() == -own);
      case Operation::constant:
      case Operation::look_up:
      case Operation::square_root: return node.dropped_bits == 0;
      case Operation::convert: {
        if (fixed::is_floating_code(node)) return node.dropped_bits == 0;
        const bool is_cut = node.conversion == fixed::Conversion::cut ||
                            node.conversion == fixed::Conversion::function_value;
        return own == unit(0) && (is_cut || node.dropped_bits == 0);
      }
      case Operation::negate:
      case Operation::absolute: return own == unit(0);
      case Operation::square: return own == 2 * unit(0);
      case Operation::multiply: return own == unit(0) + unit(1);
      case Operation::add:
      case Operation::subtract:
      case Operation::minimum:
      case Operation::maximum: return own == std::min(unit(0), unit(1));
      case Operation::divide:
      case Operation::function:
      case Operation::fused_sum: return false;
    }
    MIXCMP_CHECK(false);
  }

  /// Whether the format holds every possible result.
  static bool fits(const FixedNode& node) {
    return in_format(node.value, node.format) == node.value;
  }

  /// Derives value and error from those of the operands.
  void prove_enclosure(NodeId id) {
    FixedNode& node = nodes_[id];
    if (const auto function = functions_.find(id); function != functions_.end()) {
      return prove_function(function->second);
    }
    if (const auto inside = inside_.find(id); inside != inside_.end()) {
      return prove_inside(id, functions_.at(inside->second));
    }
    if (node.operation == Operation::input) return assume_operand(node);
    if (node.operation == Operation::constant) {
      node.value.low = node.value.high = node.format.unit() * node.constant;
      node.error = rounded_outward(node.error, node.format);
      return;
    }
    if (node.operation == Operation::square_root) {
      const Range& squares = nodes_[node.operands[0]].value;
      node.value.low = root_of(squares.low, fixed::root_digits);
      node.value.high = root_above(squares.high, fixed::root_digits);
      node.error = rounded_outward(fixed::root_error(nodes_, node.operands[0]), node.format);
      node.error.low -= node.format.unit();
      node.value = fixed::rounded_down(node.value, node.format.unit());
      return;
    }
    if (node.operation == Operation::look_up) return;  // of no known function
    if (node.operation == Operation::convert) return convert(node);
    const FixedNode& a = nodes_[node.operands[0]];
    const FixedNode& b = nodes_[node.operands[std::max(0, arity(node.operation) - 1)]];
    const bool cancels =
        node.operation == Operation::subtract && node.operands[0] == node.operands[1];
    if (cancels) {
      node.value = node.error = {0, 0};
      return;
    }
    const Range value = fixed::exact_value(node.operation, a.value, b.value);
    const Range exact = rounded_outward(fixed::exact_error(node.operation, a, b), node.format);
    node.value = value;
    node.error = exact;
    drop_bits(node);
    if (is_polynomial(node.operation)) add_script(id, value, exact);
  }

  const std::optional<FunctionEnclosure>& enclosure_of(const FunctionNodes& function) {
    const auto [known, is_new] = enclosures_.try_emplace(function.result);
    if (is_new) known->second = enclose_function(lane_, nodes_, function);
    return known->second;
  }

  /// The number stands for itself.
  void prove_inside(NodeId id, const FunctionNodes& function) {
    const std::optional<FunctionEnclosure>& found = enclosure_of(function);
    FixedNode& node = nodes_[id];
    node.error = {0, 0};
    if (!found) return;
    const Range enclosed = found->inside.at(id);
    if (arity(node.operation) == 2) {
      const FixedNode &a = nodes_[node.operands[0]], &b = nodes_[node.operands[1]];
      node.value = fixed::exact_value(node.operation, a.value, b.value);
      drop_bits(node);
      node.error = {0, 0};
      fixed::narrow(node.value, enclosed);
    } else {
      node.value = enclosed;
    }
  }

  /// Theorem 10. The comparisons of a running bound's step have those of all comparisons.
  void prove_function(const FunctionNodes& function) {
    if (!where_.empty()) return;
    FixedNode& node = nodes_[function.result];
    const std::string name = text(function.result);
    const std::optional<FunctionEnclosure>& found = enclosure_of(function);
    if (!found) {
      proof_.findings.push_back({"value and error of " + name, Outcome::not_proven,
                                 "the function's nodes have no bound"});
      node.error = rounded_outward(node.error, node.format);
      return;
    }
    const Range stated = node.error;
    Range value = found->value;
    if (node.conversion == fixed::Conversion::function_value) {
      FixedNode last = node;  // the last cut
      last.value = nodes_[node.operands[0]].value;
      drop_bits(last);
      fixed::narrow(value, last.value);
    }
    const mpq_class more = scaled(node.format.unit(), -places_of_function_errors);
    const bool holds = is_inside(value, node.value) &&
                       is_inside(found->error, {stated.low - more, stated.high + more});
    const std::string other =
        fmt::format("; the lane says {} to {}", shown(stated.low), shown(stated.high));
    proof_.findings.push_back({fmt::format("value and error of {}: {} to {}", name,
                                           shown(found->error.low), shown(found->error.high)),
                               holds ? Outcome::proven : Outcome::not_proven,
                               found->reason + (holds ? "" : other)});
    node.value = value;
    node.error = rounded_outward(found->error, node.format);
  }

  /// Theorem 2 on dropped bits, by hand.
  static void drop_bits(FixedNode& node) {
    if (node.dropped_bits == 0) return;
    node.error.low -= node.format.unit() * (1 - power_of_two(-node.dropped_bits));
    node.value = fixed::rounded_down(node.value, node.format.unit());
  }

  /// The range of a limit's result. Hardware checks an end of the limit if it lies inside the range
  /// that the lane states for the operand. Any other end is that of the operand.
  Range within_limits(const FixedNode& limit, const Range& operand) const {
    const Range& said = lane_.nodes[limit.operands[0]].value;
    return {limit.value.low > said.low ? limit.value.low : operand.low,
            limit.value.high < said.high ? limit.value.high : operand.high};
  }

  /// The numbers of a range that a format holds.
  static Range in_format(const Range& value, const FixedFormat& format) {
    const mpq_class unit = format.unit();
    return {std::max<mpq_class>(value.low, format.smallest() * unit),
            std::min<mpq_class>(value.high, format.largest() * unit)};
  }

  /// Derives the value and error of a conversion: a cut or a limit by theorem 2, by hand; a common
  /// cut by theorem 7; a reach by theorem 8.
  void convert(FixedNode& node) {
    const FixedNode& operand = nodes_[node.operands[0]];
    switch (*node.conversion) {
      case fixed::Conversion::cut:
        node.value = operand.value;
        node.error = operand.error;
        return drop_bits(node);
      case fixed::Conversion::common_cut:
        node.value = fixed::cut_value(operand, lane_.format.bits, node.most_dropped);
        node.error = rounded_outward(fixed::cut_error(operand, node.most_dropped), node.format);
        return;
      case fixed::Conversion::limit:
        node.value = within_limits(node, operand.value);
        node.error = operand.error;
        return;
      case fixed::Conversion::reach:  // the hardware checks the format
        node.value = in_format(operand.value, node.format);
        node.error = operand.error;
        return;
      case fixed::Conversion::floating:
      case fixed::Conversion::place:
      case fixed::Conversion::function_value: return;  // of no known function
    }
    MIXCMP_CHECK(false);
  }

  /// Whether the operand of each common cut has at most `most_dropped` bits more than W, and
  /// `most_dropped` is the same for all common cuts.
  bool cuts_drop_enough() const {
    const int most = fixed::most_dropped_in_common(lane_);
    return std::all_of(nodes_.begin(), nodes_.end(), [&](const FixedNode& node) {
      if (!fixed::is_common_cut(node)) return true;
      const int bits = nodes_[node.operands[0]].format.magnitude_bits();
      return node.most_dropped == most && bits <= lane_.format.bits + most;
    });
  }

  /// Theorem 1, by hand; an operand in fixed point loses only its dropped bits. An encoding stands
  /// for itself. The hardware checks that promised multiples of the unit are such.
  void assume_operand(FixedNode& node) const {
    const mpq_class unit = node.format.unit();
    node.value = {node.format.smallest() * unit, node.format.largest() * unit};
    node.error = {0, 0};
    if (node.is_promised || node.is_encoding) return;
    const FixedFormat* arriving = fixed::arriving_fixed(lane_, node);
    node.error.low = (arriving == nullptr ? mpq_class(0) : arriving->unit()) - unit;
  }

  void add_script(NodeId id, const Range& value, const Range& exact) {
    const FixedNode& node = nodes_[id];
    const auto end = node.operands.begin() + arity(node.operation);
    const std::vector<NodeId> operands(node.operands.begin(), end);
    Script script;
    script.comment("x: numbers as computed; e: their errors; c, t: the result and the true one.");
    for (std::size_t k = 0; k < operands.size(); ++k) {
      if (k == 1 && operands[1] == operands[0]) continue;
      const FixedNode& operand = nodes_[operands[k]];
      for (const auto& [name, range] :
           {std::pair(computed(operands[k]), operand.value), {error(operands[k]), operand.error}}) {
        script.assume_within(name, dyadic(range.low), dyadic(range.high));
      }
    }
    const NodeId last = operands.back();
    script.define("c", operation_text(node.operation, computed(operands[0]), computed(last)));
    script.define("t", operation_text(node.operation, truth(operands[0]), truth(last)));
    const FixedNode &first = nodes_[operands[0]], &second = nodes_[last];
    script.ask_for_digits(
        digits_between({&first.value, &first.error, &second.value, &second.error, &value, &exact}));
    conclude(script, "c", value);
    conclude(script, "c - t", exact);
    script.hint("c - t", identity(node));
    const ScriptResult result = prove_(script.text());
    Finding finding{fmt::format("value and error of {}{}: {} to {}", text(id), where_,
                                shown(exact.low), shown(exact.high)),
                    result.outcome, result.detail};
    if (!result.file.empty()) finding.files.push_back(result.file);
    proof_.findings.push_back(std::move(finding));
  }

  /// Digits with which Gappa's products of numbers between these ends are exact.
  static int digits_between(std::initializer_list<const Range*> ranges) {
    long least = 0, top = 0;
    for (const Range* range : ranges) {
      for (const mpq_class& end : {range->low, range->high}) {
        if (end == 0) continue;
        least = std::min(least, lowest_digit(end));
        top = std::max(top, floor_log2(abs(end)) + 1);
      }
    }
    return static_cast<int>(2 * (top - least));
  }

  static std::string shown(const mpq_class& value) { return rounded_text(value, 4); }

  static void conclude(Script& script, const std::string& name, const Range& range) {
    script.conclude(fmt::format("{} in [{}, {}]", name, dyadic(range.low), dyadic(range.high)));
  }

  void add_exact(std::string what, bool holds) {
    proof_.findings.push_back(
        {std::move(what), holds ? Outcome::proven : Outcome::not_proven, "by exact arithmetic"});
  }

  bool has_common_cuts() const {
    return std::any_of(nodes_.begin(), nodes_.end(), fixed::is_common_cut);
  }

  void prove_decision(const fixed::ConstantThresholds& thresholds, const fixed::FixedPart& part) {
    const FixedNode& difference = nodes_[part.difference];
    const mpq_class unit = difference.format.unit();
    add_exact("the constants lie beyond the error of f - g",
              thresholds.greater_from * unit > difference.error.high &&
                  thresholds.less_to * unit < difference.error.low &&
                  (!thresholds.decides_ties || is_exact(difference, thresholds)));
    if (has_reaches()) {
      add_exact("constants depend on no reach", !depends_on_reach(part.difference));
    }
  }

  /// Whether a difference that lies between the constants is 0, and the real difference is 0 as
  /// well.
  static bool is_exact(const FixedNode& difference, const fixed::ConstantThresholds& thresholds) {
    return difference.error.low == 0 && difference.error.high == 0 &&
           thresholds.greater_from == 1 && thresholds.less_to == -1;
  }

  /// The condition of theorem 3 in each step, by the errors that comparisons of it can have.
  void prove_decision(const fixed::RunningThresholds& thresholds, const fixed::FixedPart& part) {
    const std::vector<FixedNode> whole = nodes_;
    const auto last = static_cast<int>(thresholds.of_steps.size()) - 1;
    bool suffice = steps_are_right(thresholds, part) && !depends_on_reach(part.difference);
    for (int step = 0; step <= last; ++step) {
      nodes_ = whole;
      where_ = fmt::format(", step {}", step);
      for (NodeId id = 0; id < static_cast<NodeId>(nodes_.size()); ++id) {
        enclose_in_step(id, whole, thresholds, step);
      }
      const FixedNode& difference = nodes_[part.difference];
      const mpq_class unit = difference.format.unit();
      const mpz_class& threshold = thresholds.of_steps[step];
      const FixedFormat& format = difference.format;
      suffice = suffice &&
                (threshold > format.largest() || threshold * unit > difference.error.high) &&
                (-threshold <= format.smallest() || -(threshold + 1) * unit < difference.error.low);
    }
    nodes_ = whole;
    where_.clear();
    add_exact("the threshold of each step lies beyond the error of f - g there", suffice);
  }

  /// Whether hardware can have these steps: their number is allowed, every watched number has a bit
  /// left in each step, and the difference is computed from all watched numbers.
  bool steps_are_right(const fixed::RunningThresholds& thresholds,
                       const fixed::FixedPart& part) const {
    const auto last = static_cast<int>(thresholds.of_steps.size()) - 1;
    const std::set<NodeId> cone = fixed::fan_in(lane_, part.difference);
    return last >= 1 && last <= fixed::most_last_step &&
           std::all_of(thresholds.watched.begin(), thresholds.watched.end(), [&](NodeId id) {
             return cone.contains(id) && nodes_[id].format.magnitude_bits() > last;
           });
  }

  /// Narrows the enclosures of `whole` to those in a step.
  void enclose_in_step(NodeId id, const std::vector<FixedNode>& whole,
                       const fixed::RunningThresholds& thresholds, int step) {
    FixedNode& node = nodes_[id];
    bool has_changed = false;
    for (int k = 0; k < arity(node.operation); ++k) {
      has_changed = has_changed || nodes_[node.operands[k]] != whole[node.operands[k]];
    }
    if (has_changed) prove_enclosure(id);
    fixed::narrow(node.value, whole[id].value);
    fixed::narrow(node.error, whole[id].error);
    const auto& watched = thresholds.watched;
    if (std::find(watched.begin(), watched.end(), id) == watched.end()) return;
    const auto last = static_cast<int>(thresholds.of_steps.size()) - 1;
    const mpq_class unit = node.format.unit();
    const mpq_class beyond = scaled(unit, node.format.magnitude_bits() - last + step);
    fixed::narrow(node.value, {-beyond, beyond - unit});
  }

  void prove_decision(const fixed::NormThresholds& thresholds, const fixed::FixedPart& part) {
    const NormConditions conditions(nodes_, nodes_[part.difference], thresholds);
    add_exact("the thresholds are those that theorem 4 asks for", conditions.hold());
    if (!has_reaches()) return;
    bool decide = conditions.hold() && !depends_on_reach(conditions.other_side());
    for (const NodeId id : conditions.elements()) {
      decide = decide && decides_beyond(id, conditions.far_square());
    }
    add_exact("what is beyond reach decides", decide);
  }

  /// Whether an element of x depends on no reach except its own, and the square of an element
  /// beyond its reach is `far` or more.
  bool decides_beyond(NodeId element, const mpq_class& far) const {
    const FixedNode& node = nodes_[element];
    if (!fixed::is_reach(node)) return !depends_on_reach(element);
    const Range& whole = nodes_[node.operands[0]].value;
    const mpq_class above = node.value.high + node.format.unit();
    const mpq_class below = node.value.low - node.format.unit();
    return (node.value.high >= whole.high || above * above >= far) &&
           (node.value.low <= whole.low || below * below >= far) &&
           !depends_on_reach(node.operands[0]);
  }

  bool depends_on_reach(NodeId id) const {
    const std::set<NodeId> cone = fixed::fan_in(lane_, id);
    return std::any_of(cone.begin(), cone.end(),
                       [&](NodeId behind) { return fixed::is_reach(nodes_[behind]); });
  }

  bool has_reaches() const { return std::any_of(nodes_.begin(), nodes_.end(), fixed::is_reach); }

  /// `theorem`: "2 (limits)" where it says several things.
  void add_step(const std::string& theorem, const char* statement) {
    const std::string number = theorem.substr(0, theorem.find(' '));
    proof_.by_hand.push_back(
        {theorem, fmt::format("docs/fixed_point.md, theorem {}: {}", number, statement)});
  }

  void add_steps_by_hand() {
    const auto any = [&](auto condition) {
      return std::any_of(nodes_.begin(), nodes_.end(), condition);
    };
    add_step("1 (operands)", "value and error of an operand");
    if (any([](const FixedNode& node) {
          return node.operation == Operation::absolute || is_choice(node.operation);
        })) {
      add_step("2 (choices)", "absolute values, minima and maxima");
    }
    if (any([](const FixedNode& node) { return node.dropped_bits > 0; })) {
      add_step("2 (dropped bits)", "the error of dropped bits");
    }
    if (any([](const FixedNode& node) { return fixed::is_limit(node); })) {
      add_step("2 (limits)", "the values that pass a limit");
    }
    if (any([](const FixedNode& node) { return node.operation == Operation::square_root; })) {
      add_step("5", "value and error of a square root");
    }
    const auto any_function = [&](bool jumps) {
      return any([&](const FixedNode& node) {
        return node.function && has_jumps(*node.function) == jumps;
      });
    };
    if (any_function(false)) add_step("10", "from polynomials to a function's error");
    if (any_function(true)) add_step("11", "from exact quotients and signs to errors");
    if (lane_.format.is_block) add_step("6", "operands divided by a power of two");
    if (has_common_cuts()) add_step("7", "value and error of a common cut");
    if (has_reaches()) add_step("8", "one square that decides");
    if (any_part<fixed::ConstantThresholds>()) add_step("3", "from the error to the constants");
    if (any_part<fixed::RunningThresholds>()) {
      add_step("9", "from the error in a step to its threshold");
    }
    if (any_part<fixed::NormThresholds>()) {
      add_step("4", "from the errors' norm to the thresholds");
    }
  }

  template <class Thresholds>
  bool any_part() const {
    return std::any_of(lane_.parts.begin(), lane_.parts.end(), [](const fixed::FixedPart& part) {
      return std::holds_alternative<Thresholds>(part.criterion);
    });
  }

  const FixedLane& lane_;
  std::vector<FixedNode> nodes_;               ///< with errors that Gappa can read
  std::vector<Node> shown_;                    ///< for their texts
  std::map<NodeId, FunctionNodes> functions_;  ///< by their results
  std::map<NodeId, NodeId> inside_;            ///< the results of the functions that nodes are in
  std::map<NodeId, std::optional<FunctionEnclosure>> enclosures_;  ///< by their results
  const Prove& prove_;
  bool results_fit_ = true;
  bool units_are_right_ = true;
  std::string where_;  ///< ", step 3" of a running bound
  LaneProof proof_;
};

}  // namespace

LaneProof prove_fixed(const FixedLane& lane, const Prove& prove) {
  return FixedProof(lane, prove).run();
}

}  // namespace mixcmp::proof
