#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "generator/faces/cli/planning.hpp"
#include "generator/tasks/optimise.hpp"

/// `optimise --plans`: several plans and the rule that switches between them.
namespace mixcmp::cli {

struct PlanSetOptions {
  int plans = 0;       ///< at most; 0: one plan, not a set
  std::string over;    ///< "data.radius_max=5,10,25"
  std::string stream;  ///< the same for the data of a stream, in their order
  std::optional<double> reconfiguration_seconds;
  std::filesystem::path output;  ///< a folder
};

/// Adds --plans and the options that need it to `optimise`, whose other options must be there.
void add_plan_set_options(const Verb& verb, PlanSetOptions& options);

/// The words of these options as the user writes them.
void add_to(CommandLine& line, const PlanSetOptions& options);

/// `base`: the request for one plan; `own`: its scene. `command`: it makes the same files again.
void run_plan_set(const PlanningOptions& planning, const PlanSetOptions& options,
                  tasks::OptimiseRequest base, LoadedScene own, const std::string& command);

}  // namespace mixcmp::cli
