#include <fmt/core.h>

#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/program.hpp"

/// `generate --project`: the files for other tools do what they say, wherever they lie.
namespace mixcmp::test::project_command_test {
namespace {

namespace fs = std::filesystem;

class Project : public ProgramTest {
protected:
  Project() {
    write("data.csv", data());
    write("scene.toml",
          "[comparison]\nname = \"scene\"\nf = \"a\"\ng = \"b\"\n"
          "[reference]\nformat = \"binary32\"\n"
          "[reduced]\nformat = \"s8e8\"\ninputs = \"rounded\"\n"
          "[system]\nlanes = 2\nreferences = 1\ndevice = \"ice40-hx8k\"\n"
          "[data]\nfile = \"data.csv\"\n");
  }

  /// Rows whose b differs from a by nothing, by too little for 8 bits, and by much.
  static std::string data() {
    std::string text = "a,b\n";
    constexpr double factors[] = {1, 1 + 1e-5, 1 - 1e-5, 1.5, 0.75};
    for (int k = 0; k < 150; ++k) {
      const double a = 1 + 0.37 * (k % 29);
      text += fmt::format("{:.7f},{:.7f}\n", a, a * factors[k % 5]);
    }
    return text;
  }

  /// Generates into the folder `rtl`.
  void generate(const std::string& arguments) {
    const Outcome run = mixcmp("generate scene.toml --no-prove -o rtl " + arguments);
    ASSERT_EQ(run.exit_code, 0) << run.output;
  }

  /// Runs a command in the test's folder.
  Outcome in_folder(const std::string& command) const {
    return shell(fmt::format("cd '{}' && {}", directory_.path().string(), command));
  }

  static bool is_installed(const std::string& tool) {
    return shell("command -v " + tool).exit_code == 0;
  }

  /// Runs the test bench with one line of a module in rtl changed by sed.
  Outcome run_changed(const std::string& file, const std::string& change) {
    const Outcome changed =
        in_folder(fmt::format("rm -rf changed && cp -r rtl changed && sed -i '{1}' changed/{0} && "
                              "! cmp -s changed/{0} rtl/{0}",
                              file, change));
    EXPECT_EQ(changed.exit_code, 0) << "nothing changed: " << change;
    return in_folder("changed/icarus/run work");
  }

