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
    context_.randReset(2);  // what is not reset starts random
    context_.randSeed(5);
    model_ = std::make_unique<Model>(&context_);
#define BIND(PORT) PORT = harness::Port(model_->PORT)
    BIND(aclk), BIND(aresetn);
    BIND(s_axis_tvalid), BIND(s_axis_tready), BIND(s_axis_tdata), BIND(s_axis_tlast);
    BIND(pair_tvalid), BIND(pair_tready), BIND(pair_items), BIND(pair_tag);
    BIND(result_tvalid), BIND(result_tready), BIND(result_tdata), BIND(result_tag);
    BIND(s_refetch_tvalid), BIND(s_refetch_tready), BIND(s_refetch_tdata);
    BIND(m_answer_tvalid), BIND(m_answer_tready), BIND(m_answer_tdata);
    BIND(m_axis_tvalid), BIND(m_axis_tready), BIND(m_axis_tdata), BIND(m_axis_tuser);
    BIND(m_axis_tlast), BIND(reports), BIND(busy_cycles), BIND(stalled_cycles);
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
#define ENGINE(NAME, LANES, REFERENCES, CAPACITY, INDEX_BITS, RADIX, REPORT) \
  {#NAME, make<V##NAME>, LANES, REFERENCES, CAPACITY, INDEX_BITS, RADIX, REPORT},
#include "engines.inc"
#undef ENGINE
};

const std::vector<EngineTraffic> traffics = {
    {.name = "FullSpeed"},
    {.name = "SlowItems", .offer = 0.2},
    {.name = "SlowLanes", .take = 0.3, .give = 0.5},
    {.name = "SlowResults", .give = 0.3, .undecided = 0.4},
    {.name = "SlowReports", .accept = 0.1},
    {.name = "WarySink", .accept = 0.8, .wary = true},
    {.name = "AllSlow", .offer = 0.5, .take = 0.5, .give = 0.5, .accept = 0.4, .undecided = 0.3},
};

class Pairwise : public ::testing::TestWithParam<EngineSpec> {};

/// Sets of every size in one run, one after the other: the closing beat of one lets the next in.
TEST_P(Pairwise, EveryPairMeetsOnceAndEveryReportLeavesOnce) {
  for (const EngineTraffic& traffic : traffics) {
    SCOPED_TRACE(traffic.name);
    EngineRun run(GetParam(), 21);
    for (int items = 1; items <= GetParam().capacity && !run.failed(); ++items) {
      run.run_set(items, traffic);
    }
    run.idle(200);
    run.check_counters();
    EXPECT_EQ(run.failure(), "");
    if (GetParam().capacity < 10) continue;
    EXPECT_GT(run.reported(), 1000u);
    if (GetParam().references == 0) continue;
    EXPECT_GT(run.refetched(), 500u);
  }
}

TEST_P(Pairwise, ItemsBeyondTheCapacityAreLeftOutAndTold) {
  for (const EngineTraffic& traffic : traffics) {
    SCOPED_TRACE(traffic.name);
    EngineRun run(GetParam(), 22);
    for (const int excess : {1, 7, 0, 2}) run.run_set(GetParam().capacity + excess, traffic);
    run.run_set(2, traffic);
    run.check_counters();
    EXPECT_EQ(run.failure(), "");
  }
}

TEST_P(Pairwise, EqualItemsAreItemsLikeOthers) {
  EngineRun run(GetParam(), 23);
  for (int set = 0; set < 4; ++set) run.run_set(GetParam().capacity, traffics.back(), true);
  EXPECT_EQ(run.failure(), "");
}

TEST_P(Pairwise, AResetForgetsTheSet) {
  EngineRun run(GetParam(), 24);
  EngineTraffic traffic = traffics.back();
  traffic.reset = 0.02;
  for (int set = 0; set < 200 && !run.failed(); ++set) {
    run.run_set(1 + set % GetParam().capacity, traffic);
    run.check_counters();
  }
  EXPECT_EQ(run.failure(), "");
  EXPECT_GT(run.resets(), 20u);
}

/// Words that a set takes: block by block from its first item to the last.
std::uint64_t words_of(int items, int lanes) {
  std::uint64_t words = 0;
  for (int base = 0; base + 1 < items; base += lanes) words += items - base;
  return words;
}

/// Of what is reported one leaves in a cycle: only where nothing is, lanes are never held up.
class QuietPairwise : public Pairwise {};

TEST_P(QuietPairwise, TakesAWordACycleWithoutAGap) {
  const EngineSpec& spec = GetParam();
  EngineRun run(spec, 25);
  const int segments = (spec.lanes + spec.radix - 1) / spec.radix;
  for (int items = 2; items <= spec.capacity; ++items) {
    run.run_set(items, {.name = "FullSpeed", .undecided = 0, .quiet = true});
    // Beside the words: each segment's latency, the reader's, the last pair's, the closing beat's.
    EXPECT_EQ(run.set_cycles(), words_of(items, spec.lanes) + 2 * segments + 6) << items;
  }
  EXPECT_EQ(run.failure(), "");
  EXPECT_EQ(run.stalled_cycles(), 0u);
}

/// A word that is held up is late; those between the segments may be, too, when the lanes are fast
/// again.
TEST_P(QuietPairwise, StalledCyclesAreWhatTheSetTakesLonger) {
  const EngineSpec& spec = GetParam();
  EngineRun run(spec, 26);
  const int segments = (spec.lanes + spec.radix - 1) / spec.radix;
  const std::uint64_t words = words_of(spec.capacity, spec.lanes);
  run.run_set(spec.capacity, {.name = "SlowAtFirst",
                              .take = 0.3,
                              .undecided = 0,
                              .quiet = true,
                              .slow_cycles = words / 2});
  EXPECT_EQ(run.failure(), "");
  const std::uint64_t late = run.set_cycles() - (words + 2 * segments + 6);
  EXPECT_GE(run.stalled_cycles(), words / 8);
  EXPECT_LE(run.stalled_cycles(), late);
  EXPECT_GE(run.stalled_cycles() + 2 * segments, late);
}

std::vector<EngineSpec> engines_that_leave_verdicts_out() {
  std::vector<EngineSpec> chosen;
  std::copy_if(engines.begin(), engines.end(), std::back_inserter(chosen),
               [](const EngineSpec& spec) { return spec.report != 15; });
  return chosen;
}

std::string name_of(const ::testing::TestParamInfo<EngineSpec>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Engines, Pairwise, ::testing::ValuesIn(engines), name_of);
INSTANTIATE_TEST_SUITE_P(Engines, QuietPairwise,
                         ::testing::ValuesIn(engines_that_leave_verdicts_out()), name_of);

}  // namespace
}  // namespace mixcmp::test::pairwise_test
