#include "model/base/common/process.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "model/base/common/file.hpp"
#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test::process_test {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

/// Whether the process has ended: it is not there any more, or it is a zombie.
bool is_gone(pid_t process) {
  std::ifstream stat(fs::path("/proc") / std::to_string(process) / "stat");
  std::string line;
  if (!std::getline(stat, line)) return true;
  return line.substr(line.rfind(')') + 2, 1) == "Z";
}

bool is_gone_soon(pid_t process) {
  for (int attempt = 0; attempt < 500; ++attempt) {
    if (is_gone(process)) return true;
    std::this_thread::sleep_for(milliseconds(10));
  }
  return false;
}

/// The number that a script writes into a file. Waits until it is there.
pid_t number_in(const fs::path& file) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    pid_t number = 0;
    if (std::ifstream(file) >> number) return number;
    std::this_thread::sleep_for(milliseconds(10));
  }
  return 0;
}

/// A script with a grandchild in the background whose number goes into a file.
std::string with_grandchild(const fs::path& file) {
  return "sleep 1000 & echo $! >" + file.string();
}

class Processes : public testing::Test {
protected:
  Result<Done> run(const std::string& script, ToolLimits limits = {}) const {
    return run_tool({.command = {"sh", "-c", script},
                     .directory = directory_.path(),
                     .log = directory_.path() / "log",
                     .limits = limits});
  }

  test::ScratchDirectory directory_;
  fs::path number_ = directory_.path() / "number";
};

TEST_F(Processes, AToolThatFailsIsToldWithTheEndOfItsLog) {
  const auto failed = run("echo words >&2; exit 3");
  ASSERT_FALSE(failed.ok());
  EXPECT_EQ(failed.error().kind, ErrorKind::mistake);
  EXPECT_NE(failed.error().message.find("sh failed"), std::string::npos);
  EXPECT_NE(failed.error().message.find("words"), std::string::npos);
  const auto killed = run("kill -SEGV $$");
  ASSERT_FALSE(killed.ok());
  EXPECT_NE(killed.error().message.find("was ended by signal 11"), std::string::npos);
}

TEST_F(Processes, ALogIsAFileWhateverWasInItsPlace) {
  fs::create_symlink("/dev/full", directory_.path() / "log");
  const auto failed = run("echo words >&2; exit 3");
  ASSERT_FALSE(failed.ok());
  EXPECT_NE(failed.error().message.find("words"), std::string::npos);
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(directory_.path() / "log")));
}

TEST_F(Processes, AToolThatIsNotThereIsMissing) {
  const auto missing = run_tool({.command = {"no-such-tool"},
                                 .directory = directory_.path(),
                                 .log = directory_.path() / "log"});
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().kind, ErrorKind::missing_tool);
  const auto version = tool_version({"no-such-tool", "-V"}, "package");
  ASSERT_FALSE(version.ok());
  EXPECT_EQ(version.error().kind, ErrorKind::missing_tool);
  EXPECT_EQ(version.error().accepted, "no-such-tool, on Debian: apt-get install package");
  const auto portable = tool_version({"no-such-tool", "-V"}, "yowasp-tool");
  ASSERT_FALSE(portable.ok());
  EXPECT_EQ(portable.error().accepted, "no-such-tool, anywhere: pip install yowasp-tool");
}

TEST_F(Processes, ADirectoryThatIsNotThereIsNoMissingTool) {
  const auto failed = run_tool({.command = {"true"},
                                .directory = directory_.path() / "no",
                                .log = directory_.path() / "log"});
  ASSERT_FALSE(failed.ok());
  EXPECT_EQ(failed.error().kind, ErrorKind::mistake);
}

TEST_F(Processes, EndTogetherWithTheirProgram) {
  ASSERT_TRUE(run(with_grandchild(number_)).ok());
  EXPECT_TRUE(is_gone_soon(number_in(number_)));
}

TEST_F(Processes, EndAtTheirLimitOfTime) {
  const auto slow = run(with_grandchild(number_) + "; sleep 1000", {.seconds = 1});
  ASSERT_FALSE(slow.ok());
  EXPECT_NE(slow.error().message.find("took longer than 1 s"), std::string::npos);
  EXPECT_TRUE(is_gone_soon(number_in(number_)));
}

TEST_F(Processes, EndWhenTheyAreCancelled) {
  std::atomic<bool> cancelled = false;
  std::thread later([&] {
    number_in(number_);
    cancelled = true;
  });
  EXPECT_FALSE(run(with_grandchild(number_) + "; sleep 1000", {.cancelled = &cancelled}).ok());
  later.join();
  EXPECT_TRUE(is_gone_soon(number_in(number_)));
}

