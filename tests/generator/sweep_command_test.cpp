#include <fmt/core.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>

#include "tests/generator/characterise_fixture.hpp"

/// `mixcmp sweep`: jobs split over shards, killed, done again and merged.
namespace mixcmp::test::sweep_command_test {
namespace {

class SweepCommand : public CharacteriseCommand {
protected:
  SweepCommand() {
    write("data.csv", "a,b,c\n1,2,3\n4,5,6\n9,8,7\n");
    write("rows.toml",
          "[comparison]\nname = \"rows\"\nf = \"a * c\"\ng = \"a * b\"\n"
          "[reference]\nformat = \"binary32\"\n[reduced]\nformat = \"s8e8\"\n"
          "[system]\nlanes = 1\nreferences = 1\n[data]\nfile = \"data.csv\"\n");
    write("sweep.toml", tables() + runs());
  }

  static std::string tables() {
    return "[[characterise]]\nscenes = \"scene.toml\"\nprecisions = \"4,5,6\"\nports = \"1\"\n"
           "bounds = \"relative\"\ninputs = \"exact\"\nmultipliers = \"logic\"\n"
           "components = \"lane\"\narea_only = true\n";
  }
  static std::string runs() {
    return "[[run]]\nscenes = \"rows.toml\"\nsimulator = \"icarus\"\n"
           "traffic = [\"full_rate\", \"stressed\"]\n";
  }

  Outcome sweep(const std::string& arguments, const std::string& settings = "") {
    return mixcmp("sweep " + arguments, fake(settings));
  }

  void expect_done(const std::string& arguments) {
    const Outcome run = sweep(arguments);
    EXPECT_EQ(run.exit_code, 0) << arguments << "\n" << run.output;
  }

  std::string table_text() { return read("characterisation/scene-virtex6-lx760.csv"); }
  void remove_table() { fs::remove_all(path("characterisation")); }

