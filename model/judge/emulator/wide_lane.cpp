#include "model/judge/emulator/wide_lane.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "model/base/common/check.hpp"
#include "model/judge/emulator/combine_parts.hpp"

namespace mixcmp::emulator {
namespace {

using fixed::FixedLane;
using fixed::FixedNode;

/// Magnitudes are at most 2^most_bits, so that the sum of two of them fits as well.
constexpr int most_bits = 125;

Wide power_of_two(int exponent) {
  return Wide{1} << exponent;
}

int bits_of(const mpz_class& value) {
  return static_cast<int>(mpz_sizeinbase(value.get_mpz_t(), 2));
}

/// A number of more than most_bits + 1 bits becomes 2^(most_bits + 1) or its negation, which
/// compares with every result as the number does.
Wide wide(const mpz_class& value) {
  const mpz_class magnitude = abs(value);
  const mpz_class low = magnitude % (mpz_class(1) << 64), high = magnitude >> 64;
  const Wide found = bits_of(value) > most_bits + 1
                         ? power_of_two(most_bits + 1)
                         : (Wide{high.get_ui()} << 64) + Wide{low.get_ui()};
  return value < 0 ? -found : found;
}

/// value * 2^shift, rounded down.
Wide shifted(Wide value, int shift) {
  if (shift >= 0) return value << shift;
  return value >> std::min(-shift, 127);
}

/// Whether the integer is from -2^bits to 2^bits - 1.
bool fits(Wide value, int bits) {
  const Wide magnitude = value < 0 ? -(value + 1) : value;
  return bits > most_bits || (magnitude >> bits) == 0;
}

/// The square root, rounded down.
Wide root_of(Wide value) {
  Wide root = 0;
  for (int bit = most_bits / 2; bit >= 0; --bit) {
    const Wide tried = root + power_of_two(bit);
    if (tried * tried <= value) root = tried;
  }
  return root;
}

/// 2^k for the least k >= 0 with value < 4^k.
Wide power_above_root(Wide value) {
  int k = 0;
  while ((value >> (2 * k)) != 0) ++k;
  return power_of_two(k);
}

bool aligns_operands(Operation operation) {
  return operation == Operation::add || operation == Operation::subtract || is_choice(operation);
}

Decision negated(Decision decision) {
  if (decision == Decision::less) return Decision::greater;
  return decision == Decision::greater ? Decision::less : decision;
}

}  // namespace

/// Makes a lane, and bounds the bits of each node's results from those of its operands. The nodes'
/// formats are no such bound: a number beyond its reach does not fit its format.
class WideLane::Maker {
public:
  explicit Maker(const FixedLane& lane) : lane_(lane) {}

  std::optional<WideLane> make() {
    for (const FixedNode& node : lane_.nodes) add(node);
    for (const fixed::FixedPart& part : lane_.parts) {
      const auto criterion =
          std::visit([&](const auto& thresholds) { return converted(thresholds); }, part.criterion);
      made_.parts_.push_back({part.difference, part.swapped, criterion});
    }
    made_.inputs_read_ = fixed::inputs_read(lane_);
    made_.cut_in_common_ = fixed::cut_in_common(lane_);
    made_.combination_ = lane_.combination;
    made_.format_bits_ = lane_.format.bits;
    if (lane_.format.is_block) {
      made_.least_block_exponent_ = fixed::least_block_exponent(lane_.input_format);
    }
    return fits_ ? std::optional(std::move(made_)) : std::nullopt;
  }

private:
  using Criterion = std::variant<Constant, Norm, Running>;

  void add(const FixedNode& node) {
    Node added{.operation = node.operation,
               .conversion = node.conversion,
               .operands = node.operands,
               .input = node.input,
               .format = node.format,
               .dropped_bits = node.dropped_bits,
               .arrives_fixed = node.operation == Operation::input &&
                                fixed::arriving_fixed(lane_, node) != nullptr,
               .is_promised = node.is_promised,
               .constant = wide(node.constant)};
    if (aligns_operands(node.operation)) align(added);
    if (node.operation == Operation::square_root) {
      added.shifts[0] = unit_of(node.operands[0]) - 2 * node.format.unit_exponent;
    }
    if (fixed::is_limit(node)) set_limits(added, node.value);
    if (node.operation == Operation::look_up) set_words(added, node);
    if (node.is_encoding) added.exponent_bias = lane_.input_format.bias();
    if (fixed::is_floating_code(node)) {
      added.argument_bits = lane_.nodes[node.operands[0]].format.width;
    }
    const int bits = result_bits(added, node);
    fits_ = fits_ && bits <= most_bits;
    const int most = fixed::is_common_cut(node) ? lane_.format.bits : most_bits;
    const bool is_input = node.operation == Operation::input;
    node_bits_.push_back(std::clamp(is_input ? bits : bits - node.dropped_bits, 0, most));
    made_.nodes_.push_back(added);
  }

