#include "model/error/profiled_error.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "model/data/permutation.hpp"
#include "model/error/error_analysis.hpp"
#include "model/error/hazards.hpp"
#include "model/error/largest_relative_error.hpp"
#include "model/golden/arithmetic.hpp"
#include "model/golden/evaluate.hpp"
#include "model/golden/true_values.hpp"

namespace mixcmp::model {
namespace {

/// The smallest number of the arithmetic that is not below `value` >= 0.
Bits round_up(const Arithmetic& arithmetic, const mpq_class& value) {
  const FloatFormat format = arithmetic.format;
  Bits bits = golden::from_rational(format, value);
  if (!format.is_infinite(bits) && golden::to_rational(format, bits) < value) ++bits;
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

  NodeId constant(const mpq_class& value) {
    const FloatFormat format = graph_.arithmetic.format;
    return append({.operation = Operation::constant,
                   .operand_format = format,
                   .format = format,
                   .constant = round_up(graph_.arithmetic, value),
                   .value = value});
  }

  /// |computed| * relative_error.
  NodeId error(NodeId computed, bool nonnegative, const mpq_class& relative_error) {
    const NodeId magnitude = nonnegative ? computed : operation(Operation::absolute, computed);
    return operation(Operation::multiply, magnitude, constant(relative_error));
  }

private:
  NodeId append(TypedNode node) {
    graph_.nodes.push_back(std::move(node));
    return static_cast<NodeId>(graph_.nodes.size()) - 1;
  }

  TypedGraph& graph_;
};

}  // namespace

ProfiledError profile_error(const Graph& graph, const TypedGraph& lane, const Comparisons& data,
                            std::uint64_t sample_count, std::uint64_t seed) {
  const Permutation permutation(data.size(), seed);
  const std::uint64_t count = std::min(sample_count, data.size());
  golden::TrueValues truth(graph, {graph.f(), graph.g()});
  LargestRelativeError f(lane.arithmetic.format), g(lane.arithmetic.format);
  std::vector<Bits> operands(data.input_count());
  ProfiledError profiled;
  for (std::uint64_t index = 0; index < count; ++index) {
    data.fetch(permutation(index), operands);
    if (!truth.compute(lane.input_format, operands)) continue;
    const std::vector<golden::Rounded> computed = golden::evaluate(lane, operands);
    f.measure(computed[lane.f].bits, truth.f());
    g.measure(computed[lane.g].bits, truth.g());
    ++profiled.comparisons;
  }
  profiled.f = f.value();
  profiled.g = g.value();
  return profiled;
}

Lane profiled_lane(TypedGraph graph, const mpq_class& relative_error_f,
                   const mpq_class& relative_error_g) {
  // The analysis is given no ranges, for a profiled lane checks no sign bits.
  const std::vector<bool> no_ranges(graph.input_count, false);
  const std::vector<NodeBound> known = analyse_errors(graph, no_ranges).nodes;
  Appender append(graph);
  const NodeId difference = append.operation(Operation::subtract, graph.f, graph.g);
  const NodeId error_f = append.error(graph.f, known[graph.f].nonnegative, relative_error_f);
  const NodeId error_g = append.error(graph.g, known[graph.g].nonnegative, relative_error_g);
  const NodeId error = append.operation(Operation::add, error_f, error_g);
  const IntervalDecision decision{
      .minimum = append.operation(Operation::subtract, difference, error),
      .maximum = append.operation(Operation::add, difference, error),
      .relative_error_f = relative_error_f,
      .relative_error_g = relative_error_g};
  std::vector<Hazards> hazards = structural_hazards(graph);
  return {.graph = std::move(graph), .decision = decision, .hazards = std::move(hazards)};
}

}  // namespace mixcmp::model
