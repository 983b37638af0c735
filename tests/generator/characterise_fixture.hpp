#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include "generator/synthesis/characterise/store.hpp"
#include "model/cost/measured/measurement.hpp"
#include "tests/support/fake_yosys.hpp"
#include "tests/support/program.hpp"

namespace mixcmp::test {

namespace fs = std::filesystem;

/// Stands in for Yosys: takes no time, finds as many LUTs as the sources have bytes, keeps each net
/// of the top. Environment variables make it fail, hang or answer otherwise.
inline const std::string yosys_script = std::string(R"sh(
case "$*" in *-V*) echo "${FAKE_VERSION:-Yosys 9.9 (fake)}"; exit 0;; esac
echo called >> "$FAKE/calls"
if [ -n "$FAKE_FAILS" ] && cat *.v | grep -q "$FAKE_FAILS"; then
  echo "ERROR: something is wrong with $PWD"; exit 1
fi
if [ -n "$FAKE_SLOW_AFTER" ] && [ "$(wc -l < "$FAKE/calls")" -gt "$FAKE_SLOW_AFTER" ]; then
  mktemp > /dev/null; echo $$ > "$FAKE/pid"; mv "$FAKE/pid" "$FAKE/sleeps"
  sleep "${FAKE_SLEEP:-60}"
fi
)sh") + fake_cells + R"sh(
echo "{\"design\":{\"num_cells_by_type\":{\"$lut\":$(cat *.v | wc -c),\"$register\":900,\
\"$multiplier\":${FAKE_DSPS:-90}}}}" > area.json
if [ -z "$FAKE_CUT" ]; then
  { echo "Latest arrival time in 'top' is 4000:"; echo end of the timing report; } > timing.txt
else
  : > timing.txt
fi
)sh" + fake_netlist;

/// Ended, or about to be taken off the list by whoever inherited it.
inline bool is_gone(const std::string& process) {
  std::string line;
  std::ifstream stream("/proc/" + process + "/stat");
  return !std::getline(stream, line) || line.find(") Z ") != std::string::npos;
}

/// A process that was killed may take a moment on a busy machine.
inline bool has_ended(const std::string& process) {
  for (int attempt = 0; attempt < 500 && !is_gone(process); ++attempt) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return is_gone(process);
}

inline bool has_yosys() {
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
    write_script("yosys", yosys_script);
  }

  /// Two lanes and a crossbar, unless the arguments say otherwise.
  Outcome characterise(const std::string& arguments, const std::string& environment = "") {
    return characterise_into("s.sqlite", arguments, environment);
  }

  Outcome characterise_into(const std::string& store, const std::string& arguments,
                            const std::string& environment) {
    return mixcmp(
        "characterise scene.toml --store " + store +
            " --area-only --bounds relative --inputs exact --multipliers logic --jobs 2 " +
            arguments,
        environment);
  }

  /// The script above instead of Yosys.
  std::string fake(const std::string& settings) {
    const std::string here = directory_.path().string();
    return fmt::format("FAKE='{0}' PATH='{0}':\"$PATH\" {1}", here, settings);
  }

  /// Three jobs, one after the other. When one hangs, only the program gets the signal. Job control
  /// (set -m) is needed because background jobs of a plain shell ignore SIGINT.
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
    return shell("bash '" + path("run.sh").string() + "'");
  }

  int calls() {
    const std::string text = read("calls");
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  }

  int stored() { return characterise::ResultStore::open(store()).value().size().value(); }
  fs::path store() const { return path("s.sqlite"); }
  fs::path table() const { return path("characterisation") / "scene-virtex6-lx760.csv"; }
  measured::Characterisation read_table() {
    const auto read_back = measured::read_characterisation(table());
    EXPECT_TRUE(read_back.ok()) << read_back.error().to_string();
    return *read_back;
  }
  bool scratch_is_left() const { return fs::exists(store().string() + ".work"); }
};

}  // namespace mixcmp::test
