#include "model/lane/error/exponent_range.hpp"

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/expression/typed_graph.hpp"
#include "model/lane/error/hazards.hpp"
#include "model/lane/error/range_analysis.hpp"

namespace mixcmp::error {
namespace {

/// Whether `value` * 2^(-2P) is a normal number of the format.
bool reaches_below(FloatFormat format, mpq_class value) {
  mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(),
               2UL * static_cast<unsigned long>(format.precision()));
  return value >= to_rational(format, format.smallest_normal(false));
}

bool part_serves(const TypedGraph& lane, const std::vector<std::optional<Range>>& ranges) {
  const auto checked = checked_ranges(lane, full_range_checks(lane, ranges));
  const std::vector<NodeRange> nodes = analyse_ranges(lane, checked);
  mpq_class largest = 0;
  for (std::size_t id = 0; id < nodes.size(); ++id) {
    if (nodes[id].may(Event::overflow) || nodes[id].may(Event::division_by_zero)) return false;
    if (!(lane.nodes[id].format == lane.arithmetic.format)) continue;
    largest = std::max<mpq_class>(
        largest, std::max<mpq_class>(abs(nodes[id].value.low), abs(nodes[id].value.high)));
  }
  return reaches_below(lane.arithmetic.format, largest);
}

bool serves(const TypedGraph& lane, const std::vector<std::optional<Range>>& ranges) {
  for (std::size_t k = 0; k < lane.parts.size(); ++k) {
    if (!part_serves(part_of(lane, k).graph, ranges)) return false;
  }
  return true;
}

}  // namespace

int lane_exponent_bits(const Graph& graph, FloatFormat reference, const Arithmetic& arithmetic,
                       LaneInputs inputs, const std::vector<std::optional<Range>>& ranges) {
  const bool all_ranges = std::all_of(ranges.begin(), ranges.end(),
                                      [](const auto& range) { return range.has_value(); });
  if (!all_ranges) return reference.exponent_bits();
  constexpr int fewest = 4;
  for (int bits = fewest; bits < reference.exponent_bits(); ++bits) {
    Arithmetic narrow = arithmetic;
    narrow.format = FloatFormat::make(arithmetic.format.precision(), bits).value();
    if (serves(lane_graph(graph, reference, narrow, inputs), ranges)) return bits;
  }
  return reference.exponent_bits();
}

}  // namespace mixcmp::error
