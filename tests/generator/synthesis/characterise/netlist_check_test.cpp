#include "generator/synthesis/characterise/netlist_check.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace mixcmp::test::netlist_check_test {
namespace {

using characterise::NeededNet;
using nlohmann::json;

/// The top "dut" with one net, "lane.product".
json netlist(const char* bits) {
  return {
      {"modules", {{"dut", {{"netnames", {{"lane.product", {{"bits", json::parse(bits)}}}}}}}}}};
}

Result<Done> check(const char* bits, const std::vector<NeededNet>& nets,
                   bool has_multipliers = false) {
  return characterise::check_nets(netlist(bits), "dut", nets, has_multipliers);
}

const NeededNet product = {.name = "lane.product", .low_bits = 4, .varying_bits = 2};

TEST(NetlistCheck, ANetWithEnoughBitsThatVaryIsThere) {
  EXPECT_TRUE(check(R"([7, "0", "x", 8, "0", "1"])", {product}).ok());
  EXPECT_TRUE(check("[7, 8]", {product}).ok()) << "cut off above";
}

TEST(NetlistCheck, ANetWithFewerIsRefused) {
  for (const char* bits : {R"(["x", "x", "x", "x", "x", "x"])", R"(["0", "1", 7, "0", 8, 9])"}) {
    const auto checked = check(bits, {product});
    ASSERT_FALSE(checked.ok()) << bits;
    EXPECT_EQ(checked.error().field, "lane.product");
    EXPECT_EQ(checked.error().accepted, "at least 2");
  }
  EXPECT_EQ(check(R"(["0", "1", 7, "0", 8, 9])", {product}).error().received,
            "1 of 4 bits that vary");
}

/// A multiplier that has taken a register in leaves an "x"; one of logic takes none.
TEST(NetlistCheck, UnknownBitsVaryBesideMultipliers) {
  const char* const taken_in = R"(["x", "x", "x", "x"])";
  EXPECT_TRUE(check(taken_in, {product}, true).ok());
  EXPECT_FALSE(check(taken_in, {product}).ok());
  EXPECT_FALSE(check(R"(["0", "0", "x", "1"])", {product}, true).ok());
}

/// Registers of a shift register have lost their names.
TEST(NetlistCheck, ANetMayBeAbsentButNotAllOfAnInstance) {
  const NeededNet sum = {.name = "lane.sum"}, other = {.name = "lanes.lane.sum"};
  EXPECT_TRUE(check("[7, 8]", {sum, product}).ok());
  const auto checked = check("[7, 8]", {product, other});
  ASSERT_FALSE(checked.ok());
  EXPECT_EQ(checked.error().field, "lanes.lane");
}

TEST(NetlistCheck, MultipliersCountWhereTheDeviceMapsThem) {
  const auto check = [](int dsps, const char* device) {
    return characterise::check_multipliers({.dsps = dsps}, {.dsps = 4, .nets = {}},
                                           devices::find_device(device).value());
  };
  EXPECT_TRUE(check(4, "virtex6-lx760").ok());
  EXPECT_TRUE(check(0, "virtex5-lx330t").ok()) << "it multiplies in LUTs";
  EXPECT_TRUE(check(0, "gw1n-9").ok()) << "Yosys has no cell for its multipliers";
  const auto checked = check(3, "virtex6-lx760");
  ASSERT_FALSE(checked.ok());
  EXPECT_EQ(checked.error().field, "dsps");
  EXPECT_EQ(checked.error().received, "3");
  EXPECT_EQ(checked.error().accepted, "at least 4");
}

}  // namespace
}  // namespace mixcmp::test::netlist_check_test
