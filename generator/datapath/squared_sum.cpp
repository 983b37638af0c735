#include "generator/datapath/squared_sum.hpp"

#include <algorithm>
#include <utility>

#include "generator/datapath/stage_list.hpp"

namespace mixcmp::datapath {
namespace {

/// The fewest digits that fp_squared_sum takes.
constexpr int least_precision = 3;

/// Counts operations and sides of comparisons that read `node`.
std::ptrdiff_t readers_of(const TypedGraph& graph, NodeId node) {
  std::ptrdiff_t readers = 0;
  for (const TypedNode& reader : graph.nodes) {
    const std::vector<NodeId> operands = operands_of(reader);
    readers += std::count(operands.begin(), operands.end(), node);
  }
  for (const Sides& part : graph.parts) readers += (part.f == node) + (part.g == node);
  return readers;
}

/// The search for leading zeros and for the shift, which runs beside the first product stages.
StageList exponent_stages(FloatFormat format, int product_stages, const DelayTable& delays) {
  StageList stages(delays);
  const int exponent_bits = std::max(format.exponent_bits(), bits_for(format.precision() + 3)) + 2;
  stages.add("count", std::max(stages.lut_delay_ns(count_levels(format.precision())),
                               stages.carry(exponent_bits)));
  stages.add("limit", stages.carry(exponent_bits) + stages.lut_delay_ns(2));
  for (int k = 2; k < product_stages; ++k) stages.add("", 0);
  return stages;
}

}  // namespace

std::optional<NodeId> squared_sum_of(const TypedGraph& graph, NodeId square) {
  const TypedNode& node = graph.nodes[static_cast<std::size_t>(square)];
  if (node.operation != Operation::square) return std::nullopt;
  const NodeId operand = node.operands[0];
  const TypedNode& sum = graph.nodes[static_cast<std::size_t>(operand)];
  const bool adds = sum.operation == Operation::add || sum.operation == Operation::subtract;
  const bool one_format = sum.operand_format == sum.format && sum.format == node.format;
  const bool fits = node.format.precision() >= least_precision &&
                    graph.arithmetic.rounding == Rounding::nearest_even;
  if (!adds || !one_format || !fits || readers_of(graph, operand) != 1) return std::nullopt;
  return operand;
}

Unit squared_sum_unit(FloatFormat format, Subnormals subnormals, scene::Multipliers multipliers,
                      const DelayTable& delays) {
  const int precision = format.precision();
  StageList stages(delays);
  stages.add_aligned_operands(format, precision + 2, subnormals, StageList::Order::by_exponent);
  // The larger operand is selected while the smaller one is still being aligned.
  const double selection = stages.lut_delay_ns(1);
  stages.add_overlapping("sum", selection + stages.carry(precision + 4), selection);
  stages.add("select", stages.lut_delay_ns(3));
  stages.add("round sum", stages.carry(precision + 1) + stages.lut_delay_ns(1));
  StageList product(delays);
  const bool has_digit_stage =
      product.add_fastest_product(precision, LogicProduct::Kind::square, multipliers);
  const StageList beside = exponent_stages(format, product.count(), delays);
  stages.add_slowest({std::move(product), beside});
  const int margin = subnormals == Subnormals::gradual ? (precision + 4) / 2 : 0;
  const int step_bits = bits_for(margin + precision - 1);
  stages.add("normalise by eights",
             stages.lut_delay_ns(shift_levels(std::max(step_bits - 3, 1)) + 1));
  stages.add("normalise by twos", stages.lut_delay_ns(shift_levels(2)));
  stages.add_last_selection(format);
  Unit unit = std::move(stages).unit("fp_squared_sum");
  unit.multipliers = multipliers;
  unit.multiplier = delays.multiplier_size;
  unit.has_digit_stage = has_digit_stage;
  return unit;
}

}  // namespace mixcmp::datapath
