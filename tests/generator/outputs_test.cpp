#include <fmt/core.h>
#include <sys/stat.h>

#include <fstream>
#include <sstream>
#include <string>

#include "tests/support/fake_yosys.hpp"
#include "tests/support/program.hpp"

/// Every verb's outputs, their places, and the exit code when one fails.
namespace mixcmp::test::outputs_test {
namespace {

namespace fs = std::filesystem;

class Outputs : public ProgramTest {
protected:
  Outputs() {
    write("data.csv", "a,b,c\n1,2,3\n4,5,6\n9,8,7\n");
    write_scene("scene.toml", "a * b");
  }

  /// Writes a scene that compares a * c with `g`.
  void write_scene(const std::string& name, const std::string& g) {
    std::ofstream(path(name))
        << "[comparison]\nname = \"scene\"\nf = \"a * c\"\ng = \"" << g << "\"\n"
        << "[reference]\nformat = \"binary32\"\n[reduced]\nformat = \"s8e8\"\n"
        << "[system]\nlanes = 1\nreferences = 1\n[data]\nfile = \"data.csv\"\n";
  }

  std::string folder() const { return directory_.path().string(); }
};

TEST_F(Outputs, AFullStandardOutputFails) {
  for (const char* verb :
       {"check scene.toml", "check scene.toml --json", "generate scene.toml -o rtl",
        "generate scene.toml -o rtl --json", "profile scene.toml --last 5",
        "profile scene.toml --last 5 --json", "verify scene.toml --simulator icarus",
        "verify scene.toml --simulator icarus --json", "doctor", "doctor --json", "devices",
        "devices --json", "--help", "verify --help", "--version"}) {
    const Outcome full = shell(fmt::format("cd '{}' && exec 3>&1 && '{}' {} 2>&3 >/dev/full",
                                           folder(), MIXCMP_PROGRAM, verb));
    EXPECT_EQ(full.exit_code, 1) << verb << "\n" << full.output;
    EXPECT_NE(full.output.find("standard output: cannot be written: No space left on device"),
              std::string::npos)
        << verb << "\n"
        << full.output;
    EXPECT_EQ(
        shell(fmt::format("cd '{}' && '{}' {} >&-", folder(), MIXCMP_PROGRAM, verb)).exit_code, 1)
        << verb;
  }
}

TEST_F(Outputs, WhatCannotBeToldOnStandardErrorChangesNoExitCode) {
  const std::string call = fmt::format("cd '{}' && '{}' ", folder(), MIXCMP_PROGRAM);
  EXPECT_EQ(shell(call + "check scene.toml 2>/dev/full").exit_code, 0);
  EXPECT_EQ(shell(call + "check nowhere.toml 2>/dev/full").exit_code, 1);
}

TEST_F(Outputs, ATableGoesThroughDevicesAndLinks) {
  fs::create_symlink("target.csv", path("link.csv"));
  for (const char* csv : {"/dev/null", "link.csv"}) {
    const Outcome run = mixcmp(fmt::format("verify scene.toml --simulator icarus --csv {}", csv));
    EXPECT_EQ(run.exit_code, 0) << run.output;
  }
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(fs::is_symlink(path("link.csv")));
  EXPECT_EQ(read("target.csv").substr(0, 5), "index");
  const Outcome piped =
      shell(fmt::format("cd '{}' && '{}' verify scene.toml --simulator icarus "
                        "--csv /dev/stdout >both.txt",
                        folder(), MIXCMP_PROGRAM));
  EXPECT_EQ(piped.exit_code, 0) << piped.output;
  EXPECT_EQ(read("both.txt").substr(0, 5), "index");
  EXPECT_NE(read("both.txt").find("passed: "), std::string::npos);
  EXPECT_EQ(mixcmp("verify scene.toml --simulator icarus --csv /dev/full").exit_code, 1);
}

/// On a * c the scene finds two rows greater than a * b and one less; the other scene finds all
/// three greater.
TEST_F(Outputs, TwoSystemsThatShareAWorkFolderKeepTheirOwn) {
  write_scene("other.toml", "2 * a * c - 1000");
  const auto verify = [&](const char* scene, const char* csv) {
    return fmt::format("'{}' verify {} --simulator icarus --work work --csv {} >{}.txt 2>&1",
                       MIXCMP_PROGRAM, scene, csv, csv);
  };
  const std::string both = fmt::format(
      "cd '{}' && for k in 1 2 3 4 5 6; do {} & one=$!; {} & two=$!; wait $one || exit 1; "
      "wait $two || exit 2; cat a.csv >>all_a.txt; cat b.csv >>all_b.txt; done",
      folder(), verify("scene.toml", "a.csv"), verify("other.toml", "b.csv"));
  const Outcome run = shell("bash -c \"" + both + "\"");
  ASSERT_EQ(run.exit_code, 0) << run.output << read("a.csv.txt") << read("b.csv.txt");
  EXPECT_NE(read("all_a.txt").find("less,"), std::string::npos) << read("all_a.txt");
  EXPECT_EQ(read("all_b.txt").find("less,"), std::string::npos) << read("all_b.txt");
}

TEST_F(Outputs, NoOutputIsAnInputOrAnotherOutput) {
  const std::string scene = read("scene.toml");
  fs::copy_file(path("scene.toml"), path("scene.fst"));
  for (const char* arguments :
       {"verify scene.toml --csv scene.toml", "verify scene.toml --csv data.csv",
        "verify scene.fst --trace scene.fst", "verify scene.toml --csv x.fst --trace x.fst",
        "verify scene.toml --csv x.gtkw --trace x.fst"}) {
    expect_refused(std::string(arguments) + " --simulator icarus", "would be written over");
  }
  EXPECT_EQ(read("scene.toml"), scene);
  EXPECT_EQ(read("scene.fst"), scene);
}

TEST_F(Outputs, AGeneratedSystemGoesThroughALinkAndReplacesNothingOfTheUsers) {
  fs::create_directory(path("real"));
  fs::create_directory_symlink("real", path("link"));
  ASSERT_EQ(mixcmp("generate scene.toml -o link").exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(path("link")));
  const fs::path list = path("real") / "scene_s8e8_1x1.f";
  ASSERT_TRUE(fs::exists(list));
  fs::remove(list);
  fs::create_directory(list);
  expect_refused("generate scene.toml -o real",
                 "a file that is not of a previous output of generate");
  EXPECT_TRUE(fs::is_directory(list));
  fs::create_directory(path("pipe"));
  ASSERT_EQ(mkfifo((path("pipe") / "x.json").c_str(), 0600), 0);
  expect_refused("generate scene.toml -o pipe",
                 "a file that is not of a previous output of generate");
  fs::create_symlink("loop", path("loop"));
  expect_refused("generate scene.toml -o loop", "loop: cannot be written: Too many levels");
}

TEST_F(Outputs, AFolderBehindALinkIsTheOneThatTheKernelFinds) {
  fs::create_directories(path("real/deep"));
  fs::create_directory_symlink("real/deep", path("link"));
  EXPECT_EQ(mixcmp("generate scene.toml -o link/../out").exit_code, 0);
  EXPECT_TRUE(fs::exists(path("real/out/scene_s8e8_1x1.v")));
  EXPECT_FALSE(fs::exists(path("out")));
  EXPECT_EQ(mixcmp("verify scene.toml --simulator icarus --work link/../work").exit_code, 0);
}

TEST_F(Outputs, AFolderThatHoldsAnInputIsNotReplaced) {
  ASSERT_EQ(mixcmp("generate scene.toml -o rtl").exit_code, 0);
  fs::copy_file(path("scene.toml"), path("rtl/scene_s8e8_1x1.f"),
                fs::copy_options::overwrite_existing);
  expect_refused("generate rtl/scene_s8e8_1x1.f --set data.file=../data.csv -o rtl",
                 "holds an input");
  EXPECT_EQ(read("rtl/scene_s8e8_1x1.f"), read("scene.toml"));
}

TEST_F(Outputs, FilesOfBaselineAndProofsReplaceNoInput) {
  const std::string scene = read("scene.toml");
  for (const char* name : {"run.log", "compile.log", "comparison", "scene_s8e8.json"}) {
    write(name, scene);
    const std::string verb = fs::path(name).extension() == ".json"
                                 ? fmt::format("check {} --prove --proof-dir .", name)
                                 : fmt::format("baseline {} --work .", name);
    expect_refused(verb, "would be written over");
    EXPECT_EQ(read(name), scene);
  }
  write("scene_s8e8.json", "scene = \"scene.toml\"\n");
  expect_refused("check scene_s8e8.json --prove --proof-dir .", "would be written over");
}

TEST_F(Outputs, ALinkToWhatIsNotThereYetIsThatFile) {
  fs::create_symlink("t.fst", path("table.csv"));
  expect_refused("verify scene.toml --simulator icarus --csv table.csv --trace t.fst",
                 "would be written over");
}

TEST_F(Outputs, ATableGoesThroughAPipe) {
  const Outcome piped = shell(
      fmt::format("cd '{}' && {{ '{}' verify scene.toml --simulator icarus --csv /dev/stdout; "
                  "echo code $?; }} | cat",
                  folder(), MIXCMP_PROGRAM));
  EXPECT_EQ(piped.output.substr(0, 5), "index") << piped.output;
  EXPECT_NE(piped.output.find("\ncode 0\n"), std::string::npos) << piped.output;
}

/// Arguments stand in comments of Verilog and of plans.
TEST_F(Outputs, AnArgumentIsOneLineOfUtf8) {
  for (const char* text : {"a\nb", "a\tb", "\xff", "a\x7f"}) {
    expect_refused(fmt::format("check 'scene{}.toml'", text), "cannot be written into files");
    expect_refused(fmt::format("check scene.toml --set 'comparison.name={}'", text),
                   "cannot be written into files");
  }
}

TEST_F(Outputs, TheWorkingDirectoryIsNotReplaced) {
  fs::create_directory(path("empty"));
  const Outcome run = shell(fmt::format("cd '{}' && '{}' generate ../scene.toml -o .",
                                        path("empty").string(), MIXCMP_PROGRAM));
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("is the working directory"), std::string::npos) << run.output;
}

/// "010" is eight to some and ten to others.
TEST_F(Outputs, AWholeNumberHasNoZerosInFront) {
  for (const char* arguments :
       {"verify scene.toml --simulator icarus --first 010", "profile scene.toml --samples 010",
        "verify scene.toml --simulator icarus --seed 18446744073709551617",
        "profile scene.toml --first 08", "baseline scene.toml --rounds 0x10",
        "verify scene.toml --simulator icarus --only -1"}) {
    const Outcome run = mixcmp(arguments);
    EXPECT_EQ(run.exit_code, 1) << arguments << "\n" << run.output;
    EXPECT_NE(run.output.find("received"), std::string::npos) << arguments << "\n" << run.output;
  }
}

TEST_F(Outputs, ANumberOfSecondsIsANumber) {
  expect_refused("baseline scene.toml --seconds nan", "--seconds");
  expect_refused("check scene.toml --prove --proof-seconds nan", "--proof-seconds");
}

TEST_F(Outputs, VerifyNeedsATagForEachLaneThatRefetches) {
  expect_refused(
      "verify scene.toml --lanes 4 --references 1 --set system.operands=refetched "
      "--set system.tag_bits=1",
      "system.tag_bits");
}

TEST_F(Outputs, AVerilatorThatWritesNoProgramIsAnError) {
  const Outcome run =
      mixcmp("verify scene.toml", instead_of("verilator", "echo Verilator 5.006; exit 0"));
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("build.log: make failed"), std::string::npos) << run.output;
}

