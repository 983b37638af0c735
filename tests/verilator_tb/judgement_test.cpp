#include "verilator_tb/judgement.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "model/base/number/decimal.hpp"
#include "model/base/number/verdict.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/unproven_tie.hpp"
#include "tests/verilator_tb/fake_system.hpp"

/// Which verdicts are held against the truth, which are not and why, and the notes of a report
/// beside its numbers; without a simulator.
namespace mixcmp::test::judgement_test {
namespace {

constexpr auto less = Verdict::less, equal = Verdict::equal, greater = Verdict::greater,
               unordered = Verdict::unordered;

constexpr ResultWord recomputed(Verdict verdict) {
  return ResultWord::recomputed(verdict);
}

/// Results of a fake system, whose reference compares a with b, held against another truth.
class Truths {
public:
  explicit Truths(Graph truth, verilator_tb::TruthScope scope = verilator_tb::TruthScope::all,
                  FakeSystem fake = {})
      : graph_(std::move(truth)), scope_(scope), design_(fake_design(fake)) {}

  /// The reference computes the same f and g instead.
  Truths& by_reference_of_its_own() {
    design_.reference = reference_graph(graph_, {design_.reference.input_format});
    return *this;
  }

  Truths& hold(const std::string& a, const std::string& b, Verdict verdict) {
    return hold(a, b, ResultWord::decided(verdict));
  }

  Truths& hold(const std::string& a, const std::string& b, ResultWord word) {
    const auto format = design_.reference.input_format;
    const std::vector<Bits> operands = {from_text(format, a).value(), from_text(format, b).value()};
    verilator_tb::check_against_truth({&graph_, scope_}, design_, operands, word, count, group);
    ++comparisons;
    EXPECT_EQ(count.checked + count.not_checked(), comparisons);
    return *this;
  }

  /// The reference computes the same f and g in fixed point of so many bits.
  Truths& by_fixed_reference(int bits, const Range& range) {
    const std::vector<std::optional<Range>> ranges(graph_.inputs().size(), range);
    design_.fixed_reference = fixed::fixed_lane(graph_, design_.reference.input_format,
                                                {.format = {.bits = bits},
                                                 .bound = BoundKind::constant,
                                                 .ranges = ranges,
                                                 .is_reference = true})
                                  .value();
    return *this;
  }

  bool orders(const std::string& a, const std::string& b) const {
    const auto format = design_.reference.input_format;
    const std::vector<Bits> operands = {from_text(format, a).value(), from_text(format, b).value()};
    return verilator_tb::computes_numbers(design_, operands);
  }