  void expect_in(const std::string& text, const std::string& words) {
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  }
};

TEST_F(Project, TheTestBenchPassesInIcarusFromAnyFolder) {
  generate("--project icarus");
  fs::create_directories(path("far away"));
  fs::rename(path("rtl"), path("far away/moved rtl"));
  fs::create_directories(path("elsewhere"));
  const Outcome run =
      in_folder("cd elsewhere && '../far away/moved rtl/icarus/run' 'a work' +waves=w.fst");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_TRUE(
      std::regex_search(run.output, std::regex("PASSED: 708 comparisons \\(177, 4 times\\), "
                                               "[1-9][0-9]* recomputed")))
      << run.output;
  EXPECT_TRUE(fs::exists(path("elsewhere/a work/scene_s8e8_2x1_tb.log")));
  EXPECT_TRUE(fs::exists(path("elsewhere/a work/w.fst")));
}

struct Fault {
  const char* file;     ///< of a module around a lane, or inside that
  const char* change;   ///< for sed
  const char* message;  ///< of the test bench
};

constexpr const char* scoreboard = "mixcmp_lane_scoreboard.v";
constexpr const char* tags = "mixcmp_lane_tags.v";

constexpr Fault faults[] = {
    {tags, "s/!s_result_asks) || result_waits/!s_result_asks)/", "changed before tready rose"},
    {tags, "s/{4.b0000, result_q}/{4'\\''b0000, result_q ^ 4'\\''b0010}/",
     "expected less, decided by the lane; got greater, decided by the lane"},
    {scoreboard, "s/answer_slot, 2.b01/answer_slot, 2'\\''b00/",
     "expected less, recomputed; got less, decided by the lane"},
    {tags, "s/write_data   (start_tag)/write_data   (start_tag ^ 2)/", "expected "},
    {tags, "s/write_data   (start_tag)/write_data   (start_tag | 1)/",
     "a result of comparison 1, which is not inside"},
    {scoreboard, "s/request_sent    (m_request_tvalid/request_sent    (m_request_tready/",
     "recomputations of lane 0: the counter is"},
    {scoreboard, "s/s_free_valid(retire)/s_free_valid(1'\\''b0)/", "time-out: nothing has moved"},
    {tags, "s/= m_valid_q;/= m_valid_q \\&\\& m_axis_tready;/",
     "m_axis_tvalid follows m_axis_tready"},
    {scoreboard, "s/tvalid({answer_valid, direct_valid})/tvalid({1'\\''b0, direct_valid})/",
     "the result has not left"}};

TEST_F(Project, TheTestBenchFindsFaultsOfTheHardware) {
  generate("--project icarus --vectors 100");
  for (const Fault& fault : faults) {
    const Outcome run = run_changed(fault.file, fault.change);
    EXPECT_NE(run.exit_code, 0) << fault.change << "\n" << run.output;
    expect_in(run.output, fault.message);
    expect_in(run.output, "FAILED: ");
    EXPECT_EQ(run.output.find("PASSED"), std::string::npos) << run.output;
  }
}

/// The data have neither ties of zeros nor NaNs, and lanes take as many comparisons in each pass.
TEST_F(Project, TheTestBenchFindsFaultsThatTheDataAloneDoNotShow) {
  generate("--project icarus --vectors 100");
  const auto expect_found = [&](const char* file, const char* change, const char* message) {
    const Outcome run = run_changed(file, change);
    EXPECT_NE(run.exit_code, 0) << change << "\n" << run.output;
    expect_in(run.output, message);
  };
  expect_found("scene_s8e8_2x1.v", "s/(comparisons\\[lane/(comparisons[(1 - lane)/",
               "comparisons of lane 0: the counter is");
  expect_found("mixcmp_fp_compare.v", "s/s1_equal = s1_both_zero ||/s1_equal =/",
               "expected equal, recomputed; got");
  expect_found("mixcmp_fp_compare.v", "s/= s0_a_nan || s0_b_nan/= s0_a_nan/",
               "expected unordered, recomputed; got");
}

TEST_F(Project, TheMemoryBehindAReferenceFindsLostTagsAndTooManyOfThem) {
  generate("--project icarus --set system.operands=refetched --lanes 4");
  for (const auto& [file, change] :
       {std::pair("mixcmp_reference_port.v",
                  "s/accept || (refetch_valid_q \\&\\& !m_refetch_tready)/accept/"),
        std::pair("mixcmp_stream_fifo.v", "s/same_address \\&\\& !same_lap/1'\\''b0/")}) {
    const Outcome run = run_changed(file, change);
    EXPECT_NE(run.exit_code, 0) << change << "\n" << run.output;
    expect_in(run.output, "expected ");
  }
}

TEST_F(Project, AFileOfVectorsThatIsCutShortFails) {
  generate("--project icarus");
  const Outcome run = run_changed("testbench/scene_s8e8_2x1_tb.hex", "$ d");
  EXPECT_NE(run.exit_code, 0) << run.output;
  expect_in(run.output, "the file of vectors cannot be read, or is not whole");
}

TEST_F(Project, TheTestBenchPassesForEveryKindOfSystem) {
  for (const char* settings :
       {"--set system.operands=refetched --set system.tag_bits=5 --lanes 3 --references 2",
        "--set system.order=in_order --set system.counter_bits=0 --lanes 1",
        "--set system.counters=axi_lite --lanes 3 --references 2",
        "--references 0 --set system.tag_bits=64", "--format block9 --set system.tag_bits=33"}) {
    generate(std::string("--project icarus --vectors 60 ") + settings);
    const Outcome run = in_folder("rtl/icarus/run work");
    EXPECT_EQ(run.exit_code, 0) << settings << "\n" << run.output;
    expect_in(run.output, "PASSED: 240 comparisons");
    fs::remove_all(path("rtl"));
  }
}

class EngineProject : public Project {
protected:
  /// Items whose differences tie, nearly tie, or are far apart.
  void write_pairs(const std::string& pairing = "pairs = \"all\"\n") {
    std::string data = "a,b\n";
    for (int k = 0; k < 12; ++k) {
      const double a = 1 + 0.37 * k;
      data += fmt::format("{:.7f},{:.7f}\n", a, k % 3 == 0 ? a : a * (1 + 0.003 * (k % 5)));
    }
    write("data.csv", data);
    write_engine("ai - aj", "bi - bj", "[engine]\nkind = \"pairwise\"\ncapacity = 16\n", pairing);
  }

