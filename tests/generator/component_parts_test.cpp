#include "generator/synthesis/components/component_parts.hpp"

#include <gtest/gtest.h>

namespace mixcmp::test::component_parts_test {
namespace {

using namespace rtl;

/// The part of the sum in c + a * b: the product has `cuts` and drops some bits, the sum others.
components::Part sum_part(Bits cuts, int product_dropped, int sum_dropped) {
  const int width = 20 - product_dropped;
  Module module{.name = "m", .ports = {}, .items = {}};
  module.items.emplace_back(
      Instance{.module = "fixed_product",
               .name = "product",
               .parameters = {{"A_WIDTH", 10},
                              {"B_WIDTH", 10},
                              {"DROPPED", product_dropped},
                              {"WIDTH", width},
                              {"CUTS", Literal{2, cuts}}},
               .connections = {{"a", net("a")}, {"b", net("b")}, {"y", net("p")}}});
  module.items.emplace_back(
      Instance{.module = "fixed_sum",
               .name = "sum",
               .parameters = {{"A_WIDTH", 24},
                              {"B_WIDTH", width},
                              {"DROPPED", sum_dropped},
                              {"WIDTH", 25 - sum_dropped},
                              {"CUTS", Literal{1, 1}}},
               .connections = {
                   {"a", concatenation({net("c"), zeros(7)})}, {"b", net("p")}, {"y", net("s")}}});
  return components::parts_of({module}).instances.back();
}

int number(const components::Part& part, const std::string& name) {
  for (const Parameter& parameter : part.instance.parameters) {
    if (parameter.name == name) return static_cast<int>(std::get<long long>(parameter.value));
  }
  return 0;
}

TEST(ComponentParts, MultiplierBlocksTakeSumsOfWholeProducts) {
  EXPECT_TRUE(sum_part(2, 0, 0).is_absorbed);
  EXPECT_EQ(sum_part(2, 0, 0).kept_registers, 0);
  EXPECT_TRUE(sum_part(2, 0, 7).is_absorbed);
  EXPECT_EQ(sum_part(2, 0, 7).kept_registers, 18) << "the block's register holds all bits";
  EXPECT_FALSE(sum_part(2, 7, 0).is_absorbed) << "the product lacks its low bits";
  EXPECT_FALSE(sum_part(3, 0, 0).is_absorbed) << "a second register takes the adder's place";
}

TEST(ComponentParts, SumsHaveNoLowBitsWithoutCarry) {
  const components::Part part = sum_part(3, 0, 5);
  EXPECT_EQ(number(part, "A_WIDTH"), 19);
  EXPECT_EQ(number(part, "B_WIDTH"), 15);
  EXPECT_EQ(number(part, "DROPPED"), 0);
  EXPECT_EQ(number(part, "WIDTH"), 20);
  EXPECT_EQ(number(sum_part(3, 0, 9), "DROPPED"), 2) << "only 7 zeros";
}

}  // namespace
}  // namespace mixcmp::test::component_parts_test
