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

/// Looks for a short run that fails. First come single comparisons among the mismatched ones, that
/// with the fewest hexadecimal digits first. Otherwise, for a run from the first comparison on, its
/// length is bisected until this has taken `seconds`. Returns nothing where neither fails, for
/// example in a random sample whose failure takes several comparisons.
Result<std::optional<Counterexample>> least_counterexample(const VerifyReport& failed,
                                                           const Selection::Options& selection,
                                                           const Rerun& rerun, double seconds);

}  // namespace mixcmp::verilator_tb
