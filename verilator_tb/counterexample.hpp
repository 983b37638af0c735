#pragma once

#include <functional>
#include <optional>

#include "verilator_tb/report.hpp"
#include "verilator_tb/selection.hpp"

namespace mixcmp::verilator_tb {

/// A short run that fails.
struct Counterexample {
  Selection::Options selection;
  VerifyReport report;
};

/// Repeats the failed run on other comparisons, all else equal.
using Rerun = std::function<Result<VerifyReport>(const Selection::Options& selection)>;

/// Looks for the shortest run that fails as `failed` did: one of its mismatched comparisons alone,
/// that with the fewest hexadecimal digits first; otherwise, in a run from the first comparison on,
/// the fewest of those. Nothing where neither fails, for example in a random sample whose failure
/// takes several comparisons.
Result<std::optional<Counterexample>> least_counterexample(const VerifyReport& failed,
                                                           const Selection::Options& selection,
                                                           const Rerun& rerun);

}  // namespace mixcmp::verilator_tb
