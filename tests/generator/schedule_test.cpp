#include "generator/hardware/datapath/schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "generator/hardware/datapath/delays.hpp"
#include "generator/hardware/datapath/embedded_square.hpp"
#include "generator/hardware/datapath/scheduler.hpp"
#include "generator/hardware/datapath/squared_sum.hpp"
#include "generator/hardware/datapath/stage_list.hpp"
#include "model/comparison/expression/parser.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/sphere.hpp"

namespace mixcmp::test::schedule_test {
namespace {

constexpr double targets_mhz[] = {1, 50, 150, 250, 400, 600, 2000};

/// The delays of a unit's stages, and the masks of cuts that its template allows.
class Stages {
public:
  explicit Stages(const datapath::Unit& unit) : stages_(unit.stages) {}

  int count() const { return static_cast<int>(stages_.size()); }

  double longest_path_ns(unsigned cuts) const {
    double longest = 0;
    for (int k = 0; k < count(); ++k) {
      for (int chain = 0; chain < chains(k); ++chain) {
        longest = std::max(longest, ready_ns(cuts, k, chain));
      }
    }
    return longest;
  }

  /// Whether each cut that needs another cut has it.
  bool has_needed(unsigned cuts) const {
    for (int k = 0; k < count(); ++k) {
      const int needed = stages_[k].cut_needs;
      if (is_cut(cuts, k) && needed >= 0 && !is_cut(cuts, needed)) return false;
    }
    return true;
  }

  int halved_sums(unsigned cuts) const {
    int halved = 0;
    for (int k = 1; k < count(); ++k) halved += stages_[k].is_upper_half && is_cut(cuts, k - 1);
    return halved;
  }

private:
  static bool is_cut(unsigned cuts, int stage) { return (cuts >> stage & 1) != 0; }

  int chains(int stage) const {
    return std::max(1, static_cast<int>(stages_[stage].chains.size()));
  }

  /// How long after the last register the result of a chain of a stage is there.
  double ready_ns(unsigned cuts, int k, int chain) const {
    const datapath::Stage& stage = stages_[k];
    const auto [delay_ns, overlap_ns] = stage.chains.empty()
                                            ? datapath::ChainDelay{stage.delay_ns, stage.overlap_ns}
                                            : stage.chains[chain];
    if (k == 0 || is_cut(cuts, k - 1)) return delay_ns;
    double before = 0;
    const bool joins = stage.forks || chains(k) != chains(k - 1);
    for (int other = 0; other < chains(k - 1); ++other) {
      if (joins || other == chain) before = std::max(before, ready_ns(cuts, k - 1, other));
    }
    return before + delay_ns - overlap_ns;
  }

