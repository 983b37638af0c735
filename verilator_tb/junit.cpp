#include "verilator_tb/junit.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/base/common/quote.hpp"

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

}  // namespace

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
