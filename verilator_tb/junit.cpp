#include "verilator_tb/junit.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/base/common/quote.hpp"
#include "verilator_tb/report.hpp"

namespace mixcmp::verilator_tb {

namespace {

/// XML 1.0 has no control characters but tab and line feed, not even as references.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : printable(text)) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      case '\n': result += "&#10;"; break;
      case '\t': result += "&#9;"; break;
      default: result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    }
  }
  return result;
}

const char* element(JUnitCase::Outcome outcome) {
  switch (outcome) {
    case JUnitCase::Outcome::passed: return "";
    case JUnitCase::Outcome::failed: return "failure";
    case JUnitCase::Outcome::broken: return "error";
    case JUnitCase::Outcome::skipped: return "skipped";
  }
  return "";
}

std::string testcase(const std::string& suite, const JUnitCase& test) {
  const std::string head = fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"",
                                       escaped(suite), escaped(test.name), test.seconds);
  const std::string name = element(test.outcome);
  if (name.empty()) return head + "/>\n";
  return fmt::format("{}>\n    <{} message=\"{}\">{}</{}>\n  </testcase>\n", head, name,
                     escaped(test.message), escaped(test.details), name);
}

/// Counts of every failure that the tests of the lanes' verdicts do not show; empty if there is
/// none.
std::string failure_besides_verdicts(const VerifyReport& report) {
  std::string text;
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  };
  add(report.violation_count, "protocol violations");
  if (report.comparisons < report.requested) {
    add(report.requested - report.comparisons, "comparisons without a result");
  }
  add(report.emulator_errors, "errors of the emulator");
  std::uint64_t of_lanes = 0;
  for (const GroupReport& group : report.groups) {
    of_lanes += group.mismatches;
    if (group.certified) add(group.wrong_by_lane, "wrong verdicts of certified lanes");
  }
  // Engines have mismatches of whole reports and rows, which no lane is counted with.
  if (report.mismatch_count > of_lanes) add(report.mismatch_count - of_lanes, "mismatches");
  if (text.empty() && of_lanes == 0 && !report.passed()) text = "see the report";
  return text;
}

}  // namespace

std::vector<JUnitCase> junit_cases(const VerifyReport& report) {
  std::vector<JUnitCase> tests;
  for (const GroupReport& group : report.groups) {
    JUnitCase& test = tests.emplace_back();
    test.name = "verdicts of lanes " + group.name;
    if (group.mismatches == 0) continue;
    test.outcome = JUnitCase::Outcome::failed;
    test.message = fmt::format("{} mismatches", group.mismatches);
    test.details = to_text(report);
  }
  JUnitCase& rest = tests.emplace_back();
  rest.name = "streams, counters and truth";
  rest.seconds = report.run_seconds;
  rest.message = failure_besides_verdicts(report);
  if (rest.message.empty()) return tests;
  rest.outcome = JUnitCase::Outcome::failed;
  rest.details = to_text(report);
  return tests;
}

std::string junit_text(const std::string& suite, const std::vector<JUnitCase>& cases) {
  const auto count = [&](JUnitCase::Outcome outcome) {
    return std::count_if(cases.begin(), cases.end(),
                         [&](const JUnitCase& test) { return test.outcome == outcome; });
  };
  double seconds = 0;
  std::string tests;
  for (const JUnitCase& test : cases) {
    seconds += test.seconds;
    tests += testcase(suite, test);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" "
      "time=\"{:.3f}\">\n{}</testsuite>\n",
      escaped(suite), cases.size(), count(JUnitCase::Outcome::failed),
      count(JUnitCase::Outcome::broken), count(JUnitCase::Outcome::skipped), seconds, tests);
}

}  // namespace mixcmp::verilator_tb
