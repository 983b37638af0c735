#include "verilator_tb/clocked_block.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "generator/hardware/emit/system.hpp"
#include "model/base/common/file.hpp"
#include "model/base/number/exact.hpp"
#include "tests/support/sphere.hpp"
#include "tests/verilator_tb/fake_system.hpp"

namespace mixcmp::test::clocked_block_test {
namespace {

namespace fs = std::filesystem;

const char* const printed =
    "// A lane.\n`default_nettype none\n\nmodule lane (\n  input  wire         aclk,\n"
    "  input  wire         go,\n  input  wire [487:0] data,\n  output wire         valid,\n"
    "  output wire [1:0]   verdict\n);\n"
    "endmodule\n";

TEST(ClockedBlock, HasThePortsOfAPrintedModule) {
  const auto block = verilator_tb::clocked_block("lane", printed);
  ASSERT_TRUE(block.has_value());
  ASSERT_EQ(block->ports.size(), 4u) << "without aclk";
  EXPECT_EQ(block->ports[1].name, "data");
  EXPECT_EQ(block->ports[1].width, 488);
  EXPECT_EQ(block->ports[1].direction, rtl::Direction::input);
  EXPECT_EQ(block->ports[3].width, 2);
  EXPECT_EQ(block->ports[3].direction, rtl::Direction::output);
}

/// A port that is forgotten or crossed with another would show in no width.
TEST(ClockedBlock, ItsWrapperAndItsStubPackTheSameWay) {
  const auto block = verilator_tb::clocked_block("lane", printed);
  ASSERT_TRUE(block.has_value());
  EXPECT_NE(block->wrapper().find(".data(d[487:0])"), std::string::npos) << block->wrapper();
  EXPECT_NE(block->wrapper().find(".go(d[488:488])"), std::string::npos) << block->wrapper();
  EXPECT_NE(block->wrapper().find(".verdict(q[1:0])"), std::string::npos) << block->wrapper();
  EXPECT_NE(block->wrapper().find(".valid(q[2:2])"), std::string::npos) << block->wrapper();
  EXPECT_NE(block->stub().find("{go, data}, next$"), std::string::npos) << block->stub();
  EXPECT_NE(block->stub().find("assign {valid, verdict} = q$;"), std::string::npos)
      << block->stub();
}

TEST(ClockedBlock, IsNoModuleThatMixcmpWouldNotPrint) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = printed;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_FALSE(verilator_tb::clocked_block("other", printed).has_value());
  EXPECT_FALSE(verilator_tb::clocked_block("lane", "").has_value());
  EXPECT_FALSE(verilator_tb::clocked_block("lane", with("module lane (",
                                                        "module lane #(parameter W"
                                                        " = 1) ("))
                   .has_value());
  EXPECT_FALSE(verilator_tb::clocked_block("lane", with("[487:0]", "[W-1:0]")).has_value());
  EXPECT_FALSE(verilator_tb::clocked_block("lane", with("aclk", "clock")).has_value());
}

TEST(ClockedBlock, IsNoModuleWhoseFunctionsWouldHaveNamesThatVerilatorHashes) {
  const auto blocks = [](std::size_t length) {
    const std::string module(length, 'm');
    std::string text = printed;
    text.replace(text.find("module lane ("), 13, "module " + module + " (");
    emit::Signature signature =
        emit::generate_system(sphere_design(format("s5e8"), format("s24e8"), 2, 1), "")
            .value()
            .signature;
    signature.lane_groups.front().module = module;
    return verilator_tb::clocked_blocks(signature, {{module + ".v", text}}).size();
  };
  EXPECT_EQ(blocks(120), 1u);
  EXPECT_EQ(blocks(121), 0u);
}

TEST(ClockedBlock, IsInNoSystemOfOneLaneAndOneReference) {
  const auto blocks = [](int lanes, int references) {
    const auto system = emit::generate_system(
        sphere_design(format("s5e8"), format("s24e8"), lanes, references), "");
    verilator_tb::SourceFiles files;
    for (const emit::GeneratedFile& file : system->files) files.emplace_back(file.name, file.text);
    return verilator_tb::clocked_blocks(system->signature, files).size();
  };
  EXPECT_EQ(blocks(1, 1), 0u);
  EXPECT_EQ(blocks(1, 0), 0u);
  EXPECT_EQ(blocks(2, 1), 2u);
  EXPECT_EQ(blocks(1, 2), 2u);
  EXPECT_EQ(blocks(2, 2), 2u);
}

TEST(ClockedBlock, ItsFilesAreThoseThatItNames) {
  const verilator_tb::SourceFiles all = {{"leaf.v", "module leaf; endmodule"},
                                         {"leaf_2.v", "module leaf_2; endmodule"},
                                         {"middle.v", "module middle; leaf_2 u (); endmodule"},
                                         {"top.v", "module top; middle leaf_3 (); endmodule"}};
  const auto files = verilator_tb::files_of_module("top", all);
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[0].first, "leaf_2.v") << "in compile order";
  EXPECT_EQ(files[1].first, "middle.v");
  EXPECT_EQ(files[2].first, "top.v");
}

