#include <fmt/core.h>
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "model/base/number/exact.hpp"
#include "model/base/number/verdict.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/judge/golden/enclosure.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "model/lane/error/error_analysis.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/hazard_judge.hpp"
#include "tests/support/lane_inputs.hpp"

/// Tests certified lanes of random graphs in random formats, on operands that are driven to where
/// the lane is only just certain. Every decided verdict must be the order of the real numbers.
namespace mixcmp::test::fuzz_test {
namespace {

using error::CertifiedOptions;
using error::Lane;
using golden::evaluate_lane;
using golden::LaneResult;
using golden::true_verdict;

using Random = std::mt19937_64;

int below(Random& random, int end) {
  return static_cast<int>(random() % static_cast<unsigned>(end));
}

template <class Values>
auto any_of(const Values& values, Random& random) {
  return values[static_cast<size_t>(below(random, static_cast<int>(values.size())))];
}

bool one_in(Random& random, int n) {
  return below(random, n) == 0;
}

/// Zeros, powers of two, numbers no binary format has, and some at the ends of small formats.
mpq_class random_constant(Random& random) {
  static const std::vector<mpq_class> values = {0,
                                                1,
                                                2,
                                                3,
                                                mpq_class(1, 2),
                                                mpq_class(1, 3),
                                                mpq_class(7, 10),
                                                mpq_class(31, 16),
                                                mpq_class(1, 64),
                                                mpq_class(1, 100),
                                                mpq_class(3, 500),
                                                48,
                                                1000,
                                                mpq_class(1000001, 1000000),
                                                mpq_class(1, 40000)};
  const mpq_class value = any_of(values, random);
  return one_in(random, 3) ? -value : value;
}

Operation random_operation(Random& random) {
  static constexpr std::array operations = {
      Operation::add,      Operation::add,     Operation::subtract, Operation::multiply,
      Operation::multiply, Operation::divide,  Operation::square,   Operation::square_root,
      Operation::minimum,  Operation::maximum, Operation::negate,   Operation::absolute};
  return any_of(operations, random);
}

/// A random graph. Leaves come first, then operations that mostly take one of the last nodes; f and
/// g are late nodes.
Graph random_graph(Random& random) {
  Graph graph;
  const int input_count = 1 + below(random, 3);
  std::vector<NodeId> nodes;
  for (int k = 0; k < input_count; ++k)
    nodes.push_back(graph.input(std::string(1, static_cast<char>('a' + k))));
  if (one_in(random, 2)) nodes.push_back(graph.constant(random_constant(random)));
  const auto any = [&] { return any_of(nodes, random); };
  const auto late = [&] { return one_in(random, 2) ? any() : nodes.back(); };
  const int operation_count = below(random, 8);
  for (int k = 0; k < operation_count; ++k) {
    const Operation operation = random_operation(random);
    nodes.push_back(arity(operation) == 1 ? graph.apply(operation, late())
                                          : graph.apply(operation, late(), any()));
  }
  graph.compare(late(), any());
  return graph;
}

FloatFormat random_reference(Random& random) {
  switch (below(random, 4)) {
    case 0: return format_of(4 + below(random, 3), 2 + below(random, 3));
    case 1: return format_of(5 + below(random, 8), 2 + below(random, 6));
    case 2: return format_of(11 + below(random, 43), 2 + below(random, 14));
    default: return format_of(4 + below(random, 110), 2 + below(random, 14));
  }
}

/// Whether every constant is finite in the format, and zero only if it is exactly zero, as in
/// scenes.
bool holds_constants(const Graph& graph, FloatFormat format) {
  for (const Node& node : graph.nodes()) {
    if (node.operation != Operation::constant) continue;
    const Bits bits = from_rational(format, node.value);
    if (format.is_infinite(bits) || (format.is_zero(bits) && node.value != 0)) return false;
  }
  return true;
}

Arithmetic random_reduced(Random& random, FloatFormat reference) {
  const int highest = std::min(reference.precision(), 52);
  const int lowest = std::min(4, highest);
  const int precision =
      lowest +
      below(random, one_in(random, 3) ? highest - lowest + 1 : std::min(4, highest - lowest + 1));
  const int exponent_bits = one_in(random, 2) ? reference.exponent_bits() : 2 + below(random, 14);
  return any_of(every_arithmetic(format_of(precision, exponent_bits)), random);
}

/// Computes the values of f and g if both are rational numbers.
class Rationals {
public:
  Rationals(const Graph& graph, FloatFormat format, const std::vector<Bits>& inputs) {
    for (const Node& node : graph.nodes()) {
      values_.push_back(value(node, format, inputs));
    }
    f_ = values_[static_cast<size_t>(graph.f())];
    g_ = values_[static_cast<size_t>(graph.g())];
  }

