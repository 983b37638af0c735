#include <gtest/gtest.h>

#include "generator/hardware/datapath/delays.hpp"
#include "generator/hardware/datapath/logic_product.hpp"
#include "generator/hardware/datapath/scheduler.hpp"
#include "generator/hardware/datapath/units.hpp"
#include "tests/support/graphs.hpp"

/// Squares of logic whose late bits are added a cycle behind the others.
namespace mixcmp::test::split_square_test {
namespace {

/// The unit of an operation in s53e8 without embedded multipliers.
datapath::Unit unit_of_logic(Operation operation, const datapath::DelayTable& delays) {
  const TypedNode node{
      .operation = operation, .operand_format = format("s53e8"), .format = format("s53e8")};
  return datapath::unit_for(node, Subnormals::gradual, {}, scene::Multipliers::logic, delays);
}

TEST(Schedule, SquaresOfLogicAreSplitWhereTheirSumsAreTooLong) {
  const datapath::DelayTable virtex5 = datapath::delays_of("virtex5-lx330t").value();
  const auto placed = [](Operation operation, const datapath::DelayTable& delays, double mhz) {
    return datapath::Scheduler(delays, mhz).place(unit_of_logic(operation, delays), {});
  };
  EXPECT_EQ(placed(Operation::square, virtex5, 200).unit.product_form,
            datapath::LogicProduct::Form::plain);
  const datapath::Step split = placed(Operation::square, virtex5, 330);
  EXPECT_EQ(split.unit.product_form, datapath::LogicProduct::Form::split);
  EXPECT_TRUE(split.cuts[9]) << "the last of the product's: there the lower places wait";
  EXPECT_TRUE(split.cuts[8]) << "the upper places have no register at the last one";
  EXPECT_EQ(placed(Operation::multiply, virtex5, 330).unit.product_form,
            datapath::LogicProduct::Form::plain);
  const datapath::DelayTable ice40 = datapath::delays_of("ice40-hx8k").value();
  EXPECT_EQ(placed(Operation::square, ice40, 330).unit.product_form,
            datapath::LogicProduct::Form::behind_digits);
}

/// A square of 53 bits has 105 places of sums in 26 rows; those from 78 up are late. Row k begins
/// at place 2 k and has 2 k + 5 bits.
TEST(Schedule, SplitSquaresHaveShortChains) {
  const datapath::LogicProduct square(53, datapath::LogicProduct::Kind::square,
                                      datapath::LogicProduct::Form::split);
  EXPECT_EQ(square.longest_chains(0).early, 39) << "row 17, to place 73";
  EXPECT_EQ(square.longest_chains(0).late, 27) << "row 25, from 78 to 105";
  EXPECT_EQ(square.longest_chains(5).early, 47) << "from row 16 at place 32, and the carry";
  EXPECT_EQ(square.longest_chains(5).late, 27);
  EXPECT_EQ(square.longest_chains(6).early, 0);
  const datapath::LogicProduct whole(53, datapath::LogicProduct::Kind::square);
  EXPECT_EQ(whole.longest_chains(0).early, 55) << "row 25";
  EXPECT_EQ(whole.longest_chains(5).early, 73);
  EXPECT_EQ(whole.longest_chains(5).late, 0);
}

/// The early chain of level 2 grows by two bits beyond that of level 1, the late one by four: so of
/// its 41 bits the chain of level 1 runs along with 37.
TEST(Schedule, LateChainsOfSplitSquaresRunAlongWithLateOnes) {
  const datapath::DelayTable delays = datapath::delays_of("virtex5-lx330t").value();
  const datapath::Unit plain = unit_of_logic(Operation::square, delays);
  ASSERT_EQ(plain.faster_form.size(), 1u);
  const std::vector<datapath::Stage>& stages = plain.faster_form.front().stages;
  ASSERT_EQ(stages[5].name, "level 2");
  EXPECT_DOUBLE_EQ(stages[5].overlap_ns, 37 * delays.carry_ns_per_bit);
  EXPECT_TRUE(stages[8].registered);
  ASSERT_EQ(stages[9].name, "level 6");
  EXPECT_TRUE(stages[9].registered) << "there the early bits wait, whatever the period is";
}

}  // namespace
}  // namespace mixcmp::test::split_square_test
