#include <gtest/gtest.h>
#include <verilated.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

#include "engine_models.inc"
#include "tests/rtl_templates/engine/pairwise_run.hpp"

namespace mixcmp::test::pairwise_test {
namespace {

template <class Model>
class VerilatedEngine : public EngineDut {
public:
  VerilatedEngine() {
    context_.randReset(2);  // registers without a reset start random
    context_.randSeed(5);
    model_ = std::make_unique<Model>(&context_);
#define BIND(PORT) PORT = harness::Port(model_->PORT)
    BIND(aclk), BIND(aresetn);
    BIND(s_axis_tvalid), BIND(s_axis_tready), BIND(s_axis_tdata), BIND(s_axis_tuser);
    BIND(s_axis_tlast), BIND(reference_ready);
    BIND(m_axis_tvalid), BIND(m_axis_tready), BIND(m_axis_tdata), BIND(m_axis_tuser);
    BIND(m_axis_tlast);
    BIND(reports), BIND(recomputations), BIND(busy_cycles), BIND(stalled_cycles);
#undef BIND
  }
  void eval() override {
    model_->eval();
  }

private:
  VerilatedContext context_;
  std::unique_ptr<Model> model_;
};

template <class Model>
std::unique_ptr<EngineDut> make() {
  return std::make_unique<VerilatedEngine<Model>>();
}

const std::vector<EngineSpec> engines = {
#include "engines.inc"
};

const std::vector<EngineTraffic> traffics = {
    {.name = "FullSpeed"},
    {.name = "SlowItems", .offer = 0.2},
    {.name = "SlowReferences", .answer = 0.1},
    {.name = "SlowReports", .accept = 0.1},
    {.name = "WarySink", .accept = 0.8, .wary = true},
    {.name = "AllSlow", .offer = 0.5, .answer = 0.3, .accept = 0.4},
};

class Pairwise : public ::testing::TestWithParam<EngineSpec> {};

/// Sends sets of every size in one run, one after the other: the closing beats of a set let the
/// next one in.
TEST_P(Pairwise, EveryPairMeetsOnceAndEveryReportLeavesOnce) {
  for (const EngineTraffic& traffic : traffics) {
    SCOPED_TRACE(traffic.name);
    EngineRun run(GetParam(), 21);
    for (int items = 1; items <= GetParam().capacity && !run.failed(); ++items) {
      run.run_set({.items = items}, traffic);
    }
    run.idle(200);
    run.check_counters();
    EXPECT_EQ(run.failure(), "");
    if (GetParam().capacity >= 40 && GetParam().report != 0) {
      EXPECT_GT(run.reported(), 1000u);
    }
  }
}

/// Tries every number of targets, from none to all, in sets of several sizes.
TEST_P(Pairwise, TargetsMeetTheOthersAlone) {
  for (const EngineTraffic& traffic : {traffics.front(), traffics.back()}) {
    SCOPED_TRACE(traffic.name);
    EngineRun run(GetParam(), 27);
    const int capacity = GetParam().capacity;
    for (const int items : {1, 2, 3, capacity / 2, capacity - 1, capacity}) {
      for (int targets = 0; targets <= items && !run.failed(); ++targets) {
        run.run_set({.items = std::max(items, 1), .targets = targets}, traffic);
      }
    }
    run.idle(200);
    run.check_counters();
    EXPECT_EQ(run.failure(), "");
  }
}

TEST_P(Pairwise, ItemsBeyondTheCapacityAreLeftOutAndTold) {
  for (const EngineTraffic& traffic : traffics) {
    SCOPED_TRACE(traffic.name);
    EngineRun run(GetParam(), 22);
    const int capacity = GetParam().capacity;
    for (const int excess : {1, 7, 0, 2}) {
      run.run_set({.items = capacity + excess}, traffic);
      run.run_set({.items = capacity + excess, .targets = capacity / 2}, traffic);
      run.run_set({.items = capacity + excess, .targets = capacity}, traffic);
    }
    run.run_set({.items = 2}, traffic);
    run.check_counters();
    EXPECT_EQ(run.failure(), "");
  }
}

TEST_P(Pairwise, EqualItemsAreItemsLikeOthers) {
  EngineRun run(GetParam(), 23);
  for (int set = 0; set < 4; ++set) {
    run.run_set({.items = GetParam().capacity, .equal = true}, traffics.back());
  }
  EXPECT_EQ(run.failure(), "");
}

TEST_P(Pairwise, AResetForgetsTheSet) {
  EngineRun run(GetParam(), 24);
  EngineTraffic traffic = traffics.back();
  traffic.reset = 0.02;
  for (int set = 0; set < 200 && !run.failed(); ++set) {
    const int items = 1 + set % GetParam().capacity;
    run.run_set({.items = items, .targets = set % 3 == 0 ? items / 2 : 0}, traffic);
    run.check_counters();
  }
  EXPECT_EQ(run.failure(), "");
  EXPECT_GT(run.resets(), 20u);
}

/// The number of words that a set takes: each block from its first item to the last.
std::uint64_t words_of(int items, int lanes) {
  std::uint64_t words = 0;
  for (int base = 0; base + 1 < items; base += lanes) words += items - base;
  return words;
}

/// Engines that report nothing, so nothing holds up their chain.
class QuietPairwise : public Pairwise {};

TEST_P(QuietPairwise, TakesAWordACycleWithoutAGap) {
  const EngineSpec& spec = GetParam();
  EngineRun run(spec, 25);
  std::uint64_t beside = 0;
  for (int items = 2; items <= spec.capacity; ++items) {
    run.run_set({.items = items}, {.name = "FullSpeed"});
    const std::uint64_t words = words_of(items, spec.lanes());
    if (items == 2) beside = run.set_cycles() - words;
    EXPECT_EQ(run.set_cycles(), words + beside) << items;
  }
  // Cycles besides those of the words: the conversion, the walk, three cycles a segment, the lanes,
  // the tier, the merges.
  const int tier = spec.tiered ? spec.tier_latency + 4 : 0;
  EXPECT_LE(beside, static_cast<std::uint64_t>(3 * spec.segments + spec.lane_latency +
                                               spec.word_latency + tier + 20));
  EXPECT_EQ(run.failure(), "");
  EXPECT_EQ(run.stalled_cycles(), 0u);
}

std::vector<EngineSpec> quiet_engines() {
  std::vector<EngineSpec> chosen;
  std::copy_if(engines.begin(), engines.end(), std::back_inserter(chosen),
               [](const EngineSpec& spec) { return spec.report == 0 && spec.undecided == 0; });
  return chosen;
}

std::string name_of(const ::testing::TestParamInfo<EngineSpec>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Engines, Pairwise, ::testing::ValuesIn(engines), name_of);
INSTANTIATE_TEST_SUITE_P(Engines, QuietPairwise, ::testing::ValuesIn(quiet_engines()), name_of);

}  // namespace
}  // namespace mixcmp::test::pairwise_test