  /// Starts a shard whose second job hangs, and kills the shard with -9 once it hangs.
  void kill_midway(const std::string& arguments) {
    write("run.sh",
          fmt::format("cd '{0}'; env {1} '{2}' sweep {3} >killed.log 2>&1 & program=$!\n"
                      "for k in $(seq 1200); do [ -e '{0}/sleeps' ] && break; sleep 0.05; done\n"
                      "kill -9 $program; wait $program; rm -f '{0}/sleeps'\n",
                      directory_.path().string(), fake("FAKE_SLOW_AFTER=1"), MIXCMP_PROGRAM,
                      arguments));
    shell("bash '" + path("run.sh").string() + "'");
  }
};

TEST_F(SweepCommand, ShardsInAnyOrderMakeWhatOneMachineMakes) {
  const Outcome planned = sweep("plan sweep.toml -o a --json");
  ASSERT_EQ(planned.exit_code, 0) << planned.output;
  const auto jobs = nlohmann::json::parse(planned.output).at("jobs");
  ASSERT_EQ(jobs.size(), 5u) << "three lanes, two simulations";
  std::set<std::string> keys;
  for (const auto& job : jobs) keys.insert(job.at("key"));
  EXPECT_EQ(keys.size(), 5u);
  for (const char* shard : {"3/3", "1/3", "2/3"}) {
    expect_done(fmt::format("run a --jobs 1 --shard {}", shard));
  }
  expect_done("merge a");
  const std::string table = table_text(), report = read("a/report.json");
  EXPECT_EQ(nlohmann::json::parse(report).at("runs").size(), 2u);

  remove_table();
  expect_done("plan sweep.toml -o b");
  expect_done("run b");
  expect_done("merge b");
  EXPECT_EQ(table_text(), table);
  EXPECT_EQ(read("b/report.json"), report);

  remove_table();
  const Outcome alone = characterise("--precisions 4,5,6 --ports 1 --components lane", fake(""));
  ASSERT_EQ(alone.exit_code, 0) << alone.output;
  EXPECT_EQ(table_text(), table) << "as mixcmp characterise makes it";
  auto verified = nlohmann::ordered_json::parse(
      mixcmp("verify rows.toml --simulator icarus --traffic stressed --json 2>/dev/null").output);
  verified.erase("build_seconds");
  verified.erase("run_seconds");
  EXPECT_EQ(nlohmann::ordered_json::parse(report)["runs"][1]["report"], verified);
}

TEST_F(SweepCommand, AKilledShardGoesOnWhereItWas) {
  write("sweep.toml", tables());
  expect_done("plan sweep.toml -o a");
  kill_midway("run a --jobs 1 --shard 1/1");
  ASSERT_EQ(calls(), 2) << read("killed.log");
  const Outcome early = sweep("merge a");
  EXPECT_EQ(early.exit_code, 3) << early.output;
  EXPECT_NE(early.output.find("not done: "), std::string::npos) << early.output;
  EXPECT_FALSE(fs::exists(table())) << "nothing is merged by halves";
  const Outcome resumed = sweep("run a --jobs 1 --json");
  EXPECT_EQ(resumed.exit_code, 0) << resumed.output;
  EXPECT_EQ(nlohmann::json::parse(resumed.output).at("done_before"), 1);
  EXPECT_EQ(calls(), 4) << "one job was done, one was killed and is done again";
  expect_done("merge a");
  EXPECT_EQ(read_table().rows.size(), 3u);
  // A result that a broken disk has cut short counts as none.
  shell(fmt::format("cd '{}' && for f in a/results/*.json; do truncate -s 20 $f; break; done",
                    directory_.path().string()));
  EXPECT_EQ(sweep("merge a").exit_code, 3);
  expect_done("run a");
  EXPECT_EQ(calls(), 5);
}

TEST_F(SweepCommand, ShardsShareTheJobsOut) {
  expect_done("plan sweep.toml -o a");
  std::size_t jobs = 0;
  for (const char* shard : {"1/2", "2/2"}) {
    const Outcome run = sweep(fmt::format("run a --json --shard {}", shard));
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const auto report = nlohmann::json::parse(run.output);
    EXPECT_EQ(report.at("done_before"), 0) << "no job is in two shards";
    jobs += report.at("jobs").get<std::size_t>();
  }
  EXPECT_EQ(jobs, 5u);
}

TEST_F(SweepCommand, AnotherSceneOrToolNeedsAnotherPlan) {
  expect_done("plan sweep.toml -o a");
  const std::string others = "the jobs are others than when they were planned";
  const Outcome tool = sweep("run a", "FAKE_VERSION='Yosys 9.8 (fake)'");
  EXPECT_EQ(tool.exit_code, 1);
  EXPECT_NE(tool.output.find(others), std::string::npos) << tool.output;
  write("data.csv", "a,b,c\n1,2,3\n");
  EXPECT_NE(sweep("merge a").output.find(others), std::string::npos);
}

TEST_F(SweepCommand, ARunThatFailsIsMergedAndTold) {
  write("sweep.toml", runs());
  expect_done("plan sweep.toml -o a");
  EXPECT_EQ(mixcmp("sweep run a", wrong_icarus()).exit_code, 2);
  const Outcome merged = sweep("merge a");
  EXPECT_EQ(merged.exit_code, 2) << merged.output;
  EXPECT_NE(merged.output.find("FAILED"), std::string::npos) << merged.output;
  expect_done("run a");
  expect_done("merge a");
}

TEST_F(SweepCommand, OptionsOfAnotherStepAreRefused) {
  expect_refused("sweep plan sweep.toml --shard 2/8", "--shard: is only of sweep run");
  expect_refused("sweep plan sweep.toml --work x", "--work: is only of sweep run");
  expect_refused("sweep merge a --jobs 2", "--jobs: is only of sweep run");
  expect_refused("sweep run a -o b", "--output: is only of sweep plan");
  EXPECT_FALSE(fs::exists(path("sweep_sweep")));
}

TEST_F(SweepCommand, MistakesInRunsAreToldWhilePlanning) {
  const auto refused = [&](const std::string& group, const std::string& words) {
    write("sweep.toml", "# a sweep\n" + group);
    expect_refused("sweep plan sweep.toml -o a", words);
    EXPECT_FALSE(fs::exists(path("a"))) << group;
  };
  const std::string run = "[[run]]\nscenes = \"rows.toml\"\n";
  refused(run + "first = \"abc\"\n",
          "sweep.toml:2: run: rows.toml --first=abc: --first: received abc");
  refused(run + "system.lanse = 4\n", "sweep.toml:2: run: rows.toml --set system.lanse=4: --set: ");
  refused(run + "system.lanse = 4\n", "accepted lanes (the nearest)");
  refused(run + "portions = 3\n", "--portion: 3 comparisons in simulations of 1048576 are too few");
  refused(run + "first = 2\nsample = 2\n", "sweep.toml:2: run: ");
  refused(run + run, "sweep.toml:4: run: rows.toml: is asked for twice");
  refused("[[characterise]]\nscenes = \"scene.toml\"\nseeds = \"5x\"\n",
          "sweep.toml:2: characterise: scene.toml --seeds=5x: --seeds: ");
}

TEST_F(SweepCommand, PortionsHaveKeysOfTheirOwn) {
  write("sweep.toml", "[[run]]\nscenes = \"rows.toml\"\nshare = 1\nportions = 3\n");
  const Outcome planned = sweep("plan sweep.toml -o a --json");
  ASSERT_EQ(planned.exit_code, 0) << planned.output;
  const auto plan = nlohmann::json::parse(planned.output);
  std::set<std::string> keys, names;
  for (const auto& job : plan.at("jobs")) {
    keys.insert(job.at("key"));
    names.insert(job.at("what"));
  }
  EXPECT_EQ(keys.size(), 3u);
  EXPECT_TRUE(names.contains("verify rows.toml --share=1 --portion=2/3")) << planned.output;
  write("sweep.toml", "[[run]]\nscenes = \"rows.toml\"\nshare = 1\n");
  EXPECT_NE(sweep("plan sweep.toml -o b").output.find("\n1 job, 1 of them to do"),
            std::string::npos);
}

TEST_F(SweepCommand, AResultThatIsNotThatOfItsJobCountsAsNone) {
  write("sweep.toml", runs());
  expect_done("plan sweep.toml -o a");
  expect_done("run a");
  const auto jobs = nlohmann::json::parse(read("a/plan.json")).at("jobs");
  const std::string first = "a/results/" + jobs.at(0).at("key").get<std::string>() + ".json";
  const std::string second = "a/results/" + jobs.at(1).at("key").get<std::string>() + ".json";
  const std::string good = read(second);
  const std::string copied = read(first);
  const std::string without_counts = good.substr(0, good.find(",\n  \"system\"")) + "}";
  const std::string wrong_type =
      std::regex_replace(good, std::regex("\"requested\": 3"), "\"requested\": \"3\"");
  const std::string untrue =
      std::regex_replace(good, std::regex("\"mismatch_count\": 0"), "\"mismatch_count\": 3");
  for (const std::string& bad : {copied, without_counts, wrong_type, untrue}) {
    ASSERT_NE(bad, good);
    write(second, bad);
    EXPECT_EQ(sweep("merge a").exit_code, 3) << bad;
    EXPECT_FALSE(fs::exists(path("a/report.json"))) << bad;
    EXPECT_EQ(nlohmann::json::parse(sweep("plan sweep.toml -o a --json").output).at("jobs"), jobs);
  }
  EXPECT_EQ(nlohmann::json::parse(sweep("run a --json").output).at("run"), 1);
  expect_done("merge a");
}

TEST_F(SweepCommand, MistakesAreTold) {
  expect_refused("sweep run nowhere", "nowhere/plan.json: no plan of a sweep");
  expect_refused("sweep run a --shard 3/2", "accepted K/N");
  expect_refused("sweep walk sweep.toml", "accepted plan, run, merge");
  write("sweep.toml", "[[charcterise]]\n");
  expect_refused("sweep plan sweep.toml", "sweep.toml:1: charcterise: no such section of a sweep");
  write("sweep.toml", "[suite]\nminutes = 1\n");
  expect_refused("sweep plan sweep.toml", "a sweep without a job");
  write("sweep.toml", "[[characterise]]\nscenes = \"scene.toml\"\nquick = 1\n");
  expect_refused("sweep plan sweep.toml", "characterise.quick: wrong type");
  write("sweep.toml", "[[run]]\nscenes = \"rows.toml\"\nportions = 0\n");
  expect_refused("sweep plan sweep.toml", "run.portions: no number of portions: received 0");
  write("sweep.toml", "[[run]]\nscenes = \"none.toml\"\n");
  expect_refused("sweep plan sweep.toml", "none.toml: cannot read the file");
}

}  // namespace
}  // namespace mixcmp::test::sweep_command_test
