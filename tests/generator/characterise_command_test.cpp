#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "model/characterise/measurement.hpp"
#include "model/characterise/store.hpp"
#include "tests/support/program.hpp"

/// `mixcmp characterise` as a user calls it.
namespace mixcmp::test {
namespace {

namespace fs = std::filesystem;

/// Stands in for Yosys: takes no time, finds as many LUTs as the sources have bytes, and is told by
/// variables what else to do.
constexpr const char* yosys_script = R"sh(#!/bin/sh
case "$*" in *-V*) echo "${FAKE_VERSION:-Yosys 9.9 (fake)}"; exit 0;; esac
echo called >> "$FAKE/calls"
if [ -n "$FAKE_FAILS" ] && cat *.v | grep -q "$FAKE_FAILS"; then
  echo "ERROR: something is wrong with $PWD"; exit 1
fi
if [ -n "$FAKE_SLOW_AFTER" ] && [ "$(wc -l < "$FAKE/calls")" -gt "$FAKE_SLOW_AFTER" ]; then
  mktemp > /dev/null; echo $$ > "$FAKE/pid"; mv "$FAKE/pid" "$FAKE/sleeps"
  sleep "${FAKE_SLEEP:-60}"
fi
echo "{\"design\":{\"num_cells_by_type\":{\"LUT6\":$(cat *.v | wc -c),\"FDRE\":7}}}" > area.json
echo "Latest arrival time in 'top' is 4000:" > timing.txt
)sh";

/// Ended, or about to be taken off the list by whoever inherited it.
bool has_ended(const std::string& process) {
  std::string line;
  std::ifstream stream("/proc/" + process + "/stat");
  return !std::getline(stream, line) || line.find(") Z ") != std::string::npos;
}

bool has_yosys() {
  return std::system("yosys -V > /dev/null 2>&1") == 0;
}

class CharacteriseCommand : public ProgramTest {
protected:
  CharacteriseCommand() {
    write(
        "scene.toml",
        "[comparison]\nname = \"sums\"\nf = \"a * b\"\ng = \"c\"\n"
        "[reference]\nformat = \"s11e5\"\n[reduced]\nformat = \"auto\"\n"
        "[system]\ndevice = \"virtex6-lx760\"\ntarget_mhz = 40\ntag_bits = 4\ncounter_bits = 0\n");
    write("yosys", yosys_script);
    fs::permissions(directory_.path() / "yosys", fs::perms::owner_all);
  }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(directory_.path() / name) << text;
  }

  std::string read(const std::string& name) {
    std::ostringstream text;
    text << std::ifstream(directory_.path() / name).rdbuf();
    return text.str();
  }

  /// Two lanes and a crossbar, unless the arguments say otherwise.
  Outcome characterise(const std::string& arguments, const std::string& environment = "") {
    return mixcmp(
        "characterise scene.toml --store s.sqlite --area-only --bounds relative "
        "--inputs exact --multipliers logic --jobs 2 " +
            arguments,
        environment);
  }

  /// The script above instead of Yosys.
  std::string fake(const std::string& settings) {
    const std::string here = directory_.path().string();
    return fmt::format("FAKE='{0}' PATH='{0}':\"$PATH\" {1}", here, settings);
  }

  /// Three jobs, one after the other; when one hangs the program alone gets the signal. Job control
  /// (set -m): background jobs of a plain shell ignore SIGINT.
  Outcome signalled(const std::string& signal, const std::string& settings,
                    const std::string& before = "") {
    write("run.sh",
          fmt::format("set -m; cd '{}'; {} {} '{}' characterise scene.toml --store s.sqlite "
                      "--area-only --bounds relative --inputs exact --multipliers logic --jobs 1 "
                      "--precisions 4,5,6 --components lane 2>&1 & program=$!\n"
                      "for k in $(seq 1200); do [ -e '{}/sleeps' ] && break; sleep 0.05; done\n"
                      "kill -{} $program; wait $program\n",
                      directory_.path().string(), before, "exec env " + fake(settings),
                      MIXCMP_PROGRAM, directory_.path().string(), signal));
    return shell("bash '" + (directory_.path() / "run.sh").string() + "'");
  }

  static Outcome shell(const std::string& command) {
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    EXPECT_NE(pipe, nullptr);
    Outcome run{0, ""};
    for (int c = 0; (c = fgetc(pipe)) != EOF;) run.output += static_cast<char>(c);
    run.exit_code = WEXITSTATUS(pclose(pipe));
    return run;
  }

  int calls() {
    const std::string text = read("calls");
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  }

  int stored() { return model::ResultStore::open(store()).value().size().value(); }
  fs::path store() const { return directory_.path() / "s.sqlite"; }
  fs::path table() const { return directory_.path() / "characterisation" / "virtex6-lx760.csv"; }
  model::Characterisation read_table() {
    const auto read_back = model::read_characterisation(table());
    EXPECT_TRUE(read_back.ok()) << read_back.error().to_string();
    return *read_back;
  }
  bool scratch_is_left() const { return fs::exists(store().string() + ".work"); }
};