  std::optional<Verdict> verdict() const {
    if (!f_ || !g_) return std::nullopt;
    if (*f_ == *g_) return Verdict::equal;
    return *f_ < *g_ ? Verdict::less : Verdict::greater;
  }

private:
  std::optional<mpq_class> value(const Node& node, FloatFormat format,
                                 const std::vector<Bits>& inputs) const {
    if (node.operation == Operation::constant) return node.value;
    if (node.operation == Operation::input) {
      const Bits input = inputs[static_cast<size_t>(node.input)];
      if (format.is_nan(input) || format.is_infinite(input)) return std::nullopt;
      return to_rational(format, input);
    }
    for (int k = 0; k < arity(node.operation); ++k) {
      if (!values_[static_cast<size_t>(node.operands[static_cast<size_t>(k)])]) return std::nullopt;
    }
    const mpq_class& a = *values_[static_cast<size_t>(node.operands[0])];
    const mpq_class& b =
        arity(node.operation) == 1 ? a : *values_[static_cast<size_t>(node.operands[1])];
    switch (node.operation) {
      case Operation::negate: return -a;
      case Operation::absolute: return abs(a);
      case Operation::add: return a + b;
      case Operation::subtract: return a - b;
      case Operation::multiply: return a * b;
      case Operation::square: return a * a;
      case Operation::divide:
        if (b == 0) return std::nullopt;
        return a / b;
      case Operation::minimum: return std::min(a, b);
      case Operation::maximum: return std::max(a, b);
      case Operation::square_root: {
        if (a < 0 || !mpz_perfect_square_p(a.get_num_mpz_t()) ||
            !mpz_perfect_square_p(a.get_den_mpz_t()))
          return std::nullopt;
        return mpq_class(sqrt(a.get_num()), sqrt(a.get_den()));
      }
      case Operation::input:
      case Operation::constant:
      case Operation::convert:
      case Operation::function:
      case Operation::look_up:
      case Operation::fused_sum: break;
    }
    MIXCMP_CHECK(false);
  }

