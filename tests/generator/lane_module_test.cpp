#include "generator/hardware/rtl/lane_module.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "generator/hardware/datapath/delays.hpp"
#include "generator/hardware/emit/template_ports.hpp"
#include "generator/hardware/emit/verilog.hpp"
#include "generator/hardware/rtl/reference_module.hpp"
#include "generator/hardware/rtl/unread_bits.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/sphere.hpp"

/// The modules that a generated lane instantiates, and their parameters.
namespace mixcmp::test::lane_module_test {
namespace {

using error::Lane;

rtl::Module module_of(const Graph& graph, const Lane& lane,
                      scene::Multipliers multipliers = scene::Multipliers::embedded,
                      const std::string& device = "virtex6-lx760") {
  const datapath::Schedule schedule =
      datapath::schedule_lane(lane, multipliers, datapath::delays_of(device).value(), 250);
  return rtl::lane_module("lane", graph.inputs(), design::Lane(lane), schedule);
}

std::vector<rtl::Instance> instances(const Graph& graph, const Lane& lane,
                                     scene::Multipliers multipliers = scene::Multipliers::embedded,
                                     const std::string& device = "virtex6-lx760") {
  std::vector<rtl::Instance> found;
  for (const rtl::ModuleItem& item : module_of(graph, lane, multipliers, device).items) {
    if (const auto* instance = std::get_if<rtl::Instance>(&item)) found.push_back(*instance);
  }
  return found;
}

/// The value of a parameter; none if the instance does not set it.
std::optional<long long> parameter(const rtl::Instance& instance, const std::string& name) {
  for (const rtl::Parameter& p : instance.parameters) {
    if (p.name != name) continue;
    if (const auto* literal = std::get_if<rtl::Literal>(&p.value)) {
      return static_cast<long long>(literal->value);
    }
    return std::get<long long>(p.value);
  }
  return std::nullopt;
}

int count(const std::vector<rtl::Instance>& all, const std::string& module) {
  return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const rtl::Instance& instance) {
    return instance.module == module;
  }));
}

const rtl::Instance& only(const std::vector<rtl::Instance>& all, const std::string& module) {
  MIXCMP_CHECK(count(all, module) == 1);
  return *std::find_if(all.begin(), all.end(),
                       [&](const rtl::Instance& instance) { return instance.module == module; });
}

Lane lane_of(const Graph& graph, BoundKind kind, Subnormals subnormals,
             std::optional<Range> range) {
  const Arithmetic reduced = {format("s8e8"), Rounding::nearest_even, subnormals};
  return error::certified_lane(
             lane_graph(graph, format("s24e8"), reduced, LaneInputs::rounded),
             {.kind = kind,
              .ranges = std::vector<std::optional<Range>>(graph.inputs().size(), range)})
      .value();
}

TEST(LaneModule, BoundHasAUnitForEveryOperation) {
  const Graph graph = graph_of("a / (b - 1.1)", "sqrt(a - 0.7)");
  const Lane lane = lane_of(graph, BoundKind::running, Subnormals::gradual, {});
  const auto& criterion = std::get<error::AbsoluteBoundCriterion>(lane.criterion());
  std::map<std::string, int> expected;
  for (const error::BoundNode& node : criterion.bound.nodes) {
    ++expected["bound_" + std::string(to_string(node.operation))];
  }
  ASSERT_GT(criterion.guard_ulp, 0u);
  ASSERT_EQ(criterion.conditions.size(), 2u);
  const std::vector<rtl::Instance> all = instances(graph, lane);
  for (const auto& [module, nodes] : expected) {
    EXPECT_EQ(count(all, module), module == "bound_constant" ? 0 : nodes) << module;
  }
  EXPECT_EQ(count(all, "bound_at_most"), static_cast<int>(criterion.conditions.size()));
  EXPECT_EQ(parameter(only(all, "bound_decision"), "GUARD_ULP"),
            static_cast<long long>(criterion.guard_ulp));
  EXPECT_EQ(count(all, "fp_range_check"), 0);
}

