#include <gtest/gtest.h>

#include <optional>
#include <random>

#include "model/lane/error/certified_lane.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"
#include "tests/support/sphere_families.hpp"

/// Systems whose lanes decide by an absolute error bound, or check ranges: the hardware is the
/// golden model bit for bit, and where a lane decided, its verdict is the truth.
namespace mixcmp::test::error_bound_test {
namespace {

struct Case {
  const char* name;
  const char* f;
  const char* g;
  BoundKind kind;
  int digits = 4;
  const char* lane = "s4e4";
  LaneInputs inputs = LaneInputs::rounded;
  std::optional<Range> range = {};
  Rounding rounding = Rounding::nearest_even;
  Subnormals subnormals = Subnormals::flush;
  const char* reference = "s4e4";  ///< of 8 bits, where every pair is compared
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.name;
}

design::Design design_of(const Case& c, const Graph& graph, FloatFormat reference) {
  const std::vector<std::optional<Range>> ranges(graph.inputs().size(), c.range);
  const Arithmetic reduced = {format(c.lane), c.rounding, c.subnormals};
  return {.name = "bounded",
          .inputs = graph.inputs(),
          .lanes = {{.lane = error::certified_lane(
                                 lane_graph(graph, reference, reduced, c.inputs),
                                 {.kind = c.kind, .bound_digits = c.digits, .ranges = ranges})
                                 .value(),
                     .inputs = c.inputs}},
          .reference = reference_graph(graph, {reference}),
          .references = {{}},
          .system = {}};
}

/// Every pair of encodings, NaNs and infinities too.
data::Table every_pair(FloatFormat format) {
  data::Table table{.format = format, .columns = {"a", "b"}, .values = {}, .labels = {}};
  const Bits count = Bits{1} << format.width();
  for (Bits a = 0; a < count; ++a) {
    for (Bits b = 0; b < count; ++b) table.values.insert(table.values.end(), {a, b});
  }
  return table;
}

class EveryOperand : public testing::TestWithParam<Case> {};

TEST_P(EveryOperand, IsDecidedAsTheGoldenModelSaysAndTruly) {
  const Graph graph = graph_of(GetParam().f, GetParam().g);
  const FloatFormat reference = format(GetParam().reference);
  const design::Design design = design_of(GetParam(), graph, reference);
  const auto data = data::Comparisons::rows(every_pair(reference), design.inputs);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  const verilator_tb::VerifyReport report =
      simulate(design, *data, {.truth = verilator_tb::TruthCheck{.graph = &graph}});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.comparisons, 65'536u);
  EXPECT_GT(report.recomputations, 100u);
  EXPECT_LT(report.recomputations, 65'000u) << "the lane decides nothing worth testing";
  EXPECT_EQ(report.truth->wrong_by_lane, 0u) << to_text(report);
}

const Range within_two = {-2, 2};
const Range positive = {mpq_class(1, 2), 4};
const Range negative = {-4, mpq_class(-1, 2)};

INSTANTIATE_TEST_SUITE_P(
    Lanes, EveryOperand,
    testing::Values(
        Case{"running_4_digits", "a * b - a", "b + 0.3", BoundKind::running, 4},
        Case{"running_exponents_alone_toward_zero", "(a - b)^2 * a", "b^2", BoundKind::running, 1,
             "s6e5", LaneInputs::rounded, std::nullopt, Rounding::toward_zero},
        Case{"running_divisor_and_root_gradual", "a / (b - 1.1)", "sqrt(a - 0.7)",
             BoundKind::running, 3, "s4e3", LaneInputs::rounded, std::nullopt,
             Rounding::nearest_even, Subnormals::gradual},
        Case{"running_exact_inputs_selected", "max(a - b, a * b) - a", "abs(b) - a",
             BoundKind::running, 2, "s3e4", LaneInputs::exact},
        Case{"running_inputs_of_4_digits", "a - b", "min(a, b) * a", BoundKind::running, 3, "s3e5",
             LaneInputs::of_digits(4), std::nullopt, Rounding::nearest_even, Subnormals::flush,
             "s5e3"},
        Case{"running_inputs_of_4_digits_toward_zero", "a - b / 3", "max(b, 0.3) - a",
             BoundKind::running, 3, "s3e5", LaneInputs::of_digits(4), std::nullopt,
             Rounding::toward_zero, Subnormals::flush, "s5e3"},
        Case{"running_inputs_of_4_digits_gradual", "a - b", "min(a, b) * a", BoundKind::running, 3,
             "s3e4", LaneInputs::of_digits(4), std::nullopt, Rounding::nearest_even,
             Subnormals::gradual, "s5e3"},
        Case{"constant_inputs_of_5_digits_in_ranges", "a - b", "a * b", BoundKind::constant, 0,
             "s4e5", LaneInputs::of_digits(5), Range{0, 4}, Rounding::nearest_even,
             Subnormals::flush, "s6e2"},
        Case{"powers_of_two_of_either_sign", "a / -4", "b * -0.5", BoundKind::relative, 0, "s3e4",
             LaneInputs::exact},
        Case{"zero_factor", "a * 0 + b", "b * a", BoundKind::running, 3, "s4e4"},
        Case{"subnormal_powers_of_two", "a / -64", "b / 128", BoundKind::relative, 0, "s3e4",
             LaneInputs::rounded, std::nullopt, Rounding::nearest_even, Subnormals::gradual},
        Case{"running_in_ranges", "a * b - a", "b", BoundKind::running, 3, "s3e5",
             LaneInputs::rounded, within_two, Rounding::nearest_even, Subnormals::gradual},
        Case{"constant_in_ranges", "a * b - a", "b", BoundKind::constant, 0, "s5e5",
             LaneInputs::rounded, within_two},
        // Normal operands whose differences are subnormal.
        Case{"gradual_differences_in_ranges", "a - b", "4 * a", BoundKind::running, 3, "s4e3",
             LaneInputs::rounded, Range{mpq_class(1, 4), mpq_class(7, 2)}, Rounding::nearest_even,
             Subnormals::gradual},
        Case{"relative_positive_ranges", "a * b", "a + b", BoundKind::relative, 0, "s3e5",
             LaneInputs::exact, positive},
        Case{"relative_negative_ranges", "a * b", "a / b", BoundKind::relative, 0, "s3e5",
             LaneInputs::exact, negative}),
    [](const auto& instance) { return std::string(instance.param.name); });

class Spheres : public testing::TestWithParam<Case> {};

/// All families of pairs made to mislead a lane, one after the other.
data::Table every_family(FloatFormat format, int precision) {
  std::vector<SphereFamily> families = sphere_families(format, precision, 400, 5);
  data::Table all = std::move(families.front().pairs);
  for (std::size_t k = 1; k < families.size(); ++k) {
    const data::Table& more = families[k].pairs;
    MIXCMP_CHECK(more.columns == all.columns);
    all.values.insert(all.values.end(), more.values.begin(), more.values.end());
  }
  return all;
}

TEST_P(Spheres, AreDecidedAsTheGoldenModelSaysAndTruly) {
  const Graph graph = sphere_graph();
  const FloatFormat s53e8 = format("s53e8");
  const design::Design design = design_of(GetParam(), graph, s53e8);
  const int precision =
      design::float_lane(design.lanes.front().lane).graph.arithmetic.format.precision();
  const auto data = data::Comparisons::rows(every_family(s53e8, precision), design.inputs);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  const verilator_tb::VerifyReport report =
      simulate(design, *data, {.truth = verilator_tb::TruthCheck{.graph = &graph}});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.truth->wrong_by_lane, 0u) << to_text(report);
  EXPECT_LT(report.recomputations, report.comparisons);
}

/// Rows of ordinary numbers in [1, 64) in turn with rows of fields at random, zeros, subnormals,
/// infinities and NaNs among them.
data::Table any_numbers(FloatFormat format, const std::vector<std::string>& columns) {
  const std::vector<Bits> special = special_encodings(format);
  std::mt19937_64 random(3);
  data::Table table{.format = format, .columns = columns, .values = {}, .labels = {}};
  Bits near = special.front();
  for (std::size_t k = 0; k < 20'000 * columns.size(); ++k) {
    if (k / columns.size() % 2 == 0) {
      const int exponent = format.bias() + static_cast<int>(random() % 6);
      const Bits fraction = random() & low_mask(format.fraction_bits());
      near = format.pack(false, exponent, fraction);
    } else if (random() % 40 == 0) {
      near = special[random() % special.size()];
    } else if (random() % 16 == 0) {
      near = random_encoding(format, random);
    } else {
      near = random_encoding_near(format, near, random);
    }
    table.values.push_back(near);
  }
  return table;
}

TEST_P(Spheres, OfAnyNumbersAreDecidedAsTheGoldenModelSays) {
  const Graph graph = sphere_graph();
  const FloatFormat s53e8 = format("s53e8");
  const design::Design design = design_of(GetParam(), graph, s53e8);
  const auto data = data::Comparisons::rows(any_numbers(s53e8, design.inputs), design.inputs);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  const verilator_tb::VerifyReport report = simulate(design, *data, {});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_GT(report.recomputations, 1'000u);
  EXPECT_LT(report.recomputations, 19'000u);
}

INSTANTIATE_TEST_SUITE_P(
    Lanes, Spheres,
    testing::Values(Case{"s8e8_running_4_digits", "", "", BoundKind::running, 4, "s8e8"},
                    Case{"s17e8_running_4_digits", "", "", BoundKind::running, 4, "s17e8"},
                    Case{"s17e8_exponents_alone_gradual", "", "", BoundKind::running, 1, "s17e8",
                         LaneInputs::rounded, std::nullopt, Rounding::toward_zero,
                         Subnormals::gradual},
                    Case{"s17e8_running_inputs_of_20_digits", "", "", BoundKind::running, 4,
                         "s17e8", LaneInputs::of_digits(20)},
                    Case{"s8e8_exponents_alone_inputs_of_10_digits", "", "", BoundKind::running, 1,
                         "s8e8", LaneInputs::of_digits(10), std::nullopt, Rounding::toward_zero},
                    Case{"s8e8_constant_in_ranges", "", "", BoundKind::constant, 0, "s8e8",
                         LaneInputs::rounded, Range{0, 100}}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace mixcmp::test::error_bound_test