  /// Points between centres, some of them in the middle of two.
  void write_chain() {
    write("data.csv", "p\n0.5\n1.0001\n1.75\n2.5\n2.9999\n3.25\n1\n3\n0\n4\n");
    write("centres.csv", "c\n0\n2\n4\n");
    write_engine("(p - ci)^2", "(p - cj)^2", "[engine]\nkind = \"arg_min\"\ntag_bits = 5\n",
                 "with = \"centres.csv\"\npairs = \"arg_min\"\n");
  }

  Outcome run_engine_changed(const std::string& file, const std::string& change) {
    Outcome run = run_changed(file, change);
    EXPECT_NE(run.exit_code, 0) << change << "\n" << run.output;
    return run;
  }

private:
  void write_engine(const std::string& f, const std::string& g, const std::string& engine,
                    const std::string& pairing) {
    write("scene.toml",
          fmt::format("[comparison]\nname = \"near\"\nf = \"{}\"\ng = \"{}\"\n"
                      "[reference]\nformat = \"binary32\"\n[reduced]\nformat = \"s8e8\"\n"
                      "[system]\nlanes = 2\nreferences = 1\ndevice = \"ice40-hx8k\"\n{}"
                      "[data]\nfile = \"data.csv\"\n{}",
                      f, g, engine, pairing));
  }
};

TEST_F(EngineProject, ThePairwiseEngineIsTested) {
  write_pairs();
  generate("--project icarus,yosys");
  const Outcome run = in_folder("rtl/icarus/run work +waves=w.fst");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_TRUE(std::regex_search(
      run.output, std::regex("PASSED: the engine's 264 pairs \\(12 items, 4 times\\), "
                             "[1-9][0-9]* reported")))
      << run.output;
  EXPECT_TRUE(fs::exists(path("work/w.fst")));
  expect_in(read("rtl/yosys/synthesise.ys"), "synth_ice40 -top near_s8e8_2x1_pairwise\n");
}

TEST_F(EngineProject, EachFormOfReportIsTested) {
  write_pairs();
  for (const char* settings : {"--set engine.report_streams=2 --set engine.lanes_per_group=1",
                               "--set engine.report_as=count", "--set system.counters=axi_lite",
                               "--set system.counter_bits=0 --set system.references=0",
                               "--set 'engine.report=[\"less\"]' --set engine.report_as=bitmap"}) {
    generate(std::string("--project icarus ") + settings);
    const Outcome run = in_folder("rtl/icarus/run work +seed=3");
    EXPECT_EQ(run.exit_code, 0) << settings << "\n" << run.output;
    expect_in(run.output, "PASSED: the engine's 264 pairs (12 items, 4 times)");
    fs::remove_all(path("rtl"));
  }
}

TEST_F(EngineProject, ItemsOfTwoTablesAreTested) {
  write("others.csv", "a,b\n1.5,1.2\n2.2,9\n3,3.1\n0.2,0.1\n");
  write_pairs("with = \"others.csv\"\npairs = \"cross\"\n");
  generate("--project icarus");
  const Outcome run = in_folder("rtl/icarus/run work");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  expect_in(run.output, "PASSED: the engine's 128 pairs (12 items, 4 times)");
}

TEST_F(EngineProject, TheArgMinEngineIsTested) {
  write_chain();
  for (const char* settings :
       {"", "--set system.counter_bits=0", "--lanes 4", "--set system.counters=axi_lite"}) {
    generate(std::string("--project icarus ") + settings);
    const Outcome run = in_folder("rtl/icarus/run work +seed=7");
    EXPECT_EQ(run.exit_code, 0) << settings << "\n" << run.output;
    expect_in(run.output, "PASSED: the engine's 40 rows (10, 4 times), 3 candidates");
    fs::remove_all(path("rtl"));
  }
}

TEST_F(EngineProject, ItIsToldWhatLeaves) {
  write_pairs();
  const std::string command =
      "generate scene.toml --no-prove -o rtl --set 'engine.report=[\"less\"]' ";
  expect_in(mixcmp(command).output, ": up to 16 items of 8 bytes, pairs that are less leave\n");
  expect_in(mixcmp(command + "--set engine.report_as=count").output,
            ", the number of pairs that are less leaves\n");
  expect_in(mixcmp(command + "--set engine.report_as=bitmap --set engine.report_streams=2 "
                             "--set engine.lanes_per_group=1")
                .output,
            ", pairs that are less leave by 2 streams as flags of 1\n");
}

/// What Verilator says, but for the statistics with which Debian 13's ends: lines that begin "- ".
std::string without_report(const std::string& output) {
  std::string said;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("- ")) said += line + "\n";
  }
  return said;
}