  std::vector<std::optional<mpq_class>> values_;
  std::optional<mpq_class> f_, g_;
};

/// A lane under attack.
struct Target {
  const Graph& graph;
  const Lane& lane;
  LaneInputs how;
};

std::string describe(const Target& target, const std::vector<Bits>& inputs) {
  const TypedGraph& lane = target.lane.graph;
  const auto text = [&](NodeId id) { return to_text(lane.nodes, lane.input_names, id, 200); };
  std::string description = fmt::format(
      "{} against {}, reference {}, lane {} {} {}, inputs {}, {}, operands checked {}:",
      text(lane.f()), text(lane.g()), lane.input_format.name(), lane.arithmetic.format.name(),
      to_string(lane.arithmetic.rounding), to_string(lane.arithmetic.subnormals),
      to_string(target.how), describe_criterion(target.lane), target.lane.checks.size());
  for (const Bits input : inputs) {
    description += fmt::format(" 0x{}", to_hex(input, lane.input_format.width()));
  }
  return description;
}

/// The distance |key(f) - key(g)| of two encodings.
Bits distance(FloatFormat format, Bits f, Bits g) {
  const Bits f_magnitude = format.magnitude(f), g_magnitude = format.magnitude(g);
  if (format.sign(f) != format.sign(g)) return f_magnitude + g_magnitude;
  return f_magnitude > g_magnitude ? f_magnitude - g_magnitude : g_magnitude - f_magnitude;
}

/// The number of steps by which a decided lane is more certain than necessary.
Bits margin(const Lane& lane, const std::vector<Bits>& inputs) {
  const auto values = golden::evaluate(lane.graph, inputs);
  const FloatFormat format = lane.graph.arithmetic.format;
  if (const auto* relative = std::get_if<error::UlpDistanceCriterion>(&lane.criterion())) {
    return distance(format, values[lane.graph.f()].bits, values[lane.graph.g()].bits) -
           relative->guard_ulp;
  }
  const auto& absolute = std::get<error::AbsoluteBoundCriterion>(lane.criterion());
  const Bits bound = golden::evaluate_bound(absolute.bound, lane.graph, values).back();
  const int padding = format.precision() - absolute.bound.format.precision;
  const Bits limit = (bound << padding) + absolute.guard_ulp;
  return format.magnitude(values[absolute.difference].bits) - limit - 1;
}

Bits random_operand(FloatFormat format, Random& random) {
  if (one_in(random, 6)) return any_of(special_encodings(format), random);
  if (one_in(random, 2)) return random_encoding(format, random);
  return random_encoding_near(format, format.pack(false, format.bias(), 0), random);
}

Bits moved(FloatFormat format, Bits operand, Random& random) {
  const Bits step = Bits{1} << below(random, format.width() - 1);
  switch (below(random, 8)) {
    case 0: return operand ^ format.zero(true);
    case 1: return random_operand(format, random);
    case 2:
    case 3:
    case 4: return (operand + step) & low_mask(format.width());
    default: return (operand - step) & low_mask(format.width());
  }
}

/// Compares one decision with the order of the real numbers, and their enclosure with rational
/// arithmetic.
void hold(const Target& target, const std::vector<Bits>& inputs, Verdict decided) {
  const FloatFormat format = target.lane.graph.input_format;
  const auto truth = true_verdict(target.graph, format, inputs);
  if (!truth) return;
  EXPECT_EQ(to_string(decided), to_string(truth)) << describe(target, inputs);
  if (const auto rational = Rationals(target.graph, format, inputs).verdict()) {
    EXPECT_EQ(to_string(*rational), to_string(truth)) << describe(target, inputs);
  }
}

/// Walks from random operands towards the smallest distance that is still decided. Returns how
/// many decisions it saw at the guard itself.
int attack(const Target& target, Random& random) {
  constexpr int steps = 60;
  const FloatFormat reference = target.lane.graph.input_format;
  std::vector<Bits> inputs(target.graph.inputs().size());
  for (Bits& input : inputs) input = random_operand(reference, random);
  if (one_in(random, 4)) inputs.front() = inputs.back();
  Bits smallest = ~Bits{0};
  int at_the_guard = 0;
  for (int step = 0; step < steps && !testing::Test::HasFailure(); ++step) {
    std::vector<Bits> next = inputs;
    Bits& operand = next[static_cast<size_t>(below(random, static_cast<int>(next.size())))];
    if (step > 0) operand = moved(reference, operand, random);
    EXPECT_EQ(broken_promise(target.lane, next), "") << describe(target, next);
    const LaneResult result = evaluate_lane(target.lane, next);
    if (!result.decided || margin(target.lane, next) > smallest) continue;
    smallest = margin(target.lane, next);
    inputs = next;
    at_the_guard += smallest == 0 ? 1 : 0;
    hold(target, inputs, result.verdict);
  }
  return at_the_guard;
}

class RandomGraphs : public testing::TestWithParam<int> {};

/// A range for some inputs; the operands under attack break it often.
std::optional<Range> random_range(Random& random) {
  static const std::vector<std::optional<Range>> ranges = {
      std::nullopt, std::nullopt,  Range{0, 100}, Range{mpq_class(1, 3), 5},
      Range{-4, 4}, Range{-9, -1}, Range{0, 1}};
  return any_of(ranges, random);
}

CertifiedOptions random_options(Random& random, std::size_t inputs) {
  static const std::vector<BoundKind> kinds = {BoundKind::relative, BoundKind::running,
                                               BoundKind::running, BoundKind::constant};
  CertifiedOptions options{.kind = any_of(kinds, random), .bound_digits = 1 + below(random, 8)};
  for (size_t i = 0; i < inputs; ++i) options.ranges.push_back(random_range(random));
  return options;
}

TEST_P(RandomGraphs, AreDecidedAsTheRealNumbersAre) {
  Random random(static_cast<unsigned>(GetParam()));
  std::map<BoundKind, int> lanes, at_the_guard;
  for (int k = 0; k < MIXCMP_FUZZED_GRAPHS && !HasFailure(); ++k) {
    const Graph graph = random_graph(random);
    const FloatFormat reference = random_reference(random);
    if (!holds_constants(graph, reference)) continue;
    const CertifiedOptions options = random_options(random, graph.inputs().size());
    const Arithmetic reduced = random_reduced(random, reference);
    const LaneInputs how = any_inputs(reduced.format.precision(), reference.precision(), random);
    const auto lane = certified_lane(lane_graph(graph, reference, reduced, how), options);
    if (!lane.ok()) continue;
    ++lanes[*options.kind];
    for (int walk = 0; walk < 4; ++walk) {
      at_the_guard[*options.kind] += attack({graph, *lane, how}, random);
    }
  }
  for (const auto& [kind, count] : lanes) {
    fmt::print("{}: {} lanes, {} decisions at the guard\n", to_string(kind), count,
               at_the_guard[kind]);
  }
  EXPECT_GT(lanes[BoundKind::relative], MIXCMP_FUZZED_GRAPHS / 20);
  EXPECT_GT(lanes[BoundKind::running], MIXCMP_FUZZED_GRAPHS / 4);
  EXPECT_GT(lanes[BoundKind::constant], MIXCMP_FUZZED_GRAPHS / 100);
  for (const auto& [kind, count] : lanes) EXPECT_GT(at_the_guard[kind], count / 8);
}

/// A graph with two or three parts over the nodes of one random graph.
Graph random_parts(Random& random) {
  Graph graph = random_graph(random);
  const auto any = [&] { return below(random, static_cast<int>(graph.nodes().size())); };
  std::vector<Sides> parts;
  for (int k = 2 + below(random, 2); k > 0; --k) parts.push_back({any(), any()});
  graph.compare(std::move(parts), one_in(random, 2) ? Combination::all : Combination::any);
  return graph;
}

TEST_P(RandomGraphs, OfSeveralPartsAreDecidedAsTheRealNumbersAre) {
  Random random(static_cast<unsigned>(GetParam()));
  int lanes = 0, decided = 0;
  for (int k = 0; k < MIXCMP_FUZZED_GRAPHS / 4 && !HasFailure(); ++k) {
    const Graph graph = random_parts(random);
    const FloatFormat format = random_reference(random);
    if (!holds_constants(graph, format)) continue;
    CertifiedOptions options = random_options(random, graph.inputs().size());
    if (one_in(random, 2)) options.kind.reset();
    const Arithmetic reduced = random_reduced(random, format);
    const LaneInputs how = any_inputs(reduced.format.precision(), format.precision(), random);
    const auto lane = certified_lane(lane_graph(graph, format, reduced, how), options);
    if (!lane.ok()) continue;
    ++lanes;
    for (int n = 0; n < 20; ++n) {
      std::vector<Bits> inputs(graph.inputs().size());
      for (Bits& input : inputs) input = random_operand(format, random);
      if (one_in(random, 3)) inputs.front() = moved(format, inputs.back(), random);
      const auto result = evaluate_lane(*lane, inputs);
      const auto truth = true_verdict(graph, format, inputs);
      if (!result.decided || !truth) continue;
      ++decided;
      EXPECT_EQ(to_string(result.verdict), to_string(truth)) << describe_criterion(*lane);
    }
  }
  EXPECT_GT(lanes, MIXCMP_FUZZED_GRAPHS / 20);
  EXPECT_GT(decided, 2 * lanes);
}

/// A comparison in which some operands are solved for: each is put between the value that the lane
/// computes for a node and that node's true value, where a bound that is too small decides wrongly.
struct Aimed {
  Graph graph;
  struct Shot {
    int input;    ///< the operand that is solved for
    NodeId node;  ///< the node that it is brought close to
  };
  std::vector<Shot> shots;  ///< in order: a node needs no operand that is solved for later
};

/// A node of the graph, or a product of two or three of them, which is inexact.
NodeId random_factor(Graph& graph, Random& random) {
  const auto any = [&] { return below(random, static_cast<int>(graph.nodes().size())); };
  NodeId node = any();
  for (int more = below(random, 3); more > 0; --more) {
    node = graph.apply(Operation::multiply, node, any());
  }
  return node;
}

/// A reader of u - y, which y brings to zero: the difference itself, its square or root, a product
/// or a quotient.
NodeId random_reader(Graph& graph, NodeId difference, Random& random) {
  const NodeId other = random_factor(graph, random);
  switch (below(random, 6)) {
    case 0: return difference;
    case 1: return graph.apply(Operation::square, difference);
    case 2: return graph.apply(Operation::square_root, difference);
    case 3: return graph.apply(Operation::divide, other, difference);
    case 4: return graph.apply(Operation::divide, difference, other);
    default: return graph.apply(Operation::multiply, difference, other);
  }
}

/// Compares a side with z. The side is u, a sum or difference of u and a factor, or a reader of u -
/// y.
Aimed random_aim(Random& random) {
  Aimed aimed{.graph = random_graph(random), .shots = {}};
  Graph& graph = aimed.graph;
  const auto last = [&] { return static_cast<int>(graph.inputs().size()) - 1; };
  const NodeId u = one_in(random, 2) ? graph.f() : random_factor(graph, random);
  NodeId side = u;
  switch (below(random, 5)) {
    case 0: break;
    case 1: side = graph.apply(Operation::add, u, random_factor(graph, random)); break;
    case 2: side = graph.apply(Operation::subtract, u, random_factor(graph, random)); break;
    default: {
      const NodeId y = graph.input("y");
      aimed.shots.push_back({last(), u});
      side = random_reader(graph, graph.apply(Operation::subtract, u, y), random);
    }
  }
  const NodeId z = graph.input("z");
  aimed.shots.push_back({last(), side});
  graph.compare(side, z);
  return aimed;
}

/// The middle of an interval of 200 digits around the true value of a node; none if the node has no
/// value.
std::optional<mpq_class> true_value(const Graph& graph, NodeId node, FloatFormat format,
                                    const std::vector<Bits>& inputs) {
  golden::Enclosure enclosure(graph, Sides{node, node}, 200);
  if (enclosure.compute(format, inputs) != golden::Knowledge::enclosed) return std::nullopt;
  mpq_class value;
  mpfr_get_q(value.get_mpq_t(), enclosure.f().low.get());
  return value;
}

/// The value that a lane computes for a node of the graph; none if the value is no number.
std::optional<mpq_class> computed_value(const Graph& graph, NodeId node, FloatFormat reference,
                                        const Arithmetic& reduced, LaneInputs how,
                                        const std::vector<Bits>& inputs) {
  Graph alone = graph;
  alone.compare(node, node);
  const TypedGraph lane = lane_graph(alone, reference, reduced, how);
  const Bits bits = golden::evaluate(lane, inputs)[lane.f()].bits;
  const FloatFormat format = lane.nodes[lane.f()].format;
  if (format.is_nan(bits) || format.is_infinite(bits)) return std::nullopt;
  return to_rational(format, bits);
}

/// Puts the solved operands where the lane is most likely to be wrong. False if a node that they
/// are put beside has no value.
bool aim(const Aimed& aimed, FloatFormat reference, const Arithmetic& reduced, LaneInputs how,
         std::vector<Bits>& inputs, Random& random) {
  for (const Aimed::Shot& shot : aimed.shots) {
    const auto truth = true_value(aimed.graph, shot.node, reference, inputs);
    const auto computed = computed_value(aimed.graph, shot.node, reference, reduced, how, inputs);
    Bits& operand = inputs[static_cast<size_t>(shot.input)];
    if (!computed) return false;
    // A root of a number below zero has no true value: any operand shows that it was decided.
    if (!truth) {
      operand = random_operand(reference, random);
      continue;
    }
    const mpq_class part(below(random, 9), 8);
    operand = from_rational(reference, mpq_class(*computed + (*truth - *computed) * part));
    const int steps = one_in(random, 2) ? 0 : below(random, 5) - 2;
    operand = (operand + static_cast<Bits>(steps)) & low_mask(reference.width());
  }
  return true;
}

/// Half of the lanes have the digits of the reference, whose operands they then take unrounded.
Arithmetic aimed_arithmetic(Random& random, FloatFormat reference) {
  if (one_in(random, 2)) return random_reduced(random, reference);
  const FloatFormat format =
      format_of(std::min(reference.precision(), 52), reference.exponent_bits());
  return any_of(every_arithmetic(format), random);
}

TEST_P(RandomGraphs, AreDecidedAsTheRealNumbersAreBetweenComputedAndTrueValues) {
  Random random(static_cast<unsigned>(GetParam()));
  int lanes = 0, decided = 0;
  for (int k = 0; k < MIXCMP_FUZZED_GRAPHS && !HasFailure(); ++k) {
    const Aimed aimed = random_aim(random);
    const FloatFormat reference = format_of(4 + below(random, 6), 4 + below(random, 3));
    if (!holds_constants(aimed.graph, reference)) continue;
    const CertifiedOptions options = random_options(random, aimed.graph.inputs().size());
    const Arithmetic reduced = aimed_arithmetic(random, reference);
    const LaneInputs how = any_inputs(reduced.format.precision(), reference.precision(), random);
    const auto lane = certified_lane(lane_graph(aimed.graph, reference, reduced, how), options);
    if (!lane.ok()) continue;
    ++lanes;
    for (int shot = 0; shot < 24 && !HasFailure(); ++shot) {
      std::vector<Bits> inputs(aimed.graph.inputs().size());
      for (Bits& input : inputs) input = random_operand(reference, random);
      if (!aim(aimed, reference, reduced, how, inputs, random)) continue;
      const LaneResult result = evaluate_lane(*lane, inputs);
      if (!result.decided) continue;
      ++decided;
      hold({aimed.graph, *lane, how}, inputs, result.verdict);
    }
  }
  EXPECT_GT(lanes, MIXCMP_FUZZED_GRAPHS / 8);
  EXPECT_GT(decided, lanes / 4);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomGraphs, testing::Range(1, 5));

}  // namespace
}  // namespace mixcmp::test::fuzz_test
