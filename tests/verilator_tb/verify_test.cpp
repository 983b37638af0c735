#include "verilator_tb/verify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "generator/hardware/emit/system.hpp"
#include "model/base/number/verdict.hpp"
#include "tests/support/sphere.hpp"
#include "tests/verilator_tb/fake_system.hpp"

namespace mixcmp::test::verify_test {
namespace {

constexpr verilator_tb::SimulatorKind simulators[] = {verilator_tb::SimulatorKind::verilator,
                                                      verilator_tb::SimulatorKind::icarus};

verilator_tb::VerifyReport run(const FakeSystem& fake, std::size_t count,
                               verilator_tb::VerifyOptions options) {
  options.work_dir = fake_work_dir() / "builds";
  const auto folder = write_fake_system(fake);
  auto report = verilator_tb::judge_system(verilator_tb::load_system(folder).value(),
                                           fake_design(fake), fake_comparisons(count), options);
  EXPECT_TRUE(report.ok()) << report.error().to_string();
  return report.ok() ? *report : verilator_tb::VerifyReport{};
}

class FakeSystems : public testing::TestWithParam<verilator_tb::SimulatorKind> {
protected:
  /// Every comparison must come back as it should, at full rate and stressed with resets.
  void expect_pass(const FakeSystem& fake) {
    for (const verilator_tb::TrafficKind traffic :
         {verilator_tb::TrafficKind::full_rate, verilator_tb::TrafficKind::stressed}) {
      const verilator_tb::VerifyReport report =
          run(fake, 3000,
              {.simulator = GetParam(),
               .traffic = traffic,
               .resets = traffic == verilator_tb::TrafficKind::stressed ? 5 : 0,
               .block_size = 1000});
      EXPECT_TRUE(report.passed()) << to_text(report);
      EXPECT_EQ(report.comparisons, 3000u);
    }
  }
};

INSTANTIATE_TEST_SUITE_P(In, FakeSystems, testing::ValuesIn(simulators), [](const auto& test) {
  return test.param == verilator_tb::SimulatorKind::icarus ? "Icarus" : "Verilator";
});

TEST_P(FakeSystems, GoodOnePasses) {
  expect_pass({.name = "good"});
}

TEST_P(FakeSystems, GoodOneInOrderPasses) {
  expect_pass({.name = "in_order", .route = FakeRoute::in_order});
}

TEST_P(FakeSystems, GoodOneWithoutReferencesPassesAndSaysUndecided) {
  const FakeSystem fake{.name = "lanes_only", .tag_bits = 64, .route = FakeRoute::none};
  expect_pass(fake);
  const verilator_tb::VerifyReport report = run(fake, 1000, {.simulator = GetParam()});
  EXPECT_GT(report.undecided, 300u);
  EXPECT_EQ(report.recomputations, 0u);
}

TEST_P(FakeSystems, GoodOneOfThreeLanesThatRefetchesPasses) {
  expect_pass({.name = "refetching", .lanes = 3, .operands = scene::OperandStore::refetched});
}

TEST_P(FakeSystems, GoodOneWithFewerTagsThanSlotsPasses) {
  expect_pass({.name = "narrow_tags", .tag_bits = 2});
}

struct Fault {
  const char* name;
  int number;             ///< +fault of fake_channel.v
  const char* violation;  ///< as reported; null: a mismatch instead
  FakeRoute route = FakeRoute::reference;
  int resets = 0;
};

std::ostream& operator<<(std::ostream& out, const Fault& fault) {
  return out << fault.name;
}

constexpr Fault faults[] = {
    {"Lost", 1, "comparison lost"},
    {"Doubled", 2, "result left twice"},
    {"Mistagged", 3, "result with a tag that is not inside"},
    {"ValidDropped", 4, "tvalid fell before tready rose"},
    {"PayloadChanged", 5, "payload changed while waiting for tready"},
    {"WrongVerdict", 6, nullptr},
    {"Hung", 7, "lane stands still"},
    {"StaleAfterReset", 8, "result from before a reset left after it", FakeRoute::reference, 3},
    {"OutOfOrder", 9, "result overtook an earlier one", FakeRoute::in_order},
    {"WrongCounter", 10, "counter is wrong"},
    {"WrongFlag", 11, nullptr},
    {"ValidInReset", 12, "tvalid high in reset", FakeRoute::reference, 3},
};

class Faults : public testing::TestWithParam<std::tuple<verilator_tb::SimulatorKind, Fault>> {};

INSTANTIATE_TEST_SUITE_P(In, Faults,
                         testing::Combine(testing::ValuesIn(simulators), testing::ValuesIn(faults)),
                         [](const auto& test) {
                           const bool icarus =
                               std::get<0>(test.param) == verilator_tb::SimulatorKind::icarus;
                           return std::string(icarus ? "Icarus" : "Verilator") +
                                  std::get<1>(test.param).name;
                         });

TEST_P(Faults, AreCaughtAndNamed) {
  const auto [simulator, fault] = GetParam();
  const bool in_order = fault.route == FakeRoute::in_order;
  const verilator_tb::VerifyReport report =
      run({.name = in_order ? "in_order" : "good", .route = fault.route}, 2000,
          {.simulator = simulator,
           .traffic = verilator_tb::TrafficKind::stressed,
           .resets = fault.resets,
           .hang_cycles = 3000,
           .repeat_command = "repeat",
           .plusargs = {"fault=" + std::to_string(fault.number)}});
  EXPECT_FALSE(report.passed()) << to_text(report);
  if (fault.violation == nullptr) {
    for (const auto& v : report.violations) EXPECT_EQ(v.fault, "counter is wrong");
    ASSERT_EQ(report.mismatch_count, 1u) << to_text(report);
    EXPECT_EQ(report.comparisons, report.requested);
    EXPECT_EQ(report.mismatches[0].repeat,
              "repeat --only " + std::to_string(report.mismatches[0].index));
    return;
  }
  ASSERT_FALSE(report.violations.empty()) << to_text(report);
  const bool named = std::any_of(report.violations.begin(), report.violations.end(),
                                 [&fault](const auto& v) { return v.fault == fault.violation; });
  EXPECT_TRUE(named) << to_text(report);
  EXPECT_EQ(report.violations[0].lane, 0u);
}

/// Unknown bits in the last of three streams, of requests that are not taken and of operands that
/// are not sent: they change no result.
TEST(Verify, FindsUnknownHandshakesOfRefetchesInIcarus) {
  for (const int fault : {0, 13, 14}) {
    const verilator_tb::VerifyReport report =
        run({.name = "refetching", .lanes = 3, .operands = scene::OperandStore::refetched}, 500,
            {.simulator = verilator_tb::SimulatorKind::icarus,
             .traffic = verilator_tb::TrafficKind::stressed,
             .plusargs = {"fault=" + std::to_string(fault)}});
    EXPECT_EQ(report.passed(), fault == 0) << to_text(report);
    EXPECT_EQ(report.mismatch_count, 0u) << to_text(report);
    for (const auto& violation : report.violations) {
      EXPECT_EQ(violation.fault, "unknown value (x) in a handshake or a beat");
      EXPECT_EQ(violation.lane, 2u);
    }
  }
}

/// The harness is the same, so each cycle is the same.
TEST(Verify, InIcarusAndInVerilatorTheReportIsTheSame) {
  for (const int fault : {0, 1, 6}) {
    nlohmann::ordered_json reports[2];
    for (const verilator_tb::SimulatorKind simulator : simulators) {
      const verilator_tb::VerifyReport report =
          run({.name = "refetching", .lanes = 3, .operands = scene::OperandStore::refetched}, 1200,
              {.simulator = simulator,
               .traffic = verilator_tb::TrafficKind::stressed,
               .resets = fault == 0 ? 3 : 0,
               .hang_cycles = 3000,
               .block_size = 100,
               .share_size = 600,
               .plusargs = {"fault=" + std::to_string(fault)}});
      EXPECT_EQ(report.passed(), fault == 0) << to_text(report);
      auto& json = reports[simulator == verilator_tb::SimulatorKind::icarus ? 1 : 0] =
          to_json(report);
      for (const char* key : {"simulator", "build_seconds", "run_seconds"}) json.erase(key);
    }
    EXPECT_EQ(reports[0], reports[1]);
  }
}

/// The emulator judges all but a sample, the recomputed ones and the mismatches. Whichever judge is
/// chosen, everything else in the report is the same.
TEST_P(FakeSystems, BothJudgesFindTheSame) {
  for (const int fault : {0, 6, 11}) {
    nlohmann::ordered_json reports[2];
    for (const auto judge :
         {verilator_tb::JudgeKind::emulator, verilator_tb::JudgeKind::golden_model}) {
      const bool by_emulator = judge == verilator_tb::JudgeKind::emulator;
      const verilator_tb::VerifyReport report =
          run({.name = "good"}, 2000,
              {.simulator = GetParam(),
               .judge = judge,
               .plusargs = {"fault=" + std::to_string(fault)}});
      EXPECT_EQ(report.passed(), fault == 0) << to_text(report);
      EXPECT_EQ(report.emulator_errors, 0u);
      if (by_emulator) {
        // The rest is one in 64, all that were recomputed, and the mismatch.
        const std::uint64_t rest = 2000 - report.judged_by_emulator;
        EXPECT_GE(rest, report.recomputations + (2000 - report.recomputations) / 100);
        EXPECT_LE(rest, report.recomputations + 2000 / 64 + 2);
      } else {
        EXPECT_EQ(report.judged_by_emulator, 0u);
      }
      reports[by_emulator ? 0 : 1] = to_json(report);
    }
    for (auto& report : reports) {
      for (const char* key : {"judged_by_emulator", "build_seconds", "run_seconds"}) {
        report.erase(key);
      }
    }
    EXPECT_EQ(reports[0], reports[1]);
  }
}

/// Seven shares, one of them short; any number of jobs gives the same report, with results in
/// order.
TEST(Verify, SharesSideBySideAreOneRun) {
  std::vector<std::uint64_t> order;
  nlohmann::ordered_json reports[2];
  for (const int jobs : {1, 3}) {
    order.clear();
    const verilator_tb::VerifyReport report =
        run({.name = "good"}, 3100,
            {.traffic = verilator_tb::TrafficKind::stressed,
             .resets = 9,
             .block_size = 100,
             .share_size = 500,
             .jobs = jobs,
             .on_result = [&](const auto& result) { order.push_back(result.index); }});
    EXPECT_TRUE(report.passed()) << to_text(report);
    EXPECT_EQ(report.comparisons, 3100u);
    ASSERT_EQ(order.size(), 3100u);
    EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
    nlohmann::ordered_json& json = reports[jobs == 1 ? 0 : 1] = to_json(report);
    json.erase("build_seconds");
    json.erase("run_seconds");
  }
  EXPECT_EQ(reports[0], reports[1]);
}

/// Shares find the same as one simulation.
TEST(Verify, SharesChangeNoVerdict) {
  const verilator_tb::VerifyReport whole = run({.name = "good"}, 3100, {});
  const verilator_tb::VerifyReport shares =
      run({.name = "good"}, 3100, {.share_size = 500, .jobs = 2});
  EXPECT_EQ(whole.verdicts, shares.verdicts);
  EXPECT_EQ(whole.recomputations, shares.recomputations);
  EXPECT_EQ(whole.latencies.decided.count, shares.latencies.decided.count);
  EXPECT_EQ(whole.counters[0].counted, shares.counters[0].counted);
  EXPECT_EQ(whole.counters[1].observed, shares.counters[1].observed);
  EXPECT_GT(shares.cycles, whole.cycles) << "each share fills and drains the lanes";
}

TEST(Verify, AFaultInOneShareFailsTheRunAndEndsIt) {
  for (const int jobs : {1, 3}) {
    const verilator_tb::VerifyReport report =
        run({.name = "good"}, 3000,
            {.hang_cycles = 3000, .share_size = 500, .jobs = jobs, .plusargs = {"fault=7"}});
    EXPECT_FALSE(report.passed());
    EXPECT_LT(report.comparisons, 500u);
    EXPECT_EQ(report.requested, 3000u);
    ASSERT_FALSE(report.violations.empty());
    EXPECT_EQ(report.violations[0].fault, "lane stands still");
  }
}

/// A long run as a sweep makes it: three portions of seven simulations, whose reports go through
/// files.
class Portions : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(WithFault, Portions, testing::Values(0, 6, 7));

TEST_P(Portions, MakeTheWholeRun) {
  verilator_tb::VerifyOptions options{.traffic = verilator_tb::TrafficKind::stressed,
                                      .resets = GetParam() == 0 ? 9 : 0,
                                      .hang_cycles = 3000,
                                      .block_size = 100,
                                      .share_size = 500,
                                      .jobs = 2,
                                      .repeat_command = "again",
                                      .plusargs = {"fault=" + std::to_string(GetParam())}};
  const auto without_times = [](nlohmann::ordered_json json) {
    json.erase("build_seconds");
    json.erase("run_seconds");
    return json;
  };
  const auto whole = without_times(to_json(run({.name = "good"}, 3100, options)));
  EXPECT_EQ(whole["passed"], GetParam() == 0);
  std::vector<verilator_tb::VerifyReport> portions;
  for (const std::uint64_t portion : {0, 1, 2}) {
    options.portion = {.number = portion, .count = 3};
    const std::string file = to_json(run({.name = "good"}, 3100, options)).dump();
    portions.push_back(verilator_tb::report_in(nlohmann::ordered_json::parse(file)));
    EXPECT_LT(portions.back().requested, 3100u);
  }
  EXPECT_EQ(without_times(to_json(verilator_tb::join_portions(portions))), whole);
}

TEST(Verify, RefusesMorePortionsThanSimulations) {
  const auto refused =
      verilator_tb::check_request(fake_design({.name = "good"}), fake_comparisons(3100),
                                  {.share_size = 500, .portion = {.number = 0, .count = 8}});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().field, "--portion");
  EXPECT_EQ(refused.error().accepted, "at most 7, or a smaller --share");
}

TEST(Verify, FullRateFeedsEveryLaneInEveryCycle) {
  const verilator_tb::VerifyReport report =
      run({.name = "lanes_only", .tag_bits = 64, .route = FakeRoute::none}, 20'000,
          {.block_size = 4096});
  EXPECT_GT(report.comparisons_per_cycle(), 1.99);
  EXPECT_EQ(report.counters.at(2).counted, 0u) << "stalls";
}

TEST(Verify, TellsResultsInOrderOfIndex) {
  std::vector<verilator_tb::VerifiedResult> results;
  const verilator_tb::VerifyReport report =
      run({.name = "good"}, 5000,
          {.selection = {.limit = 700, .sampling = verilator_tb::Sampling::random, .seed = 3},
           .traffic = verilator_tb::TrafficKind::stressed,
           .block_size = 100,
           .on_result = [&](const verilator_tb::VerifiedResult& result) {
             results.push_back(result);
           }});
  ASSERT_TRUE(report.passed()) << to_text(report);
  ASSERT_EQ(results.size(), 700u);
  for (std::size_t k = 1; k < results.size(); ++k) {
    ASSERT_LT(results[k - 1].index, results[k].index);
  }
  EXPECT_GT(results.back().index, 4900u);
  const auto comparisons = fake_comparisons(5000);
  for (const verilator_tb::VerifiedResult& result : results) {
    Bits operands[2];
    comparisons.fetch(result.index, operands);
    EXPECT_EQ(result.word.verdict() == Verdict::less, operands[0] < operands[1]);
  }
}

TEST(Verify, RepeatsOneComparisonAlone) {
  std::uint64_t index = 0;
  const verilator_tb::VerifyReport report =
      run({.name = "good"}, 5000,
          {.selection = {.only = 4321},
           .on_result = [&](const verilator_tb::VerifiedResult& result) { index = result.index; }});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.comparisons, 1u);
  EXPECT_EQ(index, 4321u);
}

