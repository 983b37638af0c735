#pragma once

#include <set>

#include "generator/present/report/profile_report.hpp"
#include "generator/tasks/scene.hpp"
#include "model/plan/profile/profile.hpp"

namespace mixcmp::tasks {

/// The kinds of inputs of lanes beside the scene's own.
struct ProfiledInputs {
  std::set<LaneInputs> counted;        ///< their errors are measured and their rates counted
  std::set<LaneInputs> measured = {};  ///< only their errors are measured
};

/// Measures errors and counts recomputations and wrong verdicts on the scene's data. It is an error
/// if the scene has no data, or if check_profile refuses the options. The scene's own inputs come
/// first in the result; their rates are there if `inputs` counts them.
Result<report::ProfileReport> measure_profile(const LoadedScene& loaded,
                                              const ProfiledInputs& inputs,
                                              const profile::ProfileOptions& options);

}  // namespace mixcmp::tasks