  void set_words(Node& node, const FixedNode& look_up) const {
    node.piece_bits = fixed::piece_bits(lane_.nodes, look_up);
    for (std::size_t address = 0; address < look_up.words.size(); ++address) {
      node.words.push_back(wide(look_up.words[address]));
    }
  }

  int unit_of(NodeId id) const { return lane_.nodes[id].format.unit_exponent; }

  void align(Node& node) const {
    const int units[] = {unit_of(node.operands[0]), unit_of(node.operands[1])};
    for (int k = 0; k < 2; ++k) node.shifts[k] = units[k] - std::min(units[0], units[1]);
  }

  static void set_limits(Node& node, const Range& value) {
    const mpq_class low = value.low / node.format.unit(), high = value.high / node.format.unit();
    mpz_class ceiling, floor;
    mpz_cdiv_q(ceiling.get_mpz_t(), low.get_num_mpz_t(), low.get_den_mpz_t());
    mpz_fdiv_q(floor.get_mpz_t(), high.get_num_mpz_t(), high.get_den_mpz_t());
    node.low = wide(ceiling);
    node.high = wide(floor);
  }

  /// The bits of a conversion inside a function. A function's value has lost its low bits.
  static int most_of(const FixedNode& node) { return node.format.width + node.dropped_bits; }

  /// The bits of the exact result, and of operands once they are aligned.
  int result_bits(const Node& node, const FixedNode& source) const {
    const auto operand = [&](int k) {
      return node_bits_[node.operands[k]] + std::max(0, node.shifts[k]);
    };
    switch (node.operation) {
      case Operation::input: return node.format.magnitude_bits();
      case Operation::constant: return bits_of(source.constant);
      case Operation::convert:
        return fixed::follows_operands(source) ? operand(0) : most_of(source);
      case Operation::look_up: return node.format.magnitude_bits();
      case Operation::negate:
      case Operation::absolute: return operand(0) + 1;
      case Operation::add:
      case Operation::subtract: return std::max(operand(0), operand(1)) + 1;
      case Operation::multiply: return operand(0) + operand(1);
      case Operation::square: return 2 * operand(0);
      case Operation::minimum:
      case Operation::maximum: return std::max(operand(0), operand(1));
      case Operation::square_root: return operand(0);
      case Operation::divide:
      case Operation::function:
      case Operation::fused_sum: break;
    }
    MIXCMP_CHECK(false);
  }

  Criterion converted(const fixed::ConstantThresholds& thresholds) {
    return Constant{wide(thresholds.greater_from), wide(thresholds.less_to),
                    thresholds.decides_ties ? Decision::equal : Decision::undecided};
  }

  Criterion converted(const fixed::NormThresholds& thresholds) {
    const int bits = thresholds.radius_is_squared ? node_bits_[thresholds.radius] / 2 + 1
                                                  : node_bits_[thresholds.radius];
    const int most = bits + std::max({0, thresholds.shift_above, thresholds.shift_below});
    fits_ = fits_ && std::max(most, bits_of(thresholds.offset_above)) < most_bits;
    return Norm{thresholds.radius, thresholds.radius_is_squared, thresholds.shift_above,
                wide(thresholds.offset_above), thresholds.shift_below};
  }

  Criterion converted(const fixed::RunningThresholds& thresholds) {
    Running running{.watched = thresholds.watched, .of_steps = {}};
    for (const mpz_class& step : thresholds.of_steps) running.of_steps.push_back(wide(step));
    return running;
  }

  const FixedLane& lane_;
  WideLane made_;
  std::vector<int> node_bits_;  ///< by node: results are from -2^bits to 2^bits
  bool fits_ = true;
};

/// The scratch memory of one call.
class WideLane::Run {
public:
  explicit Run(const WideLane& lane)
      : lane_(lane), values_(lane.nodes_.size()), has_value_(lane.nodes_.size()) {}