  verilator_tb::TruthCount count;
  verilator_tb::GroupReport group;
  std::uint64_t comparisons = 0;

private:
  Graph graph_;
  verilator_tb::TruthScope scope_;
  design::Design design_;
};

TEST(HoldAgainstTruth, BlamesNobodyForTheRootOfAHiddenZero) {
  Truths truths(graph_of("sqrt(a / b - a / b)", "b"));
  truths.hold("3", "1", recomputed(less)).hold("3", "1", less);
  EXPECT_EQ(truths.count.checked, 2u);
  EXPECT_EQ(truths.count.wrong_by_lane + truths.count.wrong_by_reference, 0u);
  truths.hold("3", "1", recomputed(unordered)).hold("3", "1", greater);
  EXPECT_EQ(truths.count.wrong_by_reference, 1u);
  EXPECT_EQ(truths.count.wrong_by_lane, 1u);
  EXPECT_EQ(truths.group.wrong_by_lane, 1u);
}

TEST(HoldAgainstTruth, BlamesNobodyForWhatIsUndetermined) {
  const auto [f, g] = test::unproven_tie();
  Truths truths(graph_of(f, g));
  for (const Verdict verdict : all_verdicts) {
    truths.hold("0.3", "0.7", verdict).hold("0.3", "0.7", recomputed(verdict));
  }
  EXPECT_EQ(truths.count.undetermined, 8u);
  EXPECT_EQ(truths.count.checked, 0u);
  EXPECT_EQ(truths.count.wrong_by_lane + truths.count.wrong_by_reference, 0u);
  EXPECT_EQ(truths.group.wrong_by_lane, 0u);
}

TEST(HoldAgainstTruth, HoldsLanesButNoReferenceWhereThereIsNoValue) {
  for (const char* f : {"a + b", "a / (b - 1)", "1 / (a / (b - 1))", "a + sqrt(-b)"}) {
    Truths truths(graph_of(f, "b"));
    truths.by_reference_of_its_own();
    const std::string a = f == std::string("a + b") ? "inf" : "3";
    truths.hold(a, "1", recomputed(greater)).hold(a, "1", recomputed(unordered));
    EXPECT_EQ(truths.count.undefined, 2u) << f;
    truths.hold(a, "1", greater);
    EXPECT_EQ(truths.count.wrong_by_lane, 1u) << f;
    EXPECT_EQ(truths.count.wrong_by_reference + truths.count.reference_alone_checked, 0u) << f;
  }
}

/// a^2 - b is negative, but 0 as the reference rounds it.
TEST(HoldAgainstTruth, BlamesAReferenceThatOrdersWhatHasNoValue) {
  Truths truths(graph_of("sqrt(a * a - b)", "b"));
  truths.by_reference_of_its_own();
  const std::string a = "1.0244140625", b = "1.0498046875";
  truths.hold(a, b, recomputed(less)).hold(a, b, recomputed(unordered));
  EXPECT_EQ(truths.count.wrong_by_reference, 1u);
  EXPECT_EQ(truths.count.ordered_without_value, 1u);
  EXPECT_EQ(truths.count.undefined, 1u);
  EXPECT_EQ(truths.count.checked, 1u);
  EXPECT_EQ(truths.count.reference_alone_checked, 0u) << "there is no true order";
}

/// log(a - b) has no value. References of lanes' kind are unordered there, as they must be.
TEST(HoldAgainstTruth, BlamesAReferenceInFixedPointForTheLogarithmOfANegativeNumber) {
  Truths truths(graph_of("log(a - b)", "b"));
  truths.by_fixed_reference(8, {0, 2});
  for (const char* b : {"1.0009765625", "1.001953125", "1.5", "2"}) {
    EXPECT_FALSE(truths.orders("1", b)) << b;
    truths.hold("1", b, recomputed(unordered));
  }
  EXPECT_TRUE(truths.orders("1.75", "0.25"));
  EXPECT_EQ(truths.count.undefined, 4u);
  EXPECT_EQ(truths.count.wrong_by_reference, 0u);
}

TEST(HoldAgainstTruth, SaysWhatItsScopeLeavesOut) {
  Truths truths(graph_of("a", "b"), verilator_tb::TruthScope::recomputed);
  truths.hold("1", "2", greater).hold("1", "2", recomputed(less));
  EXPECT_EQ(truths.count.decided_by_lane, 1u);
  EXPECT_EQ(truths.count.checked, 1u);
  EXPECT_EQ(truths.count.wrong_by_lane, 0u);
}

TEST(HoldAgainstTruth, CountsTheUndecided) {
  Truths truths(graph_of("a", "b"), verilator_tb::TruthScope::all, {.route = FakeRoute::none});
  truths.hold("1", "2", ResultWord(8 | 2)).hold("1", "2", less);
  EXPECT_EQ(truths.count.undecided, 1u);
  EXPECT_EQ(truths.count.checked, 1u);
  EXPECT_EQ(truths.count.reference_alone_checked, 0u) << "there is no reference";
}

TEST(HoldAgainstTruth, HoldsTheReferenceWhereALaneDecided) {
  Truths truths(graph_of("a + 0.0001", "b"));  // the reference compares a with b
  truths.hold("1", "1", greater).hold("1", "2", less).hold("1", "1", recomputed(equal));
  EXPECT_EQ(truths.count.reference_alone_checked, 3u);
  EXPECT_EQ(truths.count.reference_alone_wrong, 2u);
  EXPECT_EQ(truths.count.wrong_by_lane, 0u);
  EXPECT_EQ(truths.count.wrong_by_reference, 1u);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// 100 comparisons, 10 of them recomputed.
verilator_tb::VerifyReport usual_report() {
  verilator_tb::VerifyReport report;
  report.references = 1;
  report.requested = report.comparisons = 100;
  report.verdicts = {60, 10, 30, 0};
  report.recomputations = 10;
  report.groups = {
      {.name = "s8e8", .lanes = 2, .certified = true, .comparisons = 100, .recomputations = 10}};
  return report;
}

void expect_note(const verilator_tb::VerifyReport& report, const std::string& note) {
  const auto notes = verilator_tb::notes_on(report);
  EXPECT_EQ(notes, std::vector<std::string>{note});
  EXPECT_TRUE(contains(to_text(report), note)) << to_text(report);
  EXPECT_EQ(to_json(report)["notes"][0], note);
  EXPECT_TRUE(report.passed());
}

TEST(Report, SaysWhatWasNotCheckedAndWhy) {
  verilator_tb::VerifyReport report = usual_report();
  report.truth = verilator_tb::TruthCount{.checked = 93,
                                          .reference_alone_checked = 93,
                                          .reference_alone_wrong = 4,
                                          .undefined = 2,
                                          .undetermined = 1,
                                          .undecided = 3,
                                          .decided_by_lane = 1};
  const std::string text = to_text(report);
  EXPECT_TRUE(contains(text,
                       "against the truth      93 checked, 0 wrong by a lane, 0 by a reference\n"
                       "  not checked            7: 1 decided by a lane, 2 where f or g has no "
                       "value, 1 whose truth is undetermined, 3 undecided\n"
                       "  reference by itself    wrong on 4 of 93 checked\n"))
      << text;
  const auto json = to_json(report)["truth"];
  EXPECT_EQ(json["not_checked"]["total"], 7);
  EXPECT_EQ(json["not_checked"]["undefined"], 2);
  EXPECT_EQ(json["not_checked"]["undetermined"], 1);
  EXPECT_EQ(json["not_checked"]["undecided"], 3);
  EXPECT_EQ(json["not_checked"]["decided_by_lane"], 1);
  EXPECT_EQ(json["reference_alone_checked"], 93);
  EXPECT_EQ(json["reference_alone_wrong"], 4);
}

/// Every member has a value that is not its default and that no other member has.
verilator_tb::VerifyReport filled_report() {
  const verilator_tb::Latencies latencies = {
      .decided = {.count = 90, .minimum_cycles = 3, .maximum_cycles = 9, .total_cycles = 401},
      .recomputed = {.count = 10, .minimum_cycles = 21, .maximum_cycles = 29, .total_cycles = 251},
      .undecided = {.count = 5, .minimum_cycles = 4, .maximum_cycles = 8, .total_cycles = 31}};
  return {.system = "spheres",
          .simulator = verilator_tb::icarus_name,
          .lanes = 2,
          .lanes_per_group = 12,
          .references = 6,
          .certified = true,
          .inputs = {{.input = "x", .column = {.number = 13, .name = "width"}, .source = "a.csv"}},
          .groups = {{.name = "s8e8",
                      .lanes = 7,
                      .certified = true,
                      .comparisons = 101,
                      .recomputations = 14,
                      .undecided = 15,
                      .mismatches = 16,
                      .wrong_by_lane = 17,
                      .latencies = latencies}},
          .requested = 105,
          .comparisons = 100,
          .verdicts = {61, 11, 32, 18},
          .recomputations = 10,
          .undecided = 5,
          .resets = 19,
          .cycles = 40,
          .latencies = latencies,
          .counters = {{"comparisons", 48, 47}},
          .judged_by_emulator = 55,
          .emulator_errors = 56,
          .mismatch_count = 57,
          .mismatches = {{.index = 71,
                          .items = "72, 73",
                          .operands = {{"x", "3f", "1.5"}},
                          .expected = "less",
                          .got = "greater",
                          .lane = 74,
                          .cycle = 75,
                          .simulation = 76,
                          .repeat = "again"}},
          .violation_count = 58,
          .violations =
              {{.fault = "hung", .lane = 81, .cycle = 82, .details = "why", .simulation = 83}},
          .truth = verilator_tb::TruthCount{.checked = 91,
                                            .wrong_by_lane = 92,
                                            .wrong_by_reference = 93,
                                            .ordered_without_value = 90,
                                            .reference_alone_checked = 94,
                                            .reference_alone_wrong = 95,
                                            .undefined = 96,
                                            .undetermined = 97,
                                            .undecided = 98,
                                            .decided_by_lane = 99},
          .build_seconds = 1.5,
          .run_seconds = 2.5};
}

TEST(Report, IsReadBackFromItsJson) {
  const verilator_tb::VerifyReport report = filled_report();
  const auto json = to_json(report);
  EXPECT_EQ(to_json(verilator_tb::report_in(json)).dump(2), json.dump(2));
  EXPECT_EQ(to_text(verilator_tb::report_in(json)), to_text(report));
}

TEST(Report, SaysThatGroupsOfLanesCountWords) {
  verilator_tb::VerifyReport report = usual_report();
  report.lanes = 2;
  report.counters = {{"comparisons", 50, 50}, {"recomputations", 10, 10}};
  EXPECT_TRUE(contains(to_text(report), "counter comparisons    50 (observed 50)\n"));
  report.lanes_per_group = 2;
  const std::string text = to_text(report);
  for (const char* line : {"p_L = 2 in groups of 2, p_H = 1", "50 words of 2 (observed 50)\n",
                           "counter recomputations 10 (observed 10)\n"}) {
    EXPECT_TRUE(contains(text, line)) << text;
  }
  EXPECT_EQ(to_json(report)["lanes_per_group"], 2);
}

TEST(Report, HasNoNotesOnTheUsual) {
  EXPECT_TRUE(verilator_tb::notes_on(usual_report()).empty());
  EXPECT_EQ(to_json(usual_report())["notes"], nlohmann::ordered_json::array());
  EXPECT_FALSE(contains(to_text(usual_report()), "note"));
}

TEST(Report, NotesLanesThatDecidedNothing) {
  verilator_tb::VerifyReport report = usual_report();
  report.groups.push_back(report.groups.front());
  report.groups.back().name = "s4e8";
  report.groups.back().recomputations = 100;
  expect_note(report, "the lanes s4e8 decided nothing: all of 100 comparisons were recomputed");
  report.groups.back().recomputations = 0;
  report.groups.back().undecided = 100;
  expect_note(report, "the lanes s4e8 decided nothing: all of 100 comparisons were left undecided");
  report.groups.back().undecided = 99;
  EXPECT_TRUE(verilator_tb::notes_on(report).empty());
}

TEST(Report, SaysWhoJudged) {
  verilator_tb::VerifyReport report = usual_report();
  report.judged_by_emulator = report.comparisons - 10;
  EXPECT_TRUE(contains(to_text(report), "the emulator; the golden model for 10 of them"));
  report.judged_by_emulator = 0;
  EXPECT_TRUE(contains(to_text(report), "judged by              the golden model (MPFR, GMP)\n"));
}

TEST(Report, AddsSimulationsAndSaysWhichOneFoundSomething) {
  verilator_tb::VerifyReport sum = usual_report();
  verilator_tb::VerifyReport share = usual_report();
  share.mismatches.resize(verilator_tb::VerifyReport::kept - 1, {.cycle = 7});
  share.violations.push_back({"comparison lost", 1, 8, ""});
  share.groups.front().latencies.decided = {.count = 2, .minimum_cycles = 3, .maximum_cycles = 900};
  sum.add(share, 4);
  sum.add(share, 5);
  EXPECT_EQ(sum.comparisons, 300u);
  EXPECT_EQ(sum.requested, 300u);
  EXPECT_EQ(sum.groups.front().comparisons, 300u);
  EXPECT_EQ(sum.groups.front().latencies.decided.maximum_cycles, 900u);
  ASSERT_EQ(sum.mismatches.size(), verilator_tb::VerifyReport::kept);
  EXPECT_EQ(sum.mismatches.front().simulation, 4u);
  EXPECT_EQ(sum.mismatches.back().simulation, 5u);
  EXPECT_TRUE(contains(to_text(sum), "cycle 8 of simulation 5, lane 1: comparison lost"));
}

TEST(Report, FailsWhereTheEmulatorErred) {
  verilator_tb::VerifyReport report = usual_report();
  ASSERT_TRUE(report.passed());
  report.judged_by_emulator = 90;
  report.emulator_errors = 1;
  EXPECT_FALSE(report.passed());
  EXPECT_TRUE(contains(to_text(report), "emulator's errors      1\n")) << to_text(report);
  EXPECT_EQ(to_json(report)["emulator_errors"], 1);
}

TEST(Report, NotesLanesThatSawNothing) {
  verilator_tb::VerifyReport report = usual_report();
  report.groups.push_back({.name = "s4e8", .lanes = 1, .certified = true});
  expect_note(report, "no comparison went through the lanes s4e8");
}

TEST(Report, NotesARunOfNothing) {
  verilator_tb::VerifyReport report = usual_report();
  report.requested = report.comparisons = report.recomputations = 0;
  expect_note(report, "no comparison was made, so nothing was verified");
}

TEST(Report, NotesWrongVerdictsThatPass) {
  verilator_tb::VerifyReport report = usual_report();
  report.groups.front().certified = false;
  report.groups.front().wrong_by_lane = 3;
  expect_note(report,
              "the lanes s8e8 decided 3 of 100 comparisons wrongly, which does not fail since they "
              "are not certified");
}

TEST(Report, NotesWhatWasNotPutToTheTest) {
  verilator_tb::VerifyReport report = usual_report();
  report.recomputations = 0;
  expect_note(report,
              "none of these comparisons was recomputed: they put no reference to the test");
  report = usual_report();
  report.verdicts = {0, 0, 0, 100};
  expect_note(report, "every verdict is unordered");
  report = usual_report();
  report.truth = verilator_tb::TruthCount{.undefined = 100};
  expect_note(report, "no verdict was held against the truth");
}

}  // namespace
}  // namespace mixcmp::test::judgement_test