TEST(Verify, CountsVerdictsThatAreNotTheTruth) {
  // The true f and g are exchanged: every verdict but equal is called wrong.
  Graph graph;
  const auto a = graph.input("a");
  const auto b = graph.input("b");
  graph.compare(b, a);
  const verilator_tb::VerifyReport report =
      run({.name = "good"}, 1000, {.truth = verilator_tb::TruthCheck{.graph = &graph}});
  ASSERT_TRUE(report.truth.has_value());
  EXPECT_FALSE(report.passed()) << "a certified lane that is wrong";
  EXPECT_EQ(report.truth->checked, 1000u);
  EXPECT_EQ(report.truth->wrong_by_lane, 1000 - report.recomputations);
  EXPECT_EQ(report.truth->wrong_by_lane + report.truth->wrong_by_reference,
            1000 - report.verdicts[1]);
  EXPECT_EQ(report.truth->not_checked(), 0u);
  EXPECT_EQ(report.truth->reference_alone_checked, 1000u);
  EXPECT_EQ(report.truth->reference_alone_wrong, 1000 - report.verdicts[1]);
  const verilator_tb::VerifyReport fewer =
      run({.name = "good"}, 1000,
          {.truth = verilator_tb::TruthCheck{.graph = &graph,
                                             .scope = verilator_tb::TruthScope::recomputed}});
  EXPECT_EQ(fewer.truth->checked, report.recomputations);
  EXPECT_EQ(fewer.truth->decided_by_lane, 1000 - report.recomputations);
}