/// A simulator that says nothing or nonsense is told, with its log.
TEST_F(Outputs, ASimulatorThatEndsEarlyGivesNoVerdicts) {
  ASSERT_EQ(mixcmp("verify scene.toml --simulator icarus").exit_code, 0);
  for (const char* simulator : {"exit 0", "echo nonsense"}) {
    const Outcome run =
        mixcmp("verify scene.toml --simulator icarus", instead_of("vvp", simulator));
    EXPECT_EQ(run.exit_code, 1) << simulator << "\n" << run.output;
    EXPECT_NE(run.output.find("simulation.log"), std::string::npos) << run.output;
  }
}

/// A failure after the simulation leaves both files of the run before.
TEST_F(Outputs, WavesAndTheirSaveFileAreOfOneRun) {
  ASSERT_EQ(mixcmp("verify scene.toml --simulator icarus --trace t.fst").exit_code, 0);
  const std::string waves = read("t.fst"), save_file = read("t.gtkw");
  const std::string cut_short = fmt::format(
      "vvp=$(PATH=${{PATH#*:}} command -v vvp); $vvp \"$@\"; status=$?; "
      "for waves in '{}'/.mixcmp-waves.*/waves.fst; do : >\"$waves\"; done; exit $status",
      folder());
  const Outcome run = mixcmp("verify scene.toml --simulator icarus --first 1 --trace t.fst",
                             instead_of("vvp", cut_short));
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_EQ(read("t.fst"), waves);
  EXPECT_EQ(read("t.gtkw"), save_file);
}

