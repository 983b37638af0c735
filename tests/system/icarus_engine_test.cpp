#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>

#include "model/base/common/file.hpp"
#include "model/base/common/process.hpp"
#include "model/comparison/data/uniform_spheres.hpp"
#include "tests/support/scratch_directory.hpp"
#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"
#include "verilator_tb/icarus.hpp"
#include "verilator_tb/waves.hpp"

/// Engines in Icarus Verilog: the built files, and the end of a run where something is wrong.
namespace mixcmp::test::icarus_engine_test {
namespace {

namespace fs = std::filesystem;

design::Design small_engine() {
  design::Design design = sphere_design(format("s6e8"), format("s24e8"), 1, 1);
  design.system = with_engine(design.system, {.kind = scene::EngineKind::pairwise, .capacity = 8});
  return design;
}

/// Builds the engine in a folder of the test's own.
verilator_tb::Executable build(const std::string& test) {
  const auto system = verilator_tb::load_system(generate_to(small_engine(), test + "_rtl")).value();
  const auto built = verilator_tb::build_in_icarus(system, {.work_dir = test_work_dir(test)});
  EXPECT_TRUE(built.ok()) << built.error().to_string();
  return *built;
}

TEST(IcarusEngine, BuildsWithoutWarnings) {
  const fs::path folder = build("icarus_host").path.parent_path().parent_path();
  const std::string log = read_file(folder / "build.log").value();
  EXPECT_NE(log.find("-Wall"), std::string::npos) << log;
  EXPECT_EQ(log.find("warning:"), std::string::npos) << log;
}

TEST(IcarusEngine, EndsWithItsHost) {
  const std::string program = build("icarus_host").path.string();
  // Standard input, which leads to the host, is at its end.
  const auto run = capture({program, "seed=1"}, {.seconds = 20});
  ASSERT_TRUE(run.ok()) << run.error().to_string();
  EXPECT_TRUE(run->in_time);
  EXPECT_EQ(how_it_ended(run->status), "failed with exit code 1");
}

/// vvp's $dumpfile takes only ASCII names.
TEST(IcarusEngine, WritesWavesInAFolderOfAnyName) {
  const ScratchDirectory scratch;
  const fs::path folder = scratch.path() / "höhe × breite";
  fs::create_directory(folder);
  const design::Design design = small_engine();
  const data::Table spheres = data::uniform_spheres(
      {.count = 8, .side = 100, .radius_max = 30, .seed = 3}, design.reference.input_format);
  const fs::path waves = folder / "wellen→.fst";
  const auto report = simulate(design, data::Comparisons::all_pairs(spheres, design.inputs).value(),
                               {.simulator = verilator_tb::SimulatorKind::icarus, .waves = waves});
  EXPECT_TRUE(report.passed()) << to_text(report);
  ASSERT_TRUE(verilator_tb::is_whole_fst(waves));
  const auto vcd = capture({"fst2vcd", waves.string()});
  ASSERT_TRUE(vcd.ok() && vcd->succeeded());
  EXPECT_NE(vcd->output.find("$scope module testbench $end\n$scope module system $end"),
            std::string::npos);
  const std::string save_file = read_file(verilator_tb::save_file_beside(waves)).value();
  const std::regex signal(R"(testbench\.system\.(\w+))");
  int named = 0;
  for (std::sregex_iterator it(save_file.begin(), save_file.end(), signal), end; it != end; ++it) {
    EXPECT_NE(vcd->output.find(" " + it->str(1) + " "), std::string::npos) << it->str();
    ++named;
  }
  EXPECT_GT(named, 15);
}

TEST(IcarusEngine, WhoKillsTheProgramKillsTheSimulation) {
  const fs::path program = build("icarus_killed").path;
  const auto files = [&] {
    const fs::recursive_directory_iterator all(program.parent_path().parent_path());
    return std::distance(begin(all), end(all));
  };
  const auto before = files();
  const ScratchDirectory scratch;
  // The last command fails if the pipe has no reader any more.
  const auto run = capture({"sh", "-c",
                            "cd \"$1\" && mkfifo host\n"
                            "\"$0\" trace=waves.fst <host &\n"
                            "exec 3>host\n"
                            "until [ -e waves.fst ]; do sleep 0.1; done\n"
                            "kill -9 $!\n"
                            "wait\n"
                            "echo request >&3",
                            program.string(), scratch.path().string()});
  ASSERT_TRUE(run.ok()) << run.error().to_string();
  EXPECT_TRUE(run->in_time) << run->errors;
  EXPECT_FALSE(run->succeeded()) << "vvp still reads";
  EXPECT_EQ(files(), before) << "something is left in the folder of the build";
}

/// Two streams of reports. With resets, one is idle and unknown while the other has a beat.
design::Design engine_of_two_streams() {
  design::Design design = sphere_design(format("s6e8"), format("s24e8"), 4, 1);
  design.system = with_engine(design.system, {.kind = scene::EngineKind::pairwise,
                                              .capacity = 40,
                                              .report_streams = 2,
                                              .lanes_per_group = 2});
  return design;
}

verilator_tb::VerifyReport judge(const design::Design& design, const fs::path& rtl, int resets) {
  const data::Table spheres = data::uniform_spheres(
      {.count = 40, .side = 100, .radius_max = 30, .seed = 3}, design.reference.input_format);
  return verilator_tb::verify(design, data::Comparisons::all_pairs(spheres, design.inputs).value(),
                              verilator_tb::load_system(rtl).value(),
                              {.simulator = verilator_tb::SimulatorKind::icarus,
                               .work_dir = test_work_dir("builds"),
                               .resets = resets})
      .value();
}

TEST(IcarusEngine, MayLeaveAnIdleStreamUnknown) {
  const design::Design design = engine_of_two_streams();
  const auto report = judge(design, generate_to(design, "icarus_idle_stream"), 1);
  EXPECT_TRUE(report.passed()) << to_text(report);
}

/// The unknown bit is that of a closing beat. It reads as 1, which is right.
TEST(IcarusEngine, MustKnowABeatBesideAnIdleStream) {
  const design::Design design = engine_of_two_streams();
  const fs::path rtl = generate_to(design, "icarus_unknown_beat");
  const fs::path top = rtl / (verilator_tb::load_system(rtl)->signature.engine->top + ".v");
  std::string text = read_file(top).value();
  text.insert(text.rfind("endmodule"),
              "  assign m_axis_tuser[15] =\n"
              "      (m_axis_tvalid == 2'b10) && m_axis_tlast[1] ? 1'bx : 1'bz;\n\n");
  std::ofstream(top) << text;
  const auto report = judge(design, rtl, 0);
  EXPECT_EQ(report.mismatch_count, 0u) << to_text(report);
  ASSERT_GT(report.violation_count, 0u);
  for (const auto& violation : report.violations) {
    EXPECT_EQ(violation.fault, "unknown value (x) in a handshake or a beat");
  }
}

/// A program that another process runs must not change.
TEST(IcarusEngine, IsNotBuiltAnewInPlace) {
  const fs::path objects = build("icarus_anew").path.parent_path();
  const fs::path links = test_work_dir("icarus_anew_links");
  fs::remove_all(links);
  fs::create_directory(links);
  for (const auto& entry : fs::directory_iterator(objects)) {
    fs::create_hard_link(entry.path(), links / entry.path().filename());
  }
  ASSERT_TRUE(fs::remove(objects.parent_path() / verilator_tb::build_stamp));
  build("icarus_anew");
  for (const char* file : {"simulate", "simulation", "harness.vpi"}) {
    EXPECT_FALSE(fs::equivalent(objects / file, links / file)) << file;
  }
}

TEST(IcarusEngine, FailsWhereTheHarnessFails) {
  const fs::path program = build("icarus_failing").path;
  const fs::path folder = program.parent_path().parent_path();
  for (const auto& harness : fs::directory_iterator(folder.parent_path())) {
    if (!harness.path().filename().string().starts_with("icarus-harness")) continue;
    std::ofstream(harness.path() / "pairwise.cpp") << "int main(int, char**) { return 3; }\n";
  }
  const auto made = run_tool({.command = {"make", "-B", "-f", "build.mk"},
                              .directory = folder,
                              .log = folder / "build.log"});
  ASSERT_TRUE(made.ok()) << made.error().to_string();
  const auto run = capture({program.string()});
  ASSERT_TRUE(run.ok()) << run.error().to_string();
  EXPECT_EQ(how_it_ended(run->status), "failed with exit code 3");
  fs::remove_all(folder.parent_path());
}

}  // namespace
}  // namespace mixcmp::test::icarus_engine_test
