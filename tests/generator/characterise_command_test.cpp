#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "tests/generator/characterise_fixture.hpp"

/// `mixcmp characterise` as a user calls it.
namespace mixcmp::test::characterise_command_test {
namespace {

const std::string two_lanes = "--precisions 4,6 --components lane";

measured::ComponentKey lane(const std::string& format) {
  return measured::Lane{.format = LaneFormat::parse(format).value(),
                        .inputs = LaneInputs::exact,
                        .multipliers = scene::Multipliers::logic};
}

TEST_F(CharacteriseCommand, MeasuresOnceAndTheTableIsTheSame) {
  const Outcome first = characterise(two_lanes + ",fifo", fake(""));
  ASSERT_EQ(first.exit_code, 0) << first.output;
  EXPECT_EQ(calls(), 3);
  EXPECT_EQ(stored(), 3);
  const std::string text = read("characterisation/scene-virtex6-lx760.csv");
  const auto table = read_table();
  ASSERT_EQ(table.rows.size(), 3u);
  for (const measured::Measurement& row : table.rows) {
    EXPECT_GT(row.area.luts, 1000) << "the sources' bytes";
    EXPECT_EQ(row.area.registers, 900);
    EXPECT_EQ(row.tools, "Yosys 9.9 (fake)");
  }
  EXPECT_NE(table.find(lane("s4e5")), nullptr) << text;
  EXPECT_NE(table.find(lane("s6e5")), nullptr) << text;
  EXPECT_FALSE(scratch_is_left());

  const Outcome second = characterise(two_lanes + ",fifo --json", fake(""));
  ASSERT_EQ(second.exit_code, 0) << second.output;
  EXPECT_EQ(nlohmann::json::parse(second.output).at("synthesised"), 0);
  EXPECT_EQ(calls(), 3);
  EXPECT_EQ(read("characterisation/scene-virtex6-lx760.csv"), text);
}

/// To SQLite, ":memory:" and "file:x" are no paths: the measurements of a run would be lost then.
TEST_F(CharacteriseCommand, AnyNameOfAStoreIsAPath) {
  for (const std::string store : {":memory:", "file:x"}) {
    const Outcome run = characterise_into(store, two_lanes + " -o table.csv", fake(""));
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_TRUE(std::filesystem::is_regular_file(path(store)));
    EXPECT_EQ(measured::read_characterisation(path("table.csv"))->rows.size(), 2u);
    std::filesystem::remove(path("table.csv"));
  }
}

TEST_F(CharacteriseCommand, ATableIsNoFileOfTheStore) {
  const Outcome run = characterise_into("s", two_lanes + " -o s-journal", fake(""));
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("would be written over"), std::string::npos) << run.output;
}

TEST_F(CharacteriseCommand, MeasuresWithTheRealYosys) {
  if (!has_yosys()) GTEST_SKIP() << "yosys is not installed";
  const Outcome run = characterise(two_lanes + " --device ice40-hx8k -o table.csv");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(stored(), 2);
  const auto table = measured::read_characterisation(path("table.csv"));
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  const measured::Measurement* narrow = table->find(lane("s4e5"));
  const measured::Measurement* wide = table->find(lane("s6e5"));
  ASSERT_TRUE(narrow != nullptr && wide != nullptr);
  EXPECT_GT(narrow->area.luts, 20);
  EXPECT_GT(narrow->area.registers, 10);
  EXPECT_GT(wide->area.luts, narrow->area.luts);
  EXPECT_EQ(wide->area.dsps, 0) << "multipliers of logic";
}

TEST_F(CharacteriseCommand, ABoardAndItsPartHaveOneTable) {
  for (const char* device : {"arty-a7-100", "XC7A100TCSG324-1", "xc7a100t"}) {
    const Outcome run = characterise(two_lanes + " --device " + device, fake(""));
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_EQ(calls(), 2) << device;
    const auto table = measured::read_characterisation(path("characterisation/scene-xc7a100t.csv"));
    ASSERT_TRUE(table.ok()) << table.error().to_string();
    EXPECT_EQ(table->device, "xc7a100t");
  }
}

TEST_F(CharacteriseCommand, ADeviceThatYosysDoesNotMapIsToldWithTheReason) {
  expect_refused("characterise scene.toml --device de10-nano",
                 "system.device: no areas by Yosys: Yosys drops the names of nets when it maps to "
                 "Cyclone V, so that nobody can tell whether a netlist is whole: received 5cseba6");
}

TEST_F(CharacteriseCommand, MeasuresTheMemoriesOfSquares) {
  if (!has_yosys()) GTEST_SKIP() << "yosys is not installed";
  write("squares.toml",
        "[comparison]\nname = \"squares\"\nf = \"(a - b)^2\"\ng = \"c^2\"\n"
        "[inputs]\n\"*\" = { range = [0, 1] }\n[reference]\nformat = \"s11e5\"\n"
        "[reduced]\nformat = \"auto\"\n[system]\ndevice = \"ecp5-85k\"\n");
  const Outcome run = mixcmp(
      "characterise squares.toml --store s.sqlite --area-only --bounds fixed_norm "
      "--multipliers logic,memory --components lane --precisions 8 -o table.csv");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto table = measured::read_characterisation(path("table.csv"));
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  ASSERT_EQ(table->rows.size(), 2u);
  EXPECT_EQ(lane_of(table->rows[0].key)->multipliers, scene::Multipliers::logic);
  EXPECT_EQ(table->rows[0].area.memories, 0);
  EXPECT_EQ(lane_of(table->rows[1].key)->multipliers, scene::Multipliers::memory);
  EXPECT_EQ(table->rows[1].area.memories, 1) << "both squares in one block";
  EXPECT_LT(table->rows[1].area.luts, table->rows[0].area.luts);
}

TEST_F(CharacteriseCommand, AnAreaAloneDoesNotReplaceAClock) {
  const std::string timed =
      "characterise scene.toml --store s.sqlite --bounds relative --inputs exact "
      "--multipliers logic --components lane --precisions 4";
  ASSERT_EQ(mixcmp(timed, fake("")).exit_code, 0) << mixcmp(timed, fake("")).output;
  ASSERT_EQ(read_table().rows.size(), 1u);
  EXPECT_GT(read_table().rows[0].timing_seeds, 0);
  ASSERT_TRUE(read_table().rows[0].clock);
  EXPECT_EQ(read_table().rows[0].clock->mhz, 250);
  const int before = calls();
  EXPECT_EQ(characterise("--components lane --precisions 4", fake("")).exit_code, 0);
  EXPECT_EQ(calls(), before);
  EXPECT_TRUE(read_table().rows[0].clock);
}

/// A full disk cuts the report, with an exit code of 0. An empty report is not a design without
/// paths.
TEST_F(CharacteriseCommand, AReportOfTheTimingThatIsCutShortIsNoResult) {
  const std::string timed =
      "characterise scene.toml --store s.sqlite --bounds relative --inputs exact "
      "--multipliers logic --components lane --precisions 4";
  const Outcome cut = mixcmp(timed, fake("FAKE_CUT=1"));
  EXPECT_EQ(cut.exit_code, 1) << cut.output;
  EXPECT_NE(cut.output.find("Yosys' report of the timing is cut short"), std::string::npos)
      << cut.output;
  EXPECT_EQ(stored(), 0);
  ASSERT_EQ(mixcmp(timed, fake("")).exit_code, 0);
  EXPECT_EQ(read_table().rows[0].clock->mhz, 250);
}

TEST_F(CharacteriseCommand, OldResultsAreNotServedForNewTools) {
  ASSERT_EQ(characterise("--components lane --precisions 4", fake("")).exit_code, 0);
  const Outcome newer =
      characterise("--components lane --precisions 4", fake("FAKE_VERSION='Yosys 10.0'"));
  ASSERT_EQ(newer.exit_code, 0) << newer.output;
  EXPECT_EQ(calls(), 2);
  EXPECT_EQ(stored(), 2);
  ASSERT_EQ(read_table().rows.size(), 1u);
  EXPECT_EQ(read_table().rows[0].tools, "Yosys 10.0");
}

TEST_F(CharacteriseCommand, RowsOfOtherToolsAreNotKeptBesideNewOnes) {
  ASSERT_EQ(characterise(two_lanes, fake("")).exit_code, 0);
  const Outcome newer =
      characterise("--components crossbar --ports 2", fake("FAKE_VERSION='Yosys 10.0'"));
  ASSERT_EQ(newer.exit_code, 0) << newer.output;
  EXPECT_NE(newer.output.find("2 outdated rows dropped"), std::string::npos) << newer.output;
  EXPECT_EQ(read_table().rows.size(), 1u);
}

TEST_F(CharacteriseCommand, KeepsRowsOfOtherComponents) {
  ASSERT_EQ(characterise(two_lanes, fake("")).exit_code, 0);
  const Outcome added = characterise("--components crossbar --ports 2", fake(""));
  ASSERT_EQ(added.exit_code, 0) << added.output;
  EXPECT_EQ(read_table().rows.size(), 3u);
  EXPECT_EQ(calls(), 3);
  // Other cut points: no lane would be kept, and the measurements of another machine would be lost.
  const Outcome changed =
      characterise("--components crossbar --ports 2,3 --target-mhz 400", fake(""));
  EXPECT_EQ(changed.exit_code, 1) << changed.output;
  EXPECT_NE(changed.output.find("--target-mhz 40"), std::string::npos) << changed.output;
  EXPECT_EQ(read_table().rows.size(), 3u);
}

TEST_F(CharacteriseCommand, AJobThatFailsIsNamedAndTheOthersGoOn) {
  const std::string fails = fake("FAKE_FAILS='module stream_crossbar'");
  const std::string both = "--components lane,crossbar --precisions 4 --ports 2";
  const Outcome run = characterise(both, fails);
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("crossbar 2 ports: "), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("something is wrong with"), std::string::npos) << run.output;
  ASSERT_EQ(read_table().rows.size(), 1u);
  EXPECT_EQ(kind_of(read_table().rows[0].key), measured::ComponentKind::lane);
  int kept = 0;
  for (const auto& entry : fs::directory_iterator(store().string() + ".work")) {
    EXPECT_NE(run.output.find(entry.path().filename().string()), std::string::npos);
    EXPECT_TRUE(fs::exists(entry.path() / "stream_crossbar.v"));
    ++kept;
  }
  EXPECT_EQ(kept, 1);
  const Outcome mended = characterise(both, fake(""));
  EXPECT_EQ(mended.exit_code, 0) << mended.output;
  EXPECT_EQ(read_table().rows.size(), 2u);
  EXPECT_FALSE(scratch_is_left()) << "what failed once has worked";
}

