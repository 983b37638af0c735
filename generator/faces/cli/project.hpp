#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "generator/faces/cli/options.hpp"
#include "generator/hardware/emit/system.hpp"
#include "generator/project/project.hpp"

namespace mixcmp::cli {

/// --project TOOL[,TOOL...] and its options.
struct ProjectOptions {
  std::set<project::Tool> tools;
  std::uint64_t vectors = 1000;  ///< comparisons of the test bench
};

void add_project_options(const Verb& verb, ProjectOptions& options);

/// Refuses a project that runs a test bench of a scene without data.
Result<Done> check_project(const ProjectOptions& options, const LoadedScene& loaded);

/// Adds the files of the project to those of the system, where one was asked for. `command` made
/// the system. Ends the program if a tool cannot have a project of this system.
void add_project(emit::GeneratedSystem& system, const ProjectOptions& options,
                 const LoadedScene& loaded, const design::Design& design,
                 const CommandLine& command);

}  // namespace mixcmp::cli
