#include "generator/hardware/datapath/squared_sum.hpp"

#include <algorithm>
#include <utility>

namespace mixcmp::datapath {
namespace {

/// The fewest digits that fp_squared_sum takes.
constexpr int least_precision = 3;

bool is_side(const TypedGraph& graph, NodeId node) {
  return std::any_of(graph.parts.begin(), graph.parts.end(),
                     [&](const Sides& part) { return part.f == node || part.g == node; });
}

/// How often an operation, or a term of a fused sum, reads `node`; a square reads it once.
std::ptrdiff_t reads_of(const TypedNode& reader, NodeId node) {
  const auto operands = reader.operands.begin();
  std::ptrdiff_t reads = std::count(operands, operands + arity(reader.operation), node);
  for (const FusedTerm& term : reader.terms) {
    reads += (term.a == node) + (term.is_product() && !term.is_square() && term.b == node);
  }
  return reads;
}

/// How often an operation, or a term of a fused sum, is the square of `node`.
std::ptrdiff_t squares_of(const TypedNode& reader, NodeId node) {
  const bool is_square = reader.operation == Operation::square && reader.operands[0] == node;
  return std::count_if(reader.terms.begin(), reader.terms.end(),
                       [&](const FusedTerm& term) { return term.is_square() && term.a == node; }) +
         is_square;
}

/// The stages of the search for leading zeros and for the shift. It runs beside the first stages of
/// the product behind its factors.
StageList exponent_stages(FloatFormat format, int product_stages, const DelayTable& delays) {
  StageList stages(delays);
  const int exponent_bits = std::max(format.exponent_bits(), bits_for(format.precision() + 3)) + 2;
  // fp_leading_zeros has its cut behind counts of eight bits.
  const int first_levels = count_levels(7);
  stages.add("count eights",
             std::max(stages.lut_delay_ns(first_levels), stages.carry(exponent_bits)));
  stages.add("count",
             stages.lut_delay_ns(std::max(count_levels(format.precision()) - first_levels, 1)));
  stages.add("limit", stages.carry(exponent_bits) + stages.lut_delay_ns(2));
  for (int k = stages.count(); k < product_stages; ++k) stages.add("", 0);
  return stages;
}

}  // namespace

bool is_only_squared(const TypedGraph& graph, NodeId sum) {
  const TypedNode& node = graph.nodes[static_cast<std::size_t>(sum)];
  const bool adds = node.operation == Operation::add || node.operation == Operation::subtract;
  const bool fits = node.operand_format == node.format &&
                    node.format.precision() >= least_precision &&
                    graph.arithmetic.rounding == Rounding::nearest_even;
  if (!adds || !fits || is_side(graph, sum)) return false;
  std::ptrdiff_t squares = 0;
  std::ptrdiff_t reads = 0;
  for (const TypedNode& reader : graph.nodes) {
    reads += reads_of(reader, sum);
    if (reader.format == node.format) squares += squares_of(reader, sum);
  }
  return reads == 1 && squares == 1;
}

std::optional<NodeId> squared_sum_of(const TypedGraph& graph, NodeId square) {
  const TypedNode& node = graph.nodes[static_cast<std::size_t>(square)];
  if (node.operation != Operation::square) return std::nullopt;
  const NodeId sum = node.operands[0];
  return is_only_squared(graph, sum) ? std::optional(sum) : std::nullopt;
}

void add_unnormalised_sum(StageList& stages, FloatFormat format, Subnormals subnormals) {
  const int precision = format.precision();
  stages.add_aligned_operands(format, precision + 2, subnormals, StageList::Order::by_exponent);
  // In front of the sum, with SUM_SELECTS = 2, the larger operand is selected while the smaller one
  // is still being aligned. Otherwise the smaller one moves by its last place.
  const double selection = stages.lut_delay_ns(1);
  stages.add_wide_sum("sum", selection, precision + 4, selection);
  stages.add("select", stages.lut_delay_ns(stages.selects_in_sums() ? 2 : 3));
  stages.add_wide_sum("round sum", stages.lut_delay_ns(1), precision + 1);
}

namespace {

Unit squared_sum_unit_in_form(LogicProduct::Form form, FloatFormat format, Subnormals subnormals,
                              scene::Multipliers multipliers, const DelayTable& delays) {
  const int precision = format.precision();
  StageList stages(delays);
  add_unnormalised_sum(stages, format, subnormals);
  StageList product(delays);
  product.add_product(precision, LogicProduct::Kind::square, multipliers, form);
  const StageList beside = exponent_stages(format, product.count(), delays);
  stages.add_side_by_side({std::move(product), beside});
  const int margin = subnormals == Subnormals::gradual ? (precision + 4) / 2 : 0;
  const int step_bits = bits_for(margin + precision - 1);
  stages.add("normalise by eights",
             stages.lut_delay_ns(shift_levels(std::max(step_bits - 3, 1)) + 1));
  stages.add("normalise by twos", stages.lut_delay_ns(shift_levels(2)));
  stages.add_last_selection(format);
  Unit unit = std::move(stages).unit("fp_squared_sum");
  unit.multipliers = multipliers;
  unit.multiplier = delays.multiplier_size;
  unit.product_form = form;
  return with_sum_selects(std::move(unit), delays);
}

}  // namespace

Unit squared_sum_unit(FloatFormat format, Subnormals subnormals, scene::Multipliers multipliers,
                      const DelayTable& delays) {
  return unit_of_product(LogicProduct::Kind::square, format.precision(), multipliers, delays,
                         [&](LogicProduct::Form form) {
                           return squared_sum_unit_in_form(form, format, subnormals, multipliers,
                                                           delays);
                         });
}

}  // namespace mixcmp::datapath
