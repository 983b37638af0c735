#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "generator/faces/cli/suite_file.hpp"
#include "model/base/common/content_hash.hpp"
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

/// The words behind `mixcmp verify` that make this run.
std::vector<std::string> verify_words(const SuiteRun& run);

/// The hash of this program's bytes, for `identity`.
ContentHash hash_of_program();

/// The hash of a program's bytes continued over the run's options and the files that it reads. It
/// is an error if one cannot be read. Versions of simulators and compilers are not in it.
Result<ContentHash> identity(const SuiteRun& run, ContentHash program);

/// The name of a run's report, without its ending.
std::string key_of(const ContentHash& identity);

/// The outcome that an earlier run has left in this file; one that was skipped where it has none.
RunOutcome kept_outcome(const std::filesystem::path& kept);

/// Runs `mixcmp verify` for at most `seconds`. Keeps its report in the file `kept` if that is not
/// empty.
RunOutcome verify_run(const SuiteRun& run, const std::filesystem::path& work,
                      const std::filesystem::path& kept, double seconds);

}  // namespace mixcmp::cli