  Decision decide(std::span<const double* const> operands, std::size_t index) {
    evaluate(operands, index);
    Decision decision = decide(lane_.parts_.front());
    for (std::size_t part = 1; part < lane_.parts_.size(); ++part) {
      const Decision further = decide(lane_.parts_[part]);
      combine_parts(lane_.combination_, std::span(&decision, 1), std::span(&further, 1));
    }
    return decision;
  }

private:
  void evaluate(std::span<const double* const> operands, std::size_t index) {
    const std::optional<int> scale = block_exponent(operands, index);
    std::optional<int> dropped_in_common;
    for (std::size_t id = 0; id < values_.size(); ++id) {
      const Node& node = lane_.nodes_[id];
      if (node.operation == Operation::input) {
        has_value_[id] = scale && convert(node, operands[node.input][index], *scale, values_[id]);
      } else if (node.operation == Operation::constant) {
        values_[id] = node.constant;
        has_value_[id] = true;
      } else if (node.conversion == fixed::Conversion::common_cut) {
        has_value_[id] = have_values(lane_.cut_in_common_);
        if (!has_value_[id]) continue;
        if (!dropped_in_common) dropped_in_common = common_drop();
        values_[id] = values_[node.operands[0]] >> *dropped_in_common;
      } else {
        has_value_[id] = operate(node, values_[id]);
      }
    }
  }

  /// The power of two by which operands are divided; 0 outside of block floating point. None if an
  /// operand is infinite or a NaN.
  std::optional<int> block_exponent(std::span<const double* const> operands,
                                    std::size_t index) const {
    if (!lane_.least_block_exponent_) return 0;
    int largest = *lane_.least_block_exponent_;
    for (const int input : lane_.inputs_read_) {
      const double operand = operands[input][index];
      if (!std::isfinite(operand)) return std::nullopt;
      int exponent = 0;
      if (std::frexp(operand, &exponent) != 0) largest = std::max(largest, exponent);
    }
    return largest;
  }

  /// An operand as an integer: its magnitude is truncated, and all bits are inverted if its sign
  /// bit is set. A promised multiple of the unit is exact. False if the format does not hold the
  /// magnitude or the sign, or if the promise is broken.
  static bool convert(const Node& node, double operand, int scale, Wide& value) {
    const FixedFormat& format = node.format;
    if (node.arrives_fixed) {
      value = static_cast<Wide>(std::floor(std::ldexp(operand, -format.unit_exponent)));
      return true;
    }
    if (node.exponent_bias) return encode(node, operand, value);
    const bool is_negative = std::signbit(operand);
    if (std::isnan(operand) || (is_negative && !format.is_signed)) return false;
    const double units = std::ldexp(std::abs(operand), -(format.unit_exponent + scale));
    if (units >= std::ldexp(1, format.magnitude_bits())) return false;
    const auto magnitude = static_cast<Wide>(units);
    if (node.is_promised) {
      value = is_negative ? -magnitude : magnitude;
      return std::trunc(units) == units;
    }
    value = is_negative ? -magnitude - 1 : magnitude;
    return true;
  }

  /// The encoding of an operand; false if the limit behind it accepts none such.
  static bool encode(const Node& node, double operand, Wide& value) {
    if (!(operand > 0) || !std::isfinite(operand)) return false;
    int exponent = 0;
    const double significand = 2 * std::frexp(operand, &exponent);
    const int fraction_bits = -node.format.unit_exponent;
    const auto fraction = static_cast<Wide>(std::ldexp(significand - 1, fraction_bits));
    value = (Wide(exponent - 1 + *node.exponent_bias) << fraction_bits) + fraction;
    return value > 0;
  }

  bool have_values(const std::vector<NodeId>& nodes) const {
    return std::all_of(nodes.begin(), nodes.end(), [&](NodeId id) { return has_value_[id]; });
  }

  /// The fewest low bits without which each common cut's operand fits.
  int common_drop() const {
    int dropped = 0;
    for (const NodeId id : lane_.cut_in_common_) {
      while (!fits(values_[id] >> dropped, lane_.format_bits_)) ++dropped;
    }
    return dropped;
  }