TEST(Verify, CountsWhatNobodyDecidedAsNotChecked) {
  Graph graph;
  const auto a = graph.input("a");
  graph.compare(a, graph.input("b"));
  const verilator_tb::VerifyReport report =
      run({.name = "lanes_only", .tag_bits = 64, .route = FakeRoute::none}, 1000,
          {.truth = verilator_tb::TruthCheck{.graph = &graph}});
  ASSERT_TRUE(report.passed()) << to_text(report);
  EXPECT_GT(report.undecided, 0u);
  EXPECT_EQ(report.truth->undecided, report.undecided);
  EXPECT_EQ(report.truth->checked + report.truth->not_checked(), report.comparisons);
}

/// Whatever has left before the run stopped is checked, or counted as not checked.
TEST(Verify, AccountsForEveryResultOfARunThatStopped) {
  Graph graph;
  const auto a = graph.input("a");
  graph.compare(a, graph.input("b"));
  const verilator_tb::VerifyReport report = run({.name = "good"}, 2000,
                                                {.traffic = verilator_tb::TrafficKind::stressed,
                                                 .hang_cycles = 3000,
                                                 .truth = verilator_tb::TruthCheck{.graph = &graph},
                                                 .plusargs = {"fault=7"}});
  EXPECT_FALSE(report.passed());
  EXPECT_GT(report.comparisons, 0u);
  EXPECT_LT(report.comparisons, report.requested);
  EXPECT_EQ(report.truth->checked + report.truth->not_checked(), report.comparisons);
}

