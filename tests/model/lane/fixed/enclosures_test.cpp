#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "model/base/number/dyadic.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "model/lane/fixed/root_error.hpp"
#include "tests/model/lane/fixed/lanes.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// Tests the values and errors of nodes against the real numbers that they stand for.
namespace mixcmp::test::enclosures_test {
namespace {

using fixed::FixedLane;
using fixed::FixedNode;

using Values = std::vector<std::optional<mpz_class>>;

/// The factor of all common cuts: the largest power of two up to 1 that makes all their operands
/// fit W bits of magnitude.
mpq_class common_factor(const FixedLane& lane, const Values& values) {
  mpq_class factor = 1;
  const mpz_class beyond = mpz_class(1) << lane.format.bits;
  for (const NodeId id : fixed::cut_in_common(lane)) {
    while (floor_of(*values[id] * factor) >= beyond || floor_of(*values[id] * factor) < -beyond) {
      factor /= 2;
    }
  }
  return factor;
}

/// The real number that each node stands for: its operation on those of its operands.
std::vector<mpq_class> true_values(const FixedLane& lane, const std::vector<mpq_class>& inputs,
                                   const mpq_class& factor) {
  std::vector<mpq_class> values;
  for (const FixedNode& node : lane.nodes) {
    const mpq_class a = arity(node.operation) > 0 ? values[node.operands[0]] : 0;
    const mpq_class b = arity(node.operation) > 1 ? values[node.operands[1]] : 0;
    switch (node.operation) {
      case Operation::input: values.push_back(inputs[node.input]); break;
      case Operation::constant: values.push_back(node.value.low - node.error.low); break;
      case Operation::convert:
        values.push_back(fixed::is_common_cut(node) ? mpq_class(a * factor) : a);
        break;
      case Operation::negate: values.push_back(-a); break;
      case Operation::absolute: values.push_back(abs(a)); break;
      case Operation::add: values.push_back(a + b); break;
      case Operation::subtract: values.push_back(a - b); break;
      case Operation::multiply: values.push_back(a * b); break;
      case Operation::square: values.push_back(a * a); break;
      case Operation::minimum: values.push_back(std::min(a, b)); break;
      case Operation::maximum: values.push_back(std::max(a, b)); break;
      case Operation::square_root: values.push_back(root_of(a, 200)); break;
      default: ADD_FAILURE() << to_string(node.operation);
    }
  }
  return values;
}

/// Checks each node's enclosures of its value and of its error.
void expect_enclosed(const FixedLane& lane, const std::vector<mpq_class>& inputs) {
  std::vector<Bits> encodings;
  for (const mpq_class& input : inputs) {
    encodings.push_back(golden::from_rational(lane.input_format, input));
  }
  const auto values = golden::evaluate(lane, encodings);
  const std::vector<mpq_class> truth = true_values(lane, inputs, common_factor(lane, values));
  for (std::size_t id = 0; id < values.size(); ++id) {
    const FixedNode& node = lane.nodes[id];
    ASSERT_TRUE(values[id]) << id;
    const mpq_class value = *values[id] * node.format.unit(), error = value - truth[id];
    EXPECT_TRUE(node.value.low <= value && value <= node.value.high) << id << ": " << value;
    EXPECT_TRUE(node.error.low <= error && error <= node.error.high) << id << ": " << error;
    EXPECT_TRUE(node.format.smallest() <= *values[id] && *values[id] <= node.format.largest())
        << id << ": " << *values[id] << " in " << node.format.name();
  }
}

/// Every unit's multiple below 4 in magnitude, and the numbers just above and just below it.
std::vector<mpq_class> around_units(int bits, bool is_signed) {
  const mpq_class unit = mpq_class(4) / (1 << bits), little = unit / 1024;
  std::vector<mpq_class> values;
  for (mpq_class value = is_signed ? mpq_class(unit - 4) : mpq_class(0); value < 4; value += unit) {
    for (const mpq_class& near : {value, mpq_class(value + little), mpq_class(value - little)}) {
      if (near >= 0 || is_signed) values.push_back(near);
    }
  }
  if (is_signed) values.push_back(little - 4);
  values.push_back(4 - little);
  return values;
}

TEST(Enclosures, OfCommonCutsHoldWhereTheyAreTight) {
  constexpr std::array<std::pair<const char*, const char*>, 7> comparisons = {
      {{"(1.5 - a)^2", "b^2"},
       {"(a - b)^2", "(a + b)^2"},
       {"-a * (b - 2)", "b^2"},
       {"abs(a - b) * min(a, -b)", "-3 * a * b"},
       {"max(a, b / 4) * (a + b)", "(b + 3.5)^2"},
       {"(2 - abs(a))^2", "0.7 * (a - b)^2"},
       {"sqrt((a - b)^2 + a^2)", "abs(b)"}}};
  for (const auto& [f, g] : comparisons) {
    const Graph graph = graph_of(f, g);
    for (const auto& [bits, guard_digits] : {std::pair{1, 2}, {2, 1}, {3, 2}}) {
      const FixedPoint format = {.bits = bits, .guard_digits = guard_digits};
      for (const bool is_signed : {false, true}) {
        const auto lane = fixed::fixed_lane(
            graph, format_of(53, 8),
            {.format = format, .ranges = {graph.inputs().size(), Range{is_signed ? -3 : 0, 3}}});
        ASSERT_TRUE(lane.ok()) << lane.error().to_string();
        const std::vector<mpq_class> tried = around_units(bits + guard_digits, is_signed);
        for (const mpq_class& first : tried) {
          for (const mpq_class& second : tried) {
            expect_enclosed(*lane, {first, second});
            if (testing::Test::HasFailure()) FAIL() << f << ", " << format.name();
          }
        }
      }
    }
  }
}

TEST(Enclosures, HoldWhereTheyAreTight) {
  for (const char* f : {"a * b", "a^2", "abs(a)", "-a", "min(a, b)", "max(a, b)", "abs(a - b)",
                        "abs(a - 3)", "min(a, b / 4)", "max(3 * a, b)", "a * b + 0.3", "a^4",
                        "(a * b)^3", "a^2 * b^2 - b", "sqrt(abs(a))", "sqrt(abs(a) + 1)",
                        "sqrt(a^2 + b^2)", "sqrt((3 * a)^2 + (b / 64)^2)", "sqrt(a^4 + abs(b))"}) {
    const Graph graph = graph_of(f, "b");
    for (const int bits : {1, 2, 3, 5}) {
      for (const bool is_signed : {false, true}) {
        const FixedLane lane = lane_of(graph, bits, {is_signed ? -3 : 0, 3});
        const std::vector<mpq_class> tried = around_units(bits, is_signed);
        for (const mpq_class& a : tried) {
          for (const mpq_class& b : tried) {
            std::vector<mpq_class> inputs = {a, b};
            if (graph.inputs().front() == "b") std::swap(inputs[0], inputs[1]);
            expect_enclosed(lane, inputs);
            if (testing::Test::HasFailure()) FAIL() << f << ", q" << bits;
          }
        }
      }
    }
  }
}

/// Operands lie a hair below their next unit. The norm is off by all of its error, and by more if
/// the sum drops bits of b's square.
TEST(Enclosures, OfRootsHoldWhereSumsDropBits) {
  constexpr int bits = 3;
  const FixedLane lane = lane_of(graph_of("sqrt(a^2 + (b / 1024)^2)", "b"), bits, {0, 3});
  const auto root = std::find_if(lane.nodes.begin(), lane.nodes.end(), [](const FixedNode& node) {
    return node.operation == Operation::square_root;
  });
  ASSERT_NE(root, lane.nodes.end());
  const auto radicand = static_cast<std::size_t>(root->operands[0]);
  const FixedNode& sum = lane.nodes[radicand];
  ASSERT_GT(sum.dropped_bits, 0);
  const Range error = fixed::root_error(lane.nodes, root->operands[0]);
  const mpq_class unit = mpq_class(4) / (1 << bits), hair = unit * power_of_two(-40);
  for (mpq_class a = unit - hair; a < 4; a += unit) {
    for (mpq_class b = unit - hair; b < 4; b += unit) {
      std::vector<Bits> encodings;
      for (const mpq_class& input : {a, b}) {
        encodings.push_back(golden::from_rational(lane.input_format, input));
      }
      const auto values = golden::evaluate(lane, encodings);
      const mpq_class truth = true_values(lane, {a, b}, 1)[radicand];
      const mpq_class off =
          root_of(*values[radicand] * sum.format.unit(), 200) - root_of(truth, 200);
      EXPECT_TRUE(error.low <= off && off <= error.high) << a << " " << b << ": " << off.get_d();
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::enclosures_test
