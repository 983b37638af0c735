#include "verilator_tb/counterexample.hpp"

#include <algorithm>

namespace mixcmp::verilator_tb {

namespace {

/// Significant hexadecimal digits of all operands: zeros at either end do not count.
std::size_t digit_count(const Mismatch& mismatch) {
  std::size_t count = 0;
  for (const Mismatch::Operand& operand : mismatch.operands) {
    const auto first = operand.hex.find_first_not_of('0');
    if (first != std::string::npos) count += operand.hex.find_last_not_of('0') - first + 1;
  }
  return count;
}

std::vector<Mismatch> simplest_first(std::vector<Mismatch> mismatches) {
  std::stable_sort(mismatches.begin(), mismatches.end(),
                   [](const auto& a, const auto& b) { return digit_count(a) < digit_count(b); });
  return mismatches;
}

Result<std::optional<Counterexample>> one_alone(const VerifyReport& failed, const Rerun& rerun) {
  for (const Mismatch& mismatch : simplest_first(failed.mismatches)) {
    const Selection::Options alone{.only = mismatch.index};
    MIXCMP_TRY(report, rerun(alone));
    if (!report.passed()) return std::optional(Counterexample{alone, std::move(report)});
  }
  return std::optional<Counterexample>();
}

/// Halves the length of the run. Failures need not be monotonic in it, so this finds a short run
/// that fails after one that passes, which is not always the shortest.
Result<std::optional<Counterexample>> shortest_start(const VerifyReport& failed,
                                                     const Rerun& rerun) {
  std::optional<Counterexample> found;
  std::uint64_t passing = 0, failing = failed.requested;
  while (failing - passing > 1) {
    const Selection::Options start{.limit = passing + (failing - passing) / 2};
    MIXCMP_TRY(report, rerun(start));
    if (report.passed()) {
      passing = start.limit;
    } else {
      failing = start.limit;
      found = Counterexample{start, std::move(report)};
    }
  }
  return found;
}

}  // namespace

Result<std::optional<Counterexample>> least_counterexample(const VerifyReport& failed,
                                                           const Selection::Options& selection,
                                                           const Rerun& rerun) {
  if (selection.only) return std::optional<Counterexample>();
  MIXCMP_TRY(alone, one_alone(failed, rerun));
  if (alone || selection.sampling != Sampling::first) return alone;
  return shortest_start(failed, rerun);
}

}  // namespace mixcmp::verilator_tb
