#include "generator/hardware/datapath/fold.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "generator/hardware/datapath/delays.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/sphere.hpp"

/// Folded references: promises of the schedule to the hardware.
namespace mixcmp::test::fold_test {
namespace {

struct Scene {
  const char* name;
  const char* f;
  const char* g;
  Sums sums = Sums::composed;
  scene::Multipliers multipliers = scene::Multipliers::embedded;
  const char* reference = "s24e8";
};

constexpr auto logic = scene::Multipliers::logic;

constexpr Scene scenes[] = {
    {"spheres", "(a - b)^2 + (c - d)^2 + (a - d)^2", "(b + c)^2"},
    {"products", "a * b + c^2 - d * 3", "max(a, b) * -min(c, d) + a * c"},
    {"more_squares_than_products", "b^2", "c^2 + d * a"},
    {"squares_beside_products", "(a - b)^2 + c * d + b^2 + c^2", "(c - d)^2 - a * c + d^2"},
    {"squares_beside_a_product_of_logic", "(a - b)^2 + c * d + b^2 + c^2", "d^2", Sums::composed,
     logic},
    {"roots", "sqrt(a^2 + b^2) / (c + 1) - sqrt(d)", "abs(a) / 4 + b / 4 + d * 2"},
    {"late_operand", "((a + b) * c + b) * c + d", "a"},
    {"signs_alone", "-a", "abs(b)"},
    {"fused_sums", "(a - b)^2 + (c - d)^2 + (a - d)^2", "(b + c) * d - a", Sums::fused},
    {"spheres_of_logic", "(a - b)^2 + (c - d)^2 + (a - d)^2", "(b + c)^2", Sums::composed, logic},
    {"squares_of_operands", "(a - b)^2 + c^2 + (a + d)^2", "d^2 - (b - c)^2", Sums::composed, logic,
     "s53e11"},
    {"one_square", "(a - b)^2 + c", "d", Sums::composed, logic},
};

std::ostream& operator<<(std::ostream& out, const Scene& scene) {
  return out << scene.name;
}

constexpr int intervals[] = {2, 3, 4, 5, 7, 16, 32, 64};

class Fold : public testing::TestWithParam<std::tuple<Scene, int>> {
protected:
  int interval() const { return std::get<1>(GetParam()); }

  /// The unit that computes a node; null where it is an operand or wires.
  const datapath::SharedUnit* unit_of(NodeId id) const {
    for (const datapath::SharedUnit& unit : schedule_.shared_units) {
      if (std::find(unit.operations.begin(), unit.operations.end(), id) != unit.operations.end()) {
        return &unit;
      }
    }
    return nullptr;
  }

  TypedGraph graph_ = reference_graph(
      graph_of(std::get<0>(GetParam()).f, std::get<0>(GetParam()).g),
      {.format = format(std::get<0>(GetParam()).reference), .sums = std::get<0>(GetParam()).sums});
  datapath::Schedule schedule_ = datapath::schedule_reference(
      graph_,
      {.multipliers = std::get<0>(GetParam()).multipliers, .initiation_interval = interval()},
      datapath::delays_of("ice40-hx8k").value(), 100);
};

INSTANTIATE_TEST_SUITE_P(Of, Fold,
                         testing::Combine(testing::ValuesIn(scenes), testing::ValuesIn(intervals)),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param).name) + "_" +
                                  std::to_string(std::get<1>(test.param));
                         });

TEST_P(Fold, EveryOperationHasAUnitOfItsOwnInItsPhases) {
  std::vector<int> placed(graph_.nodes.size(), 0);
  for (const datapath::SharedUnit& unit : schedule_.shared_units) {
    std::set<int> phases;
    for (const NodeId id : unit.operations) {
      ++placed[id];
      for (int k = 0; k < unit.unit.initiation_interval; ++k) {
        EXPECT_TRUE(phases.insert((schedule_.steps[id].start_cycle + k) % interval()).second) << id;
      }
      EXPECT_EQ(schedule_.steps[id].unit.module, unit.unit.module);
    }
  }
  for (std::size_t id = 0; id < placed.size(); ++id) {
    EXPECT_EQ(placed[id], datapath::has_unit(graph_.nodes[id]) ? 1 : 0) << id;
  }
}

TEST_P(Fold, OperandsAreReadyAndResultsComeWhenTheUnitGivesThem) {
  for (const datapath::SharedUnit& unit : schedule_.shared_units) {
    const auto registers = std::count(unit.cuts.begin(), unit.cuts.end(), true);
    for (const NodeId id : unit.operations) {
      const datapath::Step& step = schedule_.steps[id];
      EXPECT_EQ(step.ready_cycle - step.start_cycle, registers + (unit.selects ? 1 : 0)) << id;
    }
  }
  for (std::size_t id = 0; id < graph_.nodes.size(); ++id) {
    for (const NodeId operand : operands_of(graph_.nodes[id])) {
      EXPECT_LE(schedule_.steps[operand].ready_cycle, schedule_.steps[id].start_cycle);
    }
  }
  const datapath::Step& decision = schedule_.parts.front().decision;
  EXPECT_GE(decision.start_cycle, schedule_.steps[graph_.f()].ready_cycle);
  EXPECT_GE(decision.start_cycle, schedule_.steps[graph_.g()].ready_cycle);
}

