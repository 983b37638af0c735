#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "model/base/common/counter_random.hpp"
#include "model/base/number/exact.hpp"
#include "model/base/number/verdict.hpp"
#include "model/comparison/expression/parser.hpp"
#include "model/judge/workload/compare_by_reference.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "model/lane/fixed/exact_lane.hpp"
#include "model/lane/fixed/fixed_lane.hpp"
#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"

/// Whole arg-min engines, lanes and references inside: each row leaves with the candidate that the
/// golden model's search chooses.
namespace mixcmp::test::arg_min_test {
namespace {

namespace fs = std::filesystem;

Graph squared_distances() {
  Graph graph;
  const NodeId f = parse_expression(graph, "(x - cxi)^2 + (y - cyi)^2", {}).value();
  graph.compare(f, parse_expression(graph, "(x - cxj)^2 + (y - cyj)^2", {}).value());
  return graph;
}

/// Squared distances in the plane: K candidates, K - 1 lanes of a few digits.
design::Design nearest_point(int lanes, int references, const char* reduced = "s6e8") {
  const Graph graph = squared_distances();
  TypedGraph lane = lane_graph(graph, format("s24e8"), {format(reduced)}, LaneInputs::exact);
  const std::vector<bool> any_sign(graph.inputs().size(), false);
  design::Design design{
      .name = "nearest",
      .inputs = graph.inputs(),
      .lanes = {{.lane = relative_lane(std::move(lane), any_sign).value(), .count = lanes}},
      .reference = reference_graph(graph, {format("s24e8")}),
      .references = {{.count = references}},
      .system = {}};
  design.system =
      with_engine(design.system, {.kind = scene::EngineKind::arg_min, .row_tag_bits = 11});
  return design;
}

/// Lanes in fixed point, whose operands are in [0, 8).
design::LaneGroup fixed_lanes(FixedPoint number, int count) {
  const std::vector<std::optional<Range>> ranges(6, Range{0, 7.9375});
  return {.lane = fixed::fixed_lane(squared_distances(), format("s24e8"),
                                    {.format = number, .ranges = ranges})
                      .value(),
          .count = count};
}

enum class Special {
  none,
  nans,   ///< some coordinates are NaN
  twins,  ///< every point comes twice
  far,    ///< some coordinates are outside the ranges of lanes in fixed point
};

/// Points of a grid of `steps` steps.
data::Table points(FloatFormat format, const std::vector<std::string>& columns, std::size_t count,
                   std::uint64_t steps, std::uint64_t seed, Special special) {
  data::Table table{format, columns, {}, {}};
  for (std::size_t k = 0; k < columns.size() * count; ++k) {
    const std::size_t twice = k / columns.size() / 2 * columns.size() + k % columns.size();
    const std::uint64_t random = counter_random(seed, special == Special::twins ? twice : k);
    const bool is_special = (random >> 32) % 16 == 0;
    if (special == Special::nans && is_special) {
      table.values.push_back(format.quiet_nan());
    } else {
      const std::uint64_t value = random % steps;
      table.values.push_back(
          from_rational(format, special == Special::far && is_special ? 100 + value : value));
    }
  }
  return table;
}

data::Comparisons data(const design::Design& design, std::size_t rows, std::size_t candidates,
                       std::uint64_t steps, Special special = Special::none) {
  const FloatFormat format = design.reference.input_format;
  return data::Comparisons::arg_min(points(format, {"x", "y"}, rows, steps, 1, special),
                                    points(format, {"cx", "cy"}, candidates, steps, 2, special),
                                    design.inputs, workload::compare_by_reference(design.reference))
      .value();
}

void expect_passed(const verilator_tb::VerifyReport& report, std::uint64_t rows,
                   std::uint64_t candidates) {
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.comparisons, rows * (candidates - 1));
  ASSERT_TRUE(report.arg_min.has_value());
  EXPECT_EQ(report.arg_min->rows, rows);
  EXPECT_EQ(report.arg_min->candidates, candidates);
}

class ArgMinSystem : public testing::TestWithParam<int> {};

TEST_P(ArgMinSystem, ChoosesWhatTheModelChoosesARowACycle) {
  const design::Design design = nearest_point(GetParam(), 1, "s16e8");
  const auto candidates = static_cast<std::size_t>(GetParam()) + 1;
  const verilator_tb::VerifyReport report =
      simulate(design, data(design, 500, candidates, 1'000'000), {});
  expect_passed(report, 500, candidates);
  EXPECT_EQ(report.cycles, report.arg_min->expected_cycles.value());
  EXPECT_LT(report.cycles, 500u + report.arg_min->latency.maximum_cycles + 100);
}

TEST_P(ArgMinSystem, AndUnderStallsAndResetsWithTiesAndNans) {
  const design::Design design = nearest_point(GetParam(), 1);
  const auto candidates = static_cast<std::size_t>(GetParam()) + 1;
  for (const std::uint64_t seed : {1, 2}) {
    const verilator_tb::VerifyReport report = simulate(
        design, data(design, 200, candidates, 5, seed == 1 ? Special::twins : Special::nans),
        {.traffic = verilator_tb::TrafficKind::stressed, .traffic_seed = seed, .resets = 3});
    expect_passed(report, 200, candidates);
    EXPECT_GT(report.recomputations, 10u);
    const auto seen =
        report.verdicts[static_cast<std::size_t>(seed == 1 ? Verdict::equal : Verdict::unordered)];
    EXPECT_GT(seen, 10u) << to_text(report);
  }
}

INSTANTIATE_TEST_SUITE_P(Lanes, ArgMinSystem, testing::Values(1, 2, 5),
                         [](const auto& instance) { return fmt::format("{}", instance.param); });

/// Operands that do not fit a lane's words go to the references, as do differences that are too
/// small: points come twice, some of them far away or nowhere.
TEST_P(ArgMinSystem, InFixedPointUnderStallsAndResets) {
  design::Design design = nearest_point(GetParam(), 1);
  design.lanes = {fixed_lanes({.bits = 6}, GetParam())};
  const auto candidates = static_cast<std::size_t>(GetParam()) + 1;
  for (const Special special : {Special::none, Special::nans, Special::twins, Special::far}) {
    const verilator_tb::VerifyReport report =
        simulate(design, data(design, 200, candidates, 8, special),
                 {.traffic = verilator_tb::TrafficKind::stressed,
                  .traffic_seed = static_cast<std::uint64_t>(special) + 1,
                  .resets = 3});
    expect_passed(report, 200, candidates);
    EXPECT_GT(report.recomputations, 10u);
    if (special == Special::none) {
      EXPECT_LT(report.recomputations, report.comparisons);
    }
  }
}

TEST_P(ArgMinSystem, InFixedPointARowACycle) {
  design::Design design = nearest_point(GetParam(), 1);
  design.lanes = {fixed_lanes({.bits = 12}, GetParam())};
  const auto candidates = static_cast<std::size_t>(GetParam()) + 1;
  const verilator_tb::VerifyReport report = simulate(design, data(design, 500, candidates, 8), {});
  expect_passed(report, 500, candidates);
  EXPECT_LT(report.cycles, 500u + report.arg_min->latency.maximum_cycles + 100);
}

/// A word holds the operands that fixed-point lanes have converted, in the finer format, and the
/// columns as they arrive. Whole and folded references take turns at the memories.
TEST(ArgMinSystemOf, LanesOfSeveralKindsAndThreeReferences) {
  design::Design design = nearest_point(2, 3);
  design.lanes.push_back(fixed_lanes({.bits = 5}, 2));
  design.lanes.push_back(fixed_lanes({.bits = 9}, 1));
  design::ReferenceGroup folded = design.references.front();
  folded.structure.initiation_interval = 4;
  folded.count = 2;
  design.references.front().count = 1;
  design.references.push_back(folded);
  for (const Special special : {Special::far, Special::nans}) {
    const verilator_tb::VerifyReport report =
        simulate(design, data(design, 150, 6, 8, special),
                 {.traffic = verilator_tb::TrafficKind::stressed, .traffic_seed = 3, .resets = 2});
    expect_passed(report, 150, 6);
    for (const verilator_tb::GroupReport& group : report.groups) {
      EXPECT_GT(group.recomputations, 0u);
    }
  }
}

/// Every square of the data vanishes in the reference, which calls all candidates equal.
data::Comparisons vanishing(const design::Design& design, std::size_t rows,
                            std::size_t candidates) {
  const FloatFormat format = design.reference.input_format;
  const auto tiny = [&](const std::vector<std::string>& columns, std::size_t count,
                        std::uint64_t seed) {
    data::Table table{format, columns, {}, {}};
    for (std::size_t k = 0; k < columns.size() * count; ++k) {
      const std::uint64_t number = counter_random(seed, k) % 8;
      table.values.push_back(from_rational(format, mpq_class(number) / (mpz_class(1) << 80)));
    }
    return table;
  };
  return data::Comparisons::arg_min(tiny({"x", "y"}, rows, 1), tiny({"cx", "cy"}, candidates, 2),
                                    design.inputs, workload::compare_by_reference(design.reference))
      .value();
}

/// A lane in floating point asks the reference, one in block floating point decides: the candidate
/// depends on which of them comes first in the chain.
class ArgMinSystemOfTwoKinds : public testing::TestWithParam<bool> {};

TEST_P(ArgMinSystemOfTwoKinds, ChoosesByTheLaneOfEachPosition) {
  const bool block_first = GetParam();
  design::Design design = nearest_point(1, 1);
  const fixed::FixedOptions block = {.format = {.bits = 8, .is_block = true},
                                     .ranges = std::vector<std::optional<Range>>(6)};
  design.lanes.insert(
      block_first ? design.lanes.begin() : design.lanes.end(),
      {.lane = fixed::fixed_lane(squared_distances(), format("s24e8"), block).value(), .count = 1});
  constexpr std::size_t rows = 60;
  std::vector<std::uint64_t> chosen(rows, 0);
  const verilator_tb::VerifyReport report =
      simulate(design, vanishing(design, rows, 3),
               {.simulator = block_first ? verilator_tb::SimulatorKind::icarus
                                         : verilator_tb::SimulatorKind::verilator,
                .traffic = verilator_tb::TrafficKind::stressed,
                .resets = 1,
                .on_result = [&](const verilator_tb::VerifiedResult& result) {
                  EXPECT_EQ(result.items.first, chosen[result.items.row]);
                  if (result.word.verdict() == Verdict::greater)
                    chosen[result.items.row] = result.items.second;
                }});
  expect_passed(report, rows, 3);
  const auto decided = static_cast<std::uint64_t>(
      std::count_if(chosen.begin(), chosen.end(), [](std::uint64_t best) { return best != 0; }));
  EXPECT_EQ(report.arg_min->rows_unlike_reference, decided);
  EXPECT_GT(decided, 10u);
  EXPECT_EQ(std::count(chosen.begin(), chosen.end(), block_first ? 2u : 1u), 0);
  EXPECT_EQ(report.groups[block_first ? 1 : 0].recomputations, rows);
}

INSTANTIATE_TEST_SUITE_P(Block, ArgMinSystemOfTwoKinds, testing::Bool(),
                         [](const auto& instance) { return instance.param ? "First" : "Last"; });

TEST(ArgMinSystemOf, FewerCandidatesThanItHolds) {
  const design::Design design = nearest_point(5, 2);
  const verilator_tb::VerifyReport report = simulate(design, data(design, 100, 3, 20), {});
  expect_passed(report, 100, 3);
}

/// Every point of a grid of 3-bit numbers finds its nearest one of 5, ties included.
TEST(ArgMinSystemOf, ExactLanesWithoutReferences) {
  const Graph graph = squared_distances();
  const std::vector<OperandFormat> formats(6, OperandFormat::parse("uint3").value());
  design::Design design = nearest_point(4, 1);
  fixed::FixedOptions options{.ranges = std::vector<std::optional<Range>>(6),
                              .operand_formats = formats};
  options.format = {.bits = *fixed::exact_bits(graph, format("s24e8"), options, 48)};
  design.lanes.front().lane = fixed::fixed_lane(graph, format("s24e8"), options).value();
  design.references = {};
  design.system.references = 0;
  design.operand_formats = formats;
  data::Table all{format("s24e8"), {"x", "y"}, {}, {}};
  for (int point = 0; point < 64; ++point) {
    all.values.push_back(from_rational(all.format, point / 8));
    all.values.push_back(from_rational(all.format, point % 8));
  }
  const data::Table candidates = points(all.format, {"cx", "cy"}, 5, 8, 4, Special::none);
  const data::Comparisons comparisons =
      data::Comparisons::arg_min(all, candidates, design.inputs,
                                 workload::compare_by_reference(design.reference))
          .value();
  for (const int resets : {0, 3}) {
    using enum verilator_tb::TrafficKind;
    const auto report = simulate(design, comparisons,
                                 {.traffic = resets == 0 ? full_rate : stressed,
                                  .resets = resets,
                                  .truth = verilator_tb::TruthCheck{.graph = &graph}});
    expect_passed(report, 64, 5);
    EXPECT_EQ(report.undecided, 0u);
    EXPECT_GT(report.verdicts[1], 0u) << "no tie";
    EXPECT_EQ(report.truth->wrong_by_lane, 0u);
    EXPECT_EQ(report.arg_min->rows_unlike_reference, 0u);
  }
}

TEST(ArgMinSystemOf, IcarusSaysWhatVerilatorSays) {
  const design::Design design = nearest_point(2, 1);
  const data::Comparisons rows = data(design, 60, 3, 5);
  verilator_tb::VerifyOptions options{.traffic = verilator_tb::TrafficKind::stressed, .resets = 2};
  const verilator_tb::VerifyReport verilator = simulate(design, rows, options);
  options.simulator = verilator_tb::SimulatorKind::icarus;
  const verilator_tb::VerifyReport icarus = simulate(design, rows, options);
  expect_passed(icarus, 60, 3);
  EXPECT_EQ(icarus.simulator, "Icarus Verilog");
  EXPECT_EQ(icarus.verdicts, verilator.verdicts);
  EXPECT_EQ(icarus.cycles, verilator.cycles);
}

TEST(ArgMinSystemOf, MoreCandidatesThanItHoldsAreRefused) {
  const design::Design design = nearest_point(2, 1);
  const fs::path rtl = generate_to(design, "arg_min_too_many");
  const auto report =
      verilator_tb::verify(design, data(design, 9, 4, 20), verilator_tb::load_system(rtl).value(),
                           {.work_dir = test_work_dir("builds")});
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().field, "system.lanes");
  EXPECT_EQ(report.error().received, "4 candidates, 2 lanes");
}