  std::vector<datapath::Stage> stages_;
};

unsigned mask_of(const std::vector<bool>& cuts) {
  unsigned mask = 0;
  for (std::size_t k = 0; k < cuts.size(); ++k) mask |= static_cast<unsigned>(cuts[k]) << k;
  return mask;
}

double longest_path_ns(const datapath::Step& step) {
  return Stages(step.unit).longest_path_ns(mask_of(step.cuts));
}

int halved_sums(const datapath::Step& step) {
  return Stages(step.unit).halved_sums(mask_of(step.cuts));
}

double slowest_stage_ns(const datapath::Unit& unit) {
  double slowest = 0;
  for (const datapath::Stage& stage : unit.stages) slowest = std::max(slowest, stage.delay_ns);
  return slowest;
}

int registers(const std::vector<bool>& cuts) {
  return static_cast<int>(std::count(cuts.begin(), cuts.end(), true));
}

/// The fewest registers, the last included, that leave no path over `limit_ns`, and the fewest sums
/// in halves at that number of registers. Tries every mask.
std::pair<int, int> fewest_cuts(const datapath::Unit& unit, double limit_ns) {
  const Stages stages(unit);
  const unsigned last = 1u << (stages.count() - 1);
  std::pair<int, int> fewest = {stages.count() + 1, 0};
  for (unsigned cuts = last; cuts < 2 * last; ++cuts) {
    if (std::popcount(cuts) > fewest.first) continue;
    const std::pair numbers = {std::popcount(cuts), stages.halved_sums(cuts)};
    if (numbers < fewest && stages.longest_path_ns(cuts) <= limit_ns && stages.has_needed(cuts)) {
      fewest = numbers;
    }
  }
  return fewest;
}

class ScheduleAtTarget : public testing::TestWithParam<double> {
protected:
  design::Design design_ = sphere_design(format("s17e8"), format("s53e8"), 1, 1);
  datapath::DelayTable delays_ = datapath::delays_of("virtex6-lx760").value();
};

TEST_P(ScheduleAtTarget, OperandsAreReadyBeforeTheyAreRead) {
  const datapath::Schedule schedule =
      datapath::schedule_lane(design::float_lane(design_.lanes.front().lane),
                              scene::Multipliers::embedded, delays_, GetParam());
  const auto& nodes = design::float_lane(design_.lanes.front().lane).graph.nodes;
  ASSERT_EQ(schedule.steps.size(), nodes.size());
  for (std::size_t id = 0; id < nodes.size(); ++id) {
    int latest = 0;
    for (int k = 0; k < arity(nodes[id].operation); ++k) {
      latest = std::max(latest, schedule.steps[nodes[id].operands[k]].ready_cycle);
    }
    EXPECT_EQ(schedule.steps[id].start_cycle, latest) << "node " << id;
  }
  EXPECT_EQ(schedule.latency_cycles, schedule.parts.front().decision.ready_cycle);
}

TEST_P(ScheduleAtTarget, LatencyOfAUnitIsTheNumberOfItsRegisters) {
  const datapath::Schedule schedule =
      datapath::schedule_reference(design_.reference, {}, delays_, GetParam());
  for (const datapath::Step& step : schedule.steps) {
    EXPECT_EQ(step.ready_cycle - step.start_cycle, registers(step.cuts));
  }
}

class CutsOfProducts : public testing::TestWithParam<std::tuple<double, scene::Multipliers>> {
protected:
  design::Design design_ = sphere_design(format("s17e8"), format("s53e8"), 1, 1);
  datapath::DelayTable delays_ = datapath::delays_of("virtex6-lx760").value();
};

TEST_P(CutsOfProducts, AreTheFewestThatMeetThePeriodAndTheOutputIsRegistered) {
  const auto [target_mhz, multipliers] = GetParam();
  const double logic_ns = std::max(0.0, 1000 / target_mhz - delays_.register_ns);
  const datapath::Schedule schedule = datapath::schedule_lane(
      design::float_lane(design_.lanes.front().lane), multipliers, delays_, target_mhz);
  for (const datapath::Step& step : schedule.steps) {
    if (step.unit.module.empty()) continue;
    EXPECT_TRUE(step.cuts.back()) << step.unit.module;
    if (slowest_stage_ns(step.unit) <= logic_ns) {
      EXPECT_LE(longest_path_ns(step), logic_ns) << step.unit.module;
      EXPECT_EQ(std::pair(registers(step.cuts), halved_sums(step)),
                fewest_cuts(step.unit, logic_ns))
          << step.unit.module;
    } else {
      EXPECT_FALSE(schedule.slow_stages.empty()) << step.unit.module;
    }
  }
}

/// Whether a product of multipliers has a cut between two rows only with a cut behind the
/// multipliers.
bool rows_wait_for_multipliers(const datapath::Step& step, int rows) {
  const auto& stages = step.unit.stages;
  const auto multiply =
      std::find_if(stages.begin(), stages.end(),
                   [](const datapath::Stage& stage) { return stage.name == "multiply"; }) -
      stages.begin();
  bool cut_between_rows = false;
  for (int row = 0; row < std::min(rows - 1, 4); ++row) {
    cut_between_rows |= step.cuts[static_cast<std::size_t>(multiply + 1 + row)];
  }
  return !cut_between_rows || step.cuts[static_cast<std::size_t>(multiply)];
}

/// Behind a cut between rows an unregistered multiplier would share a cycle with its adder. The
/// four squares are alike, so one search for the fewest cuts serves all of them.
TEST_P(ScheduleAtTarget, RowsOfMultipliersAreCutBehindRegisteredMultipliers) {
  for (const char* device : {"virtex6-lx760", "ecp5-85k", "ice40-up5k"}) {
    const datapath::DelayTable delays = datapath::delays_of(device).value();
    const double logic_ns = std::max(0.0, 1000 / GetParam() - delays.register_ns);
    const datapath::Schedule schedule =
        datapath::schedule_reference(design_.reference, {}, delays, GetParam());
    std::vector<datapath::Step> squares;
    for (const datapath::Step& step : schedule.steps) {
      if (step.unit.module == "fp_squared_sum") squares.push_back(step);
    }
    ASSERT_EQ(squares.size(), 4u) << device;
    for (const datapath::Step& step : squares) {
      EXPECT_EQ(step.cuts, squares.front().cuts) << device;
      const int rows = (53 + delays.multiplier_size.b_bits - 1) / delays.multiplier_size.b_bits;
      EXPECT_TRUE(rows_wait_for_multipliers(step, rows)) << device;
      if (slowest_stage_ns(step.unit) > logic_ns) continue;
      EXPECT_LE(longest_path_ns(step), logic_ns) << device;
    }
    const datapath::Step& first = squares.front();
    if (slowest_stage_ns(first.unit) > logic_ns) continue;
    EXPECT_EQ(std::pair(registers(first.cuts), halved_sums(first)),
              fewest_cuts(first.unit, logic_ns))
        << device;
  }
}

/// A lane's checks and bounds, which run beside its values, are ready when they are read, and the
/// decision waits for all of them.
TEST_P(ScheduleAtTarget, BoundsFollowTheirOperandsAndPrecedeTheDecision) {
  const Graph graph = test::sphere_graph();
  const error::Lane lane =
      error::certified_lane(
          lane_graph(graph, format("s53e8"), {format("s17e8")}, LaneInputs::rounded),
          {.kind = BoundKind::running,
           .ranges = std::vector<std::optional<Range>>(8, Range{0, 100})})
          .value();
  const auto& criterion = std::get<error::AbsoluteBoundCriterion>(lane.criterion());
  const datapath::Schedule schedule =
      datapath::schedule_lane(lane, scene::Multipliers::embedded, delays_, GetParam());
  ASSERT_EQ(schedule.parts.front().bounds.size(), criterion.bound.nodes.size());
  ASSERT_EQ(schedule.checks.size(), 8u);
  for (std::size_t id = 0; id < criterion.bound.nodes.size(); ++id) {
    const error::BoundNode& node = criterion.bound.nodes[id];
    int latest = node.value >= 0 ? schedule.steps[node.value].ready_cycle : 0;
    for (int k = 0; k < error::arity(node.operation); ++k) {
      latest = std::max(latest, schedule.parts.front().bounds[node.operands[k]].ready_cycle);
    }
    EXPECT_EQ(schedule.parts.front().bounds[id].start_cycle, latest) << "bound node " << id;
  }
  EXPECT_GE(schedule.parts.front().decision.start_cycle,
            schedule.parts.front().bounds.back().ready_cycle);
  EXPECT_GE(schedule.parts.front().decision.start_cycle,
            schedule.steps[criterion.difference].ready_cycle);
  for (const datapath::Step& check : schedule.checks) {
    EXPECT_EQ(check.unit.module, "fp_range_check");
    EXPECT_GE(schedule.parts.front().decision.start_cycle, check.ready_cycle);
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, ScheduleAtTarget, testing::ValuesIn(targets_mhz));
INSTANTIATE_TEST_SUITE_P(Targets, CutsOfProducts,
                         testing::Combine(testing::ValuesIn(targets_mhz),
                                          testing::Values(scene::Multipliers::embedded,
                                                          scene::Multipliers::logic)));

/// At any target the memory is read into a register and the result is registered.
TEST(Schedule, SquaresFromMemoriesHaveTheirRegisters) {
  const Graph graph = sphere_graph();
  const fixed::FixedOptions options = {
      .format = {11}, .ranges = {graph.inputs().size(), std::optional(Range{0, 100})}};
  const auto lane = fixed::fixed_lane(graph, format("s53e8"), options).value();
  for (const char* device : {"virtex6-lx760", "ice40-hx8k"}) {
    const datapath::DelayTable delays = datapath::delays_of(device).value();
    for (const double target : targets_mhz) {
      const auto schedule =
          datapath::schedule_lane(lane, scene::Multipliers::memory, delays, target);
      const bool two_ports = delays.memory_block.read_ports == 2;
      ASSERT_EQ(schedule.square_tables.size(), two_ports ? 2u : 4u);
      for (const fixed::SquareTable& table : schedule.square_tables) {
        for (const NodeId square : table.squares) {
          const datapath::Step& step = schedule.steps[square];
          EXPECT_EQ(step.unit.module, two_ports ? "fixed_memory_squares" : "fixed_memory_square");
          ASSERT_EQ(step.cuts.size(), 3u);
          EXPECT_TRUE(step.cuts[1] && step.cuts[2]) << target;
          EXPECT_EQ(step.cuts, schedule.steps[table.squares[0]].cuts) << "one mask a unit";
          EXPECT_EQ(step.ready_cycle - step.start_cycle, registers(step.cuts));
        }
      }
    }
  }
}

/// Chains that follow each other without a register run at the same time.
TEST(Schedule, NoRegisterIsBoughtForChainsThatOverlap) {
  const datapath::DelayTable delays = {.lut_ns = 1,
                                       .carry_start_ns = 1,
                                       .carry_ns_per_bit = 0.1,
                                       .multiplier_ns = 1,
                                       .multiplier_add_ns = 1,
                                       .register_ns = 0};
  const TypedNode node{.operation = Operation::multiply,
                       .operand_format = format("s24e8"),
                       .format = format("s24e8")};
  const datapath::Unit unit =
      datapath::unit_for(node, Subnormals::flush, {}, scene::Multipliers::logic, delays);
  ASSERT_EQ(unit.stages.size(), 15u);
  ASSERT_EQ(unit.stages[3].name, "level 0");
  // Rows of 30 bits, two bits apart: a LUT, then three chains that each start once the one before
  // has passed two bits.
  const auto first = unit.stages.begin() + 3;
  const datapath::Step levels = {.unit = {.module = {}, .stages = {first, first + 3}},
                                 .cuts = {false, false, false}};
  EXPECT_DOUBLE_EQ(longest_path_ns(levels), 1 + 3 * 1 + (30 + 2 + 2) * 0.1);
  // 13 rows: four sums of four or less, two, one.
  EXPECT_GT(unit.stages[7].delay_ns, 0);
  EXPECT_EQ(unit.stages[8].delay_ns, 0);
  EXPECT_EQ(unit.stages[9].delay_ns, 0);
}

/// The one multiplication of `text`, in s24e8 with subnormals.
struct Product {
  TypedGraph graph;
  const TypedNode& node() const {
    return *std::find_if(graph.nodes.begin(), graph.nodes.end(), [](const auto& candidate) {
      return candidate.operation == Operation::multiply;
    });
  }
};

Product product(const std::string& text) {
  Graph graph;
  const NodeId f = *parse_expression(graph, text, {});
  graph.compare(f, *parse_expression(graph, "y", {}));
  return {reference_graph(graph, {format("s24e8")})};
}

TEST(Schedule, AProductWithAPowerOfTwoTakesNoMultiplier) {
  const datapath::DelayTable delays = datapath::delays_of("virtex6-lx760").value();
  struct Case {
    const char* text;
    int exponent;
    bool negated = false;
  };
  // The constant of the last three is a subnormal number.
  const std::vector<Case> scalings = {{"x * 0.25", -2},
                                      {"8 * x", 3},
                                      {"x / 16", -4},
                                      {"x * 1", 0},
                                      {"x * 0x1p-126", -126},
                                      {"x * -0.5", -1, true},
                                      {"x / -4", -2, true},
                                      {"-x * 2", 1},
                                      {"x * 0x1p-127", -127},
                                      {"x * 0x1p-149", -149},
                                      {"x / -0x1p127", -127, true}};
  for (const auto& [text, exponent, negated] : scalings) {
    const Product scaled = product(text);
    const auto scaling = datapath::scaling_of(scaled.graph, scaled.node());
    ASSERT_TRUE(scaling) << text;
    EXPECT_EQ(scaling->exponent, exponent) << text;
    EXPECT_EQ(scaling->negated, negated) << text;
    EXPECT_NE(scaled.graph.nodes[static_cast<std::size_t>(scaling->operand)].operation,
              Operation::constant);
    const datapath::Unit unit =
        datapath::unit_for(scaled.graph, scaled.node(), {}, scene::Multipliers::embedded, delays);
    EXPECT_EQ(unit.module, "fp_convert");
    EXPECT_EQ(unit.stages.size(), 6u);
  }
  for (const char* text : {"x * 3", "x * -0.75", "x * y", "x * 0", "x * 0x1.8p-127"}) {
    const Product plain = product(text);
    EXPECT_FALSE(datapath::scaling_of(plain.graph, plain.node())) << text;
    const datapath::Unit unit =
        datapath::unit_for(plain.graph, plain.node(), {}, scene::Multipliers::embedded, delays);
    EXPECT_EQ(unit.module, "fp_multiply") << text;
  }
}

/// A sum that something else reads has to be rounded and packed for that.
TEST(Schedule, ASumThatOnlyItsSquareReadsSharesItsUnit) {
  const datapath::DelayTable delays = datapath::delays_of("virtex6-lx760").value();
  const auto units = [&](const std::string& text, int initiation_interval = 1) {
    const Product squared = product(text);
    const datapath::Schedule schedule = datapath::schedule_reference(
        squared.graph, {.initiation_interval = initiation_interval}, delays, 200);
    std::vector<std::string> modules;
    for (const datapath::Step& step : schedule.steps) {
      if (!step.unit.module.empty()) modules.push_back(step.unit.module);
    }
    return modules;
  };
  using Modules = std::vector<std::string>;
  EXPECT_EQ(units("(x - y)^2"), Modules({"fp_squared_sum"}));
  EXPECT_EQ(units("(x + y)^2"), Modules({"fp_squared_sum"}));
  EXPECT_EQ(units("(x * y)^2"), Modules({"fp_multiply", "fp_square"}));
  EXPECT_EQ(units("(x + y)^2 * (x + y)"), Modules({"fp_add", "fp_square", "fp_multiply"}));
  EXPECT_EQ(units("(x - y)^2", 2), Modules({"fp_add", "fp_square"}));

  const auto fused = [&](const std::string& f, const std::string& g) {
    const TypedGraph reference =
        reference_graph(test::graph_of(f, g), {.format = format("s24e8"), .sums = Sums::fused});
    std::vector<std::string> modules;
    const datapath::Schedule schedule = datapath::schedule_reference(reference, {}, delays, 200);
    for (const datapath::Step& step : schedule.steps) {
      if (!step.unit.module.empty()) modules.push_back(step.unit.module);
    }
    modules.push_back(schedule.parts[0].decision.unit.module);
    return modules;
  };
  EXPECT_EQ(fused("(x - y)^2 + (x + y)^2", "z"), Modules({"fp_fused_comparison"}));
  EXPECT_EQ(fused("(x - y)^2 + (x + y) * y", "z"), Modules({"fp_add", "fp_fused_comparison"}));
  EXPECT_EQ(fused("sqrt((x - y)^2 + x^2)", "z"),
            Modules({"fp_fused_sum", "fp_square_root", "fp_compare"}));
  EXPECT_EQ(fused("(x - y)^2 + (x - y) * y", "z"), Modules({"fp_add", "fp_fused_comparison"}));

  Graph graph;  // the sum is itself a side of the comparison
  const NodeId sum = *parse_expression(graph, "x - y", {});
  graph.compare(sum, *parse_expression(graph, "(x - y)^2", {}));
  const TypedGraph reference = reference_graph(graph, {format("s24e8")});
  EXPECT_FALSE(datapath::squared_sum_of(reference, reference.g()));
}

/// Synthesis removes such a product but for the handling of special values.
TEST(Schedule, AProductWithZeroTakesNoTime) {
  const datapath::DelayTable delays = datapath::delays_of("virtex6-lx760").value();
  const auto latency = [&](const std::string& text, scene::Multipliers multipliers) {
    return datapath::schedule_reference(product(text).graph, {multipliers}, delays, 200)
        .latency_cycles;
  };
  for (const auto multipliers : {scene::Multipliers::embedded, scene::Multipliers::logic}) {
    EXPECT_LE(latency("x * 0", multipliers), 2);
    EXPECT_GT(latency("x * 3", multipliers), 4);
  }
}

/// A square by its symmetry is taken where it has fewer multipliers than the parts of a product.
TEST(Schedule, SquaresTakeTheFewestMultipliers) {
  struct Case {
    int precision;
    devices::MultiplierSize size;
    int multipliers;  ///< 0: those of a product
  };
  for (const auto& [precision, size, multipliers] :
       {Case{53, {24, 17}, 6}, Case{52, {24, 17}, 6}, Case{53, {18, 18}, 6}, Case{35, {24, 17}, 3},
        Case{24, {18, 18}, 3}, Case{53, {16, 16}, 10}, Case{24, {24, 17}, 0}, Case{17, {24, 17}, 0},
        Case{41, {24, 17}, 0}, Case{19, {24, 17}, 0}, Case{30, {17, 24}, 0}}) {
    const datapath::EmbeddedSquare square(precision, size);
    EXPECT_EQ(square.is_smaller(), multipliers > 0) << precision << " " << size.a_bits;
    EXPECT_TRUE(multipliers == 0 || square.multipliers() == multipliers) << precision;
  }
}

/// The stages of a square have as many cuts as the template: in s53e8 three links and an excess.
TEST(Schedule, SquaresByTheirSymmetryHaveTheirOwnStages) {
  const datapath::DelayTable delays = datapath::delays_of("virtex6-lx760").value();
  const TypedNode node{
      .operation = Operation::square, .operand_format = format("s53e8"), .format = format("s53e8")};
  const datapath::Unit unit =
      datapath::unit_for(node, Subnormals::gradual, {}, scene::Multipliers::embedded, delays);
  ASSERT_EQ(unit.stages.size(), 15u);
  EXPECT_EQ(unit.stages[4].name, "link 0");
  EXPECT_EQ(unit.stages[6].delay_ns, delays.multiplier_add_ns);
  EXPECT_EQ(unit.stages[7].delay_ns, delays.multiplier_add_ns) << "adds the excess";
  EXPECT_EQ(unit.stages[6].cut_needs, 3);
  EXPECT_EQ(unit.stages[7].cut_needs, -1);
  EXPECT_EQ(unit.stages[9].name, "upper half");
}

/// A sum of addends of one sign moves up by one place at most: it waits for no count of zeros.
TEST(Schedule, SumsThatOnlyGrowCountNoZeros) {
  const datapath::DelayTable delays = datapath::delays_of("virtex6-lx760").value();
  const TypedNode node{
      .operation = Operation::add, .operand_format = format("s53e8"), .format = format("s53e8")};
  const auto ns_of = [&](bool cancellation, const std::string& stage) {
    const datapath::Unit unit =
        datapath::unit_for(node, Subnormals::gradual, {.cancellation = cancellation},
                           scene::Multipliers::embedded, delays);
    const auto found = std::find_if(unit.stages.begin(), unit.stages.end(),
                                    [&](const auto& each) { return each.name == stage; });
    return found->delay_ns;
  };
  for (const char* stage : {"count", "limit"}) {
    EXPECT_EQ(ns_of(false, stage), 0) << stage;
    EXPECT_GT(ns_of(true, stage), 0) << stage;
  }
}

/// A sum is cut into halves where that saves a register, and nowhere else.
TEST(Schedule, WideSumsAreHalvedWhereThatSavesARegister) {
  const design::Design spheres = sphere_design(format("s17e8"), format("s53e8"), 1, 1);
  const datapath::DelayTable delays = datapath::delays_of("virtex6-lx760").value();
  const auto halved = [&](double target_mhz) {
    const auto schedule = datapath::schedule_reference(spheres.reference, {}, delays, target_mhz);
    std::map<std::string, std::set<std::string>> names;
    for (const datapath::Step& step : schedule.steps) {
      for (std::size_t k = 1; k < step.cuts.size(); ++k) {
        const datapath::Stage& stage = step.unit.stages[k];
        if (stage.is_upper_half && step.cuts[k - 1]) names[step.unit.module].insert(stage.name);
      }
    }
    return names;
  };
  EXPECT_TRUE(halved(250).empty());
  const std::map<std::string, std::set<std::string>> wide = {
      {"fp_add", {"sum, upper half", "round, upper half"}},
      {"fp_squared_sum",
       {"sum, upper half", "round sum, upper half", "upper half", "round, upper half"}}};
  EXPECT_EQ(halved(400), wide);
}

/// Two chains side by side have a path each; chains that fork anew wait for both.
TEST(Schedule, ChainsForkWhenAllBeforeHaveEnded) {
  const datapath::DelayTable delays = {.register_ns = 0};
  const auto chain = [&](double first_ns, double second_ns) {
    datapath::StageList stages(delays);
    stages.add("first", first_ns);
    stages.add("second", second_ns);
    return stages;
  };
  const auto cuts = [&](datapath::StageList stages) {
    return datapath::Scheduler(delays, 200).place(std::move(stages).unit("u"), {}).cuts;
  };
  datapath::StageList beside(delays);
  beside.add_side_by_side({chain(3, 1), chain(1, 3)});
  EXPECT_EQ(cuts(beside), (std::vector<bool>{false, true})) << "4 ns each of 5";
  datapath::StageList anew(delays);
  anew.add_side_by_side({chain(0, 3), chain(0, 1)});
  anew.add_side_by_side({chain(1, 0), chain(3, 0)});
  EXPECT_EQ(cuts(anew), (std::vector<bool>{false, true, false, true})) << "3 and 3 of 5";
}

/// Where the wire from logic to a multiplier is long, it has a cycle of its own at a high target.
TEST(Schedule, FactorsWaitInTheMultipliersRegisters) {
  const datapath::DelayTable delays = datapath::delays_of("ecp5-85k").value();
  const Product squared = product("(x - y)^2");
  const auto cuts = [&](double target_mhz) {
    const auto schedule = datapath::schedule_reference(squared.graph, {}, delays, target_mhz);
    const auto step = std::find_if(schedule.steps.begin(), schedule.steps.end(),
                                   [](const auto& s) { return s.unit.module == "fp_squared_sum"; });
    EXPECT_EQ(step->unit.stages[9].name, "factors");
    return std::vector<bool>{step->cuts[8], step->cuts[9]};
  };
  EXPECT_EQ(cuts(190), (std::vector<bool>{true, true}));
  EXPECT_EQ(cuts(30), (std::vector<bool>{false, false}));
}

TEST(Schedule, ScalingsThatDropNoDigitAreShort) {
  const datapath::DelayTable delays = datapath::delays_of("virtex6-lx760").value();
  Graph graph;
  const NodeId f = *parse_expression(graph, "x / 4", {});
  graph.compare(f, *parse_expression(graph, "y", {}));
  const auto start_of_the_comparison = [&](Subnormals subnormals) {
    const TypedGraph typed =
        reference_graph(graph, {format("s53e8"), Rounding::nearest_even, subnormals});
    return datapath::schedule_reference(typed, {}, delays, 200).parts.front().decision.start_cycle;
  };
  EXPECT_LE(start_of_the_comparison(Subnormals::flush), 2);
  EXPECT_GT(start_of_the_comparison(Subnormals::gradual), 2);
}

TEST(Schedule, FasterTargetsNeverShortenTheLatency) {
  const design::Design design = sphere_design(format("s17e8"), format("s53e8"), 1, 1);
  const datapath::DelayTable delays = datapath::delays_of("virtex6-lx760").value();
  int previous = 0;
  for (const double target_mhz : targets_mhz) {
    const int latency =
        datapath::schedule_reference(design.reference, {}, delays, target_mhz).latency_cycles;
    EXPECT_GE(latency, previous) << target_mhz << " MHz";
    previous = latency;
  }
}

}  // namespace
}  // namespace mixcmp::test::schedule_test
