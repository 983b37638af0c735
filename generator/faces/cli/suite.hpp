#pragma once

#include <filesystem>

namespace mixcmp::cli {

struct SuiteCommand {
  std::filesystem::path suite;
  std::filesystem::path work;   ///< empty: NAME_suite
  std::filesystem::path junit;  ///< empty: none
  double minutes = 0;           ///< 0: as the suite says
  bool json = false;
};

/// Runs `mixcmp verify` for every run of the suite and prints one table. Reports are kept below the
/// work folder; a run that passed is not repeated while the program and all files that it reads are
/// the same. Ends the program unless all runs passed.
void run_suite(const SuiteCommand& command);

}  // namespace mixcmp::cli