TEST_F(EngineProject, VerilatorTakesTheTestBenchesWithoutAWarning) {
  for (const bool is_chain : {false, true}) {
    is_chain ? write_chain() : write_pairs();
    generate("--project verilator --vectors 20");
    const std::string bench = is_chain ? "near_s8e8_2x1_arg_min_tb" : "near_s8e8_2x1_pairwise_tb";
    expect_in(read("rtl/verilator/run"), "\nbench=" + bench + "\n");
    const Outcome lint = in_folder(
        fmt::format("verilator --lint-only --timing --top-module {0} -F rtl/near_s8e8_2x1.f "
                    "rtl/testbench/{0}.v",
                    bench));
    EXPECT_EQ(lint.exit_code, 0) << lint.output;
    EXPECT_EQ(without_report(lint.output), "");
    fs::remove_all(path("rtl"));
  }
}

TEST_F(EngineProject, FaultsOfThePairwiseEngineAreFound) {
  write_pairs();
  generate("--project icarus");
  const char* const output = "mixcmp_report_output.v";
  const Fault faults_of_output[] = {
      {output, "s/{4.b0000, undecided, recomputed, verdict}/{6'\\''b000000, ~verdict}/", "; got "},
      {output, "s/undecided, recomputed, verdict}/undecided, !recomputed, verdict}/",
       ", recomputed; got "},
      {output, "s/fields\\[TAG_BITS-1:0\\] = count/fields[TAG_BITS-1:0] = count + ONE/",
       "a wrong closing beat"},
      {output, "s/:0\\]           = index_i/:0]           = index_j/", "a report of no pair"},
      {output, "s/m_axis_tvalid = m_valid_q/m_axis_tvalid = m_valid_q \\&\\& m_axis_tready/",
       "m_axis_tvalid follows m_axis_tready"}};
  for (const Fault& fault : faults_of_output) {
    expect_in(run_engine_changed(fault.file, fault.change).output, fault.message);
  }
  expect_in(run_engine_changed("mixcmp_pair_segment.v", "s/(met\\[k\\])/(met[k] \\&\\& (k != 1))/")
                .output,
            "the set is closed without it");
  expect_in(run_engine_changed("testbench/near_s8e8_2x1_pairwise_tb.hex", "$ d").output,
            "the file of vectors cannot be read, or is not whole");
}

