#include <gtest/gtest.h>

#include "model/base/number/exact.hpp"
#include "model/lane/error/exactness.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/simulated_system.hpp"

/// Systems whose operands arrive in fixed point: on every operand of small formats, exact lanes and
/// references decide everything as the real numbers do, and other lanes never wrongly.
namespace mixcmp::test::fixed_operands_system_test {
namespace {

struct Case {
  const char* name;
  std::vector<std::pair<std::string, std::string>> parts;
  const char* format_of_a;
  const char* format_of_b;
  Combination combination = Combination::all;
  int references = 0;
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.name;
}

std::vector<OperandFormat> formats_of(const Case& c) {
  return {*OperandFormat::parse(c.format_of_a), *OperandFormat::parse(c.format_of_b)};
}

/// The format in which nothing is rounded.
Arithmetic exact_reference(const Graph& graph, const std::vector<OperandFormat>& formats) {
  const std::size_t inputs = formats.size();
  return {error::exact_format(graph, formats, std::vector<std::optional<Range>>(inputs),
                              std::vector<std::optional<mpq_class>>(inputs))
              .value()};
}

/// An exact lane, and one of two bits whose multipliers are logic.
design::Design design_of(const Graph& graph, const std::vector<OperandFormat>& formats,
                         int references) {
  const Arithmetic reference = exact_reference(graph, formats);
  const auto lane = [&](int bits) {
    return fixed::fixed_lane(graph, reference.format,
                             {.format = {.bits = bits},
                              .bound = {},
                              .ranges = std::vector<std::optional<Range>>(formats.size()),
                              .operand_formats = formats})
        .value();
  };
  const fixed::FixedLane exact = lane(
      fixed::exact_bits(graph, reference.format, {.ranges = {}, .operand_formats = formats}, 48)
          .value());
  design::Design design{.name = "fixed_operands",
                        .inputs = graph.inputs(),
                        .lanes = {{.lane = exact}, {.lane = lane(2)}},
                        .reference = reference_graph(graph, reference),
                        .references = {},
                        .system = {}};
  design.lanes.back().multipliers = scene::Multipliers::logic;
  design.system.references = references;
  design.operand_formats = formats;
  if (references > 0) {
    design.references = {{.count = references}};
    design.fixed_reference = exact;
  }
  return design;
}

/// Every pair of numbers, each twice in a row, so that each of two lanes takes it.
data::Table every_pair(const std::vector<OperandFormat>& formats, FloatFormat encoding) {
  data::Table table{.format = encoding, .columns = {"a", "b"}, .values = {}, .labels = {}};
  const FixedFormat &of_a = *formats[0].fixed(), &of_b = *formats[1].fixed();
  for (mpz_class a = of_a.smallest(); a <= of_a.largest(); ++a) {
    for (mpz_class b = of_b.smallest(); b <= of_b.largest(); ++b) {
      const Bits pair[] = {from_rational(encoding, a * of_a.unit()),
                           from_rational(encoding, b * of_b.unit())};
      for (int lane = 0; lane < 2; ++lane) {
        table.values.insert(table.values.end(), std::begin(pair), std::end(pair));
      }
    }
  }
  return table;
}

class FixedOperands : public testing::TestWithParam<Case> {};

TEST_P(FixedOperands, EveryPairIsDecidedAsTheGoldenModelSaysAndTruly) {
  const Graph graph = graph_of(GetParam().parts, GetParam().combination);
  const std::vector<OperandFormat> formats = formats_of(GetParam());
  const design::Design design = design_of(graph, formats, GetParam().references);
  const data::Table pairs = every_pair(formats, design.reference.input_format);
  const std::uint64_t comparisons = pairs.rows();
  const auto data = data::Comparisons::rows(pairs, design.inputs);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  const verilator_tb::VerifyReport report =
      simulate(design, *data, {.truth = verilator_tb::TruthCheck{.graph = &graph}});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.comparisons, comparisons);
  const std::uint64_t asked = GetParam().references > 0 ? report.recomputations : report.undecided;
  EXPECT_GT(asked, 0u) << "the coarse lane decides everything";
  EXPECT_LE(asked, comparisons / 2) << "the exact lane leaves something undecided";
  EXPECT_EQ(report.truth->wrong_by_lane, 0u) << to_text(report);
  EXPECT_EQ(report.truth->wrong_by_reference, 0u) << to_text(report);
}

INSTANTIATE_TEST_SUITE_P(
    Systems, FixedOperands,
    testing::Values(
        Case{"signed_products", {{"a * b - a", "max(a, b) * (b - 2)"}}, "int5", "int6"},
        Case{"of_several_widths", {{"(a - b)^2", "3 * abs(b) + a"}}, "uint7", "q1.3"},
        Case{"parts", {{"a", "4 * b"}, {"-a * b", "0.5 - b"}}, "uq2.3", "int4", Combination::any},
        Case{"recomputed",
             {{"a * b - a", "max(a, b) * (b - 2)"}},
             "uint5",
             "int6",
             Combination::all,
             1},
        Case{"parts_recomputed",
             {{"a", "4 * b"}, {"-a * b", "0.5 - b"}},
             "uq2.3",
             "int4",
             Combination::any,
             2}),
    [](const auto& instance) { return std::string(instance.param.name); });

/// An engine stores words of 5 and of 3 bits, and its lanes read them as they are.
class FixedOperandsInAnEngine : public testing::TestWithParam<int> {};

TEST_P(FixedOperandsInAnEngine, EveryPairOfItemsIsDecidedAsTheGoldenModelSays) {
  const Graph graph = graph_of("(xi - xj)^2 + (yi - yj)^2", "12");
  const OperandFormat uint5 = *OperandFormat::parse("uint5"), int3 = *OperandFormat::parse("int3");
  const std::vector<OperandFormat> formats = {uint5, uint5, int3, int3};
  design::Design design = design_of(graph, formats, GetParam());
  design.system = with_engine(design.system, {.kind = scene::EngineKind::pairwise, .capacity = 64});
  data::Table items{
      .format = design.reference.input_format, .columns = {"x", "y"}, .values = {}, .labels = {}};
  for (int k = 0; k < 64; ++k) {
    items.values.push_back(from_rational(items.format, k * 7 % 32));
    items.values.push_back(from_rational(items.format, k % 8 - 4));
  }
  const auto data = data::Comparisons::all_pairs(items, design.inputs);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  const verilator_tb::VerifyReport report =
      simulate(design, *data, {.simulator = verilator_tb::SimulatorKind::icarus});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.comparisons, 64u * 63 / 2);
  EXPECT_GT(report.verdicts[0], 0u);
  EXPECT_GT(GetParam() > 0 ? report.recomputations : report.undecided, 0u);
}

INSTANTIATE_TEST_SUITE_P(References, FixedOperandsInAnEngine, testing::Values(0, 1));

}  // namespace
}  // namespace mixcmp::test::fixed_operands_system_test