fs::path generate(const design::Design& design, const std::string& folder) {
  const auto system = emit::generate_system(design, "mixcmp generate " + folder);
  EXPECT_TRUE(system.ok()) << system.error().to_string();
  const fs::path path = fake_work_dir() / folder;
  EXPECT_TRUE(emit::write_system(*system, path).ok());
  return path;
}

std::set<std::string> folders_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

TEST(ClockedBlock, IsBuiltOnceForAllSystems) {
  const fs::path work = fake_work_dir() / "shared_blocks";
  fs::remove_all(work);
  for (const int references : {1, 2}) {
    const auto design = test::sphere_design(format("s5e8"), format("s24e8"), 2, references);
    const auto system =
        verilator_tb::load_system(generate(design, fmt::format("shared_2x{}", references)));
    ASSERT_TRUE(system.ok()) << system.error().to_string();
    const auto built = verilator_tb::build_simulator(*system, {.work_dir = work});
    ASSERT_TRUE(built.ok()) << built.error().to_string();
  }
  EXPECT_EQ(folders_in(work).size(), 4u) << "two systems, one lane, one reference";
}

/// Spheres on a line, near and far.
data::Comparisons some_spheres() {
  data::Table table{.format = format("s24e8"), .columns = test::sphere_graph().inputs()};
  for (std::size_t k = 0; k < 200 * table.columns.size(); ++k) {
    table.values.push_back(from_rational(table.format, static_cast<long>(k % 11)));
  }
  return data::Comparisons::rows(table, table.columns).value();
}

TEST(ClockedBlock, IsBuiltAnewWhereItsArchiveIsGone) {
  const fs::path work = fake_work_dir() / "lost_archive";
  fs::remove_all(work);
  for (const int lanes : {2, 3}) {
    const auto design = test::sphere_design(format("s5e8"), format("s24e8"), lanes, 1);
    const auto system =
        verilator_tb::load_system(generate(design, fmt::format("lost_{}x1", lanes)));
    ASSERT_TRUE(system.ok()) << system.error().to_string();
    const auto built = verilator_tb::build_simulator(*system, {.work_dir = work});
    ASSERT_TRUE(built.ok()) << built.error().to_string();
    for (const std::string& folder : folders_in(work)) {
      if (folder.find("_channel-") != std::string::npos) fs::remove_all(work / folder / "obj");
    }
  }
}

/// The stub of a combinational output would give it a cycle late.
TEST(ClockedBlock, OfCombinationalOutputsIsRefused) {
  const auto design = test::sphere_design(format("s5e8"), format("s24e8"), 2, 1);
  const fs::path folder = generate(design, "combinational");
  const fs::path scoreboard = folder / "mixcmp_lane_scoreboard.v";
  std::string text = read_file(scoreboard).value();
  const std::string ready = "assign s_axis_tready = slot_valid;";
  const auto at = text.find(ready);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, ready.size(), "assign s_axis_tready = m_axis_tready && slot_valid;");
  std::ofstream(scoreboard) << text;
  const auto system = verilator_tb::load_system(folder);
  ASSERT_TRUE(system.ok()) << system.error().to_string();
  const auto report = verilator_tb::judge_system(
      *system, design, some_spheres(),
      {.work_dir = fake_work_dir() / "builds", .traffic = verilator_tb::TrafficKind::stressed});
  ASSERT_FALSE(report.ok());
  EXPECT_NE(report.error().to_string().find("depends on an input of the same cycle"),
            std::string::npos)
      << report.error().to_string();
}

}  // namespace
}  // namespace mixcmp::test::clocked_block_test
