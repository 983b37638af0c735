#include <gtest/gtest.h>

#include <algorithm>

#include "model/judge/golden/fixed_evaluate.hpp"
#include "model/lane/fixed/fixed_lane.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"
#include "tests/support/sphere_families.hpp"

/// Systems whose lanes are in fixed point: the hardware is the golden model bit for bit, and where
/// a lane decided, its verdict is the truth.
namespace mixcmp::test::fixed_point_test {
namespace {

struct Case {
  const char* name;
  std::vector<std::pair<std::string, std::string>> parts;
  int bits;
  Range range;
  Combination combination = Combination::all;
  scene::Multipliers multipliers = scene::Multipliers::embedded;
  bool is_block = false;
  int guard_digits = 0;
  std::optional<BoundKind> bound = {};
  std::optional<mpq_class> grid = {};
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.name;
}

design::Design design_of(const Graph& graph, FloatFormat reference, FixedPoint lane_format,
                         const Range& range,
                         scene::Multipliers multipliers = scene::Multipliers::embedded,
                         std::optional<BoundKind> bound = {}, std::optional<mpq_class> grid = {}) {
  const std::size_t inputs = graph.inputs().size();
  const fixed::FixedOptions options = {.format = lane_format,
                                       .bound = bound,
                                       .ranges = {inputs, std::optional(range)},
                                       .grids = std::vector(inputs, std::move(grid))};
  return {.name = "fixed_point",
          .inputs = graph.inputs(),
          .lanes = {{.lane = fixed::fixed_lane(graph, reference, options).value(),
                     .multipliers = multipliers}},
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

class SystemInFixedPoint : public testing::TestWithParam<Case> {};

TEST_P(SystemInFixedPoint, EveryOperandIsDecidedAsTheGoldenModelSaysAndTruly) {
  const Graph graph = graph_of(GetParam().parts, GetParam().combination);
  const FloatFormat s4e4 = format("s4e4");
  const FixedPoint lane_format = {GetParam().bits, GetParam().is_block, GetParam().guard_digits};
  const design::Design design =
      design_of(graph, s4e4, lane_format, GetParam().range, GetParam().multipliers,
                GetParam().bound, GetParam().grid);
  const auto data = data::Comparisons::rows(every_pair(s4e4), design.inputs);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  const verilator_tb::VerifyReport report =
      simulate(design, *data, {.truth = verilator_tb::TruthCheck{.graph = &graph}});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.comparisons, 65'536u);
  EXPECT_GT(report.recomputations, 100u);
  EXPECT_LT(report.recomputations, 65'400u) << "the lane decides nothing worth testing";
  EXPECT_EQ(report.truth->wrong_by_lane, 0u) << to_text(report);
}

const Range both_signs = {-6, 6};
const Range positive = {0, 12};

INSTANTIATE_TEST_SUITE_P(
    Lanes, SystemInFixedPoint,
    testing::Values(
        Case{"norm", {{"(a - b)^2 + b^2", "(abs(a) + 1.3)^2"}}, 4, both_signs},
        Case{"norm_swapped", {{"(a + 1.5)^2", "(b - 2)^2 + (a - b)^2"}}, 5, positive},
        Case{"two_norms", {{"(a - b)^2 + b^2", "(b + 1.3)^2 + a^2"}}, 6, both_signs},
        Case{"constant", {{"a * b - a", "max(a, b) + 0.3"}}, 5, both_signs},
        Case{"dropped_bits", {{"a * b * abs(a - 0.7) * b", "min(-a, b) * 20"}}, 7, both_signs},
        Case{"roots", {{"sqrt((a - b)^2 + b^2) - sqrt(abs(a))", "0.7 * a"}}, 7, both_signs},
        Case{"root_far_from_zero", {{"sqrt(a + 64)", "b"}}, 6, positive},
        Case{"root_of_a_fine_minimum", {{"sqrt(min(a, b / 1024))", "a - b"}}, 5, positive},
        Case{"limits",
             {{"within(a - b, -2, 5)^2 + within(a + b, 0.5, 8)", "within(a, -3, 4) * b"}},
             6,
             both_signs},
        Case{"factor_of_hardly_a_sign",
             {{"min(max(a - b, -3/256), 3/256) * abs(a) + a", "b * 0.7"}},
             4,
             both_signs},
        Case{"wider_than_a_multiplier", {{"(a - b) * (a + b)", "a * b"}}, 19, both_signs},
        Case{"norm_of_logic",
             {{"(a - b)^2 + b^2", "(abs(a) + 1.3)^2"}},
             4,
             both_signs,
             Combination::all,
             scene::Multipliers::logic},
        Case{"products_of_logic",
             {{"a * b - a * 0.7", "max(a, b) * (b - 2)"}},
             7,
             both_signs,
             Combination::all,
             scene::Multipliers::logic},
        Case{"squares_in_memory",
             {{"(a - b)^2 + b^2", "(abs(a) + 1.3)^2"}},
             4,
             both_signs,
             Combination::all,
             scene::Multipliers::memory},
        Case{"squares_in_memory_and_products_of_logic",
             {{"(a - b)^2 + a * b", "(b * a)^2 * 0.01 + (a + 2)^2"}},
             6,
             both_signs,
             Combination::all,
             scene::Multipliers::memory},
        Case{"squares_of_squares_in_one_memory",
             {{"(a - 0.3)^4", "200 * max(a, b)"}},
             6,
             both_signs,
             Combination::all,
             scene::Multipliers::memory},
        Case{"parts",
             {{"(a - b)^2", "(b + 1)^2"}, {"a", "3 * b - 1"}},
             4,
             positive,
             Combination::any},
        Case{"block_norm",
             {{"(a - b)^2 + b^2", "(2 * abs(a) + b)^2"}},
             4,
             both_signs,
             Combination::all,
             scene::Multipliers::embedded,
             true},
        Case{"block_of_positive_operands",
             {{"a * b", "0.7 * a^2"}},
             3,
             positive,
             Combination::all,
             scene::Multipliers::logic,
             true},
        Case{"block_of_squares_in_memory",
             {{"(a - b)^2 + b^2", "(2 * abs(a) + b)^2"}},
             5,
             both_signs,
             Combination::all,
             scene::Multipliers::memory,
             true},
        Case{"block_of_two_degrees",
             {{"(a - b)^2", "a * b"}, {"a", "3 * abs(b)"}},
             6,
             both_signs,
             Combination::any,
             scene::Multipliers::embedded,
             true},
        Case{"norm_of_a_small_radius", {{"(a - b)^2 + a^2", "(b / 8)^2"}}, 6, both_signs},
        Case{"norm_of_a_small_radius_swapped",
             {{"(a / 16)^2", "(a - b)^2 + (b + 1)^2"}},
             5,
             positive},
        Case{"two_norms_of_which_one_is_small",
             {{"(a - b)^2", "(a / 8)^2 + (b / 16)^2"}},
             6,
             both_signs,
             Combination::all,
             scene::Multipliers::logic},
        Case{"parts_with_reaches_of_their_own",
             {{"(a - b)^2", "(b / 8)^2"}, {"(b / 16)^2", "(a - b)^2"}, {"a", "b"}},
             5,
             both_signs,
             Combination::any,
             scene::Multipliers::memory},
        Case{"reaches_behind_cuts",
             {{"(a - b)^2 + a^2", "(b / 8)^2"}},
             3,
             both_signs,
             Combination::all,
             scene::Multipliers::embedded,
             false,
             3},
        Case{"norm_behind_cuts",
             {{"(a - b)^2 + (b + 1.3)^2", "(abs(a) + 2)^2"}},
             3,
             both_signs,
             Combination::all,
             scene::Multipliers::embedded,
             false,
             2},
        Case{"products_behind_cuts",
             {{"(a - b) * a + 0.7 * b^2", "max(a - 5, 2 * b) * abs(b)"}},
             4,
             both_signs,
             Combination::all,
             scene::Multipliers::logic,
             false,
             4},
        Case{"parts_before_and_behind_cuts",
             {{"a - b", "0.4"}, {"(within(a, -3, 4) - b)^2", "a * b"}},
             3,
             both_signs,
             Combination::any,
             scene::Multipliers::embedded,
             false,
             3},
        Case{"parts_that_share_cuts",
             {{"(a - 1)^2", "(0.5 * a + 2)^2"}, {"b * (b - 1)", "(b + 1.3)^2"}},
             5,
             both_signs,
             Combination::any,
             scene::Multipliers::logic,
             false,
             4},
        Case{"roots_behind_cuts",
             {{"sqrt((a - b)^2 + b^2) - abs(a)", "0.7 * a"}},
             5,
             both_signs,
             Combination::all,
             scene::Multipliers::embedded,
             false,
             1},
        Case{"block_with_cuts",
             {{"(a - b)^2 + b^2", "(2 * abs(a) + b)^2"}},
             3,
             both_signs,
             Combination::all,
             scene::Multipliers::embedded,
             true,
             5},
        Case{"running",
             {{"a * b - 0.3 * b^2", "(a - b) * 0.7 * b"}},
             6,
             both_signs,
             Combination::all,
             scene::Multipliers::embedded,
             false,
             0,
             BoundKind::running},
        Case{"running_parts_and_limits",
             {{"within(a - b, -3, 4)^2 * 0.3", "a * b + 0.2"}, {"b^3", "a * b"}, {"a", "b"}},
             5,
             both_signs,
             Combination::any,
             scene::Multipliers::logic,
             false,
             0,
             BoundKind::running},
        Case{"block_running_behind_cuts",
             {{"(a - b) * b", "a * abs(b)"}},
             4,
             both_signs,
             Combination::all,
             scene::Multipliers::embedded,
             true,
             2,
             BoundKind::running},
        Case{"multiples_of_a_half",
             {{"a * b - a", "max(a, b) + 0.5"}},
             5,
             both_signs,
             Combination::all,
             scene::Multipliers::logic,
             false,
             0,
             BoundKind::grid,
             mpq_class(1, 2)},
        Case{"multiples_of_a_quarter",
             {{"(a - b)^2", "3 * b - 1"}, {"within(a, 2, 9)", "0.75 * b"}},
             6,
             positive,
             Combination::any,
             scene::Multipliers::embedded,
             false,
             0,
             BoundKind::grid,
             mpq_class(1, 4)}),
    [](const auto& instance) { return std::string(instance.param.name); });

/// The comparisons that a lane leaves undecided, by the golden model.
std::vector<bool> undecided_by(const design::Lane& lane, const data::Comparisons& data) {
  std::vector<bool> undecided;
  std::vector<Bits> operands(data.input_count());
  for (std::uint64_t k = 0; k < data.size(); ++k) {
    data.fetch(k, operands);
    undecided.push_back(!golden::evaluate_lane(std::get<fixed::FixedLane>(lane), operands).decided);
  }
  return undecided;
}

/// Every seventh item breaks its promise of a grid. One lane takes the others
/// exactly, the other, of fewer bits, truncates them: the items' words have both. The engine gives
/// each comparison to either.
TEST(PromisedGridsInAnEngine, AreCheckedWhereItemsAreLoaded) {
  const Graph graph = graph_of("(xi - xj)^2 + (yi - yj)^2", "12");
  const FloatFormat s24e8 = format("s24e8");
  const auto design_with = [&](int bits, std::optional<BoundKind> bound) {
    return design_of(graph, s24e8, {bits}, {-16, 15}, scene::Multipliers::embedded, bound, 1);
  };
  design::Design design = design_with(5, BoundKind::grid);
  design.lanes.push_back(design_with(3, {}).lanes.front());
  design.system = with_engine(design.system, {.kind = scene::EngineKind::pairwise, .capacity = 64});
  data::Table items{.format = s24e8, .columns = {"x", "y"}, .values = {}, .labels = {}};
  for (int k = 0; k < 64; ++k) {
    const mpq_class off_grid = k % 7 == 0 ? mpq_class(1, 2) : mpq_class(0);
    items.values.push_back(from_rational(s24e8, k * 7 % 32 - 16 + off_grid));
    items.values.push_back(from_rational(s24e8, k % 8 - 4));
  }
  const auto data = data::Comparisons::all_pairs(items, design.inputs);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  const verilator_tb::VerifyReport report =
      simulate(design, *data,
               {.simulator = verilator_tb::SimulatorKind::icarus,
                .truth = verilator_tb::TruthCheck{.graph = &graph}});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.comparisons, 64u * 63 / 2);
  const std::vector<bool> exact = undecided_by(design.lanes[0].lane, *data);
  const std::vector<bool> truncating = undecided_by(design.lanes[1].lane, *data);
  const auto broken = std::count(exact.begin(), exact.end(), true);
  EXPECT_EQ(broken, 64 * 63 / 2 - 54 * 53 / 2) << "pairs with one of the ten items off the grid";
  std::uint64_t by_both = 0, by_one = 0;
  for (std::size_t k = 0; k < exact.size(); ++k) {
    by_both += exact[k] && truncating[k] ? 1 : 0;
    by_one += exact[k] || truncating[k] ? 1 : 0;
  }
  EXPECT_GT(report.recomputations, by_both);
  EXPECT_LT(report.recomputations, by_one);
  EXPECT_EQ(report.truth->wrong_by_lane, 0u) << to_text(report);
}

/// A column has a grid as item i and a finer one as item j: its word has both, each with its check.
TEST(PromisedGridsInAnEngine, OfOneColumnMayDiffer) {
  const Graph graph = graph_of("xi", "xj");
  const FloatFormat s24e8 = format("s24e8");
  const fixed::FixedOptions options = {.format = {6},
                                       .bound = BoundKind::grid,
                                       .ranges = std::vector(2, std::optional(Range{0, 8})),
                                       .grids = {mpq_class(1), mpq_class(1, 4)}};
  design::Design design = design_of(graph, s24e8, {6}, {0, 8});
  design.lanes.front().lane = fixed::fixed_lane(graph, s24e8, options).value();
  design.system = with_engine(design.system, {.kind = scene::EngineKind::pairwise, .capacity = 16});
  data::Table items{.format = s24e8, .columns = {"x"}, .values = {}, .labels = {}};
  for (int k = 0; k < 16; ++k) {
    items.values.push_back(from_rational(s24e8, mpq_class(k * 5 % 16, k == 15 ? 8 : 4)));
  }
  const auto data = data::Comparisons::all_pairs(items, design.inputs);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  const verilator_tb::VerifyReport report =
      simulate(design, *data, {.simulator = verilator_tb::SimulatorKind::icarus});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_GT(report.recomputations, 60u) << "items i off the coarse grid";
  EXPECT_LT(report.recomputations, report.comparisons);
}

/// The families of spheres that are made to mislead a lane.
TEST(SpheresInFixedPoint, AreDecidedTruly) {
  const Graph graph = sphere_graph();
  const FloatFormat s53e8 = format("s53e8");
  const design::Design design = design_of(graph, s53e8, {13}, {0, 100});
  std::uint64_t decided = 0;
  for (const SphereFamily& family : sphere_families(s53e8, 13, 400, 5)) {
    const auto data = data::Comparisons::rows(family.pairs, design.inputs);
    ASSERT_TRUE(data.ok()) << data.error().to_string();
    const verilator_tb::VerifyReport report =
        simulate(design, *data, {.truth = verilator_tb::TruthCheck{.graph = &graph}});
    EXPECT_TRUE(report.passed()) << family.name << "\n" << to_text(report);
    EXPECT_EQ(report.truth->wrong_by_lane, 0u) << family.name;
    decided += report.comparisons - report.recomputations;
  }
  EXPECT_GT(decided, 400u);
}

}  // namespace
}  // namespace mixcmp::test::fixed_point_test
