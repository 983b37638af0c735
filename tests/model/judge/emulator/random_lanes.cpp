#include "tests/model/judge/emulator/random_lanes.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "model/judge/golden/arithmetic.hpp"
#include "tests/support/float_samples.hpp"

namespace mixcmp::test {

using error::BoundOperation;
using error::Lane;
using error::RangeCheck;
using error::RequiredSign;

int below(Random& random, int end) {
  return static_cast<int>(random() % static_cast<unsigned>(end));
}

namespace {

template <class Values>
auto any_of(const Values& values, Random& random) {
  return values[static_cast<std::size_t>(below(random, static_cast<int>(std::size(values))))];
}

mpq_class power_of_two(int exponent) {
  mpq_class one = 1;
  return exponent < 0 ? mpq_class(one >> -exponent) : mpq_class(one << exponent);
}

mpq_class random_magnitude(Random& random) {
  const int exponent = below(random, 8) == 0 ? below(random, 400) - 200 : below(random, 20) - 10;
  return power_of_two(exponent) * mpq_class(1 + below(random, 30), 1 + below(random, 9));
}

Operation random_operation(Random& random) {
  static constexpr std::array operations = {
      Operation::add,      Operation::add,     Operation::subtract, Operation::subtract,
      Operation::multiply, Operation::square,  Operation::divide,   Operation::square_root,
      Operation::minimum,  Operation::maximum, Operation::negate,   Operation::absolute};
  return any_of(operations, random);
}

RequiredSign random_sign(Random& random) {
  static constexpr std::array signs = {RequiredSign::any, RequiredSign::nonnegative,
                                       RequiredSign::nonpositive};
  return any_of(signs, random);
}

RangeCheck random_check(const TypedGraph& graph, Random& random) {
  const FloatFormat format = graph.input_format;
  RangeCheck check{.input = below(random, graph.input_count), .sign = random_sign(random)};
  if (below(random, 3) == 0) return check;
  check.leading_bits = 1 + below(random, std::min(format.width() - 1, format.exponent_bits() + 4));
  const int rest = format.width() - 1 - check.leading_bits;
  const Bits one = random_encoding(format, random), other = random_encoding(format, random);
  const auto [least, greatest] = std::minmax({format.magnitude(one), format.magnitude(other)});
  check.least = least >> rest;
  check.greatest = greatest >> rest;
  return check;
}

Bits random_guard(FloatFormat format, Random& random) {
  switch (below(random, 4)) {
    case 0: return static_cast<Bits>(below(random, 3));
    case 1: return Bits{1} << below(random, format.width());
    case 2: return low_mask(format.width());
    default: return static_cast<Bits>(below(random, 100));
  }
}

NodeId lane_node(const TypedGraph& graph, Random& random) {
  for (;;) {
    const NodeId id = below(random, static_cast<int>(graph.nodes.size()));
    if (graph.nodes[id].format == graph.arithmetic.format) return id;
  }
}

error::BoundNode random_leaf(const TypedGraph& graph, Random& random) {
  static constexpr std::array leaves = {BoundOperation::magnitude, BoundOperation::binade,
                                        BoundOperation::reciprocal};
  if (below(random, 4) == 0) {
    // Constants are so large that products of two are beyond the format, and beyond double.
    const int bias = graph.arithmetic.format.bias();
    const mpq_class scale =
        power_of_two(below(random, 3) == 0 ? below(random, 2 * bias) - bias : 0);
    const mpq_class value = below(random, 6) == 0 ? mpq_class(0) : scale * random_magnitude(random);
    return {.operation = BoundOperation::constant, .constant = value};
  }
  return {.operation = any_of(leaves, random), .value = lane_node(graph, random), .constant = {}};
}

error::BoundNode random_bound_operation(int node_count, Random& random) {
  static constexpr std::array operations = {BoundOperation::add, BoundOperation::add,
                                            BoundOperation::multiply, BoundOperation::maximum};
  return {.operation = any_of(operations, random),
          .operands = {node_count - 1, below(random, node_count)},
          .constant = {}};
}

}  // namespace

Graph random_graph(Random& random) {
  Graph graph;
  std::vector<NodeId> nodes;
  const int input_count = 1 + below(random, 4);
  for (int k = 0; k < input_count; ++k) {
    nodes.push_back(graph.input(std::string(1, static_cast<char>('a' + k))));
  }
  if (below(random, 2) == 0) {
    const mpq_class value = random_magnitude(random);
    nodes.push_back(graph.constant(below(random, 2) == 0 ? value : mpq_class(-value)));
  }
  const auto any = [&] { return any_of(nodes, random); };
  const auto late = [&] { return below(random, 2) == 0 ? any() : nodes.back(); };
  for (int k = below(random, 9); k > 0; --k) {
    const Operation operation = random_operation(random);
    nodes.push_back(arity(operation) == 1 ? graph.apply(operation, late())
                                          : graph.apply(operation, late(), any()));
  }
  graph.compare(late(), any());
  return graph;
}

Graph random_graph_of_parts(Random& random) {
  Graph graph = random_graph(random);
  std::vector<Sides> parts;
  const auto any = [&] { return below(random, static_cast<int>(graph.nodes().size())); };
  for (int k = 2 + below(random, 3); k > 0; --k) parts.push_back({any(), any()});
  graph.compare(std::move(parts), below(random, 2) == 0 ? Combination::all : Combination::any);
  return graph;
}

LaneInputs random_inputs(Random& random) {
  switch (below(random, 3)) {
    case 0: return LaneInputs::exact;
    case 1: return LaneInputs::rounded;
    default: return LaneInputs::of_digits(2 + below(random, 52));
  }
}

FloatFormat random_reference(Random& random) {
  static constexpr std::array exponent_bits = {8, 8, 8, 11, 11, 5, 9, 10, 4, 2};
  const int digits = below(random, 2) == 0 ? 53 : 4 + below(random, 50);
  return format_of(digits, any_of(exponent_bits, random));
}

Arithmetic random_reduced(FloatFormat reference, Random& random) {
  const int digits = 2 + below(random, 52);
  const int exponent_bits =
      below(random, 4) == 0 ? 2 + below(random, 10) : reference.exponent_bits();
  return any_of(every_arithmetic(format_of(digits, exponent_bits)), random);
}

error::AbsoluteBoundCriterion random_absolute_bound(TypedGraph& graph, Random& random) {
  const FloatFormat format = graph.arithmetic.format;
  graph.nodes.push_back({.operation = Operation::subtract,
                         .operands = {graph.f(), graph.g()},
                         .operand_format = format,
                         .format = format,
                         .value = {}});
  const int most_digits = std::min(format.precision(), 52);
  const int digits =
      1 + below(random, below(random, 4) == 0 ? most_digits : std::min(most_digits, 8));
  error::AbsoluteBoundCriterion criterion = {
      .difference = static_cast<NodeId>(graph.nodes.size()) - 1,
      .bound = {.format = {digits, format.exponent_bits()}, .nodes = {}},
      .conditions = {}};
  if (below(random, 2) == 0) criterion.guard_ulp = random_guard(format, random);
  auto& nodes = criterion.bound.nodes;
  for (int k = 1 + below(random, 4); k > 0; --k) nodes.push_back(random_leaf(graph, random));
  for (int k = below(random, 6); k > 0; --k) {
    nodes.push_back(random_bound_operation(static_cast<int>(nodes.size()), random));
  }
  for (int k = below(random, 3); k > 0; --k) {
    criterion.conditions.push_back(
        {below(random, static_cast<int>(nodes.size())), lane_node(graph, random)});
  }
  return criterion;
}

Lane random_lane(TypedGraph graph, Random& random) {
  error::Criterion criterion = error::UlpDistanceCriterion{0, false};
  switch (below(random, 4)) {
    case 0:
      criterion =
          error::IntervalCriterion{lane_node(graph, random), lane_node(graph, random), 0, 0};
      break;
    case 1: {
      const Bits guard = random_guard(graph.arithmetic.format, random);
      criterion = error::UlpDistanceCriterion{guard, false};
      break;
    }
    default: criterion = random_absolute_bound(graph, random);
  }
  std::vector<error::RangeCheck> checks;
  for (int k = below(random, 3); k > 0; --k) {
    checks.push_back(random_check(graph, random));
  }
  return one_part_lane(std::move(graph), std::move(criterion), std::move(checks));
}

Operands random_operands(int input_count, FloatFormat format, std::size_t count, Random& random) {
  Operands operands(static_cast<std::size_t>(input_count));
  const Bits one = format.pack(false, format.bias(), 0);
  for (std::size_t k = 0; k < count; ++k) {
    // Half of the comparisons have nothing special, so that whole blocks are in range.
    const bool plain = k < count / 2;
    const Bits near = plain ? one : random_encoding(format, random);
    for (std::vector<Bits>& column : operands) {
      const Bits bits = random_encoding_near(format, near, random);
      const int exponent = format.bias() + below(random, 3) - 1;
      column.push_back(plain ? format.pack(below(random, 2) == 0, exponent, format.fraction(bits))
                             : bits);
    }
    if (below(random, 8) == 0) operands.back()[k] = operands.front()[k];
    for (std::vector<Bits>& column : operands) {  // doubles tell no NaN from another
      if (format.is_nan(column[k])) column[k] = format.quiet_nan();
    }
  }
  return operands;
}

}  // namespace mixcmp::test
