#include "model/design/design.hpp"

#include <gtest/gtest.h>

#include "model/base/number/decimal.hpp"
#include "model/base/number/exact.hpp"
#include "model/design/slots.hpp"
#include "model/judge/workload/compare_by_reference.hpp"
#include "model/plan/profile/profiled_error.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

namespace mixcmp::test::design_test {
namespace {

using data::Comparisons;
using design::Design;
using error::IntervalCriterion;
using scene::LaneGroupSpec;
using scene::Multipliers;
using scene::Scene;

/// The scene of a^2 against b^2 in s17e8, with every choice made.
Scene complete_scene() {
  Scene scene{.path = "squares.toml",
              .name = "squares",
              .graph = graph_of("a^2", "b^2"),
              .ranges = {std::nullopt, std::nullopt},
              .reference = {format_of(53, 8)}};
  scene.reduced.format = format_of(17, 8);
  scene.system.lanes = 8;
  scene.system.references = 0;
  return scene;
}

Error error_of(const Scene& scene) {
  const auto design = design::make_design(scene, nullptr);
  EXPECT_FALSE(design.ok());
  return design.ok() ? Error{} : design.error();
}

TEST(MakeDesign, CarriesWhatTheSceneChose) {
  const Design design = design::make_design(complete_scene(), nullptr).value();
  EXPECT_EQ(design.name, "squares");
  EXPECT_EQ(design.inputs, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(design.lane_count(), 8);
  EXPECT_EQ(design.reference_count(), 0);
  EXPECT_TRUE(design::is_certified(design.lanes.front().lane));
  EXPECT_EQ(design::float_lane(design.lanes.front().lane).graph.arithmetic.format,
            format_of(17, 8));
  EXPECT_EQ(design::float_lane(design.lanes.front().lane).graph.input_format, format_of(53, 8));
  EXPECT_EQ(design.reference.arithmetic.format, format_of(53, 8));
}

TEST(MakeDesign, KeepsTheTextsOfTheScene) {
  Scene scene = complete_scene();
  scene.parts = {{.f = "square", .g = "b^2"}};
  scene.lets = {{.name = "square", .text = "a^2"}};
  const Design design = design::make_design(scene, nullptr).value();
  ASSERT_EQ(design.parts.size(), 1u);
  EXPECT_EQ(design.parts[0].f, "square");
  EXPECT_EQ(design.parts[0].g, "b^2");
  ASSERT_EQ(design.lets.size(), 1u);
  EXPECT_EQ(design.lets[0].text, "a^2");
}

TEST(MakeDesign, RequestsHaveAsManyBeatsAsCostNoTime) {
  Scene scene = complete_scene();  // two operands of 61 bits
  scene.system.references = 1;
  const auto beats = [&](int interval) {
    scene.reference_structure.initiation_interval = interval;
    return design::make_design(scene, nullptr).value().system.request_beats;
  };
  EXPECT_EQ(beats(16), 1) << "in logic a multiplexer costs what the crossbar saves";
  scene.system.operand_memory = scene::OperandMemory::block;
  EXPECT_EQ(beats(1), 1);
  EXPECT_EQ(beats(3), 1);
  EXPECT_EQ(beats(4), 2);
  EXPECT_EQ(beats(15), 4);
  EXPECT_EQ(beats(64), 4) << "a beat has 16 bits or more of the operands";
  scene.system.request_beats = 8;
  EXPECT_EQ(beats(1), 8) << "whatever they cost";
  EXPECT_EQ(beats(16), 8);
  scene.reference_structure.initiation_interval = 15;
  EXPECT_EQ(error_of(scene).field, "system.request_beats");
  EXPECT_EQ(error_of(scene).accepted, "at most half of reference.initiation_interval = 15");
  scene.system.operands = scene::OperandStore::refetched;
  EXPECT_EQ(error_of(scene).accepted, "1, or operands = \"carried\"");
}

TEST(MakeDesign, NamesTheOptionForEachAuto) {
  Scene scene = complete_scene();
  scene.reduced.format.reset();
  EXPECT_EQ(error_of(scene).field, "reduced.format");
  EXPECT_NE(error_of(scene).accepted.find("--format s17e8"), std::string::npos);
  EXPECT_EQ(error_of(scene).file, "squares.toml");

  scene = complete_scene();
  scene.system.lanes.reset();
  EXPECT_EQ(error_of(scene).field, "system.lanes");
  EXPECT_NE(error_of(scene).accepted.find("--lanes 8"), std::string::npos);

  scene = complete_scene();
  scene.system.references.reset();
  EXPECT_EQ(error_of(scene).field, "system.references");
  EXPECT_NE(error_of(scene).accepted.find("--references 1"), std::string::npos);
}

TEST(MakeDesign, SaysThatOptimiseChoosesToo) {
  Scene scene = complete_scene();
  scene.path = "my scenes/squares.toml";
  scene.settings = {"system.slack=0.5", "reduced.bound=\"certified\""};
  scene.reduced.format.reset();
  EXPECT_NE(error_of(scene).accepted.find(
                "mixcmp optimise 'my scenes/squares.toml' --set system.slack=0.5 "
                "--set 'reduced.bound=\"certified\"' -o plan.toml"),
            std::string::npos)
      << error_of(scene).accepted;
}

LaneGroupSpec group_of(const Scene& scene, int count) {
  return {.count = count, .reduced = scene.reduced, .place = {"plan.toml", 7}};
}

TEST(MakeDesign, KeepsTheOrderOfGroups) {
  Scene scene = complete_scene();
  scene.lanes = {group_of(scene, 3), group_of(scene, 1), group_of(scene, 2)};
  scene.lanes[1].reduced.format = format_of(9, 8);
  scene.lanes[2].reduced.multipliers = Multipliers::logic;
  scene.references = {{.count = 1}, {.count = 2, .structure = {.multipliers = Multipliers::logic}}};
  const Design design = design::make_design(scene, nullptr).value();
  EXPECT_EQ(design.lane_count(), 6);
  EXPECT_EQ(design.reference_count(), 3);
  std::vector<std::size_t> groups;
  for (int lane = 0; lane < 6; ++lane) groups.push_back(design.group_of_lane(lane));
  EXPECT_EQ(groups, (std::vector<std::size_t>{0, 0, 0, 1, 2, 2}));
  EXPECT_EQ(design::float_lane(design.lanes[1].lane).graph.arithmetic.format, format_of(9, 8));
  EXPECT_EQ(lane_group_names(design),
            (std::vector<std::string>{"s17e8_embedded", "s9e8", "s17e8_logic"}));
  EXPECT_EQ(reference_group_names(design),
            (std::vector<std::string>{"s53e8_embedded", "s53e8_logic"}));
}

TEST(MakeDesign, NamesReferencesByTheirTargetsWhereTheseDiffer) {
  Scene scene = complete_scene();
  scene.references = {{.count = 1}, {.count = 1, .structure = {.target_mhz = 600}}};
  EXPECT_EQ(reference_group_names(design::make_design(scene, nullptr).value()),
            (std::vector<std::string>{"s53e8", "s53e8_600mhz"}));
  scene.references = {{.count = 2, .structure = {.target_mhz = 600}}};
  EXPECT_EQ(reference_group_names(design::make_design(scene, nullptr).value()),
            std::vector<std::string>{"s53e8"});
}

TEST(MakeDesign, NamesTheGroupThatCannotBe) {
  Scene scene = complete_scene();
  scene.lanes = {group_of(scene, 3), group_of(scene, 1)};
  scene.lanes[1].place.line = 12;
  scene.lanes[1].reduced.is_profiled = true;
  const Error error = error_of(scene);
  EXPECT_EQ(error.file, "plan.toml");
  EXPECT_EQ(error.line, 12);
  scene.lanes[1].reduced.format.reset();
  EXPECT_EQ(error_of(scene).field, "lanes.format");
  EXPECT_EQ(error_of(scene).line, 12);
}

TEST(MakeDesign, IsCertifiedOnlyIfAllLanesAre) {
  Scene scene = complete_scene();
  scene.lanes = {group_of(scene, 3), group_of(scene, 1)};
  EXPECT_TRUE(design::make_design(scene, nullptr)->certified());
  scene.lanes[1].reduced.is_profiled = true;
  scene.lanes[1].reduced.relative_error_f = scene.lanes[1].reduced.relative_error_g = 0;
  EXPECT_FALSE(design::make_design(scene, nullptr)->certified());
}

TEST(MakeDesign, LanesInLockStepComeInWholeGroups) {
  Scene scene = complete_scene();
  scene.system.lanes_per_group = 4;
  EXPECT_TRUE(design::make_design(scene, nullptr).ok());
  scene.system.lanes = 10;
  EXPECT_EQ(error_of(scene).to_string(),
            "squares.toml: system.lanes: lanes in lock step come in whole groups: received 10; "
            "accepted a multiple of system.lanes_per_group, 4");
  scene.lanes = {LaneGroupSpec{.count = 8, .reduced = scene.reduced},
                 {.count = 6, .reduced = scene.reduced, .place = {"squares.toml", 20}}};
  EXPECT_EQ(error_of(scene).to_string(),
            "squares.toml:20: lanes.count: lanes in lock step come in whole groups: received 6; "
            "accepted a multiple of system.lanes_per_group, 4");
}

TEST(MakeDesign, EachGroupOfLanesHasOneStreamOfReportsAtMost) {
  Scene scene = complete_scene();
  scene.system.engine = {.kind = scene::EngineKind::pairwise, .report_streams = 3};
  scene.system.lanes = 16;
  EXPECT_EQ(error_of(scene).to_string(),
            "squares.toml: engine.report_streams: each group of lanes has one at most: received 3; "
            "accepted 1..2, or more groups, by more lanes or a smaller engine.lanes_per_group than "
            "8");
  scene.system.lanes = 17;
  EXPECT_TRUE(design::make_design(scene, nullptr).ok());
  scene.lanes = {LaneGroupSpec{.count = 1, .reduced = scene.reduced},
                 {.count = 9, .reduced = scene.reduced}};
  EXPECT_TRUE(design::make_design(scene, nullptr).ok());
}

TEST(LaneGroupNames, SayWhatTellsLanesOfOneFormatApart) {
  Scene scene = complete_scene();
  scene.lanes = {group_of(scene, 1), group_of(scene, 1), group_of(scene, 1), group_of(scene, 1)};
  scene.lanes[1].reduced.error_bound = BoundKind::running;
  scene.lanes[2].reduced.inputs = LaneInputs::rounded;
  const Design design = design::make_design(scene, nullptr).value();
  EXPECT_EQ(lane_group_names(design),
            (std::vector<std::string>{"s17e8_exact_relative", "s17e8_exact_running_4",
                                      "s17e8_rounded_relative", "s17e8_exact_relative"}));
}

/// Inputs of the lane's number of digits are rounded ones, those of the reference's are exact ones.
TEST(LaneGroupNames, NameInputsByTheirDigitsWhereTheyAreNeitherRoundedNorExact) {
  Scene scene = complete_scene();
  scene.graph = graph_of("a * b", "b");
  for (const int digits : {17, 20, scene.reference.format.precision()}) {
    scene.lanes.push_back(group_of(scene, 1));
    scene.lanes.back().reduced.inputs = LaneInputs::of_digits(digits);
  }
  for (const LaneInputs inputs : {LaneInputs::rounded, LaneInputs::exact}) {
    scene.lanes.push_back(group_of(scene, 1));
    scene.lanes.back().reduced.inputs = inputs;
  }
  const Design design = design::make_design(scene, nullptr).value();
  EXPECT_EQ(lane_group_names(design),
            (std::vector<std::string>{"s17e8_rounded", "s17e8_inputs_20", "s17e8_exact",
                                      "s17e8_rounded", "s17e8_exact"}));
  EXPECT_EQ(design.lanes[0].lane, design.lanes[3].lane);
  EXPECT_EQ(design.lanes[2].lane, design.lanes[4].lane);
}

TEST(LaneGroupNames, TellProfiledLanesOfOtherErrorsApart) {
  Scene scene = complete_scene();
  scene.reduced.is_profiled = true;
  scene.reduced.relative_error_f = scene.reduced.relative_error_g = mpq_class(1, 8);
  scene.lanes = {group_of(scene, 1), group_of(scene, 1), group_of(scene, 1)};
  scene.lanes[1].reduced.relative_error_g = mpq_class(1, 4);
  const Design design = design::make_design(scene, nullptr).value();
  EXPECT_EQ(lane_group_names(design),
            (std::vector<std::string>{"s17e8_RE_1", "s17e8_RE_2", "s17e8_RE_1"}));
}

TEST(MakeDesign, UsesTheRangesOfTheScene) {
  Scene scene = complete_scene();
  scene.graph = graph_of("a * b + a^2", "b");
  scene.reduced.error_bound = BoundKind::relative;
  EXPECT_EQ(error_of(scene).field, "reduced.error_bound");
  scene.ranges = {Range{0, 1}, Range{0, 1}};
  EXPECT_TRUE(design::make_design(scene, nullptr).ok());
  scene.ranges = {Range{0, 1}, Range{-1, 1}};
  EXPECT_FALSE(design::make_design(scene, nullptr).ok());
}

TEST(MakeDesign, RefusesAConstantBoundBeyondEveryDifference) {
  Scene scene = complete_scene();
  scene.graph = graph_of("a - b", "0.001 * a");
  scene.reduced.inputs = LaneInputs::rounded;
  scene.reduced.error_bound = BoundKind::constant;
  scene.ranges = {Range{900, 901}, Range{900, 901}};
  scene.reduced.format = format_of(4, 8);
  EXPECT_NE(error_of(scene).message.find("exceeds every difference"), std::string::npos);
  scene.reduced.format = format_of(30, 8);
  EXPECT_TRUE(design::make_design(scene, nullptr).ok());
}

TEST(MakeDesign, NeedsConstantsOrDataForAProfiledBound) {
  Scene scene = complete_scene();
  scene.reduced.is_profiled = true;
  EXPECT_NE(error_of(scene).field.find("relative_error_f"), std::string::npos);
  scene.reduced.relative_error_f = mpq_class(1, 1000);
  EXPECT_FALSE(design::make_design(scene, nullptr).ok());
  scene.reduced.relative_error_g = mpq_class(1, 2000);
  const Design design = design::make_design(scene, nullptr).value();
  const auto& criterion = std::get<IntervalCriterion>(
      design::float_lane(design.lanes.front().lane).parts.front().criterion);
  EXPECT_EQ(criterion.relative_error_f, mpq_class(1, 1000));
  EXPECT_EQ(criterion.relative_error_g, mpq_class(1, 2000));
}

TEST(MakeDesign, RefusesALaneThatCouldNeverDecide) {
  Scene scene = complete_scene();
  const std::string fourth = "((a^16)^16)";
  scene.graph = graph_of(fourth, "b");
  scene.reduced.format = format_of(4, 2);
  const Error error = error_of(scene);
  EXPECT_EQ(error.field, "reduced.format");
  EXPECT_EQ(error.received, "s4e2");
  scene.reduced.format = format_of(17, 8);
  EXPECT_TRUE(design::make_design(scene, nullptr).ok());
}

TEST(MakeDesign, TakesALaneThatIsOnlyEverCertainOfOneVerdict) {
  Scene scene = complete_scene();
  scene.graph = graph_of("a^2", "(b + 5)^2");
  scene.ranges = {Range{0, 1}, Range{0, 1}};
  scene.reduced.format.reset();
  scene.reduced.fixed_point = FixedPoint{13};
  const auto less = design::make_design(scene, nullptr);
  EXPECT_TRUE(less.ok());
  scene.graph = graph_of("(b + 5)^2", "a^2");
  EXPECT_TRUE(design::make_design(scene, nullptr).ok());
}

/// The scene of squares, in fixed point.
Scene fixed_scene() {
  Scene scene = complete_scene();
  scene.reduced.format.reset();
  scene.reduced.fixed_point = FixedPoint{13};
  scene.ranges = {Range{0, 4}, Range{0, 4}};
  return scene;
}

TEST(MakeDesign, HasLanesInFixedPoint) {
  Scene scene = fixed_scene();
  scene.reduced.inputs = LaneInputs::rounded;
  const Design design = design::make_design(scene, nullptr).value();
  EXPECT_EQ(design.lanes.front().inputs, LaneInputs::exact) << "inputs are those of floats";
  EXPECT_TRUE(design.certified());
  EXPECT_EQ(design::format_name(design.lanes.front().lane), "q13");
  EXPECT_EQ(lane_group_names(design), (std::vector<std::string>{"q13"}));
}

/// A reference for operands in fixed point is the exact lane of the fewest bits.
TEST(MakeDesign, ReferencesOfIntegersAreExactLanes) {
  Scene scene = fixed_scene();
  scene.operand_formats.assign(scene.graph.inputs().size(), *OperandFormat::parse("uint9"));
  scene.ranges.assign(scene.graph.inputs().size(), Range{0, 511});
  scene.grids.assign(scene.graph.inputs().size(), mpq_class(1));
  scene.reduced.fixed_point = FixedPoint{.bits = 5};
  EXPECT_FALSE(design::make_design(scene, nullptr)->fixed_reference.has_value());
  scene.system.references = 2;
  const Design design = design::make_design(scene, nullptr).value();
  ASSERT_TRUE(design.fixed_reference.has_value());
  EXPECT_TRUE(fixed::is_exact(*design.fixed_reference));
  EXPECT_EQ(design.fixed_reference->format.bits, 9);
  EXPECT_EQ(reference_group_names(design), std::vector<std::string>{"q9"});
  ASSERT_EQ(named_lanes(design).size(), 2u);
  EXPECT_EQ(named_lanes(design).back().name, "reference_q9");
  EXPECT_TRUE(design::is_certified(named_lanes(design).back().lane));
  EXPECT_EQ(design::datapath_format(scene).name(), "q9");
  scene.reference.format = format_of(17, 8);
  EXPECT_EQ(error_of(scene).field, "reference.format") << "squares have 18 digits";
  scene.reference.format = format_of(18, 8);
  EXPECT_TRUE(design::make_design(scene, nullptr).ok());
  scene.graph = graph_of("sqrt(a)", "b");
  EXPECT_EQ(error_of(scene).to_string(),
            "squares.toml: system.references: a reference for operands in fixed point is an exact "
            "lane: square "
            "roots are rounded: received sqrt in f or g; accepted the squares of both sides, or 0 "
            "references");
  scene.operand_formats[1] = OperandFormat(format_of(24, 8));
  EXPECT_FALSE(design::make_design(scene, nullptr)->fixed_reference.has_value())
      << "an operand in floating point has references in floating point";
}

/// Judges of an engine without references ask one which pairs are reported, and none in floating
/// point has functions.
TEST(MakeDesign, KnowsTheRoundingReferenceOfASystemWithout) {
  Scene scene = fixed_scene();
  scene.graph = graph_of("exp(a)", "b");
  scene.reference_fixed_point = FixedPoint{20};
  scene.system.references = 0;
  const Design design = design::make_design(scene, nullptr).value();
  EXPECT_TRUE(design.references.empty());
  ASSERT_NE(design.requested_reference(), nullptr);
  EXPECT_EQ(design.requested_reference()->format.bits, 20);
  EXPECT_EQ(named_lanes(design).size(), 1u);
}

TEST(MakeDesign, RefusesWhatFixedPointHasNot) {
  Scene scene = fixed_scene();
  scene.ranges[1].reset();
  EXPECT_EQ(error_of(scene).field, "inputs.b.range");
  scene = fixed_scene();
  scene.reduced.is_profiled = true;
  EXPECT_EQ(error_of(scene).field, "reduced.bound");
  scene = fixed_scene();
  scene.reduced.error_bound = BoundKind::relative;
  EXPECT_EQ(error_of(scene).field, "reduced.error_bound");
  scene.reduced.error_bound = BoundKind::running;
  scene.graph = graph_of("a - b", "b");
  EXPECT_EQ(error_of(scene).field, "reduced.error_bound") << "nothing is multiplied";
  scene.graph = graph_of("(a - b)^2", "b");
  EXPECT_TRUE(design::make_design(scene, nullptr).ok());
  scene = complete_scene();
  scene.reduced.error_bound = BoundKind::norm;
  EXPECT_EQ(error_of(scene).field, "reduced.error_bound");
}

/// The squares of q14 have magnitudes of 14 and 15 bits.
TEST(MakeDesign, RefusesMemoriesOfSquaresThatAreTooWide) {
  Scene scene = fixed_scene();
  scene.graph = graph_of("(a - b)^2", "(a + b)^2");
  scene.reduced.multipliers = Multipliers::memory;
  EXPECT_TRUE(design::make_design(scene, nullptr).ok());
  scene.reduced.fixed_point = FixedPoint{14};
  const Error error = error_of(scene);
  EXPECT_EQ(error.field, "reduced.multipliers");
  EXPECT_EQ(error.received, "\"memory\", where q14 squares magnitudes of 15 bits");
  EXPECT_NE(error.accepted.find("at most 14"), std::string::npos) << error.accepted;
  scene.lanes = {{.count = 1, .reduced = scene.reduced, .place = {"scene.toml", 7}}};
  EXPECT_EQ(error_of(scene).field, "lanes.multipliers");
  EXPECT_EQ(error_of(scene).line, 7);
}

TEST(MakeDesign, RefusesALaneInFixedPointThatCouldNeverDecide) {
  Scene scene = fixed_scene();
  scene.graph = graph_of("a^8", "b^8");
  scene.reduced.fixed_point = FixedPoint{2};
  scene.reduced.error_bound = BoundKind::constant;
  EXPECT_NE(error_of(scene).message.find("exceeds every difference"), std::string::npos);
  EXPECT_EQ(error_of(scene).received, "q2");
}

TEST(LaneGroupNames, TellLanesInFixedPointApart) {
  Scene scene = fixed_scene();
  LaneGroupSpec norm{.count = 1, .reduced = scene.reduced, .place = {}};
  LaneGroupSpec constant = norm;
  constant.reduced.error_bound = BoundKind::constant;
  scene.lanes = {norm, constant};
  EXPECT_EQ(lane_group_names(design::make_design(scene, nullptr).value()),
            (std::vector<std::string>{"q13_norm", "q13_constant"}));
}

TEST(MakeDesign, RefusesAProfileOfNothing) {
  Scene scene = complete_scene();
  scene.reduced.is_profiled = true;
  data::Table table{.format = format_of(53, 8), .columns = {"a", "b"}};
  table.values = {table.format.quiet_nan(), table.format.infinity(false)};
  const Comparisons data = Comparisons::rows(std::move(table), {"a", "b"}).value();
  const auto design = design::make_design(scene, &data, profile::profile_error);
  ASSERT_FALSE(design.ok());
  EXPECT_EQ(design.error().field, "reduced.bound");
  EXPECT_NE(design.error().received.find("1 comparisons"), std::string::npos);
}

TEST(MakeDesign, RefusesConstantsThatNoComparisonTells) {
  Scene scene = complete_scene();
  scene.reduced.is_profiled = true;
  scene.reduced.format = format_of(17, 5);
  data::Table table{.format = format_of(53, 8), .columns = {"a", "b"}};
  for (const char* value : {"1e30", "1e30"}) {
    table.values.push_back(from_text(table.format, value).value());
  }
  const Comparisons data = Comparisons::rows(std::move(table), {"a", "b"}).value();
  const auto design = design::make_design(scene, &data, profile::profile_error);
  ASSERT_FALSE(design.ok());
  EXPECT_EQ(design.error().field, "reduced.relative_error_f");
}

TEST(MakeDesign, MeasuresMissingConstantsOnData) {
  Scene scene = complete_scene();
  scene.reduced.is_profiled = true;
  scene.reduced.relative_error_g = mpq_class(1, 2000);
  data::Table table{.format = format_of(53, 8), .columns = {"a", "b"}};
  for (const char* value : {"0.1", "0.3"}) {
    table.values.push_back(from_text(table.format, value).value());
  }
  const Comparisons data = Comparisons::rows(std::move(table), {"a", "b"}).value();
  const Design design = design::make_design(scene, &data, profile::profile_error).value();
  const auto& criterion = std::get<IntervalCriterion>(
      design::float_lane(design.lanes.front().lane).parts.front().criterion);
  EXPECT_GT(criterion.relative_error_f, 0);
  EXPECT_LT(criterion.relative_error_f, mpq_class(1, 1 << 17));
  EXPECT_EQ(criterion.relative_error_g, mpq_class(1, 2000));
}

/// A table with one column, whose numbers are 0, 1, 2, ...
data::Table line(const char* column, std::uint64_t count) {
  data::Table table{.format = format_of(53, 8), .columns = {column}};
  for (std::uint64_t k = 0; k < count; ++k) {
    table.values.push_back(from_rational(table.format, k));
  }
  return table;
}

/// Comparisons of points on a line. f and g are the squared distances of a row from two candidates.
Comparisons points(const Scene& scene, std::uint64_t candidates) {
  const auto reference = reference_graph(scene.graph, scene.reference);
  return Comparisons::arg_min(line("p", 1), line("c", candidates), scene.graph.inputs(),
                              workload::compare_by_reference(reference))
      .value();
}

TEST(MakeDesign, AChainHasALaneForEachCandidateOfTheDataButTheFirst) {
  Scene scene = complete_scene();
  scene.graph = graph_of("(p - ci)^2", "(p - cj)^2");
  scene.ranges.assign(3, std::nullopt);
  scene.system = with_engine(scene.system, {.kind = scene::EngineKind::arg_min});
  scene.system.lanes.reset();
  scene.system.references = 1;
  const Comparisons few = points(scene, 7), most = points(scene, 513), many = points(scene, 514);
  EXPECT_EQ(design::make_design(scene, &few)->lane_count(), 6);
  EXPECT_EQ(design::make_design(scene, &most)->lane_count(), 512);
  const auto refused = design::make_design(scene, &many);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().field, "system.lanes");
  EXPECT_EQ(refused.error().received, "514 candidates");
  EXPECT_EQ(error_of(scene).field, "system.lanes");
  EXPECT_EQ(error_of(scene).message.find("optimise"), std::string::npos);
  scene.system.lanes = 8;  // the chain could compare two candidates more
  EXPECT_EQ(design::make_design(scene, &few)->lane_count(), 8);
  scene.system.lanes = 6;
  EXPECT_TRUE(design::make_design(scene, &few).ok());
  scene.system.lanes = 5;
  const auto short_chain = design::make_design(scene, &few);
  ASSERT_FALSE(short_chain.ok());
  EXPECT_EQ(short_chain.error().field, "system.lanes");
  EXPECT_EQ(short_chain.error().received, "7 candidates, 5 lanes");
  EXPECT_TRUE(design::make_design(scene, nullptr).ok());
}

TEST(MakeDesign, APairwiseEngineHoldsAllItemsOfTheData) {
  Scene scene = complete_scene();
  scene.graph = graph_of("pi", "pj");
  scene.system = with_engine(scene.system, {.kind = scene::EngineKind::pairwise, .capacity = 4});
  const Comparisons four = Comparisons::all_pairs(line("p", 4), scene.graph.inputs()).value();
  const Comparisons five = Comparisons::all_pairs(line("p", 5), scene.graph.inputs()).value();
  EXPECT_TRUE(design::make_design(scene, &four).ok());
  const auto refused = design::make_design(scene, &five);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().field, "engine.capacity");
  EXPECT_EQ(refused.error().received, "5 items, a capacity of 4");
}

/// A queue with half of the beats would have room for fewer.
TEST(SegmentQueue, HasRoomForABurstBesidesWhatMayStillCome) {
  for (int latency = 0; latency <= 70; ++latency) {
    const int bits = design::segment_queue_bits(latency);
    EXPECT_GE(design::beats_before_stop(bits, latency), 16) << latency;
    EXPECT_LT(design::beats_before_stop(bits - 1, latency), 16) << latency;
    EXPECT_LE(design::tier_queue_bits(latency), bits) << latency;
  }
  EXPECT_EQ(design::segment_queue_bits(13), 5);
  EXPECT_EQ(design::segment_queue_bits(14), 6);
}

}  // namespace
}  // namespace mixcmp::test::design_test