/// A unit without registers for operands reads all of them from one other unit, as they come.
TEST_P(Fold, UnitsThatDoNotSelectReadTheResultsOfOneUnit) {
  for (const datapath::SharedUnit& unit : schedule_.shared_units) {
    if (unit.selects || unit.operations.size() == 1) continue;
    std::set<const datapath::SharedUnit*> sources;
    for (const NodeId id : unit.operations) {
      for (const NodeId operand : operands_of(graph_.nodes[id])) {
        EXPECT_EQ(schedule_.steps[operand].ready_cycle, schedule_.steps[id].start_cycle) << id;
        sources.insert(unit_of(operand));
      }
    }
    EXPECT_EQ(sources.size(), 1u);
    EXPECT_FALSE(sources.contains(nullptr));
  }
}

/// No kind has more units than its operations need; a unit takes as many operations as fit into the
/// interval.
TEST_P(Fold, ThereAreAsFewUnitsAsTheIntervalAllows) {
  std::map<std::string, std::pair<int, int>> units_and_operations;
  std::map<std::string, int> cycles;
  for (const datapath::SharedUnit& unit : schedule_.shared_units) {
    auto& [units, operations] = units_and_operations[unit.unit.module];
    ++units;
    operations += static_cast<int>(unit.operations.size());
    cycles[unit.unit.module] = unit.unit.initiation_interval;
  }
  // Units of one module may differ in parameters: minima and maxima, scalings by unlike powers.
  for (const char* module :
       {"fp_add", "fp_multiply", "fp_square", "fp_serial_square", "fp_divide", "fp_square_root"}) {
    const auto [units, operations] = units_and_operations[module];
    const int most = interval() / std::max(cycles[module], 1);
    EXPECT_EQ(units, units == 0 ? 0 : (operations + most - 1) / most) << module;
  }
  const auto [multipliers, by_multipliers] = units_and_operations["fp_multiply"];
  const auto [squarers, by_squarers] = units_and_operations["fp_square"];
  const int operations = by_multipliers + by_squarers;
  EXPECT_EQ(multipliers + squarers, (operations + interval() - 1) / interval())
      << "multipliers with room to spare take squares";
}

/// No multiplier is there for squares.
TEST_P(Fold, ProductsSayHowManyMultipliersThereAre) {
  int multipliers = 0, products = 0;
  for (const datapath::SharedUnit& unit : schedule_.shared_units) {
    if (unit.unit.module != "fp_multiply") continue;
    ++multipliers;
    products += static_cast<int>(std::count_if(
        unit.operations.begin(), unit.operations.end(),
        [&](NodeId id) { return graph_.nodes[id].operation == Operation::multiply; }));
  }
  EXPECT_EQ(multipliers, (products + interval() - 1) / interval());
}

/// A multiplier for squares only would be larger than a squarer, and no operation would give its
/// second operand.
TEST_P(Fold, EveryMultiplierHasAProduct) {
  for (const datapath::SharedUnit& unit : schedule_.shared_units) {
    const bool has_product =
        std::any_of(unit.operations.begin(), unit.operations.end(),
                    [&](NodeId id) { return graph_.nodes[id].operation == Operation::multiply; });
    if (unit.unit.module == "fp_multiply" || unit.unit.module == "fp_square") {
      EXPECT_EQ(has_product, unit.unit.module == "fp_multiply");
    }
  }
}

TEST_P(Fold, OperandsStayAsLongAsTheyAreRead) {
  EXPECT_GE(schedule_.last_operand_phase, 0);
  EXPECT_LT(schedule_.last_operand_phase, interval());
  for (std::size_t id = 0; id < graph_.nodes.size(); ++id) {
    for (const NodeId operand : operands_of(graph_.nodes[id])) {
      if (graph_.nodes[operand].operation != Operation::input) continue;
      EXPECT_LE(std::min(schedule_.steps[id].start_cycle, interval() - 1),
                schedule_.last_operand_phase);
    }
  }
}

/// The datapath that feeds the reference then has a cycle to bring the next operands.
TEST(FoldedSpheres, LeaveTheLastPhaseToTheNextOperands) {
  for (const char* reference : {"s24e8", "s53e11"}) {
    for (const auto multipliers : {logic, scene::Multipliers::embedded}) {
      for (int interval = 14; interval <= 24; ++interval) {
        const datapath::Schedule schedule = datapath::schedule_reference(
            reference_graph(graph_of("(a - b)^2 + (c - d)^2 + (a - d)^2", "(b + c)^2"),
                            {.format = format(reference)}),
            {.multipliers = multipliers, .initiation_interval = interval},
            datapath::delays_of("ice40-hx8k").value(), 100);
        EXPECT_LE(schedule.last_operand_phase, interval - 2) << reference << ' ' << interval;
      }
    }
  }
}

