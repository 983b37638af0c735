#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "generator/tasks/scene.hpp"
#include "verilator_tb/verify.hpp"

namespace mixcmp::tasks {

struct VerifyOptions {
  /// Simulator, judge, traffic and selection of comparisons. `verify` itself sets work_dir, jobs,
  /// traffic_seed, truth and repeat_command.
  verilator_tb::VerifyOptions run = {};
  std::filesystem::path work = {};  ///< Verilog, builds and logs; empty: TOP_simulation
  int jobs = 0;                     ///< simulators side by side; 0: one a processor
  std::optional<verilator_tb::TruthScope> truth = {};
  bool find_counterexample = true;  ///< after a failure; engines have none
};

/// The findings of a simulation.
struct Verification {
  verilator_tb::VerifyReport report;
  std::vector<std::string> not_done;  ///< parts beside the verdicts that failed, with reasons
};

/// Makes the checks that come before a simulation: on the scene, its data and the options.
Result<Done> check_verify(const SceneRequest& request, const LoadedScene& loaded,
                          const VerifyOptions& options);

/// Generates the scene's system, simulates it on the scene's data, and compares each verdict with
/// the model of its lane. Keeps the result on record for `generate`. An error means that it could
/// not be run; wrong verdicts are in the report.
Result<Verification> verify(const SceneRequest& request, const LoadedScene& loaded,
                            const VerifyOptions& options);

}  // namespace mixcmp::tasks
