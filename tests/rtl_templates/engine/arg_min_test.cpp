#include <gtest/gtest.h>
#include <verilated.h>

#include <cstdint>
#include <vector>

#include "arg_min_models.inc"
#include "tests/rtl_templates/engine/arg_min_run.hpp"

namespace mixcmp::test::arg_min_test {
namespace {

template <class Model>
class VerilatedArgMin : public ArgMinDut {
public:
  VerilatedArgMin() {
    context_.randReset(2);  // registers without a reset start random
    context_.randSeed(5);
    model_ = std::make_unique<Model>(&context_);
#define BIND(PORT) PORT = harness::Port(model_->PORT)
    BIND(aclk), BIND(aresetn);
    BIND(s_candidate_tvalid), BIND(s_candidate_tready), BIND(s_candidate_tdata);
    BIND(s_candidate_tlast), BIND(candidate), BIND(candidate_word);
    BIND(s_axis_tvalid), BIND(s_axis_tready), BIND(s_axis_tdata), BIND(s_axis_tuser);
    BIND(s_axis_tlast), BIND(row_word);
    BIND(pair_tvalid), BIND(pair_tready), BIND(pair_best), BIND(pair_own), BIND(pair_tag);
    BIND(result_tvalid), BIND(result_tready), BIND(result_tdata), BIND(result_tag);
    BIND(refetch_tvalid), BIND(refetch_tready), BIND(refetch_tdata);
    BIND(refetched_tvalid), BIND(refetched_tready), BIND(refetched_tdata);
    BIND(m_axis_tvalid), BIND(m_axis_tready), BIND(m_axis_tdata), BIND(m_axis_tuser);
    BIND(m_axis_tlast), BIND(overrun), BIND(rows), BIND(stalled_cycles);
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
std::unique_ptr<ArgMinDut> make() {
  return std::make_unique<VerilatedArgMin<Model>>();
}

const std::vector<ArgMinSpec> engines = {
#define ENGINE(CANDIDATES, INDEX_BITS, PLACE_BITS, WORD_LATENCY, REFERENCES) \
  {"ArgMinOf" #CANDIDATES "Places" #PLACE_BITS,                              \
   make<VArgMinOf##CANDIDATES##Places##PLACE_BITS>,                          \
   CANDIDATES,                                                               \
   INDEX_BITS,                                                               \
   PLACE_BITS,                                                               \
   WORD_LATENCY,                                                             \
   REFERENCES},
#include "arg_min_engines.inc"
#undef ENGINE
};

const std::vector<ArgMinTraffic> traffics = {
    {.name = "FullSpeed"},
    {.name = "LongLanes", .lane_latency = 12},
    {.name = "SlowCandidates", .load = 0.2},
    {.name = "SlowRows", .offer = 0.2, .nan = 0.5},
    {.name = "SlowLanes", .take = 0.3, .give = 0.5, .lane_latency = 5},
    {.name = "SlowResults", .give = 0.3},
    {.name = "SlowSink", .accept = 0.1},
    {.name = "WarySink", .accept = 0.8, .wary = true},
    {.name = "Recomputed", .undecided = 0.3, .lane_latency = 6},
    {.name = "AllRecomputed", .undecided = 1.0, .recompute = 0.4},
    {.name = "Impatient", .load = 0.6, .accept = 0.8, .lane_latency = 2, .impatient = true},
    {.name = "AllSlow",
     .load = 0.5,
     .offer = 0.5,
     .take = 0.5,
     .give = 0.5,
     .accept = 0.4,
     .undecided = 0.1,
     .recompute = 0.5,
     .nan = 0.02,
     .lane_latency = 3,
     .impatient = true},
};

class ArgMin : public ::testing::TestWithParam<ArgMinSpec> {};

TEST_P(ArgMin, EachRowLeavesOnceInOrderWithTheIndexOfItsLeastCandidate) {
  const std::uint32_t candidates = GetParam().candidates;
  for (const ArgMinTraffic& traffic : traffics) {
    SCOPED_TRACE(traffic.name);
    ArgMinRun run(GetParam(), 31, traffic);
    for (int load = 0; load < 12 && !run.failed(); ++load) run.run_load(candidates, 100);
    run.drain();
    run.check_counters();
    EXPECT_EQ(run.failure(), "");
    EXPECT_EQ(run.left(), 1200u);
    for (std::uint32_t k = 0; k < std::min(candidates, 9u); ++k) EXPECT_GT(run.chosen(k), 0u) << k;
    EXPECT_GT(run.ties(), 30u);
    EXPECT_GT(run.incomparable(), 10u);
    if (GetParam().references == 0) {
      EXPECT_EQ(run.recomputed(), 0u);
    } else {
      EXPECT_GE(run.recomputed(), traffic.undecided * 1000);
    }
  }
}

TEST_P(ArgMin, LoadsOfEveryLengthFollowOneAnother) {
  const std::uint32_t candidates = GetParam().candidates;
  for (const ArgMinTraffic& traffic : traffics) {
    SCOPED_TRACE(traffic.name);
    ArgMinRun run(GetParam(), 32, traffic);
    for (std::uint32_t count = 1; count <= candidates + 3 && !run.failed(); ++count) {
      for (const std::uint32_t rows : {20u, 0u, 1u}) run.run_load(count, rows);
    }
    for (const std::uint32_t count : {3 * candidates, candidates, 1u}) run.run_load(count, 20);
    run.drain();
    run.check_counters();
    EXPECT_EQ(run.failure(), "");
  }
}

/// Sends more rows than any power of two at which the count of rows inside could wrap.
TEST_P(ArgMin, ALoadWaitsUntilAFullChainIsEmpty) {
  const std::uint32_t candidates = GetParam().candidates;
  ArgMinRun run(GetParam(), 35, {.name = "SlowSink", .accept = 0.3});
  for (int load = 0; load < 3; ++load) run.run_load(candidates, 40 * candidates);
  run.drain();
  run.check_counters();
  EXPECT_EQ(run.failure(), "");
  EXPECT_GT(run.stalled_cycles(), 20u * candidates);
}

TEST_P(ArgMin, AResetForgetsTheLoadAndItsRows) {
  ArgMinTraffic traffic = traffics.back();
  traffic.reset = 0.02;
  ArgMinRun run(GetParam(), 33, traffic);
  for (std::uint32_t load = 0; load < 200 && !run.failed(); ++load) {
    run.run_load(1 + load % (GetParam().candidates + 1), load % 30);
    run.check_counters();
  }
  run.drain();
  EXPECT_EQ(run.failure(), "");
  EXPECT_GT(run.resets(), 50u);
}

TEST_P(ArgMin, TakesARowACycleAndAsLongAsItsLanesAndOneCycleEach) {
  const std::uint32_t candidates = GetParam().candidates;
  for (const int lane_latency : {2, 5, 12, 16}) {
    const auto latency = (candidates - 1) * (static_cast<std::uint64_t>(lane_latency) + 1) +
                         static_cast<std::uint64_t>(GetParam().word_latency) + 2;
    if (latency > std::uint64_t{1} << GetParam().place_bits) continue;  // rows wait for a place
    ArgMinRun run(GetParam(), 34, {.name = "FullSpeed", .lane_latency = lane_latency});
    run.run_load(candidates, 300);
    run.drain();
    EXPECT_EQ(run.failure(), "");
    EXPECT_EQ(run.stalled_cycles(), 0u);
    EXPECT_EQ(run.interval(), 1u);
    EXPECT_EQ(run.settling(), 2u);
    EXPECT_EQ(run.latency(), latency);
  }
}

/// One lane, one reference, and enough places.
TEST(ArgMinOfTwo, AReferenceGetsTheOperandsOfAPairACycle) {
  ArgMinRun run(engines.front(), 36,
                {.name = "AllRecomputed", .undecided = 1.0, .lane_latency = 9});
  run.run_load(2, 300);
  run.drain();
  EXPECT_EQ(run.failure(), "");
  EXPECT_EQ(run.recomputed(), 300u);
  EXPECT_EQ(run.stalled_cycles(), 0u);
  EXPECT_EQ(run.interval(), 1u);
}

std::string name_of(const ::testing::TestParamInfo<ArgMinSpec>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Engines, ArgMin, ::testing::ValuesIn(engines), name_of);

}  // namespace
}  // namespace mixcmp::test::arg_min_test