TEST_F(EngineProject, FaultsOfTheArgMinEngineAreFound) {
  write_chain();
  generate("--project icarus");
  expect_in(run_engine_changed("mixcmp_arg_min_stage.v",
                               "s/own_is_better ? OWN :/!own_is_better ? OWN :/")
                .output,
            "expected candidate ");
  expect_in(run_engine_changed("mixcmp_arg_min_engine.v",
                               "s/{s_axis_tlast, s_axis_tuser}/{s_axis_tlast, s_axis_tuser ^ "
                               "(s_axis_tuser == 3)}/")
                .output,
            "expected tag 03");
}

TEST_F(Project, VerilatorFindsNoFaultAndNoWarning) {
  generate("--project verilator --vectors 100");
  const Outcome lint = in_folder("rtl/verilator/lint");
  EXPECT_EQ(lint.exit_code, 0) << lint.output;
  EXPECT_EQ(without_report(lint.output), "");
  const Outcome wrapper = in_folder(
      "verilator --lint-only -Wall --top-module scene_s8e8_2x1_streams -F rtl/scene_s8e8_2x1.f "
      "rtl/integration/scene_s8e8_2x1_streams.v");
  EXPECT_EQ(without_report(wrapper.output), "");
  const Outcome run = in_folder("rtl/verilator/run work");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  expect_in(run.output, "PASSED: 400 comparisons (100, 4 times)");
}

TEST_F(EngineProject, StreamsOfReportsHaveAWrapper) {
  write_pairs();
  generate("--project yosys");
  EXPECT_FALSE(fs::exists(path("rtl/integration/near_s8e8_2x1_pairwise_streams.v")));
  generate("--project yosys --set engine.report_streams=2 --set engine.lanes_per_group=1");
  const std::string wrapper = read("rtl/integration/near_s8e8_2x1_pairwise_streams.v");
  for (const char* port :
       {"wire [7:0]  m_axis_1_tuser", "[31:0] reports_1", "[31:0] busy_cycles"}) {
    expect_in(wrapper, port);
  }
  const Outcome lint = in_folder(
      "verilator --lint-only -Wall --top-module near_s8e8_2x1_pairwise_streams "
      "-F rtl/near_s8e8_2x1.f rtl/integration/near_s8e8_2x1_pairwise_streams.v");
  EXPECT_EQ(lint.exit_code, 0) << lint.output;
  EXPECT_EQ(without_report(lint.output), "");
  expect_in(read("rtl/integration/near_s8e8_2x1_pairwise.veo"), ".m_axis_1_tvalid");
}

TEST_F(Project, VerilatorTakesFoldersOfAnyNameButBuildsInNoneWithBlanks) {
  generate("--project verilator --vectors 5");
  fs::rename(path("rtl"), path("o ut $x [y]"));
  const Outcome lint = in_folder("'o ut $x [y]/verilator/lint'");
  EXPECT_EQ(lint.exit_code, 0) << lint.output;
  EXPECT_EQ(without_report(lint.output), "");
  EXPECT_FALSE(fs::exists(path("o ut $x [y]/obj_dir")));
  const Outcome run = in_folder("'o ut $x [y]/verilator/run' 'a work'");
  EXPECT_EQ(run.exit_code, 1) << run.output;
  expect_in(run.output, "FOLDER: make takes no blanks in its path: received ");
  EXPECT_FALSE(fs::exists(path("a work")));
}

TEST_F(Project, VerilatorsWrongOptimisationIsOffWhereverItIsCalled) {
  generate("--project verilator,fusesoc --vectors 1");
  for (const char* file : {"rtl/verilator/run", "rtl/cocotb/Makefile", "rtl/scene_s8e8_2x1.core"}) {
    expect_in(read(file), "-fno-const-bit-op-tree");
  }
}

