#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "generator/synthesis/characterise/job_runner.hpp"
#include "generator/tasks/scene.hpp"
#include "model/cost/devices/device.hpp"

namespace mixcmp::tasks {

/// A library of unit areas to make or to complete.
struct UnitsRequest {
  std::vector<SceneRequest> scenes;  ///< whose units are candidates
  devices::Device device;
  /// Is written after each batch, so that a run can be interrupted. A new one begins with the units
  /// that come with the program.
  std::filesystem::path library;
  std::set<std::string> templates = {};  ///< only units of these; empty: of all
  int units_of_a_template = 60;          ///< so many are chosen where the scenes have more
  unsigned workers = 1;
  /// Called with the number of finished batches, the number of all, and the seconds so far.
  std::function<void(int finished, int batches, double seconds)> progress = {};
};

struct UnitsReport {
  int candidates = 0;  ///< units of the scenes
  int kept = 0;        ///< that the library had
  int measured = 0;
  std::vector<characterise::FailedJob> failed;
  int interrupted_by = 0;  ///< number of the signal that interrupted the run; 0: none
};

/// Measures the units that the scenes' lanes, references, streams and engines have: for precisions
/// of 4 to 24, all bounds and multipliers, clocks of 150 to 400 MHz, operands carried and
/// refetched. Units of templates that have changed since the library was written are measured
/// again. The choice among the units of a template depends only on their names.
Result<UnitsReport> make_unit_library(const UnitsRequest& request);

}  // namespace mixcmp::tasks