TEST_F(Outputs, WavesOfIcarusHaveAnyName) {
  fs::create_directory(path("höhe × breite"));
  const Outcome run =
      mixcmp("verify scene.toml --simulator icarus --work w --trace 'höhe × breite/wellen→.fst'");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_TRUE(fs::exists(path("höhe × breite/wellen→.fst")));
}

TEST_F(Outputs, NoShellReadsAPathForIcarus) {
  for (const char* work : {"a$(touch RUN)", "a`touch RUN`", "a\"b"}) {
    expect_refused(fmt::format("verify scene.toml --simulator icarus --work '{}'", work),
                   "Icarus cannot compile where the path has one of");
  }
  EXPECT_FALSE(fs::exists(path("RUN")));
  const Outcome run =
      mixcmp("verify scene.toml --simulator icarus --work \"it's; a & (b) <c> *?[d]#!|\"");
  EXPECT_EQ(run.exit_code, 0) << run.output;
}

TEST_F(Outputs, WavesThatCannotBePlacedAreRefusedBeforeTheSimulation) {
  fs::create_directory(path("w.gtkw"));
  expect_refused("verify scene.toml --trace w.fst", "w.gtkw: waves cannot be written there");
}

TEST_F(Outputs, WavesFollowALinkToAnotherFileSystem) {
  fs::create_directory(path("disk"));
  fs::create_symlink("disk/t.fst", path("link.fst"));
  if (shell("unshare --mount true").exit_code != 0) GTEST_SKIP() << "mounting needs root";
  const Outcome run = shell(
      fmt::format("cd '{}' && unshare --mount sh -c 'mount -t tmpfs none disk && "
                  "{} verify scene.toml --simulator icarus --trace link.fst && test -s disk/t.fst'",
                  folder(), MIXCMP_PROGRAM));
  EXPECT_EQ(run.exit_code, 0) << run.output;
}