TEST_F(CharacteriseCommand, AnAreaOfConstantNetsIsRefused) {
  const std::string both = "--components lane,crossbar --precisions 6 --ports 2";
  const Outcome run = characterise(both, fake("FAKE_BITS='\"0\"'"));
  EXPECT_EQ(run.exit_code, 1) << run.output;
  for (const char* words : {"lane s6e5 exact relative logic: ", "received 0 of", "bits that vary",
                            "accepted at least "}) {
    EXPECT_NE(run.output.find(words), std::string::npos) << words << ": " << run.output;
  }
  ASSERT_EQ(read_table().rows.size(), 1u) << "the other row is there";
  EXPECT_EQ(kind_of(read_table().rows[0].key), measured::ComponentKind::crossbar);
  EXPECT_EQ(stored(), 1);
  EXPECT_EQ(characterise(both, fake("")).exit_code, 0);
  EXPECT_EQ(read_table().rows.size(), 2u);
}

TEST_F(CharacteriseCommand, AnAreaWithFewerMultipliersThanTheScheduleIsRefused) {
  const auto measure = [&](const std::string& settings) {
    return mixcmp(
        "characterise scene.toml --store s.sqlite --area-only --components reference "
        "--multipliers embedded",
        fake(settings));
  };
  const Outcome run = measure("FAKE_DSPS=0");
  EXPECT_EQ(run.exit_code, 1) << run.output;
  for (const char* words : {"reference s11e5 embedded", "dsps", "received 0",
                            "embedded multipliers", "accepted at least 1"}) {
    EXPECT_NE(run.output.find(words), std::string::npos) << words << ": " << run.output;
  }
  EXPECT_FALSE(fs::exists(table()));
  EXPECT_EQ(stored(), 0);
  EXPECT_EQ(measure("FAKE_DSPS=1").exit_code, 0);
  EXPECT_EQ(read_table().rows.size(), 1u);
}