const std::string two_lanes = "--precisions 4,6 --components lane";

model::ComponentKey lane(const std::string& format) {
  return {.kind = model::ComponentKind::lane,
          .format = format,
          .inputs = "exact",
          .bound = "relative",
          .multipliers = "logic"};
}

TEST_F(CharacteriseCommand, MeasuresOnceAndTheTableIsTheSame) {
  const Outcome first = characterise(two_lanes + ",fifo", fake(""));
  ASSERT_EQ(first.exit_code, 0) << first.output;
  EXPECT_EQ(calls(), 3);
  EXPECT_EQ(stored(), 3);
  const std::string text = read("characterisation/virtex6-lx760.csv");
  const auto table = read_table();
  ASSERT_EQ(table.rows.size(), 3u);
  for (const model::Measurement& row : table.rows) {
    EXPECT_GT(row.area.luts, 1000) << "the sources' bytes";
    EXPECT_EQ(row.area.registers, 7);
    EXPECT_EQ(row.tools, "Yosys 9.9 (fake)");
  }
  EXPECT_NE(table.find(lane("s4e5")), nullptr) << text;
  EXPECT_NE(table.find(lane("s6e5")), nullptr) << text;
  EXPECT_FALSE(scratch_is_left());

  const Outcome second = characterise(two_lanes + ",fifo --json", fake(""));
  ASSERT_EQ(second.exit_code, 0) << second.output;
  EXPECT_EQ(nlohmann::json::parse(second.output).at("synthesised"), 0);
  EXPECT_EQ(calls(), 3);
  EXPECT_EQ(read("characterisation/virtex6-lx760.csv"), text);
}

TEST_F(CharacteriseCommand, MeasuresWithTheRealYosys) {
  if (!has_yosys()) GTEST_SKIP() << "yosys is not installed";
  const Outcome run = characterise(two_lanes + " --device ice40-hx8k -o table.csv");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(stored(), 2);
  const auto table = model::read_characterisation(directory_.path() / "table.csv");
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  const model::Measurement* narrow = table->find(lane("s4e5"));
  const model::Measurement* wide = table->find(lane("s6e5"));
  ASSERT_TRUE(narrow != nullptr && wide != nullptr);
  EXPECT_GT(narrow->area.luts, 20);
  EXPECT_GT(narrow->area.registers, 10);
  EXPECT_GT(wide->area.luts, narrow->area.luts);
  EXPECT_EQ(wide->area.dsps, 0) << "multipliers of logic";
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

TEST_F(CharacteriseCommand, OldResultsAreNotServedForNewTools) {
  ASSERT_EQ(characterise("--components lane --precisions 4", fake("")).exit_code, 0);
  const Outcome newer =
      characterise("--components lane --precisions 4", fake("FAKE_VERSION='Yosys 10'"));
  ASSERT_EQ(newer.exit_code, 0) << newer.output;
  EXPECT_EQ(calls(), 2);
  EXPECT_EQ(stored(), 2);
  ASSERT_EQ(read_table().rows.size(), 1u);
  EXPECT_EQ(read_table().rows[0].tools, "Yosys 10");
}

TEST_F(CharacteriseCommand, KeepsCurrentRowsOfOtherComponentsAndDropsOthers) {
  ASSERT_EQ(characterise(two_lanes, fake("")).exit_code, 0);
  const Outcome added = characterise("--components crossbar --ports 2", fake(""));
  ASSERT_EQ(added.exit_code, 0) << added.output;
  EXPECT_EQ(read_table().rows.size(), 3u);
  EXPECT_EQ(calls(), 3);
  // Other cut points: the lanes are of yesterday; the crossbar has none.
  const Outcome changed =
      characterise("--components crossbar --ports 2,3 --target-mhz 400", fake(""));
  ASSERT_EQ(changed.exit_code, 0) << changed.output;
  EXPECT_NE(changed.output.find("2 outdated rows dropped"), std::string::npos) << changed.output;
  ASSERT_EQ(read_table().rows.size(), 2u);
  for (const auto& row : read_table().rows) {
    EXPECT_EQ(row.key.kind, model::ComponentKind::crossbar);
  }
}

TEST_F(CharacteriseCommand, AJobThatFailsIsNamedAndTheOthersGoOn) {
  const std::string fails = fake("FAKE_FAILS='module crossbar'");
  const std::string both = "--components lane,crossbar --precisions 4 --ports 2";
  const Outcome run = characterise(both, fails);
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("crossbar 2 ports: "), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("something is wrong with"), std::string::npos) << run.output;
  ASSERT_EQ(read_table().rows.size(), 1u);
  EXPECT_EQ(read_table().rows[0].key.kind, model::ComponentKind::lane);
  int kept = 0;
  for (const auto& entry : fs::directory_iterator(store().string() + ".work")) {
    EXPECT_NE(run.output.find(entry.path().filename().string()), std::string::npos);
    EXPECT_TRUE(fs::exists(entry.path() / "crossbar.v"));
    ++kept;
  }
  EXPECT_EQ(kept, 1);
  const Outcome mended = characterise(both, fake(""));
  EXPECT_EQ(mended.exit_code, 0) << mended.output;
  EXPECT_EQ(read_table().rows.size(), 2u);
  EXPECT_FALSE(scratch_is_left()) << "what failed once has worked";
}

