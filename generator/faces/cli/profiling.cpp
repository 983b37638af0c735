#include "generator/faces/cli/profiling.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "generator/faces/cli/exit.hpp"
#include "generator/present/report/trade_report.hpp"

namespace mixcmp::cli {

report::ProfileReport measure_profile(const LoadedScene& loaded,
                                      const std::set<LaneInputs>& counted,
                                      profile::ProfileOptions options) {
  const scene::Scene& scene = loaded.scene;
  std::vector<LaneInputs> inputs = {scene.reduced.inputs};
  std::set<LaneInputs> others = counted;
  others.insert({LaneInputs::exact, LaneInputs::rounded});
  for (const LaneInputs other : others) {
    if (other != inputs.front()) inputs.push_back(other);
  }
  options.progress = [](const std::string& what, double share) {
    show_progress(fmt::format("{}: {:.0f} %", what, share * 100));
  };
  report::ProfileReport report{.scene = scene.name,
                               .reference = scene.reference.format,
                               .comparisons = loaded.data->size(),
                               .errors = profile_errors(scene, *loaded.data, inputs, options),
                               .rates = {}};
  for (const profile::ErrorProfile& errors : report.errors) {
    if (!counted.contains(errors.inputs)) continue;
    report.rates.push_back(profile_rates(scene, *loaded.data, errors, options));
  }
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