/// The other run ends when the message is there, however slow the machine is.
TEST_F(Outputs, WhoWaitsForAnotherRunSaysSo) {
  const Outcome run = shell(fmt::format(
      "cd '{0}' && mkdir work && touch said && {{ flock work sh -c 'for k in $(seq 600); do "
      "grep -q waiting said && exit; sleep 0.1; done' & }} && sleep 0.2 && '{1}' baseline "
      "scene.toml --work work --rounds 1 --seconds 0.01 > said 2>&1; code=$?; cat said; exit $code",
      folder(), MIXCMP_PROGRAM));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("work: waiting for another run"), std::string::npos) << run.output;
}

/// Many machines have ccache, but not its folder.
TEST_F(Outputs, ACcacheThatCannotWriteIsNotUsed) {
  const Outcome run = mixcmp("verify scene.toml", "CCACHE_DIR=/proc/nowhere");
  EXPECT_EQ(run.exit_code, 0) << run.output;
}

TEST_F(Outputs, WavesOnAFullDiskAreAnErrorAndLeaveNothing) {
  const std::string call = fmt::format(
      "cd '{}' && mkdir disk && unshare --mount sh -c 'mount -t tmpfs -o size=16k none disk && "
      "{} verify scene.toml --simulator icarus --trace disk/t.fst; code=$?; ls disk; exit $code'",
      folder(), MIXCMP_PROGRAM);
  if (shell("unshare --mount true").exit_code != 0) GTEST_SKIP() << "mounting needs root";
  const Outcome run = shell(call);
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_EQ(run.output.find("t.fst\n"), std::string::npos) << run.output;
}

TEST_F(Outputs, IcarusKeepsWhatItWasGivenAndWhatItSaid) {
  ASSERT_EQ(mixcmp("verify scene.toml --simulator icarus --work work").exit_code, 0);
  int kept = 0;
  for (const auto& entry : fs::recursive_directory_iterator(path("work"))) {
    for (const char* name :
         {"testbench.v", "Vsystem.h", "vpi_model.cpp", "build.log", "scene_s8e8_1x1.json"}) {
      kept += entry.path().filename() == name ? 1 : 0;
    }
  }
  EXPECT_EQ(kept, 5);
}

TEST_F(Outputs, ATmpdirThatDoesNotExistIsNamed) {
  for (const char* verb : {"check scene.toml --costs", "baseline scene.toml",
                           "verify scene.toml --simulator icarus"}) {
    const Outcome run = mixcmp(verb, "TMPDIR=/no/such/folder");
    EXPECT_NE(run.exit_code, 0) << verb << run.output;
    EXPECT_NE(run.output.find("/no/such/folder: TMPDIR: no folder can be made there"),
              std::string::npos)
        << verb << "\n"
        << run.output;
  }
}

