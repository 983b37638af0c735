#include "model/lane/error/profiled_lane.hpp"

#include <utility>

#include "model/base/number/exact.hpp"
#include "model/lane/error/error_analysis.hpp"
#include "model/lane/error/hazards.hpp"

namespace mixcmp::error {
namespace {

/// The smallest number of the arithmetic that is at least `value` >= 0.
Bits round_up(const Arithmetic& arithmetic, const mpq_class& value) {
  const FloatFormat format = arithmetic.format;
  const Bits bits = from_rational_up(format, value);
  const bool flushed = arithmetic.subnormals == Subnormals::flush && format.is_subnormal(bits);
  return flushed ? format.smallest_normal(false) : bits;
}

/// Appends nodes in the lane's format.
class Appender {
public:
  explicit Appender(TypedGraph& graph) : graph_(graph) {}

  NodeId operation(Operation operation, NodeId first, NodeId second = -1) {
    const FloatFormat format = graph_.arithmetic.format;
    return append({.operation = operation,
                   .operands = {first, second},
                   .operand_format = format,
                   .format = format,
                   .value = {}});
  }

  /// The smallest number of the format that is >= `value` >= 0; infinity if `value` is too large.
  NodeId constant_above(const mpq_class& value) {
    const FloatFormat format = graph_.arithmetic.format;
    const Bits rounded = round_up(graph_.arithmetic, value);
    const mpq_class overflowing = 2 * to_rational(format, format.largest_finite(false));
    return append(
        {.operation = Operation::constant,
         .operand_format = format,
         .format = format,
         .constant = rounded,
         .value = format.is_infinite(rounded) ? overflowing : to_rational(format, rounded)});
  }

  /// |computed| * relative_error.
  NodeId error(NodeId computed, bool nonnegative, const mpq_class& relative_error) {
    const NodeId magnitude = nonnegative ? computed : operation(Operation::absolute, computed);
    return operation(Operation::multiply, magnitude, constant_above(relative_error));
  }

private:
  NodeId append(TypedNode node) {
    graph_.nodes.push_back(std::move(node));
    return static_cast<NodeId>(graph_.nodes.size()) - 1;
  }

  TypedGraph& graph_;
};

Lane profiled_part(TypedGraph graph, const mpq_class& relative_error_f,
                   const mpq_class& relative_error_g) {
  // The analysis gets no ranges, since a profiled lane checks no sign bits.
  const std::vector<bool> no_ranges(graph.input_count, false);
  const std::vector<NodeBound> known = analyse_errors(graph, no_ranges).nodes;
  Appender append(graph);
  const NodeId difference = append.operation(Operation::subtract, graph.f(), graph.g());
  const NodeId error_f = append.error(graph.f(), known[graph.f()].nonnegative, relative_error_f);
  const NodeId error_g = append.error(graph.g(), known[graph.g()].nonnegative, relative_error_g);
  const NodeId error = append.operation(Operation::add, error_f, error_g);
  const IntervalCriterion criterion{
      .minimum = append.operation(Operation::subtract, difference, error),
      .maximum = append.operation(Operation::add, difference, error),
      .relative_error_f = relative_error_f,
      .relative_error_g = relative_error_g};
  std::vector<Hazards> hazards = structural_hazards(graph);
  Lane lane = one_part_lane(std::move(graph), criterion);
  lane.hazards = std::move(hazards);
  return lane;
}

}  // namespace

Lane profiled_lane(const TypedGraph& graph, const mpq_class& relative_error_f,
                   const mpq_class& relative_error_g) {
  const auto make_part = [&](const TypedGraph& part) -> Result<Lane> {
    return profiled_part(part, relative_error_f, relative_error_g);
  };
  return lane_of_parts(graph, make_part).value();
}

}  // namespace mixcmp::error
