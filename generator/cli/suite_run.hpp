#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "generator/cli/suite_file.hpp"
#include "verilator_tb/junit.hpp"

namespace mixcmp::cli {

using Outcome = verilator_tb::JUnitCase::Outcome;

/// "passed", "FAILED", "not run", "no time".
const char* word_for(Outcome outcome);

/// The outcome of one run of a suite.
struct RunOutcome {
  Outcome outcome = Outcome::skipped;
  double seconds = 0;
  std::string report;                 ///< of `verify --json`, its text; empty where there is none
  std::filesystem::path report_file;  ///< empty where there is none
  std::string error;                  ///< why it could not be run
};

/// The report of a run; null where there is none.
nlohmann::ordered_json report_of(const RunOutcome& outcome);

/// The bytes of this program, for `identity`.
std::string this_program();

/// The hash of the files that a run reads, `program` included, and of its options; nothing where
/// the scene cannot be read. Versions of simulators and compilers are not in it.
std::optional<std::string> identity(const SuiteRun& run, const std::string& program);

/// The outcome that an earlier run has left in this file; one that was skipped where it has none.
RunOutcome kept_outcome(const std::filesystem::path& kept);

/// Runs `mixcmp verify` for so many seconds at most, and keeps its report in the file `kept` if
/// that is not empty.
RunOutcome verify_run(const SuiteRun& run, const std::filesystem::path& work,
                      const std::filesystem::path& kept, double seconds);

}  // namespace mixcmp::cli