/// Wide look-up tables have registers to spare: nothing moves to save some.
TEST(FoldedSpheres, ReadTheirOperandsEarlyWhereRegistersAreSpare) {
  const datapath::Schedule schedule = datapath::schedule_reference(
      reference_graph(graph_of("(a - b)^2 + (c - d)^2 + (a - d)^2", "(b + c)^2"),
                      {.format = format("s24e8")}),
      {.initiation_interval = 16}, datapath::delays_of("virtex6-lx760").value(), 300);
  EXPECT_LE(schedule.last_operand_phase, 4);
}

/// Two of four squares wait: one for the next to be added to it, and one for the other side.
TEST(FoldedSpheres, KeepTwoValuesAndNoRegisterInFrontOfTheSquarer) {
  const TypedGraph graph = reference_graph(
      graph_of("(a - b)^2 + (c - d)^2 + (a - d)^2", "(b + c)^2"), {.format = format("s24e8")});
  const datapath::Schedule schedule = datapath::schedule_reference(
      graph, {.multipliers = scene::Multipliers::logic, .initiation_interval = 16},
      datapath::delays_of("ice40-hx8k").value(), 95);
  std::set<NodeId> waiting;
  const auto read = [&](NodeId id, int cycle) {
    const bool computed = datapath::has_unit(graph.nodes[id]);
    if (computed && schedule.steps[id].ready_cycle < cycle) waiting.insert(id);
  };
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    for (const NodeId operand : operands_of(graph.nodes[id])) {
      read(operand, schedule.steps[id].start_cycle);
    }
  }
  read(graph.f(), schedule.parts.front().decision.start_cycle);
  read(graph.g(), schedule.parts.front().decision.start_cycle);
  EXPECT_LE(waiting.size(), 2u);
  for (const datapath::SharedUnit& unit : schedule.shared_units) {
    EXPECT_EQ(unit.selects, unit.unit.module == "fp_add");
  }
}

/// How a folded sphere squares.
struct Squarers {
  std::string module;
  int units = 0;

  friend bool operator==(const Squarers&, const Squarers&) = default;
};

std::ostream& operator<<(std::ostream& out, const Squarers& squarers) {
  return out << squarers.units << ' ' << squarers.module;
}

Squarers squarers_of(const char* f, const char* g, const char* reference, int interval,
                     const char* device = "ice40-hx8k", scene::Multipliers multipliers = logic) {
  const datapath::Schedule schedule =
      datapath::schedule_reference(reference_graph(graph_of(f, g), {.format = format(reference)}),
                                   {.multipliers = multipliers, .initiation_interval = interval},
                                   datapath::delays_of(device).value(), 90);
  Squarers found;
  for (const datapath::SharedUnit& unit : schedule.shared_units) {
    if (unit.unit.module == "fp_add") continue;
    found.module = unit.unit.module;
    ++found.units;
  }
  return found;
}

/// A square of 24 bits takes four cycles, one of 53 bits nine.
TEST(FoldedSpheres, SquareByStepsWhereThatTakesFewerTables) {
  const auto squarers = [](const char* reference, int interval, auto... rest) {
    return squarers_of("(a - b)^2 + (c - d)^2 + (a - d)^2", "(b + c)^2", reference, interval,
                       rest...);
  };
  const Squarers serial = {"fp_serial_square", 1}, parallel = {"fp_square", 1};
  EXPECT_EQ(squarers("s24e8", 16), serial);
  EXPECT_EQ(squarers("s24e8", 15), parallel) << "two serial ones are larger";
  EXPECT_EQ(squarers("s24e8", 3), (Squarers{"fp_square", 2}));
  EXPECT_EQ(squarers("s53e11", 36), serial);
  EXPECT_EQ(squarers("s53e11", 35), (Squarers{"fp_serial_square", 2}));
  EXPECT_EQ(squarers("s53e11", 17), parallel) << "each takes one square";
  EXPECT_EQ(squarers("s13e8", 64), parallel);
  EXPECT_EQ(squarers("s12e8", 64), parallel);
  EXPECT_EQ(squarers("s24e8", 16, "virtex6-lx760"), parallel) << "tables of six inputs";
  EXPECT_EQ(squarers("s24e8", 16, "ice40-hx8k", scene::Multipliers::embedded), parallel);
}

TEST(FoldedSpheres, MultiplyWhereTheyNeedAMultiplierAnyway) {
  EXPECT_EQ(squarers_of("(a - b)^2 + c * d", "a", "s24e8", 16), (Squarers{"fp_multiply", 1}));
}

}  // namespace
}  // namespace mixcmp::test::fold_test