TEST_F(Outputs, CostsAreThoseOfTheProfiledLaneToo) {
  const std::string yosys = instead_of("yosys", fake_yosys("77"));
  const Outcome run = mixcmp("check scene.toml --costs --bound profiled", yosys);
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const std::size_t place = run.output.rfind("profiled ");
  ASSERT_NE(place, std::string::npos) << run.output;
  const std::string line = run.output.substr(place, run.output.find('\n', place) - place);
  EXPECT_NE(line.find("77"), std::string::npos) << run.output;
  EXPECT_EQ(run.output.find("does not exist: a profiled"), std::string::npos) << run.output;
}

/// Yosys fails at one call: each bound has two, but the last.
TEST_F(Outputs, AreasThatCannotBeMeasuredEndInAnError) {
  for (const int broken : {1, 2, 4}) {
    fs::remove(path("calls"));
    const std::string yosys = instead_of(
        "yosys", fake_yosys("77", fmt::format("echo call >> {0}\ntest $(wc -l < {0}) = {1} "
                                              "&& echo broken && exit 1\n",
                                              path("calls").string(), broken)));
    const Outcome run = mixcmp("check scene.toml --costs", yosys + " TMPDIR=" + folder());
    EXPECT_EQ(run.exit_code, 1) << broken << run.output;
    const std::size_t line = run.output.find("no areas, ");
    ASSERT_NE(line, std::string::npos) << run.output;
    const std::size_t begin = run.output.find('/', line), end = run.output.find("/map.log", line);
    ASSERT_LT(begin, end) << run.output;
    EXPECT_EQ(read(run.output.substr(begin, end - begin) + "/map.log"), "broken\n");
  }
}

TEST_F(Outputs, WithoutACompilerVerilatorsWorkEndsWith3) {
  const std::string failing = instead_of(
      "verilator", "case \"$*\" in *--version*) echo Verilator 5.006;; *) exit 1;; esac");
  const Outcome run = mixcmp("verify scene.toml", failing.substr(0, failing.find(':')));
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_NE(run.output.find("apt-get install make"), std::string::npos) << run.output;
}

TEST_F(Outputs, WithoutAllOfIcarusItsWorkEndsWith3) {
  write("engine.toml",
        "[comparison]\nname = \"near\"\nf = \"ai - aj\"\ng = \"bi - bj\"\n"
        "[reference]\nformat = \"binary32\"\n[reduced]\nformat = \"s8e8\"\n"
        "[system]\nlanes = 1\nreferences = 1\n[engine]\nkind = \"pairwise\"\ncapacity = 3\n"
        "[data]\nfile = \"data.csv\"\npairs = \"all\"\n");
  const auto expect_missing = [&](const char* scene, const char* program) {
    const std::string all = instead_of("iverilog", "echo Icarus Verilog version 11.0");
    const Outcome run = mixcmp(fmt::format("verify {} --simulator icarus", scene),
                               all.substr(0, all.find(':')));  // no other tool
    EXPECT_EQ(run.exit_code, 3) << run.output;
    EXPECT_NE(run.output.find(fmt::format("cannot run {}: ", program)), std::string::npos)
        << run.output;
    EXPECT_NE(run.output.find("apt-get install --reinstall iverilog"), std::string::npos)
        << run.output;
  };
  expect_missing("scene.toml", "vvp");
  expect_missing("engine.toml", "vvp");
  instead_of("vvp", "echo Icarus Verilog runtime version 11.0");
  expect_missing("scene.toml", "iverilog-vpi");
  expect_missing("engine.toml", "iverilog-vpi");
}

TEST_F(Outputs, WhatIsNotDoneForWantOfAToolEndsWith3) {
  for (const auto& [verb, package] : std::initializer_list<std::pair<const char*, const char*>>{
           {"check scene.toml --prove", "apt-get install gappa"},
           {"check scene.toml --costs", "apt-get install yosys"},
           {"verify scene.toml", "apt-get install verilator"},
           {"verify scene.toml --simulator icarus", "apt-get install iverilog"},
           {"characterise scene.toml --store s.sqlite", "apt-get install yosys"},
           {"route scene.toml", "apt-get install yosys"},
           {"baseline scene.toml", "apt-get install g++"}}) {
    const Outcome run = mixcmp(verb, "PATH=/nowhere");
    EXPECT_EQ(run.exit_code, 3) << verb << "\n" << run.output;
    EXPECT_NE(run.output.find(package), std::string::npos) << verb << "\n" << run.output;
  }
}

}  // namespace
}  // namespace mixcmp::test::outputs_test