TEST_F(Project, YosysAndNextpnrBuildIt) {
  if (!is_installed("nextpnr-ice40")) GTEST_SKIP() << "nextpnr-ice40 is not installed";
  generate("--project yosys,nextpnr --lanes 1 --references 0 --set system.counter_bits=0");
  const Outcome yosys = in_folder("rtl/yosys/run work");
  EXPECT_EQ(yosys.exit_code, 0) << yosys.output;
  expect_in(yosys.output, "SB_LUT4");
  EXPECT_TRUE(fs::exists(path("work/scene_s8e8_1x0.json")));
  const Outcome nextpnr = in_folder("rtl/nextpnr/run work --seed 2");
  EXPECT_EQ(nextpnr.exit_code, 0) << nextpnr.output;
  expect_in(nextpnr.output, "Max frequency for clock");
  expect_in(nextpnr.output, "ICESTORM_LC");
}

TEST_F(Project, NextpnrIsOfItsDevicesAlone) {
  expect_refused("generate scene.toml --no-prove -o rtl --project nextpnr --device artix7-200t",
                 "--project: nextpnr does not place on the scene's device: received artix7-200t; "
                 "accepted --device with one of ecp5-85k, ice40-hx8k, ice40-up5k");
  EXPECT_FALSE(fs::exists(path("rtl")));
}