TEST_F(Processes, EndWithUsHoweverWeEnd) {
  const pid_t us = fork();
  if (us == 0) {
    [[maybe_unused]] const auto never = run(with_grandchild(number_) + "; sleep 1000");
    _exit(0);
  }
  const pid_t grandchild = number_in(number_);
  ASSERT_FALSE(is_gone(grandchild));
  kill(us, SIGKILL);
  waitpid(us, nullptr, 0);
  EXPECT_TRUE(is_gone_soon(grandchild));
}

TEST_F(Processes, CapturesBothStreamsOfAProgramThatReadsItsInput) {
  const auto run = capture({"sh", "-c", "cat; echo errors >&2; exit 2"}, {.input = "text"});
  ASSERT_TRUE(run.ok());
  EXPECT_EQ(run->output, "text");
  EXPECT_EQ(run->errors, "errors\n");
  EXPECT_EQ(WEXITSTATUS(run->status), 2);
  EXPECT_FALSE(run->succeeded());
}

TEST_F(Processes, CapturesNoLongerThanItMay) {
  const auto run = capture({"sh", "-c", "echo begun; sleep 1000"}, {.seconds = 0.3});
  ASSERT_TRUE(run.ok());
  EXPECT_FALSE(run->in_time);
  EXPECT_EQ(run->output, "begun\n");
}

/// The streams end while the program still runs.
TEST_F(Processes, CapturesNoLongerThanItMayWhereStreamsAreClosed) {
  const auto start = std::chrono::steady_clock::now();
  const auto run = capture({"sh", "-c", "exec >&- 2>&-; exec sleep 1000"}, {.seconds = 0.3});
  ASSERT_TRUE(run.ok());
  EXPECT_FALSE(run->in_time);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(100));
}

TEST_F(Processes, WhatAProgramLeavesRunningIsNotWaitedFor) {
  const auto start = std::chrono::steady_clock::now();
  const auto run = capture({"sh", "-c", "sleep 1000 & echo done"}, {.seconds = 500});
  ASSERT_TRUE(run.ok());
  EXPECT_TRUE(run->succeeded());
  EXPECT_EQ(run->output, "done\n");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(100));
}

TEST_F(Processes, AProgramFillsNoDisk) {
  const auto run = capture({"sh", "-c", "ulimit -S -f"});
  ASSERT_TRUE(run.ok() && run->succeeded());
  EXPECT_GT(std::stol(run->output), 0) << "a number of blocks, not \"unlimited\"";
}

TEST_F(Processes, CapturesNoMoreThanItMay) {
  const auto run = capture({"sh", "-c", "head -c 80000000 /dev/zero"});
  ASSERT_FALSE(run.ok());
  EXPECT_NE(run.error().message.find("prints too much"), std::string::npos);
  const auto version = tool_version({"sh", "-c", "printf 7.%05000d 7"}, "dash");
  ASSERT_TRUE(version.ok());
  EXPECT_EQ(version->size(), 200u);
}

TEST_F(Processes, AToolThatIsThereAndFailsIsNotMissing) {
  const auto version = tool_version({"sh", "-c", "echo no memory >&2; exit 3"}, "dash");
  ASSERT_FALSE(version.ok());
  EXPECT_EQ(version.error().kind, ErrorKind::mistake);
  EXPECT_EQ(version.error().received, "no memory");
}

TEST_F(Processes, TemporaryFilesOfAToolGoToItsFolder) {
  const char* before = getenv("TMPDIR");
  const std::string kept = before == nullptr ? "" : before;
  setenv("TMPDIR", "/nowhere", 1);
  const auto run = run_tool({.command = {"sh", "-c", "echo $TMPDIR; touch \"$(mktemp)\""},
                             .directory = directory_.path(),
                             .log = directory_.path() / "log"});
  before == nullptr ? unsetenv("TMPDIR") : setenv("TMPDIR", kept.c_str(), 1);
  ASSERT_TRUE(run.ok()) << run.error().to_string();
  const std::string folder = (directory_.path() / ".mixcmp-temporary.").string();
  EXPECT_EQ(read_file(directory_.path() / "log")->substr(0, folder.size()), folder);
  const std::filesystem::directory_iterator files(directory_.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 1) << "the log alone is left";
}

TEST_F(Processes, AToolThatPrintsNoVersionIsNone) {
  for (const char* said : {"true", "echo I am a tool", "printf '\\3777\\n'", "echo 5. .5"}) {
    const auto version = tool_version({"sh", "-c", said}, "dash");
    ASSERT_FALSE(version.ok()) << said;
    EXPECT_NE(version.error().message.find("prints no version"), std::string::npos);
  }
}

TEST_F(Processes, ALogThatCannotBeWrittenIsAnError) {
  const auto failed = run_tool({.command = {"true"}, .directory = "/", .log = "/no/such/log"});
  ASSERT_FALSE(failed.ok());
  EXPECT_EQ(failed.error().file, "/no/such/log");
}

}  // namespace
}  // namespace mixcmp::test::process_test
