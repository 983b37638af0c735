#include "verilator_tb/junit.hpp"

#include <gtest/gtest.h>

namespace mixcmp::test::junit_test {
namespace {

using verilator_tb::JUnitCase;

TEST(JUnit, HasAnElementForEveryOutcome) {
  const std::string text = verilator_tb::junit_text(
      "a suite", {{.name = "first", .seconds = 1},
                  {.name = "second",
                   .seconds = 0.5,
                   .outcome = JUnitCase::Outcome::failed,
                   .message = "2 mismatches",
                   .details = "less"},
                  {.name = "third", .outcome = JUnitCase::Outcome::broken, .message = "no tool"},
                  {.name = "fourth", .outcome = JUnitCase::Outcome::skipped}});
  EXPECT_EQ(text,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuite name=\"a suite\" tests=\"4\" failures=\"1\" errors=\"1\" skipped=\"1\" "
            "time=\"1.500\">\n"
            "  <testcase classname=\"a suite\" name=\"first\" time=\"1.000\"/>\n"
            "  <testcase classname=\"a suite\" name=\"second\" time=\"0.500\">\n"
            "    <failure message=\"2 mismatches\">less</failure>\n  </testcase>\n"
            "  <testcase classname=\"a suite\" name=\"third\" time=\"0.000\">\n"
            "    <error message=\"no tool\"></error>\n  </testcase>\n"
            "  <testcase classname=\"a suite\" name=\"fourth\" time=\"0.000\">\n"
            "    <skipped message=\"\"></skipped>\n  </testcase>\n"
            "</testsuite>\n");
}

TEST(JUnit, EscapesWhatXmlDoesNotTake) {
  const std::string text = verilator_tb::junit_text("s", {{.name = "a<b & \"c\">\x01\xff"}});
  EXPECT_NE(text.find("name=\"a&lt;b &amp; &quot;c&quot;&gt;??\""), std::string::npos) << text;
}

}  // namespace
}  // namespace mixcmp::test::junit_test