TEST_F(CharacteriseCommand, AnInterruptLosesTheRunningJobsAlone) {
  for (const auto& [signal, number] :
       std::map<std::string, int>{{"INT", SIGINT}, {"TERM", SIGTERM}, {"HUP", SIGHUP}}) {
    for (const char* name : {"calls", "sleeps", "s.sqlite"}) fs::remove(directory_.path() / name);
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
  const Outcome run = shell("bash '" + (directory_.path() / "two.sh").string() + "'");
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

TEST_F(CharacteriseCommand, RefusesWhatItCannotDo) {
  const auto refused = [this](const std::string& arguments, const std::string& words) {
    expect_refused("characterise scene.toml --store s.sqlite " + arguments, words);
  };
  refused("--precisions 3", "--precisions");
  refused("--precisions 12", "numbers 4..11");
  refused("--precisions 8-5", "interval");
  refused("--precisions 8,x", "\"x\"");
  refused("--bounds tight", "--bounds");
  refused("--bounds running_9", "running_1 to running_8");
  refused("--inputs some", "both, exact, rounded");
  refused("--multipliers some", "both, embedded, logic");
  refused("--components gate", "lane, reference, fifo, crossbar, unit");
  refused("--ports 0", "--ports");
  refused("--exponents some", "reference, ranges");
  refused("--device nothing", "system.device");
  EXPECT_FALSE(fs::exists(store()));
  write("s.sqlite", std::string(3000, 'x'));
  refused("--components crossbar --ports 1 --area-only", "no SQLite file");
  EXPECT_EQ(read("s.sqlite").size(), 3000u);
  fs::create_directory(directory_.path() / "characterisation");
  std::ofstream(table()) << "not,a,table\n";
  refused("--components crossbar --ports 1 --area-only", "not the columns");
  EXPECT_EQ(read("characterisation/virtex6-lx760.csv"), "not,a,table\n");
}

TEST_F(CharacteriseCommand, ATableOfSomethingElseIsNotWrittenOver) {
  ASSERT_EQ(characterise("--components crossbar --ports 1", fake("")).exit_code, 0);
  const std::string before = read("characterisation/virtex6-lx760.csv");
  const Outcome other = characterise(
      "--components crossbar --ports 1 --device ice40-hx8k "
      "-o characterisation/virtex6-lx760.csv");
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.output.find("sums on virtex6-lx760"), std::string::npos) << other.output;
  EXPECT_EQ(read("characterisation/virtex6-lx760.csv"), before);
}

}  // namespace
}  // namespace mixcmp::test
