#include <gtest/gtest.h>

#include <random>

#include "model/lane/fixed/fixed_lane.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"

/// Systems with folded references: each result is the golden model's, whatever shares a unit.
namespace mixcmp::test::folded_reference_test {
namespace {

struct Case {
  const char* name;
  std::vector<std::pair<std::string, std::string>> parts;
  int interval;
  int references = 1;
  scene::OperandStore operands = scene::OperandStore::carried;
  scene::ResultOrder order = scene::ResultOrder::tagged;
  scene::Multipliers multipliers = scene::Multipliers::embedded;
  const char* reference = "s4e4";
  const char* device = "virtex6-lx760";
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.name;
}

/// A lane of so few bits that references decide most comparisons.
design::Design design_of(const Case& c) {
  const Graph graph = graph_of(c.parts, Combination::any);
  const Range range = {-6, 6};
  const fixed::FixedOptions options = {.format = {2, false, 0},
                                       .bound = {},
                                       .ranges = {graph.inputs().size(), std::optional(range)}};
  design::Design design = {
      .name = "folded",
      .inputs = graph.inputs(),
      .lanes = {{.lane = fixed::fixed_lane(graph, format(c.reference), options).value(),
                 .count = 3}},
      .reference = reference_graph(graph, {format(c.reference)}),
      .references = {{.structure = {c.multipliers, c.interval}, .count = c.references}},
      .system = {}};
  design.system.operands = c.operands;
  design.system.order = c.order;
  design.system.device = c.device;
  return design;
}

constexpr std::size_t encodings = 256;

/// All encodings of a format of eight bits, NaNs and infinities included. Wider formats get as many
/// encodings, with those at the ends of the range among them.
std::vector<Bits> encodings_of(FloatFormat format) {
  std::vector<Bits> all;
  if (format.width() > 8) all = special_encodings(format);
  std::mt19937_64 random(19);
  while (all.size() < encodings) {
    all.push_back(format.width() > 8 ? random_encoding(format, random) : Bits{all.size()});
  }
  return all;
}

data::Comparisons every_pair(const design::Design& design) {
  const FloatFormat format = design.reference.input_format;
  data::Table table{.format = format, .columns = {"a", "b"}, .values = {}, .labels = {}};
  const std::vector<Bits> values = encodings_of(format);
  for (const Bits a : values) {
    for (const Bits b : values) table.values.insert(table.values.end(), {a, b});
  }
  return data::Comparisons::rows(table, design.inputs).value();
}

class FoldedReference : public testing::TestWithParam<Case> {};

TEST_P(FoldedReference, DecidesEveryPairAsTheGoldenModelDoes) {
  const design::Design design = design_of(GetParam());
  const verilator_tb::VerifyReport report =
      simulate(design, every_pair(design),
               {.judge = verilator_tb::JudgeKind::golden_model,
                .traffic = verilator_tb::TrafficKind::stressed,
                .resets = 2});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.comparisons, 65'536u);
  EXPECT_GT(report.recomputations, 20'000u) << to_text(report);
}

constexpr auto refetched = scene::OperandStore::refetched;
constexpr auto carried = scene::OperandStore::carried;
constexpr auto in_order = scene::ResultOrder::in_order;
constexpr auto tagged = scene::ResultOrder::tagged;
constexpr auto logic = scene::Multipliers::logic;

INSTANTIATE_TEST_SUITE_P(
    Of, FoldedReference,
    testing::Values(
        Case{"sums_and_squares_16", {{"(a - b)^2 + (a + b)^2 + b^2", "(a - 1.5)^2"}}, 16},
        Case{"sums_and_squares_2_refetched",
             {{"(a - b)^2 + (a + b)^2 + b^2", "(a - 1.5)^2"}},
             2,
             2,
             refetched,
             in_order},
        Case{"squares_of_sums_16",
             {{"(a - b)^2 + (a + b)^2 + (b - 0.5)^2", "(a - 1.5)^2"}},
             16,
             1,
             refetched,
             tagged,
             logic},
        Case{"squares_by_steps_16",
             {{"(a - b)^2 + (a + b)^2 + (b - 0.5)^2", "(a - 1.5)^2"}},
             16,
             3,
             refetched,
             tagged,
             logic,
             "s24e8",
             "ice40-hx8k"},
        // Sides that are the same number: a wrong bit on either is another verdict.
        Case{"equal_sides_by_steps_16",
             {{"(a - b)^2 + (a + b)^2", "(b - a)^2 + (b + a)^2"}},
             16,
             1,
             carried,
             tagged,
             logic,
             "s24e8",
             "ice40-hx8k"},
        Case{"squares_of_operands_by_steps_21",
             {{"(a - b)^2 + a^2 + b^2", "(a - 1.5)^2"}, {"(a + b)^2 + 1", "a"}},
             21,
             1,
             carried,
             in_order,
             logic,
             "s19e4",
             "ice40-hx8k"},
        Case{"one_square_by_steps_5",
             {{"(a - b)^2 + a", "b"}},
             5,
             2,
             carried,
             tagged,
             logic,
             "s24e8",
             "ice40-hx8k"},
        Case{"products_and_signs_5",
             {{"a * b - abs(b) * a + 0.75", "-a * max(a, b) + min(a, -b)"}},
             5,
             1,
             carried,
             in_order,
             logic},
        // Squares and products in every proportion, some of them by one unit.
        Case{"more_squares_than_products_2", {{"a^2", "b^2 + a * b"}}, 2},
        Case{"squares_beside_products_3",
             {{"(a - b)^2 + a * b + a^2 + b^2", "(a + b)^2 - (a - 1) * b"}},
             3,
             2,
             refetched},
        Case{"squares_beside_products_4",
             {{"(a - b)^2 + a * b + a^2", "(a + b)^2 - b^2 * (a - 1)"}},
             4,
             1,
             carried,
             in_order,
             logic},
        Case{"late_operands_3", {{"((a + b) * b + a) * b + a", "a - b * 0.7"}}, 3, 1, refetched},
        Case{"powers_of_two_and_parts_4", {{"a / 4 + b / 4", "(a * -2 - b) * 2"}, {"a", "b"}}, 4},
        Case{"longer_than_needed_64", {{"(a - b)^2 + b", "a * b"}}, 64}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace mixcmp::test::folded_reference_test