  /// False if an operand has no value, or lies outside a limit.
  bool operate(const Node& node, Wide& value) const {
    Wide operands[2] = {};
    for (int k = 0; k < arity(node.operation); ++k) {
      if (!has_value_[node.operands[k]]) return false;
      operands[k] = shifted(values_[node.operands[k]], node.shifts[k]);
    }
    if (node.operation == Operation::look_up) {
      const auto upper = static_cast<std::size_t>(operands[0] >> node.piece_bits);
      value = node.words[upper & (node.words.size() - 1)];
      return true;
    }
    if (node.conversion == fixed::Conversion::floating) {
      value = operands[0] >= 0 ? floating_code(node, operands[0]) : 0;
      return operands[0] >= 0;
    }
    value = shifted(result(node.operation, operands[0], operands[1]), -node.dropped_bits);
    if (node.conversion == fixed::Conversion::place) value &= power_of_two(node.format.width) - 1;
    const bool is_limit = node.conversion == fixed::Conversion::limit;
    return !is_limit || (value >= node.low && value <= node.high);
  }

  /// Computes what function::FloatingCode::of does.
  static Wide floating_code(const Node& node, Wide number) {
    const function::FloatingCode code{node.argument_bits};
    if (number == 0) return Wide(code.offset() - 1) << code.fraction_bits();
    int exponent = 0;
    while ((number >> exponent) > 1) ++exponent;
    const Wide field = exponent + code.offset() - 1;
    return (field << code.fraction_bits()) + (number << (code.fraction_bits() - exponent));
  }

  static Wide result(Operation operation, Wide a, Wide b) {
    switch (operation) {
      case Operation::convert: return a;
      case Operation::negate: return -a;
      case Operation::absolute: return a < 0 ? -a : a;
      case Operation::add: return a + b;
      case Operation::subtract: return a - b;
      case Operation::multiply: return a * b;
      case Operation::square: return a * a;
      case Operation::minimum: return std::min(a, b);
      case Operation::maximum: return std::max(a, b);
      case Operation::square_root: return root_of(a);
      case Operation::input:
      case Operation::constant:
      case Operation::divide:
      case Operation::function:
      case Operation::look_up:
      case Operation::fused_sum: break;
    }
    MIXCMP_CHECK(false);
  }

  Decision decide(const Part& part) const {
    if (!has_value_[part.difference]) return Decision::undecided;
    const Wide difference = values_[part.difference];
    const Decision decision = std::visit(
        [&](const auto& criterion) { return decide(criterion, difference); }, part.criterion);
    return part.swapped ? negated(decision) : decision;
  }

  static Decision decide(const Constant& criterion, Wide difference) {
    if (difference >= criterion.greater_from) return Decision::greater;
    return difference <= criterion.less_to ? Decision::less : criterion.otherwise;
  }

  Decision decide(const Norm& criterion, Wide difference) const {
    const Wide value = values_[criterion.radius];
    const Wide radius = criterion.radius_is_squared ? power_above_root(value) : value;
    if (difference >= shifted(radius, criterion.shift_above) + criterion.offset_above) {
      return Decision::greater;
    }
    return difference < -shifted(radius, criterion.shift_below) ? Decision::less
                                                                : Decision::undecided;
  }

  Decision decide(const Running& criterion, Wide difference) const {
    const int last = static_cast<int>(criterion.of_steps.size()) - 1;
    int step = 0;
    for (const NodeId id : criterion.watched) {
      const int bits = lane_.nodes_[id].format.magnitude_bits();
      while (step < last && !fits(values_[id], bits - last + step)) ++step;
    }
    const Wide threshold = criterion.of_steps[static_cast<std::size_t>(step)];
    if (difference >= threshold) return Decision::greater;
    return difference < -threshold ? Decision::less : Decision::undecided;
  }

  const WideLane& lane_;
  std::vector<Wide> values_;
  std::vector<char> has_value_;
};

std::optional<WideLane> WideLane::make(const FixedLane& lane) {
  return Maker(lane).make();
}

void WideLane::decide(std::span<const double* const> operands,
                      std::span<Decision> decisions) const {
  Run run(*this);
  for (std::size_t k = 0; k < decisions.size(); ++k) decisions[k] = run.decide(operands, k);
}

}  // namespace mixcmp::emulator
