#include "generator/tasks/profile.hpp"

namespace mixcmp::tasks {

Result<report::ProfileReport> measure_profile(const LoadedScene& loaded,
                                              const ProfiledInputs& inputs,
                                              const profile::ProfileOptions& options) {
  MIXCMP_DO(check_has_data(loaded, "a profile needs data to measure"));
  const scene::Scene& scene = loaded.scene;
  MIXCMP_DO(check_profile(scene, options));
  std::vector<LaneInputs> measured = {scene.reduced.inputs};
  std::set<LaneInputs> others = inputs.counted;
  others.insert(inputs.measured.begin(), inputs.measured.end());
  others.erase(scene.reduced.inputs);
  measured.insert(measured.end(), others.begin(), others.end());
  report::ProfileReport report{.scene = scene.name,
                               .reference = scene.format_of_reference(),
                               .comparisons = loaded.data->size(),
                               .errors = profile_errors(scene, *loaded.data, measured, options),
                               .rates = {}};
  for (const profile::ErrorProfile& errors : report.errors) {
    if (!inputs.counted.contains(errors.inputs)) continue;
    report.rates.push_back(profile_rates(scene, *loaded.data, errors, options));
  }
  return report;
}

}  // namespace mixcmp::tasks
