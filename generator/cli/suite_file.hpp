#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/common/result.hpp"

namespace mixcmp::cli {

/// One run of `mixcmp verify` in a regression suite.
struct SuiteRun {
  std::filesystem::path scene;
  std::vector<std::string> options;  ///< words of the command line
  std::string name;                  ///< scene and options as the suite writes them
};

/// A regression suite as its file describes it (docs/verification.md, "Suites").
struct Suite {
  double minutes = 0;  ///< budget of time; 0: none
  std::vector<SuiteRun> runs;
};

/// Reads a suite. Scenes are found from its folder. Each [[run]] becomes one run for every
/// combination of its scenes and of its options' values.
Result<Suite> read_suite(const std::filesystem::path& path);

}  // namespace mixcmp::cli
