#include "generator/faces/cli/profiling.hpp"

#include "generator/faces/cli/exit.hpp"
#include "generator/present/report/trade_report.hpp"
#include "generator/tasks/profile.hpp"

namespace mixcmp::cli {

report::ProfileReport measure_profile(const LoadedScene& loaded,
                                      const std::set<LaneInputs>& counted,
                                      profile::ProfileOptions options) {
  options.progress = show_share;
  report::ProfileReport report = value_or_exit(tasks::measure_profile(
      loaded, {.counted = counted, .measured = {LaneInputs::exact, LaneInputs::rounded}}, options));
  show_progress("");
  return report;
}

Trades weigh(const LoadedScene& loaded, const report::ProfileReport& report,
             const estimated::MeasuredAreas& areas, const std::vector<double>& accepted) {
  Trades weighed;
  for (const profile::RateProfile& rates : report.rates) {
    for (const profile::ErrorProfile& errors : report.errors) {
      if (errors.inputs != rates.inputs) continue;
      weighed.trades.push_back(make_trade(loaded.scene, rates, errors, areas));
    }
    for (const double each : accepted) {
      weighed.accepted.push_back(report::advice(weighed.trades.back(), each));
    }
  }
  return weighed;
}

}  // namespace mixcmp::cli