TEST(LaneModule, BoundsReadSubnormalNumbersOnlyWhereThereMayBeSome) {
  const Graph graph = graph_of("a * b", "a + b");
  const auto gradual = [&](Subnormals subnormals, std::optional<Range> range) {
    const Lane lane = lane_of(graph, BoundKind::running, subnormals, range);
    long long any = 0;
    for (const rtl::Instance& instance : instances(graph, lane)) {
      if (instance.module == "bound_magnitude") any |= parameter(instance, "GRADUAL").value();
      if (instance.module == "bound_binade") any |= parameter(instance, "GRADUAL").value();
    }
    return any;
  };
  EXPECT_EQ(gradual(Subnormals::gradual, {}), 1);
  EXPECT_EQ(gradual(Subnormals::flush, {}), 0);
  EXPECT_EQ(gradual(Subnormals::gradual, Range{1, 100}), 0) << "ruled out by the ranges";
}

TEST(LaneModule, ProductsAndNothingElseAreToldToBeLogic) {
  const Graph graph = graph_of("a * b + a^2", "a + b");
  const Lane lane = lane_of(graph, BoundKind::running, Subnormals::gradual, {});
  for (const rtl::Instance& instance : instances(graph, lane)) {
    EXPECT_EQ(parameter(instance, "EMBEDDED"), std::nullopt) << instance.module;
  }
  int products = 0;
  for (const rtl::Instance& instance : instances(graph, lane, scene::Multipliers::logic)) {
    const bool product = instance.module == "fp_multiply" || instance.module == "fp_square";
    EXPECT_EQ(parameter(instance, "EMBEDDED"), product ? std::optional(0) : std::nullopt)
        << instance.module;
    products += product;
  }
  EXPECT_EQ(products, 2);
}

/// In front of carry chains: two bits on Virtex-6, which is the templates' default.
TEST(LaneModule, UnitsSelectAsManyBitsAsTheDeviceCan) {
  const Graph graph = graph_of("a * b + a^2", "a / b");
  const Lane lane = lane_of(graph, BoundKind::running, Subnormals::gradual, {});
  const std::set<std::string> select = {"fp_add", "fp_multiply", "fp_square", "fp_divide"};
  const auto expect = [&](const std::string& device, std::optional<long long> bits) {
    std::set<std::string> found;
    for (const auto& instance : instances(graph, lane, scene::Multipliers::embedded, device)) {
      const bool selects = select.contains(instance.module);
      EXPECT_EQ(parameter(instance, "SUM_SELECTS"), selects ? bits : std::nullopt)
          << instance.module << " on " << device;
      if (selects) found.insert(instance.module);
    }
    EXPECT_EQ(found, select);
  };
  expect("virtex6-lx760", std::nullopt);
  expect("ecp5-85k", 1);
  expect("ice40-hx8k", 0);
}

TEST(LaneModule, HazardsThatRangesRuleOutAreNotBuilt) {
  const Graph graph = graph_of("a * b", "a + b");
  const Range range = {1, 100};
  const Lane lane = lane_of(graph, BoundKind::running, Subnormals::gradual, range);
  const std::vector<rtl::Instance> all = instances(graph, lane);
  EXPECT_EQ(count(all, "fp_range_check"), 2);
  const rtl::Instance product = only(all, "fp_multiply");
  EXPECT_EQ(parameter(product, "SPECIAL_OPERANDS"), 0);
  EXPECT_EQ(parameter(product, "OVERFLOW"), 0);
  EXPECT_EQ(parameter(product, "UNDERFLOW"), 0);
  const Lane unchecked = lane_of(graph, BoundKind::running, Subnormals::gradual, {});
  const std::vector<rtl::Instance> unranged = instances(graph, unchecked);
  for (const char* hazard : {"SPECIAL_OPERANDS", "OVERFLOW", "UNDERFLOW"}) {
    EXPECT_EQ(parameter(only(unranged, "fp_multiply"), hazard), std::nullopt);
  }
}