TEST_F(CharacteriseCommand, AnInterruptLosesTheRunningJobsAlone) {
  for (const auto& [signal, number] :
       std::map<std::string, int>{{"INT", SIGINT}, {"TERM", SIGTERM}, {"HUP", SIGHUP}}) {
    for (const char* name : {"calls", "sleeps", "s.sqlite"}) fs::remove(path(name));
    const Outcome run = signalled(signal, "FAKE_SLOW_AFTER=1");
    EXPECT_EQ(run.exit_code, 128 + number) << signal << "\n" << run.output;
    EXPECT_NE(run.output.find("interrupted"), std::string::npos) << run.output;
    EXPECT_EQ(stored(), 1) << signal;
    EXPECT_FALSE(scratch_is_left()) << signal;
    EXPECT_FALSE(fs::exists(table())) << "half a table";
    EXPECT_TRUE(has_ended(read("sleeps").substr(0, read("sleeps").find('\n')))) << signal;
  }
  const Outcome resumed = characterise("--precisions 4,5,6 --components lane", fake(""));
  EXPECT_EQ(resumed.exit_code, 0) << resumed.output;
  EXPECT_NE(resumed.output.find("2 jobs run"), std::string::npos) << resumed.output;
  EXPECT_EQ(read_table().rows.size(), 3u);
}

