#include "verilator_tb/waves.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "generator/hardware/emit/system.hpp"
#include "tests/support/sphere.hpp"
#include "tests/verilator_tb/fake_system.hpp"

namespace mixcmp::test::waves_test {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Full names of the variables a VCD file declares, "scope.name[msb:lsb]".
std::set<std::string> declared(const std::string& vcd) {
  std::set<std::string> names;
  std::vector<std::string> scopes;
  std::istringstream lines(vcd);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword, kind, width, code, name, range;
    words >> keyword;
    if (keyword == "$scope") {
      words >> kind >> name;
      scopes.push_back(name);
    } else if (keyword == "$upscope") {
      scopes.pop_back();
    } else if (keyword == "$var") {
      words >> kind >> width >> code >> name >> range;
      std::string full;
      for (const std::string& scope : scopes) full += scope + ".";
      names.insert(full + name + (range == "$end" ? "" : range));
    }
  }
  return names;
}

/// How often each signal named `name` changes to 0, by the code that the VCD file gives it.
std::map<std::string, int> falls_of(const std::string& name, const std::string& vcd) {
  std::map<std::string, int> falls;
  std::istringstream lines(vcd);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword, kind, width, code, declared_name;
    words >> keyword >> kind >> width >> code >> declared_name;
    if (keyword == "$var" && declared_name == name) falls[code] = 0;
    if (line.starts_with("0") && falls.contains(line.substr(1))) ++falls[line.substr(1)];
  }
  return falls;
}

class WavesOf : public testing::TestWithParam<verilator_tb::SimulatorKind> {};

INSTANTIATE_TEST_SUITE_P(In, WavesOf,
                         testing::Values(verilator_tb::SimulatorKind::verilator,
                                         verilator_tb::SimulatorKind::icarus),
                         [](const auto& test) {
                           return test.param == verilator_tb::SimulatorKind::icarus ? "Icarus"
                                                                                    : "Verilator";
                         });

TEST_P(WavesOf, AreReadableAndTheSaveFileNamesWhatIsInThem) {
  const FakeSystem fake{.name = "good"};
  const auto folder = write_fake_system(fake);
  const bool icarus = GetParam() == verilator_tb::SimulatorKind::icarus;
  const fs::path waves = fs::absolute(fake_work_dir()) / (icarus ? "icarus.fst" : "verilator.fst");
  fs::remove(waves);
  const auto report = verilator_tb::judge_system(
      verilator_tb::load_system(folder).value(), fake_design(fake), fake_comparisons(200),
      {.simulator = GetParam(), .work_dir = fake_work_dir() / "builds", .waves = waves});
  ASSERT_TRUE(report.ok()) << report.error().to_string();
  EXPECT_TRUE(report->passed());

  const fs::path vcd = fs::path(waves).replace_extension(".vcd");
  const auto converted = run_tool({.command = {"fst2vcd", "-f", waves.string(), "-o", vcd.string()},
                                   .directory = "/",
                                   .log = waves.string() + ".log"});
  ASSERT_TRUE(converted.ok()) << converted.error().to_string();
  EXPECT_TRUE(verilator_tb::is_whole_fst(waves));
  const fs::path half = fs::path(waves).replace_extension(".half");
  const std::string whole = read(waves);
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{100}, whole.size() / 2, whole.size() - 1}) {
    std::ofstream(half, std::ios::binary) << whole.substr(0, size);
    EXPECT_FALSE(verilator_tb::is_whole_fst(half)) << size << " of " << whole.size() << " bytes";
  }
  const std::set<std::string> names = declared(read(vcd));
  EXPECT_GT(names.size(), 40u) << "waves show the inside";

  const std::string save_file = read(fs::path(waves).replace_extension(".gtkw"));
  const std::regex signal(icarus ? R"(testbench\.[A-Za-z_.]+(\[\d+:0\])?)"
                                 : R"(TOP\.[A-Za-z_.]+(\[\d+:0\])?)");
  std::set<std::string> named;
  for (auto it = std::sregex_iterator(save_file.begin(), save_file.end(), signal);
       it != std::sregex_iterator(); ++it) {
    named.insert(it->str());
  }
  EXPECT_EQ(named.size(), 13u);
  for (const std::string& name : named) EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Waves, TheSaveFileShowsALaneWithTheStreamsOfItsGroup) {
  auto design = test::sphere_design(format("s5e8"), format("s24e8"), 8, 1);
  design.system.lanes_per_group = 4;
  const emit::Signature signature = emit::generate_system(design, "").value().signature;
  const std::string text =
      verilator_tb::gtkwave_save_file(signature, {.waves = "w.fst",
                                                  .scope = "TOP.top",
                                                  .time_per_cycle = 2,
                                                  .marked = harness::wire::Result{.lane = 6}});
  for (const char* words :
       {"-comparisons of lane 6\n", "-counters of group 1 of lanes\n",
        "#{s_axis_tvalid[1]} (0)TOP.top.s_axis_tvalid[1:0]\n",
        "#{m_axis_tdata[6]} (8)TOP.top.m_axis_tdata[63:0] ", "#{m_axis_tuser[1]} (0)TOP.top."}) {
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  }
}

TEST(Waves, ShowTheInsideOfEveryLane) {
  const auto design = test::sphere_design(format("s5e8"), format("s24e8"), 2, 1);
  const auto generated = emit::generate_system(design, "mixcmp generate waves");
  ASSERT_TRUE(generated.ok()) << generated.error().to_string();
  const fs::path folder = fake_work_dir() / "waves_2x1";
  ASSERT_TRUE(emit::write_system(*generated, folder).ok());
  data::Table table{.format = format("s24e8"), .columns = design.inputs};
  table.values.resize(20 * design.inputs.size());
  const fs::path waves = fs::absolute(fake_work_dir()) / "every_lane.fst";
  fs::remove(waves);
  const auto report =
      verilator_tb::judge_system(verilator_tb::load_system(folder).value(), design,
                                 data::Comparisons::rows(table, table.columns).value(),
                                 {.work_dir = fake_work_dir() / "builds", .waves = waves});
  ASSERT_TRUE(report.ok()) << report.error().to_string();
  EXPECT_TRUE(report->passed());
  const fs::path vcd = fs::path(waves).replace_extension(".vcd");
  const auto converted = run_tool({.command = {"fst2vcd", "-f", waves.string(), "-o", vcd.string()},
                                   .directory = "/",
                                   .log = waves.string() + ".log"});
  ASSERT_TRUE(converted.ok()) << converted.error().to_string();
  std::map<std::string, int> inside;  // registers of results, by the instance they are in
  for (const std::string& name : declared(read(vcd))) {
    const std::string scope = "TOP.sphere_s5e8_2x1.";
    if (name.find(".tracker.tags.result_q") == std::string::npos) continue;
    ASSERT_TRUE(name.starts_with(scope)) << name;
    ++inside[name.substr(scope.size(), name.find('.', scope.size()) - scope.size())];
  }
  EXPECT_EQ(inside, (std::map<std::string, int>{{"g_lanes[0]", 1}, {"g_lanes[1]", 1}}));
  const auto falls = falls_of("aclk", read(vcd));
  EXPECT_GE(falls.size(), 4u) << "of the system, two lanes and a reference";
  for (const auto& [code, count] : falls) EXPECT_GT(count, 10) << "a clock that stands still";
}

}  // namespace
}  // namespace mixcmp::test::waves_test
