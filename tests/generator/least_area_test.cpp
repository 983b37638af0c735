#include "generator/rtl/least_area.hpp"

#include <gtest/gtest.h>

namespace mixcmp::test::least_area_test {
namespace {

using rtl::Literal;
using rtl::ModuleItem;

constexpr Literal three_cuts = {23, 0b111};

/// A unit in binary64 with these operands, and its result y.
std::vector<ModuleItem> unit(const std::string& module, std::vector<rtl::Connection> operands,
                             std::vector<rtl::Parameter> parameters = {}, int precision = 53) {
  parameters.push_back({"PRECISION", precision});
  parameters.push_back({"CUTS", three_cuts});
  operands.push_back({"y", rtl::net("y")});
  return {rtl::Wire{64, "y", nullptr},
          rtl::Instance{module, "unit_y", std::move(parameters), std::move(operands)}};
}

rtl::Module module_of(std::vector<ModuleItem> items, const std::string& name = "reference") {
  return {
      name, {{rtl::Direction::input, 64, "x"}, {rtl::Direction::input, 64, "z"}}, std::move(items)};
}

devices::Area least(std::vector<ModuleItem> items) {
  return rtl::least_area({module_of(std::move(items))});
}

const std::vector<rtl::Connection> one_operand = {{"a", rtl::net("x")}};
const std::vector<rtl::Connection> two_operands = {{"a", rtl::net("x")}, {"b", rtl::net("z")}};
const std::vector<rtl::Connection> with_constant = {{"a", rtl::net("x")},
                                                    {"b", rtl::literal(64, 5)}};

TEST(LeastArea, AProductHasAMultiplierForEachPairOfParts) {
  EXPECT_EQ(least(unit("fp_multiply", two_operands)).dsps, 9)
      << "3 parts of 24 bits and less, 3 of 17; the last 2 bits may be multiplied by logic";
  EXPECT_EQ(least(unit("fp_multiply", two_operands, {{"FACTOR_A", 18}, {"FACTOR_B", 18}})).dsps, 9);
  EXPECT_EQ(least(unit("fp_multiply", two_operands, {}, 24)).dsps, 2);
  EXPECT_EQ(least(unit("fp_multiply", two_operands, {}, 18)).dsps, 1) << "a row of gates beside it";
}

TEST(LeastArea, ASquareHasNoPairTwice) {
  EXPECT_EQ(least(unit("fp_square", one_operand)).dsps, 6);
  EXPECT_EQ(least(unit("fp_squared_sum", two_operands)).dsps, 6);
}

TEST(LeastArea, EachTermOfAFusedSumThatIsAProductCounts) {
  const auto sum = [](rtl::Operand last) {
    const rtl::Operand a = rtl::concatenation({rtl::net("x"), rtl::net("x"), rtl::net("x")});
    const rtl::Operand b = rtl::concatenation({std::move(last), rtl::zeros(64), rtl::zeros(64)});
    return unit("fp_fused_sum", {{"a", a}, {"b", b}},
                {{"TERMS", 3}, {"SQUARES", Literal{3, 0b001}}, {"PLAIN", Literal{3, 0b010}}});
  };
  EXPECT_EQ(least(sum(rtl::net("z"))).dsps, 6 + 9);
  EXPECT_EQ(least(sum(rtl::literal(64, 5))).dsps, 6);
}

TEST(LeastArea, MultipliersThatSynthesisMayLeaveOutDoNotCount) {
  EXPECT_EQ(least(unit("fp_multiply", with_constant)).dsps, 0);
  EXPECT_EQ(least(unit("fp_multiply", two_operands, {{"EMBEDDED", 0}})).dsps, 0);
  EXPECT_EQ(least(unit("fp_multiply", two_operands, {}, 4)).dsps, 0) << "of logic";
  EXPECT_EQ(least(unit("fp_add", two_operands)).dsps, 0);
}

/// Folded references once had such a multiplier. Synthesis removes it, so the bound must count it.
TEST(LeastArea, AMultiplierWhosePinIsNotConnectedCounts) {
  EXPECT_EQ(least(unit("fp_multiply", one_operand)).dsps, 9);
}

TEST(LeastArea, AFactorThatVariesInSomePhaseIsNoConstant) {
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
  EXPECT_EQ(least(shared(rtl::net("x"))).dsps, 9);
  EXPECT_EQ(least(shared(rtl::net("x"))).registers, 63 + 63 + 63);
  EXPECT_EQ(least(shared(rtl::literal(64, 5))).dsps, 0);
  EXPECT_EQ(least(shared(rtl::literal(64, 5))).registers, 63 + 63) << "but its sign";
}

TEST(LeastArea, FixedPointCountsProductsThatFitAMultiplier) {
  const auto product = [](int bits) {
    return unit("fixed_product", one_operand, {{"A_WIDTH", bits}, {"SQUARE", 1}});
  };
  EXPECT_EQ(least(product(13)).dsps, 1);
  EXPECT_EQ(least(product(17)).dsps, 1);
  EXPECT_EQ(least(product(30)).dsps, 0) << "left to synthesis";
  EXPECT_EQ(least(product(5)).dsps, 0);
}

TEST(LeastArea, AMultiplierOfFixedPointMayHoldTheRegistersAroundIt) {
  std::vector<ModuleItem> items;
  for (const char* name : {"p", "q", "r"}) {
    items.push_back(rtl::Wire{64, name, nullptr});
    items.push_back(rtl::Instance{"fixed_sum",
                                  std::string("unit_") + name,
                                  {{"CUTS", Literal{1, 1}}},
                                  {{"a", rtl::net("x")}, {"y", rtl::net(name)}}});
  }
  EXPECT_EQ(least(items).registers, 3 * 63);
  for (ModuleItem& item : unit("fixed_product", one_operand, {{"A_WIDTH", 13}, {"SQUARE", 1}})) {
    items.push_back(std::move(item));
  }
  EXPECT_EQ(least(items).registers, 3 * 63 - 139);
}

TEST(LeastArea, ARegisterHoldsEachValueThatWaits) {
  const auto held = [](const char* name, rtl::Operand value) {
    return rtl::HeldValue{64, name, Literal{1, 0}, std::move(value)};
  };
  EXPECT_EQ(least({held("x_held", rtl::net("x")), held("z_held", rtl::net("z"))}).registers, 126);
  EXPECT_EQ(least({held("x_held", rtl::net("x")), held("x_later", rtl::net("x_held"))}).registers,
            63)
      << "both may be one shift register";
  const rtl::Operand negated =
      rtl::concatenation({rtl::inverted(rtl::bit("x", 63)), rtl::slice("x", 62, 0)});
  EXPECT_EQ(least({rtl::Wire{64, "minus_x", negated}, held("x_held", rtl::net("x")),
                   held("minus_x_held", rtl::net("minus_x"))})
                .registers,
            63)
      << "all bits but the sign are the same";
}

TEST(LeastArea, BitsThatNothingReadsHaveNoRegister) {
  std::vector<ModuleItem> items = unit("fp_add", two_operands);
  EXPECT_EQ(least(items).registers, 63);
  items.push_back(rtl::Wire{1, "unused_y", rtl::all_bits(rtl::slice("y", 9, 0))});
  EXPECT_EQ(least(items).registers, 53);
}

TEST(LeastArea, WithoutACutThereIsNoRegister) {
  std::vector<ModuleItem> items = unit("fp_add", two_operands);
  std::get<rtl::Instance>(items.back()).parameters.back().value = Literal{23, 0};
  EXPECT_EQ(least(items).registers, 0);
}

TEST(LeastArea, ModulesAndLoopsCountAsOftenAsTheyOccur) {
  const rtl::ForGenerate loop = {
      "k", 0, 3, "lanes", {rtl::Instance{"lane", "lane", {}, {{"x", rtl::net("x")}}}}};
  const rtl::Module top = module_of({std::make_shared<const rtl::ForGenerate>(loop)}, "segment");
  const devices::Area area =
      rtl::least_area({module_of(unit("fp_multiply", two_operands), "lane"), top});
  EXPECT_EQ(area.dsps, 3 * 9);
  EXPECT_EQ(area.registers, 3 * 63);
}

}  // namespace
}  // namespace mixcmp::test::least_area_test
