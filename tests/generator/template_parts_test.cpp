#include "generator/hardware/emit/template_parts.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "generator/synthesis/components/synthesis_jobs.hpp"
#include "model/base/common/process.hpp"
#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test::template_parts_test {
namespace {

using Counts = std::map<std::string, int>;  ///< instances, by template

rtl::TemplateInstance instance(std::string_view name) {
  return components::instance_of_name(name).value();
}

std::vector<std::string> names_of_parts(std::string_view name) {
  std::vector<std::string> names;
  for (const rtl::TemplateInstance& part : emit::template_parts(instance(name))) {
    names.push_back(components::instance_name(part));
  }
  return names;
}

void count_all(const rtl::TemplateInstance& of, Counts& counts) {
  for (const rtl::TemplateInstance& part : emit::template_parts(of)) {
    ++counts[part.module];
    count_all(part, counts);
  }
}

/// The cells of each module of a design, from the output of Yosys' command `stat`.
using Cells = std::map<std::string, Counts>;

Cells cells_of(const std::string& stat) {
  static const std::regex title("=== (.+) ==="),
      cell(R"(     (\$paramod\S+|[a-z_0-9]+) +([0-9]+))");
  Cells cells;
  std::string module;
  std::istringstream lines(stat);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_match(line, match, title)) module = match[1];
    if (module == "design hierarchy") break;
    if (std::regex_match(line, match, cell)) cells[module][match[1]] = std::stoi(match[2]);
  }
  return cells;
}

/// "$paramod\stream_fifo\WIDTH=s32'..." and "$paramod$0123\stream_fifo" are stream_fifo.
std::string template_of(const std::string& module) {
  static const std::regex derived(R"(\$paramod(?:\$[0-9a-f]+)?\\([a-z_0-9]+).*)");
  std::smatch match;
  return std::regex_match(module, match, derived) ? match[1].str() : module;
}

void count_all(const Cells& cells, const std::string& module, Counts& counts) {
  const auto found = cells.find(module);
  if (found == cells.end()) return;
  for (const auto& [cell, count] : found->second) {
    for (int k = 0; k < count; ++k) {
      ++counts[template_of(cell)];
      count_all(cells, cell, counts);
    }
  }
}

/// All instances below a template, as Yosys elaborates them.
Counts elaborated(const rtl::TemplateInstance& of) {
  const ScratchDirectory folder;
  const characterise::SynthesisJob job = components::template_job(of);
  std::string script;
  for (const characterise::SourceText& source : job.sources) {
    if (!source.cells.empty()) continue;
    std::ofstream(folder.path() / source.name) << source.text;
    script += "read_verilog " + source.name + "; ";
  }
  script += fmt::format("hierarchy -check -top {}; tee -q -o stat.txt stat", job.top);
  const auto run = run_tool({.command = {"yosys", "-q", "-p", script},
                             .directory = folder.path(),
                             .log = folder.path() / "yosys.log"});
  EXPECT_TRUE(run.ok()) << run.error().to_string();
  std::ifstream stat(folder.path() / "stat.txt");
  const Cells cells = cells_of({std::istreambuf_iterator<char>(stat), {}});
  Counts counts;
  count_all(cells, job.top, counts);
  return counts;
}

TEST(TemplateParts, HaveTheParametersThatTheTemplateGives) {
  EXPECT_EQ(names_of_parts("stream_tree INPUTS=9 WIDTH=5"),
            (std::vector<std::string>{"stream_arbiter INPUTS=3 WIDTH=5 HALF_RATE=1 BEAT_BITS=0",
                                      "stream_arbiter INPUTS=3 WIDTH=5 HALF_RATE=1 BEAT_BITS=0",
                                      "stream_arbiter INPUTS=3 WIDTH=5 HALF_RATE=1 BEAT_BITS=0",
                                      "stream_arbiter INPUTS=3 WIDTH=5 HALF_RATE=0 BEAT_BITS=0"}));
  EXPECT_EQ(names_of_parts("beat_memory WIDTH=8 BEAT_BITS=2"),
            std::vector<std::string>{"dual_port_memory WIDTH=32 ADDRESS_BITS=4"});
  EXPECT_EQ(names_of_parts("beat_memory WIDTH=8 BEAT_BITS=2 BLOCK=1"), std::vector<std::string>{});
}

TEST(TemplateParts, OfRefusedParametersAreNone) {
  EXPECT_FALSE(names_of_parts("lane_scoreboard LANES=64").empty());
  EXPECT_EQ(names_of_parts("lane_scoreboard LANES=65"), std::vector<std::string>{});
}

TEST(TemplateParts, AreThoseThatYosysElaborates) {
  for (const char* name :
       {"lane_scoreboard LANES=4 OPERAND_BITS=70 BEAT_BITS=1", "lane_scoreboard CARRIED=0",
        "lane_scoreboard LANES=2 RECOMPUTE=0 COUNTER_BITS=0", "lane_reorder LANES=2",
        "stream_crossbar LANES=40 REFERENCES=3 LANE_BITS=6",
        "arg_min_engine CANDIDATES=9 INDEX_BITS=5",
        "pairwise_engine SEGMENTS=20 STREAMS=3 REFERENCES=4 COUNT=1", "operand_memory REFERENCES=3",
        "pair_segment LANES=5 LANE_BITS=3 TIERED=1", "reference_port CARRIED=1 BEAT_BITS=2",
        "counter_port COUNTERS=30 INDEX_BITS=5"}) {
    Counts counts;
    count_all(instance(name), counts);
    EXPECT_EQ(counts, elaborated(instance(name))) << name;
  }
}

}  // namespace
}  // namespace mixcmp::test::template_parts_test