TEST_F(CharacteriseCommand, AKilledRunLeavesNoToolsAndTheNextClearsItsFolders) {
  const Outcome run = signalled("KILL", "FAKE_SLOW_AFTER=1 FAKE_SLEEP=1000");
  EXPECT_EQ(run.exit_code, 128 + SIGKILL) << run.output;
  EXPECT_TRUE(has_ended(read("sleeps").substr(0, read("sleeps").find('\n'))));
  EXPECT_EQ(stored(), 1);
  EXPECT_TRUE(scratch_is_left());
  const Outcome resumed = characterise("--precisions 4,5,6 --components lane", fake(""));
  EXPECT_EQ(resumed.exit_code, 0) << resumed.output;
  EXPECT_NE(resumed.output.find("2 jobs run"), std::string::npos) << resumed.output;
  EXPECT_FALSE(scratch_is_left());
}

TEST_F(CharacteriseCommand, ATmpdirThatDoesNotExistIsNotNeeded) {
  const Outcome run =
      characterise("--precisions 4 --components lane", fake("TMPDIR=/no/such/folder"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
}

TEST_F(CharacteriseCommand, TwoAtOnceLoseNoRowOfOneTable) {
  const std::string arguments =
      "characterise scene.toml --store s.sqlite --area-only --bounds relative --inputs exact "
      "--multipliers logic --components lane --jobs 1 --precisions ";
  write("two.sh", fmt::format("cd '{0}'; export {3}\n'{1}' {2} 4,5 & one=$!\n"
                              "'{1}' {2} 6,7 && wait $one\n",
                              directory_.path().string(), MIXCMP_PROGRAM, arguments,
                              fake("FAKE_SLOW_AFTER=0 FAKE_SLEEP=0.3")));
  const Outcome run = shell("bash '" + path("two.sh").string() + "'");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(read_table().rows.size(), 4u);
}

/// The second run adds a row and measures an outdated one anew while the first is at work.
TEST_F(CharacteriseCommand, RowsThatAnotherRunMeasuredMeanwhileStay) {
  ASSERT_EQ(characterise("--components crossbar --ports 1", fake("")).exit_code, 0);
  const measured::Measurement sound = read_table().rows.at(0);
  const std::string file = "characterisation/scene-virtex6-lx760.csv";
  write(file, std::regex_replace(read(file), std::regex(sound.hash), "00"));
  const std::string arguments =
      "characterise scene.toml --area-only --components crossbar --jobs 1 --ports ";
  write("two.sh", fmt::format("cd '{0}'\n{3} {4} '{1}' {2} 2 --store a.sqlite & one=$!\n"
                              "for k in $(seq 1200); do [ -e sleeps ] && break; sleep 0.05; done\n"
                              "{3} '{1}' {2} 1,2,3 --store b.sqlite && wait $one\n",
                              directory_.path().string(), MIXCMP_PROGRAM, arguments, fake(""),
                              "FAKE_SLOW_AFTER=0 FAKE_SLEEP=3"));
  const Outcome run = shell("bash '" + path("two.sh").string() + "'");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto now = read_table();
  ASSERT_EQ(now.rows.size(), 3u) << run.output;
  EXPECT_EQ(now.rows[0].hash, sound.hash);
}

TEST_F(CharacteriseCommand, ALostTerminalIsIgnoredUnderNohup) {
  const Outcome run = signalled("HUP", "FAKE_SLOW_AFTER=1 FAKE_SLEEP=1", "trap '' HUP;");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(stored(), 3);
}

TEST_F(CharacteriseCommand, TwoAtOnceShareAStore) {
  const std::string arguments =
      "characterise scene.toml --store s.sqlite --area-only --bounds relative --inputs exact "
      "--multipliers logic --components lane --jobs 1 --precisions ";
  write("two.sh", fmt::format("cd '{0}'; export {3}\n'{1}' {2} 4,5,6 -o one.csv & one=$!\n"
                              "'{1}' {2} 6,5,4 -o two.csv && wait $one\n",
                              directory_.path().string(), MIXCMP_PROGRAM, arguments,
                              fake("FAKE_SLOW_AFTER=0 FAKE_SLEEP=0.3")));
  const Outcome run = shell("bash '" + path("two.sh").string() + "'");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(stored(), 3);
  EXPECT_FALSE(scratch_is_left());
  const auto rows = [&](const std::string& name) {
    const std::string text = read(name);
    return text.substr(text.find("kind,"));
  };
  EXPECT_EQ(rows("one.csv"), rows("two.csv"));
  EXPECT_GE(calls(), 3);
  EXPECT_LE(calls(), 6);
}

TEST_F(CharacteriseCommand, ATableGoesToAPipe) {
  const Outcome run = shell(fmt::format(
      "cd '{}' && '{}' characterise scene.toml --store s.sqlite --area-only --components fifo "
      "-o /dev/stdout | grep -c ^fifo",
      directory_.path().string(), MIXCMP_PROGRAM));
  EXPECT_EQ(run.exit_code, 0) << run.output;
}

TEST_F(CharacteriseCommand, WhereNothingIsMeasuredTheOldTableStays) {
  write("old.csv", "");
  const Outcome run = mixcmp(
      "characterise scene.toml --store s.sqlite --area-only -o old.csv "
      "--components fifo",
      instead_of("yosys", "[ \"$1\" = -V ] && { echo Yosys 1.0; exit; }; exit 1"));
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_EQ(read("old.csv"), "");
  EXPECT_NE(run.output.find("old.csv is as it was"), std::string::npos) << run.output;
}

/// Two squares, in fixed point: with guard digits, and with a bound that follows magnitudes.
TEST_F(CharacteriseCommand, NamesGuardDigitsAndRunningBounds) {
  write("squares.toml",
        "[comparison]\nname = \"squares\"\nf = \"(a - b)^2\"\ng = \"c^2\"\n"
        "[inputs]\n\"*\" = { range = [0, 1] }\n[reference]\nformat = \"s11e5\"\n"
        "[reduced]\nformat = \"auto\"\n[system]\ndevice = \"ecp5-85k\"\n");
  const Outcome run = mixcmp(
      "characterise squares.toml --store s.sqlite --area-only --components lane --precisions 6 "
      "--bounds fixed_norm_g3,fixed_running,block_running_g2 --multipliers logic -o table.csv",
      fake(""));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto table = measured::read_characterisation(path("table.csv"));
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  std::vector<std::string> names;
  for (const auto& row : table->rows)
    names.push_back(lane_of(row.key)->format.name() + " " + to_string(lane_of(row.key)->bound));
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"block6g2 block_running_g2", "q6 fixed_running",
                                             "q6g3 fixed_norm_g3"}));
}

