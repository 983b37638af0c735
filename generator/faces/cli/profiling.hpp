#pragma once

#include <set>
#include <string>
#include <vector>

#include "generator/faces/cli/options.hpp"
#include "generator/present/report/profile_report.hpp"
#include "model/plan/profile/trade.hpp"

namespace mixcmp::cli {

/// Measures the scene's errors, for its own, exact and rounded inputs, and the rates of lanes with
/// the inputs of `counted`, which are among these or others. The scene must have data, and
/// check_profile must accept the options. Progress is shown.
report::ProfileReport measure_profile(const LoadedScene& loaded,
                                      const std::set<LaneInputs>& counted,
                                      profile::ProfileOptions options);

struct Trades {
  std::vector<profile::Trade> trades;
  std::vector<std::string> accepted;  ///< an answer to each number that was given, for each trade
};

/// Weighs wrong verdicts against area. `accepted`: wrong verdicts per million.
Trades weigh(const LoadedScene& loaded, const report::ProfileReport& report,
             const estimated::MeasuredAreas& areas, const std::vector<double>& accepted);

}  // namespace mixcmp::cli
