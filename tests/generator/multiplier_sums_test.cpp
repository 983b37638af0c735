#include "generator/hardware/datapath/multiplier_sums.hpp"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <vector>

#include "generator/hardware/datapath/delays.hpp"
#include "generator/hardware/datapath/schedule.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/sphere.hpp"

namespace mixcmp::test::multiplier_sums_test {
namespace {

/// [kind of node]: how many cycles it takes, for each node of that kind, in order.
std::map<Operation, std::vector<int>> latencies(const fixed::FixedLane& lane,
                                                const datapath::Schedule& schedule) {
  std::map<Operation, std::vector<int>> found;
  for (std::size_t id = 0; id < lane.nodes.size(); ++id) {
    const datapath::Step& step = schedule.steps[id];
    found[lane.nodes[id].operation].push_back(step.ready_cycle - step.start_cycle);
  }
  return found;
}

fixed::FixedLane lane_of(const Graph& graph, const Range& range) {
  const fixed::FixedOptions options = {.format = {9},
                                       .ranges = {graph.inputs().size(), std::optional(range)}};
  return fixed::fixed_lane(graph, format_of(53, 8), options).value();
}

/// The first square of a sum has two registers at this clock. Each further one has the register in
/// front of the adder behind its multiplier, and ends in the cycle in which that adds. The square
/// that is subtracted joins nothing.
TEST(MultiplierSums, ProductsJoinTheSumsThatReadThem) {
  const fixed::FixedLane lane = lane_of(sphere_graph(), {0, 100});
  const auto lasting = [&](const char* device) {
    const datapath::DelayTable delays = datapath::delays_of(device).value();
    const auto schedule = datapath::schedule_lane(lane, scene::Multipliers::embedded, delays, 400);
    for (const auto& [sum, product] : datapath::multiplier_sums(lane, delays)) {
      EXPECT_EQ(schedule.steps[product].ready_cycle, schedule.steps[sum].start_cycle);
      EXPECT_EQ(schedule.steps[product].cuts, (std::vector{true, false}));
    }
    return latencies(lane, schedule)[Operation::square];
  };
  EXPECT_EQ(lasting("virtex6-lx760"), (std::vector{2, 1, 1, 2}));
  EXPECT_EQ(lasting("virtex5-lx330t"), (std::vector{2, 2, 2, 2})) << "synthesis uses no adders";
}

/// A product that two nodes read, one that loses bits, and one wider than a multiplier.
TEST(MultiplierSums, OtherProductsJoinNone) {
  const datapath::DelayTable delays = datapath::delays_of("virtex6-lx760").value();
  const auto sums = [&](const char* f, const Range& range, int bits) {
    const Graph graph = graph_of(f, "c");
    const fixed::FixedOptions options = {.format = {bits},
                                         .ranges = {graph.inputs().size(), std::optional(range)}};
    const auto lane = fixed::fixed_lane(graph, format_of(53, 8), options).value();
    return datapath::multiplier_sums(lane, delays).size();
  };
  EXPECT_EQ(sums("a * b + c", {0, 4}, 9), 1u);
  EXPECT_EQ(sums("c + a * b", {0, 4}, 9), 1u);
  EXPECT_EQ(sums("c - a * b", {0, 4}, 9), 0u);
  EXPECT_EQ(sums("max(a * b + c, a * b)", {0, 4}, 9), 0u);
  EXPECT_EQ(sums("a * b + c", {0, 4}, 17), 1u);
  EXPECT_EQ(sums("a * b + c", {0, 4}, 18), 0u);
}

}  // namespace
}  // namespace mixcmp::test::multiplier_sums_test
