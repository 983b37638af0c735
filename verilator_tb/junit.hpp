#pragma once

#include <string>
#include <vector>

namespace mixcmp::verilator_tb {

struct VerifyReport;

/// One test of a JUnit report.
struct JUnitCase {
  enum class Outcome {
    passed,
    failed,   ///< hardware and model differ
    broken,   ///< could not be run
    skipped,  ///< no time was left for it
  };

  std::string name;
  double seconds = 0;
  Outcome outcome = Outcome::passed;
  std::string message;  ///< one line; empty where it passed
  std::string details;  ///< the report or the error
};

/// The tests of a report: the verdicts of each kind of lane, and all else.
std::vector<JUnitCase> junit_cases(const VerifyReport& report);

/// A file that continuous-integration servers read: one <testsuite>, in the format of Ant's JUnit
/// task (https://github.com/testmoapp/junitxml).
std::string junit_text(const std::string& suite, const std::vector<JUnitCase>& cases);

}  // namespace mixcmp::verilator_tb
