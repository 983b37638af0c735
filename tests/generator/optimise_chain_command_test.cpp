#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/generator/planning_fixture.hpp"

/// `mixcmp optimise` of arg-min engines as a user calls it, on a made-up table.
namespace mixcmp::test::optimise_chain_command_test {
namespace {

/// An arg-min engine of three candidates beside a made-up table of its parts.
class OptimiseChainCommand : public PlanningTest {
protected:
  OptimiseChainCommand() {
    write("points.csv", "p\n1\n2\n3\n4\n");
    write("centres.csv", "c\n1\n2\n5\n");
    std::ofstream(path("chain.toml"))
        << "[comparison]\nname = \"chain\"\nf = \"(p - ci)^2\"\ng = \"(p - cj)^2\"\n"
        << "[inputs]\n\"*\" = { range = [0, 8] }\n"
        << "[reference]\nformat = \"s53e8\"\n[reduced]\nformat = \"auto\"\n"
        << "[system]\ndevice = \"virtex6-lx760\"\nreferences = \"auto\"\n"
        << "[engine]\nkind = \"arg_min\"\n"
        << "[data]\nfile = \"points.csv\"\nwith = \"centres.csv\"\npairs = \"arg_min\"\n";
    write_table("chain-virtex6-lx760.csv", "virtex6-lx760", "chain");
    std::ofstream table(path(table_name), std::ios::app);
    const std::string fixed = ",,q12,,fixed_norm,embedded,0,";
    row(table, "segment" + fixed + "1", 9, 300, 2);
    row(table, "conversion" + fixed + "0", 2, 200, 0);
    row(table, "engine" + fixed + "2", 0, 400, 0);
    row(table, "engine" + fixed + "8", 0, 1000, 0);
    row(table, "operand_memory,,,,,,0,1", 0, 90, 0);
    row(table, "operand_memory,,,,,,0,4", 0, 180, 0);
    row(table, "reference_port,,s53e8,,,embedded,1,0", 0, 70, 0);
  }

  const std::string table_name = "characterisation/chain-virtex6-lx760.csv";
};

TEST_F(OptimiseChainCommand, APlanHasALaneForEachCandidateAndNamesWhatItCounts) {
  const Outcome run = mixcmp("optimise chain.toml --table characterisation --json -o plan.toml");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const nlohmann::json report = json_of(run);
  ASSERT_EQ(report["best"], 12);
  const nlohmann::json& plan = report["plans"].back();
  EXPECT_EQ(plan["lanes"], 2);
  std::set<std::string> names;
  int luts = 0;
  for (const nlohmann::json& part : report["counted"]) {
    names.insert(part["part"].get<std::string>());
    luts += part["area"]["lut"].get<int>();
  }
  EXPECT_EQ(names, (std::set<std::string>{"2 x q12 fixed_norm embedded",
                                          "1 x reference s53e8 embedded", "crossbar", "engine"}));
  EXPECT_EQ(luts, plan["used"]["lut"]);
  EXPECT_EQ(luts, 2 * 300 + 200 + 400 + 8000 + 70 + 18) << "18: a crossbar of 2 ports";
  EXPECT_EQ(mixcmp("generate plan.toml -o rtl").exit_code, 0);
  const Outcome text = mixcmp("optimise chain.toml --table characterisation");
  EXPECT_NE(text.output.find("1 x reference s53e8 embedded"), std::string::npos) << text.output;
}

TEST_F(OptimiseChainCommand, ATableOfAnotherNumberOfCandidatesIsRefused) {
  const std::string engine = "arg_min, 3 candidates, row tags of 16 bits";
  write(table_name, "# engine: " + engine + "\n" + read(table_name));
  EXPECT_EQ(mixcmp("optimise chain.toml --table characterisation").exit_code, 0);
  for (const char* other : {"system.lanes=3", "engine.tag_bits=8"}) {
    expect_refused(std::string("optimise chain.toml --table characterisation --set ") + other,
                   "the table is of another engine: received " + engine);
  }
}

}  // namespace
}  // namespace mixcmp::test::optimise_chain_command_test
