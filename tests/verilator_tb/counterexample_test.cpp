#include "verilator_tb/counterexample.hpp"

#include <gtest/gtest.h>

namespace mixcmp::test::counterexample_test {
namespace {

using verilator_tb::Selection;
using verilator_tb::VerifyReport;

VerifyReport report(bool passed, std::uint64_t requested) {
  VerifyReport result;
  result.requested = result.comparisons = requested;
  if (!passed) result.mismatch_count = 1;
  return result;
}

/// A run of 1000 comparisons with these mismatches: the index, and one operand in hexadecimal.
VerifyReport failed(const std::vector<std::pair<std::uint64_t, std::string>>& mismatches) {
  VerifyReport result = report(false, 1000);
  for (const auto& [index, hex] : mismatches) {
    result.mismatches.push_back({.index = index, .operands = {{"a", hex, ""}}});
  }
  return result;
}

TEST(LeastCounterexample, IsTheFailingComparisonOfFewestDigits) {
  const auto found = verilator_tb::least_counterexample(
      failed({{7, "3f812345"}, {8, "00100000"}, {9, "3f800000"}}), {},
      [](const Selection::Options& selection) -> Result<VerifyReport> {
        return report(selection.only == 8u, 1);
      },
      60);
  ASSERT_TRUE(found.ok() && found->has_value());
  EXPECT_EQ((*found)->selection.only, 9u) << "8 passes alone";
}

TEST(LeastCounterexample, IsOtherwiseTheShortestStart) {
  std::vector<std::uint64_t> tried;
  const auto found = verilator_tb::least_counterexample(
      failed({{700, "1"}}), {},
      [&](const Selection::Options& selection) -> Result<VerifyReport> {
        if (!selection.only) tried.push_back(selection.limit);
        return report(selection.only.has_value() || selection.limit < 617, selection.limit);
      },
      60);
  ASSERT_TRUE(found.ok() && found->has_value());
  EXPECT_EQ((*found)->selection.limit, 617u);
  EXPECT_LE(tried.size(), 11u) << "that of the mismatch, and a bisection";
}

TEST(LeastCounterexample, OfAViolationAloneIsAShortStart) {
  const auto found = verilator_tb::least_counterexample(
      failed({}), {},
      [](const Selection::Options& selection) -> Result<VerifyReport> {
        return report(selection.limit < 3, selection.limit);
      },
      60);
  ASSERT_TRUE(found.ok() && found->has_value());
  EXPECT_EQ((*found)->selection.limit, 3u);
}

TEST(LeastCounterexample, IsNotLookedForWhereNothingCanBeLeftOut) {
  const auto found = verilator_tb::least_counterexample(
      failed({{7, "1"}}), {.only = 7},
      [](const Selection::Options&) -> Result<VerifyReport> {
        ADD_FAILURE() << "nothing to run";
        return report(true, 1);
      },
      60);
  ASSERT_TRUE(found.ok());
  EXPECT_FALSE(found->has_value());
}

TEST(LeastCounterexample, OfARandomSampleIsOneComparisonOrNothing) {
  const auto found = verilator_tb::least_counterexample(
      failed({{700, "1"}}), {.limit = 10, .sampling = verilator_tb::Sampling::random},
      [](const Selection::Options&) -> Result<VerifyReport> { return report(true, 1); }, 60);
  ASSERT_TRUE(found.ok());
  EXPECT_FALSE(found->has_value());
}

}  // namespace
}  // namespace mixcmp::test::counterexample_test
