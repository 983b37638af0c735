#include "generator/synthesis/components/needed_parts.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "generator/synthesis/characterise/tools.hpp"
#include "generator/synthesis/components/synthesis_jobs.hpp"
#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test::needed_parts_test {
namespace {

using rtl::Literal;
using rtl::ModuleItem;

/// A unit in binary64 with these operands, and its result y.
std::vector<ModuleItem> unit(const std::string& module, std::vector<rtl::Connection> operands,
                             std::vector<rtl::Parameter> parameters = {}, int precision = 53) {
  parameters.push_back({"PRECISION", precision});
  operands.push_back({"y", rtl::net("y")});
  return {rtl::Wire{64, "y", nullptr},
          rtl::Instance{module, "unit_y", std::move(parameters), std::move(operands)}};
}

rtl::Module module_of(std::vector<ModuleItem> items, const std::string& name = "reference") {
  return {
      name, {{rtl::Direction::input, 64, "x"}, {rtl::Direction::input, 64, "z"}}, std::move(items)};
}

characterise::NeededParts needed(std::vector<ModuleItem> items) {
  return components::needed_parts({module_of(std::move(items))});
}
int dsps(std::vector<ModuleItem> items) {
  return needed(std::move(items)).dsps;
}

using Texts = std::vector<std::string>;

/// "y: 2 of 52" of each net.
Texts texts(const characterise::NeededParts& parts) {
  Texts texts;
  for (const characterise::NeededNet& net : parts.nets) {
    texts.push_back(fmt::format("{}: {} of {}", net.name, net.varying_bits, net.low_bits));
  }
  return texts;
}
Texts nets(std::vector<ModuleItem> items) {
  return texts(needed(std::move(items)));
}

const std::vector<rtl::Connection> one_operand = {{"a", rtl::net("x")}};
const std::vector<rtl::Connection> two_operands = {{"a", rtl::net("x")}, {"b", rtl::net("z")}};
const std::vector<rtl::Connection> with_constant = {{"a", rtl::net("x")},
                                                    {"b", rtl::literal(64, 5)}};

TEST(NeededParts, AProductHasAMultiplierForEachPairOfParts) {
  EXPECT_EQ(dsps(unit("fp_multiply", two_operands)), 9)
      << "3 parts of 24 bits and less, 3 of 17; the last 2 bits may be multiplied by logic";
  EXPECT_EQ(dsps(unit("fp_multiply", two_operands, {{"FACTOR_A", 18}, {"FACTOR_B", 18}})), 9);
  EXPECT_EQ(dsps(unit("fp_multiply", two_operands, {}, 24)), 2);
  EXPECT_EQ(dsps(unit("fp_multiply", two_operands, {}, 18)), 1) << "a row of gates beside it";
}

TEST(NeededParts, ASquareHasNoPairTwice) {
  EXPECT_EQ(dsps(unit("fp_square", one_operand)), 6);
  EXPECT_EQ(dsps(unit("fp_squared_sum", two_operands)), 6);
}

TEST(NeededParts, EachTermOfAFusedSumThatIsAProductCounts) {
  const auto sum = [](rtl::Operand last) {
    const rtl::Operand a = rtl::concatenation({rtl::net("x"), rtl::net("x"), rtl::net("x")});
    const rtl::Operand b = rtl::concatenation({std::move(last), rtl::zeros(64), rtl::zeros(64)});
    return unit("fp_fused_sum", {{"a", a}, {"b", b}},
                {{"TERMS", 3}, {"SQUARES", Literal{3, 0b001}}, {"PLAIN", Literal{3, 0b010}}});
  };
  EXPECT_EQ(dsps(sum(rtl::net("z"))), 6 + 9);
  EXPECT_EQ(dsps(sum(rtl::literal(64, 5))), 6);
}

TEST(NeededParts, MultipliersThatSynthesisMayLeaveOutDoNotCount) {
  EXPECT_EQ(dsps(unit("fp_multiply", with_constant)), 0);
  EXPECT_EQ(dsps(unit("fp_multiply", two_operands, {{"EMBEDDED", 0}})), 0);
  EXPECT_EQ(dsps(unit("fp_multiply", two_operands, {}, 4)), 0) << "of logic";
  EXPECT_EQ(dsps(unit("fp_add", two_operands)), 0);
}

/// Folded references once had such a multiplier. Synthesis removes it, so the bound must count it.
TEST(NeededParts, AMultiplierWhosePinIsNotConnectedCounts) {
  EXPECT_EQ(dsps(unit("fp_multiply", one_operand)), 9);
}

TEST(NeededParts, AFactorThatVariesInSomePhaseIsNoConstant) {
  const auto shared = [](rtl::Operand second) {
    std::vector<ModuleItem> items = {
        rtl::PhaseRegisters{64,
                            {"first", "factor"},
                            {{Literal{1, 0}, "", {rtl::net("x"), rtl::literal(64, 3)}},
                             {Literal{1, 1}, "", {rtl::net("z"), std::move(second)}}}}};
    for (ModuleItem& item :
         unit("fp_multiply", {{"a", rtl::net("first")}, {"b", rtl::net("factor")}})) {
      items.push_back(std::move(item));
    }
    return items;
  };
  EXPECT_EQ(dsps(shared(rtl::net("x"))), 9);
  EXPECT_EQ(nets(shared(rtl::net("x"))),
            (Texts{"first: 1 of 64", "factor: 1 of 64", "y: 2 of 52"}));
  EXPECT_EQ(dsps(shared(rtl::literal(64, 5))), 0);
  EXPECT_EQ(nets(shared(rtl::literal(64, 5))), (Texts{"first: 1 of 64", "y: 2 of 52"}));
}

TEST(NeededParts, FixedPointCountsProductsThatFitAMultiplier) {
  const auto product = [](int bits) {
    return std::vector<ModuleItem>{rtl::Instance{"fixed_product",
                                                 "unit_y",
                                                 {{"A_WIDTH", bits}, {"SQUARE", 1}},
                                                 {{"a", rtl::net("x")}, {"y", rtl::net("y")}}}};
  };
  EXPECT_EQ(dsps(product(13)), 1);
  EXPECT_EQ(dsps(product(17)), 1);
  EXPECT_EQ(dsps(product(30)), 0) << "left to synthesis";
  EXPECT_EQ(dsps(product(5)), 0);
}

/// A NaN sets one bit of the fraction that a factor stuck at zero leaves constant.
TEST(NeededParts, AResultInFloatingPointNeedsTwoBitsOfItsFraction) {
  EXPECT_EQ(nets(unit("fp_add", two_operands)), Texts{"y: 2 of 52"});
  EXPECT_EQ(nets(unit("fp_convert", one_operand, {{"RESULT_PRECISION", 24}})), Texts{"y: 2 of 23"});
}

TEST(NeededParts, AFractionOfOneBitNeedsIt) {
  EXPECT_EQ(nets(unit("fp_add", two_operands, {}, 2)), Texts{"y: 1 of 1"});
  EXPECT_EQ(nets(unit("fp_convert", one_operand, {{"RESULT_PRECISION", 24}}, 2)),
            Texts{"y: 1 of 23"});
}

TEST(NeededParts, OtherResultsNeedOneBitOfAll) {
  std::vector<ModuleItem> items = {
      rtl::Instance{"fixed_product",
                    "unit_y",
                    {{"A_WIDTH", 13}, {"B_WIDTH", 12}, {"WIDTH", 25}},
                    {{"a", rtl::net("x")}, {"b", rtl::net("z")}, {"y", rtl::net("y")}}},
      rtl::Instance{"fixed_memory_squares",
                    "unit_squares",
                    {{"WIDTH_A", 10}, {"WIDTH_B", 12}},
                    {{"a", rtl::net("x")},
                     {"b", rtl::net("z")},
                     {"y_a", rtl::net("first")},
                     {"y_b", rtl::net("second")}}}};
  EXPECT_EQ(nets(items), (Texts{"y: 1 of 25", "first: 1 of 10", "second: 1 of 12"}));
}

TEST(NeededParts, ARegisterHoldsEachValueThatWaits) {
  const auto held = [](const char* name, rtl::Operand value) {
    return rtl::HeldValue{64, name, Literal{1, 0}, std::move(value)};
  };
  EXPECT_EQ(nets({held("x_held", rtl::net("x")), held("x_later", rtl::net("x_held")),
                  held("five", rtl::literal(64, 5))}),
            (Texts{"x_held: 1 of 64", "x_later: 1 of 64"}));
}

TEST(NeededParts, WhatFollowsFromConstantsIsConstant) {
  std::vector<ModuleItem> items =
      unit("fp_add", {{"a", rtl::net("root")}, {"b", rtl::net("minus_root")}});
  const rtl::Operand negated =
      rtl::concatenation({rtl::inverted(rtl::bit("root", 63)), rtl::slice("root", 62, 0)});
  items.push_back(rtl::Wire{64, "minus_root", negated});
  items.push_back(rtl::Instance{
      "fp_square_root", "unit_root", {}, {{"a", rtl::literal(64, 2)}, {"y", rtl::net("root")}}});
  EXPECT_EQ(nets(items), Texts{});
}

TEST(NeededParts, ModulesAndLoopsCountAsOftenAsTheyOccur) {
  const rtl::ForGenerate loop = {
      "k", 1, 2, "lanes", {rtl::Instance{"lane", "lane", {}, {{"x", rtl::net("x")}}}}};
  const rtl::Module top = module_of({std::make_shared<const rtl::ForGenerate>(loop)}, "segment");
  const auto parts =
      components::needed_parts({module_of(unit("fp_multiply", two_operands), "lane"), top});
  EXPECT_EQ(parts.dsps, 2 * 9);
  EXPECT_EQ(texts(parts), (Texts{"g_lanes[1].lane.y: 2 of 52", "g_lanes[2].lane.y: 2 of 52"}));
}

/// Two products of small numbers, in logic. The factor of the second is `factor`.
Result<characterise::SynthesisResult> synthesise_products(const rtl::Operand& factor) {
  const auto product = [](const std::string& name, const rtl::Operand& b) {
    return rtl::Instance{"fp_multiply",
                         "unit_" + name,
                         {{"EXPONENT_BITS", 4},
                          {"PRECISION", 5},
                          {"EMBEDDED", 0},
                          {"CUTS", Literal{15, 0b100000000000000}}},
                         {{"aclk", rtl::net("aclk")},
                          {"a", rtl::net("x")},
                          {"b", b},
                          {"y", rtl::net(name)},
                          {"exceptional", rtl::net(name + "_exceptional")}}};
  };
  const rtl::Module module = {"products",
                              {{rtl::Direction::input, 1, "aclk"},
                               {rtl::Direction::input, 9, "x"},
                               {rtl::Direction::input, 9, "z"},
                               {rtl::Direction::output, 9, "first"},
                               {rtl::Direction::output, 9, "second"},
                               {rtl::Direction::output, 1, "first_exceptional"},
                               {rtl::Direction::output, 1, "second_exceptional"}},
                              {product("first", rtl::net("z")), product("second", factor)}};
  const test::ScratchDirectory directory;
  return characterise::synthesise(
      components::module_job(module), devices::find_device("ice40-hx8k").value(),
      {.effort = characterise::TimingEffort::area_only}, directory.path());
}

TEST(NeededParts, AProductByAFactorStuckAtZeroIsRefused) {
  const devices::Device device = devices::find_device("ice40-hx8k").value();
  if (!characterise::yosys_version(device).ok()) GTEST_SKIP() << "yosys is not installed";
  const auto whole = synthesise_products(rtl::inverted(rtl::net("z")));
  EXPECT_TRUE(whole.ok()) << whole.error().to_string();
  const auto hollow = synthesise_products(rtl::zeros(9));
  ASSERT_FALSE(hollow.ok());
  EXPECT_EQ(hollow.error().field, "second");
  EXPECT_EQ(hollow.error().received, "1 of 4 bits that vary");
}

}  // namespace
}  // namespace mixcmp::test::needed_parts_test
