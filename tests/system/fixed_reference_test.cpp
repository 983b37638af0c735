#include <gtest/gtest.h>

#include "model/base/number/exact.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/simulated_system.hpp"

/// Systems whose references compute in fixed point, on every pair of operands of a small format:
/// those out of range, infinities and NaNs make a verdict unordered.
namespace mixcmp::test::fixed_reference_test {
namespace {

using Parts = std::vector<std::pair<std::string, std::string>>;

struct Case {
  const char* name;
  Parts parts;
  int lane_bits;
  Combination combination = Combination::all;
  verilator_tb::SimulatorKind simulator = verilator_tb::SimulatorKind::verilator;
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.name;
}

/// Narrower than the numbers of the format, which go up to 14.
const Range range = {-3, 5};
const FloatFormat arriving = format_of(3, 3), widened = format_of(11, 5);

fixed::FixedLane lane_of(const Graph& graph, int bits, bool is_reference) {
  return fixed::fixed_lane(graph, widened,
                           {.format = {.bits = bits},
                            .bound = BoundKind::constant,
                            .ranges = std::vector<std::optional<Range>>(2, range),
                            .operand_formats = {OperandFormat(arriving), OperandFormat(arriving)},
                            .is_reference = is_reference})
      .value();
}

Graph graph_of_case(const Case& c) {
  Graph graph = graph_of(c.parts, c.combination);
  for (int input = 0; input < 2; ++input) graph.arrives_in(input, OperandFormat(arriving));
  return graph;
}

design::Design design_of(const Case& c) {
  const Graph graph = graph_of_case(c);
  return {.name = "fixed_reference",
          .inputs = graph.inputs(),
          .lanes = {{.lane = lane_of(graph, c.lane_bits, false)}},
          .reference = reference_graph(graph, {widened}),
          .references = {{.count = 1}},
          .system = {},
          .operand_formats = {OperandFormat(arriving), OperandFormat(arriving)},
          .fixed_reference = lane_of(graph, 7, true)};
}

data::Table every_pair() {
  data::Table table{.format = widened, .columns = {"a", "b"}, .values = {}, .labels = {}};
  for (Bits a = 0; a < Bits{1} << arriving.width(); ++a) {
    for (Bits b = 0; b < Bits{1} << arriving.width(); ++b) {
      table.values.push_back(converted(widened, arriving, a));
      table.values.push_back(converted(widened, arriving, b));
    }
  }
  return table;
}

bool is_taken(Bits operand) {
  if (!widened.is_finite(operand)) return false;
  const mpq_class value = to_rational(widened, operand);
  return value >= range.low && value <= range.high;
}

class FixedReferenceSystem : public testing::TestWithParam<Case> {};

TEST_P(FixedReferenceSystem, EveryPairIsDecidedAsTheGoldenModelSays) {
  const design::Design design = design_of(GetParam());
  const auto data = data::Comparisons::rows(every_pair(), design.inputs);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  const verilator_tb::VerifyReport report =
      simulate(design, *data, {.simulator = GetParam().simulator});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_GT(report.recomputations, 0u);
  EXPECT_GT(report.verdicts[static_cast<std::size_t>(Verdict::unordered)], 0u);
  EXPECT_GT(report.verdicts[static_cast<std::size_t>(Verdict::less)], 0u);
}

/// Comparisons of one part.
class FixedReference : public testing::TestWithParam<Case> {};

/// A verdict is the order of the real numbers if the difference exceeds the stated error.
TEST_P(FixedReference, KeepsToItsStatedAccuracy) {
  const Graph graph = graph_of_case(GetParam());
  const fixed::FixedLane reference = lane_of(graph, 7, true);
  const fixed::FixedNode& difference =
      reference.nodes[static_cast<std::size_t>(reference.parts.front().difference)];
  const std::vector<Bits> pairs = every_pair().values;
  int checked = 0, equal = 0;
  for (std::size_t at = 0; at < pairs.size(); at += 2) {
    const std::vector<Bits> operands = {pairs[at], pairs[at + 1]};
    const Verdict verdict = golden::evaluate_lane(reference, operands).verdict;
    if (!is_taken(operands[0]) || !is_taken(operands[1])) continue;
    const auto computed = golden::evaluate(reference, operands);
    const mpq_class n = *computed[static_cast<std::size_t>(reference.parts.front().difference)] *
                        difference.format.unit();
    EXPECT_EQ(verdict, n > 0 ? Verdict::greater : n < 0 ? Verdict::less : Verdict::equal);
    equal += n == 0 ? 1 : 0;
    if (n >= difference.error.low && n <= difference.error.high) continue;
    EXPECT_EQ(to_string(verdict), to_string(golden::true_verdict(graph, widened, operands)));
    ++checked;
  }
  EXPECT_GT(checked, 100);
  EXPECT_GT(equal, 0);
}

/// A lane leaves numbers beyond a limit undecided; a reference takes them.
TEST(FixedReferenceLimits, AreNone) {
  const Graph limited = graph_of({{"within(a, 0, 1) * b", "a"}}, Combination::all);
  const std::vector<Bits> operands = {from_rational(widened, 4), from_rational(widened, 2)};
  EXPECT_FALSE(golden::evaluate_lane(lane_of(limited, 7, false), operands).decided);
  EXPECT_EQ(golden::evaluate_lane(lane_of(limited, 7, true), operands).verdict, Verdict::greater);
}

std::string name_of(const testing::TestParamInfo<Case>& instance) {
  return instance.param.name;
}

const Case products = {"products", {{"a * b", "(a - b)^2"}}, 4};
const Case roots = {"roots", {{"sqrt(abs(a * b))", "max(a, -b) * 0.75"}}, 5};
const Parts two_parts = {{"a", "b * 1.25"}, {"a * a", "b + 2"}};

INSTANTIATE_TEST_SUITE_P(Of, FixedReference, testing::Values(products, roots), name_of);
INSTANTIATE_TEST_SUITE_P(Of, FixedReferenceSystem,
                         testing::Values(products, roots,
                                         Case{"parts", two_parts, 4, Combination::any},
                                         Case{"parts_by_icarus", two_parts, 4, Combination::all,
                                              verilator_tb::SimulatorKind::icarus}),
                         name_of);

}  // namespace
}  // namespace mixcmp::test::fixed_reference_test
