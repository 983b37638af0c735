#include <fmt/core.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/generator/project_fixture.hpp"

/// The files of `generate --project` for tools that drive others or are not Debian's: vendors'
/// scripts, FuseSoC, cocotb, VHDL.
namespace mixcmp::test::project_tools_test {
namespace {

namespace fs = std::filesystem;

class ProjectTools : public ProjectTest {};
class EngineProjectTools : public EngineProjectTest {};

class VendorScript : public EngineProjectTest {
protected:
  void SetUp() override {
    if (!is_installed("tclsh")) GTEST_SKIP() << "tclsh is not installed (Debian: tcl)";
  }

  Outcome tcl(const std::string& script) {
    return in_folder(fmt::format("tclsh '{}' {}", MIXCMP_VENDOR_COMMANDS, script));
  }
};

TEST_F(VendorScript, VivadoSynthesisesAndPackages) {
  generate("--project vivado --device artix7-200t");
  const Outcome synthesis = tcl("rtl/vivado/synthesise.tcl");
  EXPECT_EQ(synthesis.exit_code, 0) << synthesis.output;
  expect_in(synthesis.output, "mixcmp_lane_tracker.v");
  expect_in(synthesis.output, "read_xdc scene_s8e8_2x1.xdc\n");
  expect_in(synthesis.output,
            "synth_design -top scene_s8e8_2x1 -part xc7a200tfbg676-2 -mode out_of_context\n");
  expect_in(synthesis.output, "210.5 MHz (target 200 MHz)");  // a slack of 0.25 of 5 ns
  EXPECT_EQ(read("scene_s8e8_2x1_vivado/scene_s8e8_2x1.json"), read("rtl/scene_s8e8_2x1.json"));
  const Outcome constraint = tcl("rtl/vivado/scene_s8e8_2x1.xdc");
  expect_in(constraint.output, "create_clock -name aclk -period 5.000 ports\n");
  expect_in(constraint.output, "set_input_delay -clock aclk 0.6 ports\n");
  expect_in(constraint.output, "set_output_delay -clock aclk 0.6 ports\n");
  const Outcome packaging = tcl("rtl/vivado/package_ip.tcl xc7k325tffg900-2 here");
  EXPECT_EQ(packaging.exit_code, 0) << packaging.output;
  expect_in(packaging.output, "create_project -force package project -part xc7k325tffg900-2\n");
  expect_in(packaging.output, "set_property top scene_s8e8_2x1_streams sources_1\n");
  for (const char* stream : {"s_axis_0", "m_axis_0", "s_axis_1", "m_axis_1"}) {
    expect_in(packaging.output, fmt::format("infer_bus_interface {0}_tvalid {0}_tready {0}_tdata "
                                            "{0}_tuser xilinx.com:interface:axis_rtl:1.0",
                                            stream));
    expect_in(packaging.output, fmt::format("-busif {} -clock aclk", stream));
  }
}

TEST_F(VendorScript, StreamsOfGroupsArePackagedEach) {
  generate("--project vivado --device artix7-200t --lanes 8 --set system.lanes_per_group=4");
  const Outcome packaging = tcl("rtl/vivado/package_ip.tcl");
  EXPECT_EQ(packaging.exit_code, 0) << packaging.output;
  expect_in(packaging.output, "infer_bus_interface m_axis_1_tvalid m_axis_1_tready");
  EXPECT_EQ(packaging.output.find("m_axis_2"), std::string::npos) << packaging.output;
}

TEST_F(VendorScript, StreamsOfReportsArePackagedEach) {
  write_pairs();
  generate(
      "--project vivado --device artix7-200t --set engine.report_streams=2 "
      "--set engine.lanes_per_group=1");
  const Outcome packaging = tcl("rtl/vivado/package_ip.tcl");
  EXPECT_EQ(packaging.exit_code, 0) << packaging.output;
  expect_in(packaging.output, "set_property top near_s8e8_2x1_pairwise_streams sources_1\n");
  for (const char* stream : {"s_axis", "m_axis_0", "m_axis_1"}) {
    expect_in(packaging.output, fmt::format("infer_bus_interface {0}_tvalid {0}_tready {0}_tdata "
                                            "{0}_tuser {0}_tlast xilinx.com",
                                            stream));
  }
}

TEST_F(VendorScript, QuartusCompiles) {
  generate("--project quartus");
  const Outcome nameless = tcl("rtl/quartus/compile.tcl");
  EXPECT_EQ(nameless.exit_code, 1) << nameless.output;
  expect_in(nameless.output, "Quartus has no ice40-hx8k: name a part");
  const Outcome run = tcl("rtl/quartus/compile.tcl 5CEBA4F23C7");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  expect_in(run.output, "set_global_assignment -name FAMILY Cyclone V\n");
  expect_in(run.output, "set_global_assignment -name VERILOG_FILE scene_s8e8_2x1.v\n");
  expect_in(run.output, "set_global_assignment -name SDC_FILE scene_s8e8_2x1.sdc\n");
  expect_in(run.output, "set_instance_assignment -name VIRTUAL_PIN OFF -to aclk\n");
  EXPECT_EQ(read("output_files/scene_s8e8_2x1.json"), read("rtl/scene_s8e8_2x1.json"));
}

TEST_F(VendorScript, AFileThatIsNotThereIsAnError) {
  generate("--project vivado,quartus --device artix7-200t");
  fs::remove(path("rtl/mixcmp_lane_tracker.v"));
  for (const char* script : {"vivado/synthesise.tcl", "quartus/compile.tcl 5CEBA4F23C7"}) {
    const Outcome run = tcl(std::string("rtl/") + script);
    EXPECT_EQ(run.exit_code, 1) << run.output;
    expect_in(run.output, "mixcmp_lane_tracker.v");
  }
}

TEST_F(ProjectTools, ACoreFileNamesFilesThatAreThere) {
  if (shell("python3 -c 'import yaml'").exit_code != 0) {
    GTEST_SKIP() << "python3-yaml is not installed";
  }
  generate("--project fusesoc --device artix7-200t");
  const Outcome run = in_folder(fmt::format("python3 '{}' rtl", MIXCMP_CHECK_CORE));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(run.output, "default lint sim synth synth_vivado\n");
}

TEST_F(ProjectTools, FuseSocRunsItsTargets) {
  if (!is_installed("fusesoc")) GTEST_SKIP() << "fusesoc is not installed";
  generate("--project fusesoc --vectors 50");
  for (const char* target : {"lint", "sim", "synth"}) {
    const Outcome run = in_folder(fmt::format(
        "fusesoc --cores-root rtl run --target {} mixcmp:comparison:scene_s8e8_2x1", target));
    EXPECT_EQ(run.exit_code, 0) << target << "\n" << run.output;
    if (target == std::string("sim")) expect_in(run.output, "PASSED: 200 comparisons");
  }
}

TEST_F(ProjectTools, CocotbPasses) {
  if (!is_installed("cocotb-config")) GTEST_SKIP() << "cocotb is not installed";
  for (const char* settings : {"", "--lanes 8 --set system.lanes_per_group=4",
                               "--lanes 6 --set system.lanes_per_group=3 "
                               "--set system.operands=refetched --set system.tag_bits=5"}) {
    generate(std::string("--project icarus --vectors 50 ") + settings);
    const Outcome run = in_folder("mkdir work && cd work && make -f ../rtl/cocotb/Makefile");
    EXPECT_EQ(run.exit_code, 0) << settings << "\n" << run.output;
    expect_in(run.output, "PASS=2 FAIL=0");
    fs::remove_all(path("rtl"));
    fs::remove_all(path("work"));
  }
}

TEST_F(ProjectTools, CocotbLeavesNothingInTheGeneratedFolder) {
  if (!is_installed("python3")) GTEST_SKIP() << "python3 is not installed";
  generate("--project icarus --vectors 5");
  // A cocotb that only imports the test, as the simulator's Python does.
  fs::create_directories(path("stub/cocotb"));
  write("stub/cocotb-config", "#!/bin/sh\nprintf '%s' \"$STUB\"\n");
  write("stub/Makefile.sim", "all:\n\tpython3 -c 'import $(MODULE)'\n");
  write("stub/cocotb/__init__.py", "def test(): return lambda function: function\n");
  write("stub/cocotb/clock.py", "Clock = None\n");
  write("stub/cocotb/triggers.py", "FallingEdge = ReadOnly = None\n");
  const Outcome run = in_folder(
      "chmod +x stub/cocotb-config && unset PYTHONDONTWRITEBYTECODE && mkdir work && cd work && "
      "STUB=\"$PWD/../stub\" PYTHONPATH=\"$PWD/../stub\" PATH=\"$PWD/../stub:$PATH\" "
      "make -f ../rtl/cocotb/Makefile");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_TRUE(fs::exists(path("rtl/cocotb/test_scene_s8e8_2x1.py")));
  generate("--project icarus --vectors 5");
}

TEST_F(ProjectTools, TheCocotbTestIsPython) {
  if (!is_installed("python3")) GTEST_SKIP() << "python3 is not installed";
  for (const char* settings : {"", "--set system.lanes_per_group=2"}) {
    generate(std::string("--project icarus --vectors 5 ") + settings);
    const Outcome run = in_folder(
        "python3 -W error -c 'import ast, sys; ast.parse(open(sys.argv[1]).read())' "
        "rtl/cocotb/test_scene_s8e8_2x1.py");
    EXPECT_EQ(run.exit_code, 0) << settings << "\n" << run.output;
  }
}

TEST_F(ProjectTools, GhdlTakesTheComponents) {
  if (!is_installed("ghdl")) GTEST_SKIP() << "ghdl is not installed";
  generate("--project vivado --set comparison.name=a__b");
  const Outcome run = in_folder("ghdl -s --std=93 rtl/integration/*_components.vhd");
  EXPECT_EQ(run.exit_code, 0) << run.output;
}

TEST_F(EngineProjectTools, GhdlTakesTheComponents) {
  if (!is_installed("ghdl")) GTEST_SKIP() << "ghdl is not installed";
  write_pairs();
  generate("--project vivado --set engine.report_streams=2 --set engine.lanes_per_group=1");
  const Outcome run = in_folder("ghdl -s --std=93 rtl/integration/*_components.vhd");
  EXPECT_EQ(run.exit_code, 0) << run.output;
}

}  // namespace
}  // namespace mixcmp::test::project_tools_test
