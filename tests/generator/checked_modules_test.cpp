#include "generator/hardware/rtl/checked_modules.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "generator/hardware/emit/template_ports.hpp"
#include "generator/hardware/emit/templates.hpp"

/// A tree of modules with one fault is not printed, whatever the fault is.
namespace mixcmp::test::checked_modules_test {
namespace {

using namespace rtl;

constexpr auto in = Direction::input;
constexpr auto out = Direction::output;

Instance product(std::vector<Connection> connections) {
  return {
      "fp_multiply", "product", {{"EXPONENT_BITS", 8}, {"PRECISION", 24}}, std::move(connections)};
}

const std::vector<Connection> all_pins = {{"aclk", net("aclk")},
                                          {"a", net("a")},
                                          {"b", net("b")},
                                          {"y", net("y")},
                                          {"exceptional", net("unused_exceptional")}};

/// A product of two floats with nothing wrong.
Module whole() {
  return {"top",
          {{in, 1, "aclk"}, {in, 32, "a"}, {in, 32, "b"}, {out, 32, "y"}},
          {Wire{1, "unused_exceptional", nullptr}, product(all_pins)}};
}

/// A folded datapath with nothing wrong: registers of both kinds, and a flag.
Module folded() {
  return {"folded",
          {{in, 1, "aclk"}, {in, 2, "phase"}, {in, 8, "a"}, {out, 8, "y"}, {out, 1, "last"}},
          {HeldValue{8, "a_held", {2, 0}, net("a")},
           PhaseRegisters{
               8, {"chosen"}, {{{2, 0}, "a", {net("a")}}, {{2, 1}, "held", {net("a_held")}}}},
           PhaseFlag{"at_end", {{2, 3}}}, Assignment{net("y"), net("chosen")},
           Assignment{net("last"), net("at_end")}}};
}

std::vector<std::string> faults_in(const std::vector<Module>& modules) {
  return faults_of(modules, emit::template_ports);
}

void expect_fault(const Module& module, const std::string& fault) {
  const std::vector<std::string> found = faults_in({module});
  EXPECT_TRUE(std::find(found.begin(), found.end(), module.name + ": " + fault) != found.end())
      << "expected " << fault << "\nfound " << fmt::format("{}", fmt::join(found, "\n"));
}

Module with(Module module, std::vector<ModuleItem> items) {
  module.items.insert(module.items.end(), items.begin(), items.end());
  return module;
}

TEST(CheckedModules, WholeTreesHaveNoFault) {
  EXPECT_EQ(faults_in({whole(), folded()}), std::vector<std::string>());
}

TEST(CheckedModules, EveryPinIsConnectedOnce) {
  for (std::size_t k = 0; k < all_pins.size(); ++k) {
    std::vector<Connection> pins = all_pins;
    pins.erase(pins.begin() + static_cast<long>(k));
    Module module = whole();
    module.items.back() = product(pins);
    expect_fault(module, "pin " + all_pins[k].port + " of product (fp_multiply) is not connected");
    pins = all_pins;
    pins.push_back(all_pins[k]);
    module.items.back() = product(pins);
    expect_fault(module,
                 "pin " + all_pins[k].port + " of product (fp_multiply) is connected twice");
  }
  Module module = whole();
  std::vector<Connection> pins = all_pins;
  pins.push_back({"c", net("a")});
  module.items.back() = product(pins);
  expect_fault(module, "pin c of product (fp_multiply) does not exist");
}

TEST(CheckedModules, PinsHaveTheWidthThatTheParametersGive) {
  Module module = whole();
  std::get<Instance>(module.items.back()).parameters[1].value = 23;
  expect_fault(module, "pin a of product (fp_multiply) has 31 bits, and gets 32");
  expect_fault(module, "pin y of product (fp_multiply) has 31 bits, and gets 32");
}

TEST(CheckedModules, ParametersExistAndHaveTheirWidth) {
  Module module = whole();
  std::get<Instance>(module.items.back()).parameters.push_back({"CLOUDY", 1});
  expect_fault(module, "product (fp_multiply): there is no parameter CLOUDY");
  module = whole();
  std::get<Instance>(module.items.back()).parameters.push_back({"CUTS", Literal{3, 0}});
  expect_fault(module, "product (fp_multiply): parameter CUTS has 15 bits, and gets 3");
}

TEST(CheckedModules, ModulesExistOnce) {
  Module module = whole();
  std::get<Instance>(module.items.back()).module = "fp_multiplyer";
  expect_fault(module, "product (fp_multiplyer): there is no such module");
  EXPECT_EQ(faults_in({whole(), whole()}),
            std::vector<std::string>{"top: two modules of this name"});
}

TEST(CheckedModules, ModulesOfTheTreeAreInstantiatedByTheirPorts) {
  Module around = {"around", {{in, 1, "aclk"}, {in, 32, "a"}, {out, 32, "y"}}, {}};
  around.items = {
      Instance{"top",
               "inner",
               {},
               {{"aclk", net("aclk")}, {"a", net("a")}, {"b", net("a")}, {"y", net("y")}}}};
  EXPECT_EQ(faults_in({whole(), around}), std::vector<std::string>());
  std::get<Instance>(around.items.back()).connections[2].value = slice("a", 30, 0);
  EXPECT_EQ(faults_in({whole(), around}),
            std::vector<std::string>{"around: pin b of inner (top) has 32 bits, and gets 31"});
  std::get<Instance>(around.items.back()).parameters = {{"WIDTH", 3}};
  EXPECT_FALSE(faults_in({whole(), around}).empty());
}

TEST(CheckedModules, EveryBitHasOneDriver) {
  Module module = whole();
  module.ports.push_back({out, 4, "z"});
  expect_fault(module, "z is not driven");
  expect_fault(with(module, {Assignment{slice("z", 3, 2), literal(2, 0)}}), "z[1:0] is not driven");
  expect_fault(
      with(module, {Assignment{net("z"), literal(4, 0)}, Assignment{bit("z", 1), literal(1, 0)}}),
      "z[1] is driven twice");
  expect_fault(with(whole(), {Assignment{bit("a", 1), literal(1, 0)}}), "a[1] is driven twice");
  expect_fault(with(whole(), {Assignment{literal(1, 0), bit("a", 1)}}), "a constant is driven");
  expect_fault(with(whole(), {Assignment{inverted(bit("a", 1)), bit("b", 1)}}),
               "the result of an operation is driven");
}

TEST(CheckedModules, EveryBitIsReadButOfUnusedNets) {
  expect_fault(with(whole(), {Wire{4, "z", literal(4, 0)}}), "z is not read");
  expect_fault(with(whole(), {Wire{4, "z", literal(4, 0)}, Wire{2, "unused", slice("z", 2, 1)}}),
               "z[3], z[0] is not read");
  Module module = whole();
  module.ports.push_back({in, 4, "c"});
  expect_fault(module, "c is not read");
}

TEST(CheckedModules, BothSidesHaveOneWidth) {
  expect_fault(with(whole(), {Wire{4, "unused", literal(3, 0)}}), "unused has 4 bits, and gets 3");
  Module module = with(whole(), {Assignment{net("z"), slice("a", 4, 0)}});
  module.ports.push_back({out, 4, "z"});
  expect_fault(module, "an assignment has 4 bits, and gets 5");
  expect_fault(with(whole(), {Wire{2, "unused", any_of({slice("a", 1, 0), bit("a", 0)})}}),
               "an OR has operands of 1 and 2 bits");
  expect_fault(with(whole(), {Wire{2, "unused", literal(2, 5)}}), "a literal has more than 2 bits");
}

TEST(CheckedModules, BitsAreSelectedInsideOfANetThatHasSeveral) {
  expect_fault(with(whole(), {Wire{2, "unused", slice("a", 32, 31)}}),
               "a[32:31] is outside of its 32 bits");
  expect_fault(with(whole(), {Wire{1, "unused", bit("aclk", 0)}}), "aclk has no range");
}

TEST(CheckedModules, LoopsAreWrittenOut) {
  Module module = {"loops", {{in, 8, "a"}, {out, 6, "y"}}, {}};
  const auto loop = [&](int first, int count) {
    const std::vector<ModuleItem> body = {Wire{2, "inner", indexed("a", "k", 2)},
                                          Assignment{indexed("y", "k", 2), net("inner")}};
    module.items = {
        std::make_shared<const ForGenerate>(ForGenerate{"k", first, count, "all", body})};
    return module;
  };
  expect_fault(loop(0, 3), "a[7:6] is not read");
  expect_fault(loop(0, 4), "y[7:6] is outside of its 6 bits");
  expect_fault(loop(1, 2), "y[1:0] is not driven");
  module = loop(0, 3);
  module.items.emplace_back(Wire{2, "unused", indexed("a", "k", 2)});
  expect_fault(module, "k is used outside of its loop");
}

TEST(CheckedModules, NamesAreDeclaredOnceAndBeforeTheyAreUsed) {
  expect_fault(with(whole(), {Wire{1, "a", literal(1, 0)}}), "a is declared twice");
  expect_fault(with(whole(), {Wire{1, "product", literal(1, 0)}}), "product is declared twice");
  expect_fault(with(whole(), {Wire{1, "unused", net("later")}, Wire{1, "later", literal(1, 0)}}),
               "later is used before it is declared");
  expect_fault(with(whole(), {Wire{1, "always", literal(1, 0)}}),
               "always: \"always\" is a Verilog or SystemVerilog keyword");
  const std::vector<ModuleItem> body = {Wire{1, "a", literal(1, 0)}};
  expect_fault(
      with(whole(), {std::make_shared<const ForGenerate>(ForGenerate{"k", 0, 2, "l", body})}),
      "a is declared twice");
}

TEST(CheckedModules, RegistersHoldDataOnly) {
  Module module = folded();
  module.ports.push_back({in, 1, "aresetn"});
  expect_fault(module, "a_held is not reset");
  expect_fault(module, "chosen is not reset");
}

TEST(CheckedModules, RegistersTakeAValueOfTheirWidthInEveryCase) {
  Module module = folded();
  auto& registers = std::get<PhaseRegisters>(module.items[1]);
  registers.cases[1].values.clear();
  expect_fault(module, "chosen in phase 1 takes 0 values");
  registers.cases[1].values = {bit("a_held", 0)};
  expect_fault(module, "chosen in phase 1 has 8 bits, and gets 1");
  registers.cases[1] = registers.cases[0];
  expect_fault(module, "chosen in phase 0 has two cases");
  registers.cases[1].phase.width = 3;
  expect_fault(module, "phase has 2 bits, and gets 3");
  registers.cases.clear();
  expect_fault(module, "chosen takes no value");
}

TEST(CheckedModulesDeathTest, AFaultEndsTheProgram) {
  Module module = whole();
  std::get<Instance>(module.items.back()).connections.pop_back();
  EXPECT_DEATH(emit::checked({module}),
               "broken invariant: top: pin exceptional of product .fp_multiply. is not connected");
}

TEST(TemplatePorts, WidthsFollowTheParameters) {
  const auto width = [](const Instance& instance, const std::string& name) {
    const std::vector<Port> ports = emit::template_ports(instance).value();
    const auto port = std::find_if(ports.begin(), ports.end(),
                                   [&](const Port& each) { return each.name == name; });
    return port == ports.end() ? 0 : port->width;
  };
  Instance scoreboard = {
      "lane_scoreboard", "tracker", {{"OPERAND_BITS", 100}, {"SLOT_BITS", 4}}, {}};
  EXPECT_EQ(width(scoreboard, "m_request_tdata"), 104);
  scoreboard.parameters.push_back({"BEAT_BITS", 3});
  EXPECT_EQ(width(scoreboard, "m_request_tdata"), 4 + 13);
  scoreboard.parameters.push_back({"CARRIED", 0});
  EXPECT_EQ(width(scoreboard, "m_request_tdata"), 4 + 32);
  EXPECT_EQ(width(scoreboard, "comparisons"), 32);
  scoreboard.parameters.push_back({"COUNTER_BITS", 0});
  EXPECT_EQ(width(scoreboard, "comparisons"), 1);
  EXPECT_EQ(width({"fp_convert",
                   "c",
                   {{"PRECISION", 24}, {"EXPONENT_BITS", 8}, {"RESULT_PRECISION", 9}},
                   {}},
                  "y"),
            17);
}

}  // namespace
}  // namespace mixcmp::test::checked_modules_test