TEST(LaneModule, RangeChecksAreThoseOfTheLane) {
  const Graph graph = graph_of("a * b", "a + b");
  const Lane lane = lane_of(graph, BoundKind::constant, Subnormals::flush, Range{-100, -1});
  const std::vector<rtl::Instance> all = instances(graph, lane);
  std::size_t k = 0;
  for (const rtl::Instance& instance : all) {
    if (instance.module != "fp_range_check") continue;
    const error::RangeCheck& check = lane.checks.at(k++);
    EXPECT_EQ(parameter(instance, "SIGN"), 2);
    EXPECT_EQ(parameter(instance, "PRECISION"), 24) << "the operand's, not the lane's";
    EXPECT_EQ(parameter(instance, "LEADING_BITS"), check.leading_bits);
    EXPECT_EQ(parameter(instance, "LEAST"), static_cast<long long>(check.least));
    EXPECT_EQ(parameter(instance, "GREATEST"), static_cast<long long>(check.greatest));
  }
  EXPECT_EQ(k, 2u);
}

TEST(LaneModule, SignChecksAreWires) {
  const Graph graph = graph_of("a + b", "a * 0.3");
  Lane lane = error::certified_lane(
                  lane_graph(graph, format("s24e8"), {format("s8e8")}, LaneInputs::rounded),
                  {.kind = BoundKind::relative,
                   .ranges = {Range{0, 100}, Range{0, 100}},
                   .hazards = error::HazardRemoval::keep})
                  .value();
  ASSERT_EQ(lane.checks.size(), 2u);
  lane.checks.back().sign = error::RequiredSign::nonpositive;
  EXPECT_EQ(count(instances(graph, lane), "fp_range_check"), 0);
  const std::string text = emit::to_verilog(emit::checked({module_of(graph, lane)})).front();
  EXPECT_NE(text.find("wire wrong_sign = a[31] | ~b[31];"), std::string::npos) << text;
}

TEST(UnreadBits, OfADelayedValueAreConsumed) {
  using namespace rtl;
  const auto delay = [](const std::string& name) {
    return Instance{"delay_line",
                    "delay_" + name,
                    {{"WIDTH", 8}, {"LENGTH", 1}},
                    {{"aclk", net("aclk")}, {"d", net("a")}, {"q", net(name)}}};
  };
  std::vector<ModuleItem> items = {
      Wire{8, "part", nullptr}, delay("part"), Wire{8, "whole", nullptr}, delay("whole"),
      Assignment{net("y"),
                 concatenation({slice("part", 6, 5), inverted(bit("part", 1)), net("whole")})}};
  NamePool pool({"unused_part"});
  consume_unread_bits(items, {}, pool);
  const std::vector<Port> ports = {
      {Direction::input, 1, "aclk"}, {Direction::input, 8, "a"}, {Direction::output, 11, "y"}};
  const std::string text = emit::to_verilog(emit::checked({{"m", ports, items}})).front();
  EXPECT_NE(text.find("wire unused_part_2 = &{1'b0, part[0], part[4:2], part[7]};"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("unused_whole"), std::string::npos);
}

/// The phases in which the squares of a folded reference start, by its schedule; `later` cycles
/// later.
std::set<Bits> start_phases(const TypedGraph& graph, const datapath::Schedule& schedule,
                            int later) {
  std::set<Bits> phases;
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    if (graph.nodes[id].operation != Operation::square) continue;
    const int cycle = schedule.steps[id].start_cycle + later;
    phases.insert(static_cast<Bits>(cycle % schedule.initiation_interval));
  }
  return phases;
}

std::set<Bits> start_phases(const rtl::Module& module) {
  std::set<Bits> phases;
  for (const rtl::ModuleItem& item : module.items) {
    const auto* flag = std::get_if<rtl::PhaseFlag>(&item);
    if (flag == nullptr) continue;
    for (const rtl::Literal& phase : flag->phases) phases.insert(phase.value);
  }
  return phases;
}

