#include "generator/hardware/datapath/fixed_units.hpp"

#include <algorithm>

#include "generator/hardware/datapath/stage_list.hpp"
#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"

namespace mixcmp::datapath {
namespace {

using fixed::FixedLane;
using fixed::FixedNode;

bool aligns_operands(Operation operation) {
  return operation == Operation::add || operation == Operation::subtract || is_choice(operation);
}

/// The bits that hold a number of the format in two's complement. A format without a sign needs one
/// bit more.
int signed_bits(const FixedFormat& format) {
  return format.width + (format.is_signed ? 0 : 1);
}

/// The unit that converts an operand: aligned to its range; exactly, to its grid; or, in block
/// floating point, aligned to the largest operand.
Unit operand_unit(const FixedLane& lane, const FixedNode& input, const DelayTable& delays) {
  const FloatFormat from = lane.input_format;
  const FixedFormat& to = input.format;
  StageList stages(delays);
  stages.add("distance", stages.carry(from.exponent_bits()) + stages.lut_delay_ns(1));
  const int or_levels =
      input.is_promised ? reduction_levels(to.width) : 0;  // of the bits shifted out
  stages.add("shift", stages.lut_delay_ns(1 + shift_levels(bits_for(to.width - 1)) + or_levels));
  if (input.is_promised) {
    stages.add("negate", to.is_signed ? stages.carry(to.width) : stages.lut_delay_ns(1));
    return std::move(stages).unit("fixed_grid_operand");
  }
  return std::move(stages).unit(lane.format.is_block ? "fixed_alignment" : "fixed_operand");
}

/// The unit of a product by an embedded multiplier. `b_bits` is the width of the second factor. Its
/// bits beyond the multiplier's port become rows of gates.
Unit product_unit(int b_bits, const DelayTable& delays) {
  const bool rows = b_bits - 1 > delays.multiplier_size.b_bits;
  StageList stages(delays);
  stages.add("multiply", delays.multiplier_ns);
  stages.add("output", rows ? delays.multiplier_add_ns : delays.multiplier_output_ns);
  Unit unit = std::move(stages).unit("fixed_product");
  unit.multiplier = delays.multiplier_size;
  return unit;
}

Unit logic_product_unit(LogicProduct::Kind kind, int bits, const DelayTable& delays) {
  constexpr int fewest_bits = 4;
  StageList stages(delays);
  stages.add_logic_product({std::max(bits, fewest_bits), kind});
  return std::move(stages).unit("fixed_logic_product");
}

Unit choice_unit(int bits, const DelayTable& delays) {
  StageList stages(delays);
  stages.add("compare", stages.carry(bits + 1));
  stages.add("select", stages.lut_delay_ns(1));
  return std::move(stages).unit("fixed_minimum_maximum");
}

/// The unit that finds the leading one of a function's argument.
Unit floating_code_unit(const FixedLane& lane, const FixedNode& code, const DelayTable& delays) {
  const int bits = lane.nodes[code.operands[0]].format.width;
  StageList stages(delays);
  stages.add("count", stages.lut_delay_ns(count_levels(bits)));
  stages.add("shift", stages.lut_delay_ns(shift_levels(bits_for(bits - 1))));
  return std::move(stages).unit("fixed_floating");
}

/// A table in logic: look-up tables of six inputs, and multiplexers of four.
Unit table_unit(int address_bits, const DelayTable& delays) {
  constexpr int inputs = 6;
  StageList stages(delays);
  stages.add("read", stages.lut_delay_ns(1 + shift_levels(std::max(0, address_bits - inputs))));
  return std::move(stages).unit("fixed_table");
}

/// A square root with one stage for each bit of the root.
Unit square_root_unit(int root_bits, const DelayTable& delays) {
  StageList stages(delays);
  for (int bit = 0; bit < root_bits; ++bit) {
    stages.add("digit " + std::to_string(bit), stages.carry(bit + 3));
  }
  return std::move(stages).unit("fixed_square_root");
}

Unit common_cut_unit(const FixedNode& node, const DelayTable& delays) {
  StageList stages(delays);
  stages.add("shift", stages.lut_delay_ns(shift_levels(bits_for(node.most_dropped))));
  return std::move(stages).unit("fixed_common_cut");
}

/// A unit of one carry chain.
Unit chain_unit(std::string module, std::string stage, int bits, const DelayTable& delays) {
  StageList stages(delays);
  stages.add(std::move(stage), stages.carry(bits));
  return std::move(stages).unit(std::move(module));
}

Unit decision_unit(const FixedLane&, const fixed::ConstantThresholds&,
                   const FixedFormat& difference, const DelayTable& delays) {
  StageList stages(delays);
  stages.add("compare", stages.carry(difference.width + 1) + stages.lut_delay_ns(1));
  return std::move(stages).unit("fixed_constant_decision");
}

/// The unit of a decision by thresholds of `threshold` bits. They take `root_ns` and then
/// `threshold_ns`.
Unit norm_decision_unit(double root_ns, double threshold_ns, int threshold,
                        const FixedFormat& difference, const DelayTable& delays) {
  StageList stages(delays);
  stages.add("root", root_ns);
  stages.add("threshold", threshold_ns);
  stages.add("compare", stages.carry(std::max(signed_bits(difference), threshold) + 1) +
                            stages.lut_delay_ns(1));
  return std::move(stages).unit("fixed_norm_decision");
}

Unit decision_unit(const FixedLane& lane, const fixed::NormThresholds& thresholds,
                   const FixedFormat& difference, const DelayTable& delays) {
  const int threshold = threshold_bits(lane, thresholds);
  const int root_bits = lane.nodes[thresholds.radius].format.width;
  const StageList stages(delays);
  const double root_ns =
      thresholds.radius_is_squared ? stages.lut_delay_ns(reduction_levels(root_bits)) : 0;
  return norm_decision_unit(root_ns, stages.carry(threshold), threshold, difference, delays);
}

/// The threshold is an operand, used as it is: the slope is 1 and there is no offset.
Unit decision_unit(const FixedLane&, const fixed::RunningThresholds& thresholds,
                   const FixedFormat& difference, const DelayTable& delays) {
  return norm_decision_unit(0, 0, threshold_bits(thresholds), difference, delays);
}

}  // namespace

int alignment_bits(const std::vector<FixedNode>& nodes, const FixedNode& node, int operand) {
  if (!aligns_operands(node.operation)) return 0;
  const int own = nodes[node.operands[operand]].format.unit_exponent;
  const int other = nodes[node.operands[1 - operand]].format.unit_exponent;
  return std::max(0, own - other);
}

int operand_bits(const std::vector<FixedNode>& nodes, const FixedNode& node, int operand) {
  return signed_bits(nodes[node.operands[operand]].format) + alignment_bits(nodes, node, operand);
}

Unit fixed_unit(const FixedLane& lane, const FixedNode& node, scene::Multipliers multipliers,
                const DelayTable& delays) {
  // Multipliers::memory has no table of the products of two operands, so products are logic.
  const bool of_logic = multipliers != scene::Multipliers::embedded;
  const auto bits = [&](int operand) { return operand_bits(lane.nodes, node, operand); };
  switch (node.operation) {
    case Operation::input: return operand_unit(lane, node, delays);
    case Operation::negate: return chain_unit("fixed_sum", "add", bits(0) + 1, delays);
    case Operation::add:
    case Operation::subtract:
      return chain_unit("fixed_sum", "add", std::max(bits(0), bits(1)) + 1, delays);
    case Operation::absolute: return chain_unit("fixed_absolute", "negate", bits(0), delays);
    case Operation::multiply:
      return of_logic ? logic_product_unit(LogicProduct::Kind::product, std::max(bits(0), bits(1)),
                                           delays)
                      : product_unit(bits(1), delays);
    case Operation::square:
      return of_logic ? logic_product_unit(LogicProduct::Kind::square, bits(0), delays)
                      : product_unit(bits(0), delays);
    case Operation::minimum:
    case Operation::maximum: return choice_unit(std::max(bits(0), bits(1)), delays);
    case Operation::square_root: return square_root_unit(node.format.width, delays);
    case Operation::convert:
      return fixed::is_floating_code(node) ? floating_code_unit(lane, node, delays)
                                           : common_cut_unit(node, delays);
    case Operation::constant:
    case Operation::look_up: return table_unit(node.words.address_bits(), delays);
    case Operation::divide:
    case Operation::function:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(!"an operation that fixed point has no unit for");
}

Unit multiplier_sum_unit(const DelayTable& delays) {
  StageList stages(delays);
  stages.add("add", delays.multiplier_add_ns);
  return std::move(stages).unit("fixed_sum");
}

/// Memories deeper than a block of 1024 words have a multiplexer behind them.
Unit memory_square_unit(const fixed::SquareTable& table, const DelayTable& delays) {
  constexpr int block_address_bits = 10;
  const int selected = shift_levels(std::max(0, table.address_bits - block_address_bits));
  StageList stages(delays);
  stages.add("magnitude", table.has_signed_address ? 0 : stages.carry(table.address_bits + 1));
  stages.add_registered("read", stages.lut_delay_ns(1));
  stages.add("output", delays.memory_ns + stages.lut_delay_ns(selected));
  return std::move(stages).unit(table.squares.size() == 2 ? "fixed_memory_squares"
                                                          : "fixed_memory_square");
}

Unit block_exponent_unit(const FixedLane& lane, const DelayTable& delays) {
  const int bits = lane.input_format.exponent_bits();
  const int levels = std::max(1, bits_for(static_cast<int>(fixed::inputs_read(lane).size()) - 1));
  StageList stages(delays);
  for (int level = 0; level < levels; ++level) {
    const int choose = level + 1 < levels ? 1 : 1 + reduction_levels(bits);
    stages.add("level " + std::to_string(level), stages.carry(bits) + stages.lut_delay_ns(choose));
  }
  return std::move(stages).unit("block_exponent");
}

Unit common_drop_unit(const FixedLane& lane, const DelayTable& delays) {
  const auto count = static_cast<int>(fixed::cut_in_common(lane).size());
  StageList stages(delays);
  stages.add("join", stages.lut_delay_ns(reduction_levels(2 * count)));
  stages.add("encode", stages.lut_delay_ns(count_levels(fixed::most_dropped_in_common(lane))));
  return std::move(stages).unit("fixed_common_drop");
}

Unit step_threshold_unit(const fixed::RunningThresholds& thresholds, const DelayTable& delays) {
  const auto count = static_cast<int>(thresholds.watched.size());
  const auto last = static_cast<int>(thresholds.of_steps.size()) - 1;
  StageList stages(delays);
  stages.add("join", stages.lut_delay_ns(reduction_levels(2 * count)));
  stages.add("encode", stages.lut_delay_ns(count_levels(last)));
  stages.add("select", stages.lut_delay_ns(1));
  return std::move(stages).unit("fixed_step_threshold");
}

/// A low bit does not matter if it and all below it are 0 in the least number within the limit and
/// 1 in the greatest. At least one bit and a sign stay.
int unchecked_bits(const std::vector<FixedNode>& nodes, const FixedNode& limit) {
  const FixedNode& whole = nodes[limit.operands[0]];
  auto bits = static_cast<mp_bitcnt_t>(std::max(0, signed_bits(whole.format) - 2));
  const auto in_units = [&](const mpq_class& end) {
    return mpz_class(floor_of(end / limit.format.unit()));
  };
  if (limit.value.low > whole.value.low) {
    bits = std::min(bits, mpz_scan1(in_units(limit.value.low).get_mpz_t(), 0));
  }
  if (limit.value.high < whole.value.high) {
    bits = std::min(bits, mpz_scan0(in_units(limit.value.high).get_mpz_t(), 0));
  }
  return static_cast<int>(bits);
}

Unit check_unit(const FixedLane& lane, const FixedNode& checked, const DelayTable& delays) {
  StageList stages(delays);
  const int bits = operand_bits(lane.nodes, checked, 0);
  if (fixed::is_reach(checked)) {
    const int compared = bits - signed_bits(checked.format) + 1;
    stages.add("compare", stages.lut_delay_ns(reduction_levels(compared)));
    return std::move(stages).unit("fixed_overflow");
  }
  stages.add("compare",
             stages.carry(bits - unchecked_bits(lane.nodes, checked)) + stages.lut_delay_ns(1));
  return std::move(stages).unit("fixed_range_check");
}

Unit fixed_decision_unit(const FixedLane& lane, const fixed::FixedPart& part,
                         const DelayTable& delays) {
  const FixedFormat& difference = lane.nodes[part.difference].format;
  return std::visit(
      [&](const auto& thresholds) { return decision_unit(lane, thresholds, difference, delays); },
      part.criterion);
}

int threshold_bits(const fixed::RunningThresholds& thresholds) {
  return digits_of(*std::max_element(thresholds.of_steps.begin(), thresholds.of_steps.end()));
}

int threshold_bits(const FixedLane& lane, const fixed::NormThresholds& thresholds) {
  const FixedFormat& format = lane.nodes[thresholds.radius].format;
  const mpz_class radius =
      thresholds.radius_is_squared ? shifted_left(1, (format.width + 1) / 2) : format.largest();
  const mpz_class above = shifted_left(radius, thresholds.shift_above) + thresholds.offset_above;
  const mpz_class below = shifted_left(radius, thresholds.shift_below);
  return digits_of(std::max(above, below));
}

}  // namespace mixcmp::datapath