class VendorScript : public EngineProject {
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

TEST_F(Project, ACoreFileNamesFilesThatAreThere) {
  if (shell("python3 -c 'import yaml'").exit_code != 0) {
    GTEST_SKIP() << "python3-yaml is not installed";
  }
  generate("--project fusesoc --device artix7-200t");
  const Outcome run = in_folder(fmt::format("python3 '{}' rtl", MIXCMP_CHECK_CORE));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(run.output, "default lint sim synth synth_vivado\n");
}

TEST_F(Project, FuseSocRunsItsTargets) {
  if (!is_installed("fusesoc")) GTEST_SKIP() << "fusesoc is not installed";
  generate("--project fusesoc --vectors 50");
  for (const char* target : {"lint", "sim", "synth"}) {
    const Outcome run = in_folder(fmt::format(
        "fusesoc --cores-root rtl run --target {} mixcmp:comparison:scene_s8e8_2x1", target));
    EXPECT_EQ(run.exit_code, 0) << target << "\n" << run.output;
    if (target == std::string("sim")) expect_in(run.output, "PASSED: 200 comparisons");
  }
}

TEST_F(Project, CocotbPasses) {
  if (!is_installed("cocotb-config")) GTEST_SKIP() << "cocotb is not installed";
  generate("--project icarus --vectors 50");
  const Outcome run = in_folder("mkdir work && cd work && make -f ../rtl/cocotb/Makefile");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  expect_in(run.output, "PASS=2 FAIL=0");
}

TEST_F(Project, CocotbLeavesNothingInTheGeneratedFolder) {
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

TEST_F(Project, TheCocotbTestIsPython) {
  if (!is_installed("python3")) GTEST_SKIP() << "python3 is not installed";
  generate("--project icarus --vectors 5");
  const Outcome run = in_folder(
      "python3 -W error -c 'import ast, sys; ast.parse(open(sys.argv[1]).read())' "
      "rtl/cocotb/test_scene_s8e8_2x1.py");
  EXPECT_EQ(run.exit_code, 0) << run.output;
}

TEST_F(Project, GhdlTakesTheComponents) {
  if (!is_installed("ghdl")) GTEST_SKIP() << "ghdl is not installed";
  generate("--project vivado --set comparison.name=a__b");
  const Outcome run = in_folder("ghdl -s --std=93 rtl/integration/*_components.vhd");
  EXPECT_EQ(run.exit_code, 0) << run.output;
}

TEST_F(EngineProject, GhdlTakesTheComponents) {
  if (!is_installed("ghdl")) GTEST_SKIP() << "ghdl is not installed";
  write_pairs();
  generate("--project vivado --set engine.report_streams=2 --set engine.lanes_per_group=1");
  const Outcome run = in_folder("ghdl -s --std=93 rtl/integration/*_components.vhd");
  EXPECT_EQ(run.exit_code, 0) << run.output;
}

TEST_F(Project, TheSameSceneGivesTheSameBytes) {
  const std::string tools = "--project vivado,quartus,yosys,nextpnr,fusesoc,verilator,icarus";
  fs::create_directories(path("deep/er"));
  ASSERT_EQ(mixcmp("generate scene.toml --no-prove -o rtl " + tools).exit_code, 0);
  ASSERT_EQ(mixcmp("generate scene.toml --no-prove -o deep/er/rtl " + tools).exit_code, 0);
  const Outcome difference = in_folder("diff -r rtl deep/er/rtl");
  EXPECT_EQ(difference.exit_code, 0) << difference.output;
  EXPECT_EQ(in_folder(fmt::format("grep -rF '{}' rtl", directory_.path().string())).exit_code, 1);
}

TEST_F(Project, AnotherOutputReplacesItAndNothingOfTheUsers) {
  generate("--project icarus,yosys");
  generate("--project yosys");
  EXPECT_FALSE(fs::exists(path("rtl/icarus")));
  EXPECT_TRUE(fs::exists(path("rtl/yosys/run")));
  const std::string again = "generate scene.toml --no-prove -o rtl";
  write("rtl/yosys/mine.txt", "mine");
  expect_refused(again, "not of a previous output of generate: received yosys/mine.txt");
  fs::remove(path("rtl/yosys/mine.txt"));
  fs::create_directories(path("rtl/mine"));
  expect_refused(again, "not of a previous output of generate: received mine");
  fs::remove(path("rtl/mine"));
  fs::rename(path("rtl/yosys"), path("moved"));
  fs::create_directory_symlink("../moved", path("rtl/yosys"));
  expect_refused(again, "not of a previous output of generate: received yosys");
  fs::remove(path("rtl/yosys"));
  EXPECT_EQ(mixcmp(again).exit_code, 0);
  EXPECT_FALSE(fs::exists(path("rtl/integration")));
  EXPECT_TRUE(fs::exists(path("moved/run")));
}

TEST_F(Project, WithoutDataThereIsNoTestBench) {
  write("scene.toml",
        "[comparison]\nname = \"scene\"\nf = \"a\"\ng = \"b\"\n"
        "[reference]\nformat = \"binary32\"\n[reduced]\nformat = \"s8e8\"\n"
        "[system]\nlanes = 1\nreferences = 1\n");
  expect_refused("generate scene.toml --no-prove -o rtl --project vivado,icarus",
                 "the test bench of --project icarus needs data to run on");
  EXPECT_FALSE(fs::exists(path("rtl")));
  generate("--project vivado");
  EXPECT_TRUE(fs::exists(path("rtl/vivado/synthesise.tcl")));
  EXPECT_FALSE(fs::exists(path("rtl/testbench")));
}

TEST_F(Project, TheCommandsThatAreToldWork) {
  const Outcome run = mixcmp("generate scene.toml --no-prove -o 'a folder' --project icarus");
  const std::string command = run.output.substr(run.output.rfind("\n  ") + 3);
  EXPECT_EQ(command, "'a folder'/icarus/run\n");
  EXPECT_EQ(in_folder(command.substr(0, command.size() - 1)).exit_code, 0);
}

TEST_F(Project, AToolThatIsNoneIsRefused) {
  expect_refused("generate scene.toml --project vivado,modelsim", "modelsim");
  expect_refused("generate scene.toml --vectors 10", "--project");
}

}  // namespace
}  // namespace mixcmp::test::project_command_test
