#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/base/common/result.hpp"
#include "model/base/settings/settings.hpp"

namespace mixcmp::cli {

/// One run of a verb, `verify` or `characterise`, that a table of a suite or a sweep asks for.
struct SuiteRun {
  std::filesystem::path scene;
  std::vector<std::string> options;  ///< words of the command line
  std::string name;                  ///< scene and options as the file writes them
  int portions = 1;                  ///< in how many portions a sweep makes it
  std::string group = {};            ///< "run", the table of the file that asks for it
  std::string file = {};             ///< the file of that table
  int line = 0;                      ///< the line of that table
};

/// A regression suite as its file describes it (docs/verification.md, "Suites").
struct Suite {
  double minutes = 0;  ///< budget of time; 0: none
  std::vector<SuiteRun> runs;
};

/// The keys that a table [[name]] of a suite or a sweep may have besides `scenes` and keys of the
/// scene.
struct GroupForm {
  std::string name;
  std::vector<std::string> options;  ///< that take a value: `first = 3` is --first=3
  std::vector<std::string> flags;    ///< `area_only = true` is --area-only
  bool has_portions = false;
};
/// [[run]]: runs of `mixcmp verify`.
const GroupForm& verify_group();

/// A mistake in the request of a group, with the group's place and the run's name.
Error mistake_in(const SuiteRun& run, const Error& error);

/// Reads all tables of this form.
Result<std::vector<SuiteRun>> read_groups(const settings::Settings& file, const GroupForm& form);

/// Reads a suite. Scenes are found from its folder. Each [[run]] becomes one run for every
/// combination of its scenes and of its options' values.
Result<Suite> read_suite(const std::filesystem::path& path);

}  // namespace mixcmp::cli