TEST(Verify, ReportsItselfAsJson) {
  const verilator_tb::VerifyReport report = run({.name = "good"}, 500, {});
  const auto json = to_json(report);
  EXPECT_EQ(json["passed"], true);
  EXPECT_EQ(json["comparisons"], 500);
  const auto& verdicts = json["verdicts"];
  EXPECT_EQ(verdicts["less"].get<int>() + verdicts["equal"].get<int>() +
                verdicts["greater"].get<int>() + verdicts["unordered"].get<int>(),
            500);
  EXPECT_EQ(json["counters"]["comparisons"]["counted"], 500);
  ASSERT_EQ(json["lane_groups"].size(), 1u);
  EXPECT_EQ(json["lane_groups"][0]["comparisons"], 500);
  EXPECT_EQ(json["lane_groups"][0]["recomputations"], json["recomputations"]);
}

TEST(VerifyReport, TellsTheColumnOfEveryInput) {
  const auto source = [](const char* input, std::uint64_t number, const char* name,
                         const char* file, const char* item) {
    data::InputSource told;
    told.input = input;
    told.column.number = number;
    told.column.name = name;
    told.source = file;
    told.item = item;
    return told;
  };
  verilator_tb::VerifyReport report;
  report.inputs.push_back(source("xi", 2, "width", "points.csv", "item i"));
  report.inputs.push_back(source("y", 0, "", "rows.npy", ""));
  EXPECT_NE(to_text(report).find(
                "\n  xi                     <- column 2 \"width\" of points.csv, item i\n"
                "  y                      <- column 0 of rows.npy\n"),
            std::string::npos)
      << to_text(report);
  const auto inputs = to_json(report).at("inputs");
  ASSERT_EQ(inputs.size(), 2U);
  EXPECT_EQ(inputs[0].at("input"), "xi");
  EXPECT_EQ(inputs[0].at("column"), 2);
  EXPECT_EQ(inputs[0].at("name"), "width");
  EXPECT_EQ(inputs[0].at("source"), "points.csv");
  EXPECT_EQ(inputs[0].at("item"), "item i");
  EXPECT_TRUE(inputs[1].at("name").is_null());
}

}  // namespace
}  // namespace mixcmp::test::verify_test