/// Lanes on grids differ only in their names, so the one of the fewest bits is measured.
TEST_F(CharacteriseCommand, MeasuresALaneOnGridsWhereAnInputHasAGrid) {
  const auto formats_on_grids = [&](const std::string& grid) {
    write("scene.toml",
          "[comparison]\nname = \"squares\"\nf = \"(a - b)^2\"\ng = \"c^2\"\n"
          "[inputs]\n\"*\" = { range = [0, 1]" +
              grid +
              " }\n"
              "[reference]\nformat = \"s11e5\"\n[reduced]\nformat = \"auto\"\n"
              "[system]\ndevice = \"ecp5-85k\"\n");
    const Outcome run = mixcmp(
        "characterise scene.toml --store s.sqlite --area-only --components lane --precisions 5-8 "
        "--inputs exact --multipliers logic -o table.csv",
        fake(""));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    const auto table = measured::read_characterisation(path("table.csv"));
    EXPECT_TRUE(table.ok()) << run.output;
    std::vector<std::string> formats;
    for (const auto& row : table.value().rows) {
      const measured::Lane* const lane = lane_of(row.key);
      if (lane->bound == grid_bound) formats.push_back(lane->format.name());
    }
    return formats;
  };
  EXPECT_EQ(formats_on_grids(""), std::vector<std::string>());
  EXPECT_EQ(formats_on_grids(", grid = \"0x1p-5\""), std::vector<std::string>{"q6"});
}