/// One place in one template broken.
struct Fault {
  const char* name;
  const char* file;
  const char* from;
  const char* to;
};

class BrokenArgMin : public testing::TestWithParam<Fault> {};

TEST_P(BrokenArgMin, IsFoundOut) {
  const Fault& fault = GetParam();
  const design::Design design = nearest_point(2, 1);
  const fs::path rtl = generate_to(design, std::string("broken_arg_min_") + fault.name);
  std::ifstream in(rtl / fault.file);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t place = text.find(fault.from);
  ASSERT_NE(place, std::string::npos);
  std::ofstream(rtl / fault.file) << text.replace(place, std::string(fault.from).size(), fault.to);
  const auto report =
      verilator_tb::verify(design, data(design, 200, 3, 5), verilator_tb::load_system(rtl).value(),
                           {.work_dir = test_work_dir("builds"),
                            .traffic = verilator_tb::TrafficKind::stressed,
                            .hang_cycles = 2'000});
  ASSERT_TRUE(report.ok()) << report.error().to_string();
  EXPECT_FALSE(report->passed()) << to_text(*report);
}

INSTANTIATE_TEST_SUITE_P(
    Faults, BrokenArgMin,
    testing::Values(Fault{"ties", "mixcmp_arg_min_stage.v", "(result_verdict == GREATER)",
                          "(result_verdict != 2'b00)"},
                    Fault{"place", "mixcmp_arg_min_engine.v", "{next_word, next_place_q}",
                          "{next_word, free_place_q}"},
                    Fault{"operands", "mixcmp_operand_memory.v", "candidate_index : best",
                          "candidate_index : own"},
                    Fault{"row", "mixcmp_arg_min_engine.v", ".row_write      (!full)",
                          ".row_write      (1'b0)"},
                    Fault{"own", "mixcmp_arg_min_stage.v", "&& (index_q != OWN)", ""},
                    Fault{"short_load", "mixcmp_candidate_loader.v", "keep || repeated", "keep"},
                    Fault{"reload", "mixcmp_candidate_loader.v", "&& idle)", ")"},
                    Fault{"overrun", "mixcmp_candidate_loader.v", "(accept && all_sent)", "1'b0"}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace mixcmp::test::arg_min_test
