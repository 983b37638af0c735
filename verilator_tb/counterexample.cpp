#include "verilator_tb/counterexample.hpp"

#include <algorithm>
#include <chrono>

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

/// Bisects the length of the run, from its first mismatch on. Failures need not be monotonic in the
/// length, so the result is not always the shortest run.
Result<std::optional<Counterexample>> short_start(const VerifyReport& failed, const Rerun& rerun,
                                                  double seconds) {
  const auto begin = std::chrono::steady_clock::now();
  const auto has_time = [&] {
    return std::chrono::steady_clock::now() - begin < std::chrono::duration<double>(seconds);
  };
  std::optional<Counterexample> found;
  std::uint64_t passing = 0, failing = failed.requested;
  std::uint64_t next = failed.mismatches.empty() ? failing / 2 : failed.mismatches[0].index + 1;
  for (; failing - passing > 1 && has_time(); next = passing + (failing - passing) / 2) {
    const Selection::Options start{.limit = std::clamp(next, passing + 1, failing - 1)};
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
                                                           const Rerun& rerun, double seconds) {
  if (selection.only) return std::optional<Counterexample>();
  MIXCMP_TRY(alone, one_alone(failed, rerun));
  if (alone || selection.sampling != Sampling::first) return alone;
  return short_start(failed, rerun, seconds);
}

}  // namespace mixcmp::verilator_tb