/// A norm bound of the fixture's product does not exist.
TEST_F(CharacteriseCommand, WhereNoComponentExistsTheOldTableStays) {
  const std::string nothing =
      "characterise scene.toml --store s.sqlite --area-only --components lane --bounds fixed_norm "
      "--precisions 5 -o old.csv";
  const Outcome none = mixcmp(nothing, fake(""));
  EXPECT_EQ(none.exit_code, 1) << none.output;
  EXPECT_FALSE(fs::exists(path("old.csv")));
  EXPECT_NE(none.output.find("nothing was measured"), std::string::npos) << none.output;
  ASSERT_EQ(characterise("--components lane --precisions 4 -o old.csv", fake("")).exit_code, 0);
  const std::string before = read("old.csv");
  EXPECT_EQ(mixcmp(nothing, fake("")).exit_code, 1);
  EXPECT_EQ(read("old.csv"), before);
}

TEST_F(CharacteriseCommand, RefusesWhatItCannotDo) {
  const auto refused = [this](const std::string& arguments, const std::string& words) {
    expect_refused("characterise scene.toml --store s.sqlite " + arguments, words);
  };
  refused("-o s.sqlite", "would be written over");
  refused("--precisions 3", "--precisions");
  refused("--precisions 12", "numbers 4..11");
  refused("--precisions 8-5", "interval");
  refused("--precisions 8,x", "\"x\"");
  refused("--bounds tight", "--bounds");
  refused("--bounds running_9", "running_1 to running_8");
  refused("--inputs some", "exact, rounded, or a number of digits 4..11");
  refused("--inputs exact,54", "exact, rounded, or a number of digits 4..11");
  refused("--multipliers some", "both, embedded, logic, memory");
  refused("--multipliers logic,logic", "given twice");
  refused("--multipliers memory --bounds relative", "only lanes in fixed point read");
  refused("--components gate", "unit, lane, reference, fifo, crossbar, reference_port");
  refused("--components segment", "not a component of this scene's systems");
  refused("--ports 0", "--ports");
  refused("--exponents some", "reference, ranges");
  refused("--device nothing", "system.device");
  EXPECT_FALSE(fs::exists(store()));
  write("s.sqlite", std::string(3000, 'x'));
  refused("--components crossbar --ports 1 --area-only", "no SQLite file");
  EXPECT_EQ(read("s.sqlite").size(), 3000u);
  fs::create_directory(path("characterisation"));
  std::ofstream(table()) << "not,a,table\n";
  refused("--components crossbar --ports 1 --area-only", "not the columns");
  EXPECT_EQ(read("characterisation/scene-virtex6-lx760.csv"), "not,a,table\n");
}

TEST_F(CharacteriseCommand, ATableOfSomethingElseIsNotWrittenOver) {
  ASSERT_EQ(characterise("--components crossbar --ports 1", fake("")).exit_code, 0);
  const std::string before = read("characterisation/scene-virtex6-lx760.csv");
  const Outcome other = characterise(
      "--components crossbar --ports 1 --device ice40-hx8k "
      "-o characterisation/scene-virtex6-lx760.csv");
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.output.find("sums on virtex6-lx760"), std::string::npos) << other.output;
  EXPECT_EQ(read("characterisation/scene-virtex6-lx760.csv"), before);
}

}  // namespace
}  // namespace mixcmp::test::characterise_command_test