/// The squarer's operands are results of the adder, or come a cycle later out of registers.
TEST(ReferenceModule, SquarersStartWhenTheirOperandIsThere) {
  for (const auto& [f, later] :
       {std::pair{"(a - b)^2 + (c - d)^2", 0}, {"(a - b)^2 + c^2", 1}, {"(a - b)^2 + d", 0}}) {
    const Graph graph = graph_of(f, "(a + b)^2 + c + d");
    const TypedGraph reference = reference_graph(graph, {format("s24e8")});
    const datapath::Schedule schedule = datapath::schedule_reference(
        reference, {.multipliers = scene::Multipliers::logic, .initiation_interval = 16},
        datapath::delays_of("ice40-hx8k").value(), 90);
    EXPECT_EQ(start_phases(rtl::reference_module("reference", graph.inputs(), reference, schedule)),
              start_phases(reference, schedule, later))
        << f;
  }
}

/// A multiplier that takes squares among its products gets their operand twice.
TEST(ReferenceModule, FoldedSquaresAndProductsHaveNoFault) {
  const Graph graph = graph_of("a^2 + b^2 + a * b + c^2", "(a - b) * c + (a + c)^2 - 0.3 * b");
  const TypedGraph reference = reference_graph(graph, {format("s24e8")});
  for (const int interval : {2, 3, 4, 5, 8, 16}) {
    const datapath::Schedule schedule = datapath::schedule_reference(
        reference, {.multipliers = scene::Multipliers::embedded, .initiation_interval = interval},
        datapath::delays_of("virtex6-lx760").value(), 250);
    const rtl::Module module =
        rtl::reference_module("reference", graph.inputs(), reference, schedule);
    EXPECT_EQ(rtl::faults_of({module}, emit::template_ports), std::vector<std::string>());
  }
}

TEST(ReferenceModule, WithoutASharedUnitEveryPhaseIsAlike) {
  const Graph graph = graph_of("a", "b * 1.5");
  const TypedGraph reference = reference_graph(graph, {format("s23e6")});
  const datapath::Schedule schedule = datapath::schedule_reference(
      reference, {.initiation_interval = 16}, datapath::delays_of("virtex6-lx760").value(), 250);
  const rtl::Module module =
      rtl::reference_module("reference", graph.inputs(), reference, schedule);
  EXPECT_EQ(rtl::faults_of({module}, emit::template_ports), std::vector<std::string>());
}

/// The names that a module declares: of ports, wires and instances.
std::vector<std::string> declared_names(const rtl::Module& module) {
  std::vector<std::string> names;
  for (const rtl::Port& port : module.ports) names.push_back(port.name);
  for (const rtl::ModuleItem& item : module.items) {
    if (const auto* wire = std::get_if<rtl::Wire>(&item)) names.push_back(wire->name);
    if (const auto* instance = std::get_if<rtl::Instance>(&item)) names.push_back(instance->name);
  }
  return names;
}

/// The lane and the reference of a * b against c where a has this name.
std::vector<rtl::Module> modules_with_input(const std::string& name) {
  const Graph graph = graph_of(name + " * b", "c");
  const auto delays = datapath::delays_of("virtex6-lx760").value();
  const Lane lane = lane_of(graph, BoundKind::running, Subnormals::gradual, Range{0, 1});
  const TypedGraph reference = reference_graph(graph, {format("s24e8")});
  const auto embedded = scene::Multipliers::embedded;
  return {rtl::lane_module("lane", graph.inputs(), design::Lane(lane),
                           datapath::schedule_lane(lane, embedded, delays, 250)),
          rtl::reference_module("reference", graph.inputs(), reference,
                                datapath::schedule_reference(reference, {embedded}, delays, 250))};
}

TEST(DatapathModules, AnInputMayHaveTheNameOfAnyWire) {
  for (const rtl::Module& plain : modules_with_input("a")) {
    for (const std::string& taken : declared_names(plain)) {
      if (taken == "b" || taken == "c") continue;
      for (const rtl::Module& module : modules_with_input(taken)) {
        std::vector<std::string> names = declared_names(module);
        std::sort(names.begin(), names.end());
        const auto twice = std::adjacent_find(names.begin(), names.end());
        EXPECT_EQ(twice, names.end()) << module.name << " declares " << *twice << " twice";
      }
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::lane_module_test
