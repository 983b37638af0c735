#include "generator/hardware/datapath/units.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "generator/hardware/datapath/fused_sum.hpp"
#include "generator/hardware/datapath/stage_list.hpp"
#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/lane/error/hazards.hpp"

namespace mixcmp::datapath {
namespace {

using error::BoundOperation;
using scene::Multipliers;

int bias_difference(FloatFormat result, FloatFormat operands) {
  return result.bias() - operands.bias();
}

enum class Normalisation { by_one_place, unlimited, limited_by_room };

/// The stages "count" to "normalise by fours" of fp_add. A sum that only grows moves up by one
/// place if its first bit is 0, so it needs neither a count nor the shift by fours.
void add_normalisation(StageList& stages, FloatFormat operands, Normalisation normalisation) {
  const bool counts = normalisation != Normalisation::by_one_place;
  const double exponent = stages.carry(operands.exponent_bits() + 2);
  const int amount_bits = bits_for(operands.precision() + 2);
  stages.add("count", counts ? stages.lut_delay_ns(count_levels(operands.precision() + 2)) : 0);
  stages.add("limit", normalisation == Normalisation::limited_by_room
                          ? exponent + stages.lut_delay_ns(1)
                          : 0);
  const double by_fours = counts ? stages.lut_delay_ns(shift_levels(amount_bits - 2)) : 0;
  stages.add("normalise by fours", std::max(by_fours, exponent));
}

Unit add_unit(FloatFormat operands, FloatFormat result, Subnormals subnormals,
              const error::Hazards& hazards, const DelayTable& delays) {
  // Without underflow there are no subnormals, as in the template.
  const Subnormals kept = hazards.underflow ? subnormals : Subnormals::flush;
  const bool gradual = kept == Subnormals::gradual;
  const bool grows =
      !hazards.cancellation && (!gradual || result.exponent_bits() == operands.exponent_bits());
  const int aligned = std::max(operands.precision(), result.precision() + 1) + 1;
  StageList stages(delays);
  stages.add_aligned_operands(
      operands, aligned, kept,
      hazards.cancellation ? StageList::Order::by_magnitude : StageList::Order::by_exponent);
  stages.add_wide_sum("sum", 0, aligned + 3);
  Normalisation normalisation = gradual ? Normalisation::limited_by_room : Normalisation::unlimited;
  if (grows) normalisation = Normalisation::by_one_place;
  add_normalisation(stages, operands, normalisation);
  // fp_round moves by the remaining places. If fp_round denormalises, fp_add moves by them instead,
  // in front of it.
  const bool denormalises = gradual && result.exponent_bits() < operands.exponent_bits();
  const double last_places = stages.lut_delay_ns(grows || stages.selects_in_sums() ? 1 : 2);
  stages.add("normalise", denormalises ? last_places : 0);
  stages.add_round(result, denormalises, 0, denormalises ? 0 : last_places);
  return with_sum_selects(std::move(stages).unit("fp_add"), delays);
}

/// Tells whether the square of every subnormal operand is less than half the smallest result.
bool squares_vanish(FloatFormat operands, FloatFormat result) {
  return 2 * operands.bias() > result.bias() + result.precision();
}

Unit multiply_unit_in_form(LogicProduct::Form form, LogicProduct::Kind kind, FloatFormat operands,
                           FloatFormat result, Subnormals subnormals, Multipliers multipliers,
                           const DelayTable& delays) {
  const int dropped_bits = 2 * operands.precision() - result.precision() - 2;
  StageList stages(delays);
  const bool flushes = kind == LogicProduct::Kind::square && squares_vanish(operands, result);
  stages.add_operand(operands, flushes ? Subnormals::flush : subnormals);
  stages.add_product(operands.precision(), kind, multipliers, form);
  stages.add_select_round(result, subnormals,
                          stages.lut_delay_ns(reduction_levels(std::max(dropped_bits, 1))));
  Unit unit =
      std::move(stages).unit(kind == LogicProduct::Kind::square ? "fp_square" : "fp_multiply");
  unit.multipliers = multipliers;
  unit.multiplier = delays.multiplier_size;
  unit.product_form = form;
  return with_sum_selects(std::move(unit), delays);
}

Unit multiply_unit(LogicProduct::Kind kind, FloatFormat operands, FloatFormat result,
                   Subnormals subnormals, Multipliers multipliers, const DelayTable& delays) {
  return unit_of_product(
      kind, operands.precision(), multipliers, delays, [&](LogicProduct::Form form) {
        return multiply_unit_in_form(form, kind, operands, result, subnormals, multipliers, delays);
      });
}

Unit divide_unit(FloatFormat operands, FloatFormat result, Subnormals subnormals,
                 const DelayTable& delays) {
  StageList stages(delays);
  stages.add_operand(operands, subnormals);
  for (int digit = 0; digit < result.precision() + 2; ++digit) {
    stages.add("digit " + std::to_string(digit), stages.carry(operands.precision() + 2));
  }
  stages.add_select_round(result, subnormals,
                          stages.lut_delay_ns(1 + reduction_levels(operands.precision())));
  return with_sum_selects(std::move(stages).unit("fp_divide"), delays);
}

Unit square_root_unit(FloatFormat operands, FloatFormat result, Subnormals subnormals,
                      const DelayTable& delays) {
  StageList stages(delays);
  stages.add_operand(operands, subnormals);
  for (int digit = 1; digit <= result.precision(); ++digit) {
    stages.add("digit " + std::to_string(digit), stages.carry(digit + 3));
  }
  stages.add("select", stages.lut_delay_ns(1 + reduction_levels(result.precision() + 2)));
  const bool denormalises = subnormals == Subnormals::gradual &&
                            operands.bias() + operands.precision() > 2 * result.bias();
  stages.add_round(result, denormalises, 0);
  return std::move(stages).unit("fp_square_root");
}

Unit convert_unit(FloatFormat operands, FloatFormat result, Subnormals subnormals,
                  const DelayTable& delays) {
  StageList stages(delays);
  stages.add_operand(operands, subnormals);
  const bool denormalises = subnormals == Subnormals::gradual &&
                            bias_difference(result, operands) < operands.precision() - 1;
  stages.add_round(result, denormalises, operands.precision() - result.precision() - 2);
  return std::move(stages).unit("fp_convert");
}

/// The unit that multiplies by a power of two. It adds to the exponent, and rounds only if digits
/// are dropped.
Unit scale_unit(FloatFormat operands, FloatFormat result, Subnormals subnormals, int scale,
                const DelayTable& delays) {
  StageList stages(delays);
  stages.add_operand(operands, subnormals);
  const int offset = bias_difference(result, operands) + scale;
  const bool denormalises = subnormals == Subnormals::gradual && offset < operands.precision() - 1;
  if (denormalises || operands.precision() > result.precision()) {
    stages.add_round(result, denormalises, operands.precision() - result.precision() - 2);
  } else {
    const int exponent_bits = std::max(operands.exponent_bits(), result.exponent_bits());
    stages.add("denormalise", stages.carry(exponent_bits + 3));
    stages.add("round", stages.lut_delay_ns(1));
    stages.add("round, upper half", 0);
    stages.add("pack", stages.lut_delay_ns(1 + reduction_levels(result.exponent_bits()) + 1));
  }
  return std::move(stages).unit("fp_convert");
}

Unit minimum_maximum_unit(FloatFormat format, const DelayTable& delays) {
  StageList stages(delays);
  stages.add("compare", stages.carry(format.width() - 1) + stages.lut_delay_ns(1));
  stages.add("select", stages.lut_delay_ns(2));
  return std::move(stages).unit("fp_minimum_maximum");
}

Unit bound_add_unit(BoundFormat bound, const DelayTable& delays) {
  const int shift = shift_levels(bits_for(bound.precision - 1));
  StageList stages(delays);
  stages.add("align", stages.carry(bound.exponent_bits + 1) + stages.lut_delay_ns(2 + shift));
  stages.add("sum", stages.carry(bound.precision + 2) + stages.carry(bound.exponent_bits) +
                        stages.lut_delay_ns(1));
  return std::move(stages).unit("bound_add");
}

/// The product of the significands is precision - 1 rows of additions.
Unit bound_multiply_unit(BoundFormat bound, const DelayTable& delays) {
  StageList stages(delays);
  const double product = (bound.precision - 1) * stages.carry(bound.precision + 1);
  stages.add("multiply", std::max(product, stages.carry(bound.exponent_bits + 3)));
  stages.add("round", stages.lut_delay_ns(1 + reduction_levels(bound.precision)) +
                          stages.carry(bound.width() + 3) + stages.lut_delay_ns(2));
  return std::move(stages).unit("bound_multiply");
}

Unit bound_magnitude_unit(FloatFormat value, BoundFormat bound, const DelayTable& delays) {
  StageList stages(delays);
  stages.add("reduce", stages.lut_delay_ns(1 + reduction_levels(value.width() - bound.width())));
  stages.add("round", stages.carry(bound.width()));
  return std::move(stages).unit("bound_magnitude");
}

/// A unit of a single stage.
Unit single_stage_unit(std::string module, std::string stage, double delay_ns) {
  return {.module = std::move(module), .stages = {{std::move(stage), delay_ns}}};
}

bool multiplies_by_zero(const TypedGraph& graph, const TypedNode& node) {
  if (node.operation != Operation::multiply) return false;
  return std::any_of(node.operands.begin(), node.operands.end(), [&](NodeId id) {
    const TypedNode& factor = graph.nodes[static_cast<std::size_t>(id)];
    return factor.operation == Operation::constant && factor.format.is_zero(factor.constant);
  });
}

/// Gives a product with zero the delay of the logic that synthesis leaves: the sign, and the test
/// whether the other factor is a number.
void leave_special_values(Unit& unit, FloatFormat operands, const DelayTable& delays) {
  for (Stage& stage : unit.stages) stage = {.name = stage.name, .delay_ns = 0};
  unit.stages.front().delay_ns =
      StageList(delays).lut_delay_ns(1 + reduction_levels(operands.width()));
}

}  // namespace

Unit widening_unit(const OperandFormat& from, FloatFormat to, const DelayTable& delays) {
  const auto [read, scale] = from.scaled_float();
  StageList stages(delays);
  stages.add_operand(read, Subnormals::gradual);
  const bool denormalises = bias_difference(to, read) + scale < read.precision() - 1;
  const int moved = denormalises ? 1 + shift_levels(bits_for(to.precision() + 2)) : 0;
  stages.add("denormalise", stages.carry(to.exponent_bits() + 2) + stages.lut_delay_ns(moved));
  stages.add("round", 0);
  stages.add("round, upper half", 0);
  stages.add("pack", stages.lut_delay_ns(1));
  const double nan_ns = stages.lut_delay_ns(reduction_levels(from.width() - 1));
  const double absolute_ns = stages.carry(from.width());
  Unit unit = std::move(stages).unit("fp_convert");
  double& first_ns = unit.stages.front().delay_ns;
  if (const FixedFormat* const fixed = from.fixed()) {
    if (fixed->is_signed) first_ns += absolute_ns;
  } else if (!from.floating()->has_infinities()) {
    first_ns += nan_ns;
  }
  return unit;
}

std::optional<Scaling> scaling_of(const TypedGraph& graph, const TypedNode& node) {
  if (node.operation != Operation::multiply) return std::nullopt;
  for (int k = 0; k < 2; ++k) {
    const TypedNode& factor = graph.nodes[static_cast<std::size_t>(node.operands[k])];
    if (factor.operation != Operation::constant) continue;
    const FloatFormat format = factor.format;
    const bool is_flushed =
        graph.arithmetic.subnormals == Subnormals::flush && format.is_subnormal(factor.constant);
    if (is_flushed || format.biased_exponent(factor.constant) == format.max_biased_exponent()) {
      continue;
    }
    const mpq_class encoded = to_rational(format, factor.constant);
    const mpq_class size = abs(encoded);
    if (encoded == 0 || !is_power_of_two(size)) continue;
    const auto exponent = static_cast<int>(floor_log2(size));
    if (std::abs(exponent) > format.max_biased_exponent()) continue;  // SCALE has no more bits
    return Scaling{.operand = node.operands[1 - k], .exponent = exponent, .negated = encoded < 0};
  }
  return std::nullopt;
}

bool has_unit(const TypedNode& node) {
  return error::has_unit(node.operation) && !node.is_sign_of_sum();
}

Unit unit_for(const TypedGraph& graph, const TypedNode& node, const error::Hazards& hazards,
              Multipliers multipliers, const DelayTable& delays) {
  const Subnormals subnormals = graph.arithmetic.subnormals;
  if (const auto scaling = scaling_of(graph, node)) {
    return scale_unit(node.operand_format, node.format, subnormals, scaling->exponent, delays);
  }
  if (node.operation == Operation::fused_sum) {
    return fused_sum_unit(graph, node, SquaredSums::apart, multipliers, delays);
  }
  Unit unit = unit_for(node, subnormals, hazards, multipliers, delays);
  if (multiplies_by_zero(graph, node)) leave_special_values(unit, node.operand_format, delays);
  return unit;
}

Unit unit_for(const TypedNode& node, Subnormals subnormals, const error::Hazards& hazards,
              Multipliers multipliers, const DelayTable& delays) {
  const FloatFormat operands = node.operand_format;
  const FloatFormat result = node.format;
  switch (node.operation) {
    case Operation::add:
    case Operation::subtract: return add_unit(operands, result, subnormals, hazards, delays);
    case Operation::multiply:
      return multiply_unit(LogicProduct::Kind::product, operands, result, subnormals, multipliers,
                           delays);
    case Operation::square:
      return multiply_unit(LogicProduct::Kind::square, operands, result, subnormals, multipliers,
                           delays);
    case Operation::divide: return divide_unit(operands, result, subnormals, delays);
    case Operation::square_root: return square_root_unit(operands, result, subnormals, delays);
    case Operation::convert: return convert_unit(operands, result, subnormals, delays);
    case Operation::minimum:
    case Operation::maximum: return minimum_maximum_unit(operands, delays);
    case Operation::input:
    case Operation::constant:
    case Operation::negate:
    case Operation::absolute:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(!"only wires, or a sum whose unit depends on the graph");
}

std::optional<Unit> serial_square_unit(const TypedNode& square, Subnormals subnormals,
                                       const DelayTable& delays) {
  const FloatFormat operands = square.operand_format;
  const FloatFormat result = square.format;
  const SerialSquare steps(operands.precision());
  if (delays.has_wide_tables() || !steps.fits(result.precision())) return std::nullopt;
  StageList stages(delays);
  stages.add_operand(operands, squares_vanish(operands, result) ? Subnormals::flush : subnormals);
  stages.add_serial_square(steps);
  stages.add_select_round(result, subnormals, stages.lut_delay_ns(2));
  Unit unit = std::move(stages).unit("fp_serial_square");
  unit.initiation_interval = steps.cycles();
  return with_sum_selects(std::move(unit), delays);
}

double logic_square_tables(FloatFormat operands) {
  const double bits = operands.precision();
  return 11.4 * bits + 0.76 * bits * bits;
}

double serial_square_tables(FloatFormat operands) {
  return 80 + 15.8 * operands.precision();
}

Unit compare_unit(FloatFormat format, const DelayTable& delays) {
  StageList stages(delays);
  stages.add("compare", stages.carry(format.width() - 1));
  stages.add("decide", stages.lut_delay_ns(2));
  return std::move(stages).unit("fp_compare");
}

Unit ulp_distance_unit(FloatFormat format, const DelayTable& delays) {
  StageList stages(delays);
  stages.add("distance", stages.carry(format.width() + 2));
  stages.add("decide", stages.lut_delay_ns(reduction_levels(format.width()) + 2));
  return std::move(stages).unit("fp_ulp_distance");
}

Unit interval_decision_unit(FloatFormat format, const DelayTable& delays) {
  StageList stages(delays);
  stages.add("decide", stages.lut_delay_ns(reduction_levels(format.width()) + 1));
  return std::move(stages).unit("fp_interval_decision");
}

Unit combination_unit(std::size_t parts, const DelayTable& delays) {
  StageList stages(delays);
  stages.add("combine", stages.lut_delay_ns(reduction_levels(3 * static_cast<int>(parts)) + 1));
  return std::move(stages).unit("verdict_combination");
}

Unit bound_unit(BoundOperation operation, FloatFormat value, BoundFormat bound,
                const DelayTable& delays) {
  const StageList stages(delays);
  switch (operation) {
    case BoundOperation::magnitude: return bound_magnitude_unit(value, bound, delays);
    case BoundOperation::binade:
      return single_stage_unit("bound_binade", "binade",
                               stages.lut_delay_ns(1 + reduction_levels(value.width() - 1)));
    case BoundOperation::reciprocal:
      return single_stage_unit("bound_reciprocal", "negate",
                               stages.lut_delay_ns(1 + reduction_levels(value.exponent_bits())) +
                                   stages.carry(value.exponent_bits()));
    case BoundOperation::add: return bound_add_unit(bound, delays);
    case BoundOperation::multiply: return bound_multiply_unit(bound, delays);
    case BoundOperation::maximum:
      return single_stage_unit("bound_maximum", "select",
                               stages.carry(bound.width()) + stages.lut_delay_ns(1));
    case BoundOperation::constant: break;
  }
  MIXCMP_CHECK(!"a constant bound has no unit");
}

Unit bound_at_most_unit(BoundFormat bound, const DelayTable& delays) {
  return single_stage_unit("bound_at_most", "compare", StageList(delays).carry(bound.width()));
}

Unit bound_decision_unit(FloatFormat lane, BoundFormat bound, const DelayTable& delays) {
  StageList stages(delays);
  const double rest = stages.lut_delay_ns(1 + reduction_levels(lane.precision() - bound.precision));
  stages.add("limit", std::max(rest, stages.carry(bound.width() + 2)));
  stages.add("compare", stages.carry(bound.width() + 4) + stages.lut_delay_ns(1));
  return std::move(stages).unit("bound_decision");
}

Unit range_check_unit(const error::RangeCheck& check, const DelayTable& delays) {
  const int levels = 2 + reduction_levels(check.leading_bits);
  return single_stage_unit("fp_range_check", "check", StageList(delays).lut_delay_ns(levels));
}

}  // namespace mixcmp::datapath
