#include "model/base/common/output_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "model/base/common/file.hpp"
#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test::output_file_test {
namespace {

namespace fs = std::filesystem;

class OutputFileTest : public testing::Test {
protected:
  void write_before(const std::string& text) { std::ofstream(path_) << text; }
  std::string content() const { return read_file(path_).value(); }

  int files() const {
    int count = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(directory_.path())) ++count;
    return count;
  }

  /// Begins the file in a process that is killed before it commits.
  void begin_and_be_killed() const {
    const pid_t child = fork();
    if (child == 0) {
      auto file = OutputFile::open(path_);
      if (file.ok()) kill(getpid(), SIGKILL);
      _exit(1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
  }

  test::ScratchDirectory directory_;
  fs::path path_ = directory_.path() / "out.txt";
};

TEST_F(OutputFileTest, NothingChangesBeforeTheCommit) {
  write_before("before");
  {
    auto file = OutputFile::open(path_);
    ASSERT_TRUE(file.ok());
    auto open = std::move(file).value();
    open.write(std::string(1 << 20, 'x'));
    EXPECT_EQ(content(), "before");
  }
  EXPECT_EQ(content(), "before");
  EXPECT_EQ(files(), 1);
  ASSERT_TRUE(write_file(path_, "after").ok());
  EXPECT_EQ(content(), "after");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, WhatAKilledRunLeftIsRemovedByTheNext) {
  begin_and_be_killed();
  EXPECT_EQ(files(), 1);
  ASSERT_TRUE(write_file(path_, "text").ok());
  EXPECT_EQ(files(), 1);
  EXPECT_EQ(content(), "text");
}

TEST_F(OutputFileTest, TwoAtOnceAreEachWhole) {
  auto first = OutputFile::open(path_).value();
  auto second = OutputFile::open(path_).value();  // must not take the first for abandoned
  first.write("first");
  second.write("second");
  ASSERT_TRUE(first.commit().ok());
  EXPECT_EQ(content(), "first");
  ASSERT_TRUE(second.commit().ok());
  EXPECT_EQ(content(), "second");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, ALinkIsFollowedEvenToAFileThatIsNotThereYet) {
  const fs::path link = directory_.path() / "link";
  fs::create_symlink("out.txt", link);
  ASSERT_TRUE(write_file(link, "text").ok());
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(content(), "text");
  fs::create_symlink("loop", directory_.path() / "loop");
  EXPECT_FALSE(write_file(directory_.path() / "loop", "text").ok());
}

TEST_F(OutputFileTest, ADeviceStaysADevice) {
  ASSERT_TRUE(write_file("/dev/null", "text").ok());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const auto full = write_file("/dev/full", "text");
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.error().to_string(), "/dev/full: cannot be written: No space left on device");
}

TEST_F(OutputFileTest, APipeTakesTheText) {
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  std::string read;
  std::thread reader([&] { std::getline(std::ifstream(path_), read); });
  EXPECT_TRUE(write_file(path_, "text\n").ok());
  reader.join();
  EXPECT_EQ(read, "text");
  EXPECT_TRUE(fs::is_fifo(path_));
}

TEST_F(OutputFileTest, StandardOutputOfARedirectionIsNotReplaced) {
  const int before = dup(STDOUT_FILENO);
  const int file = open(path_.c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_EQ(write(file, "first\n", 6), 6);
  dup2(file, STDOUT_FILENO);
  const bool written = write_file("/dev/stdout", "second\n").ok();
  dup2(before, STDOUT_FILENO);
  EXPECT_TRUE(written);
  EXPECT_EQ(content(), "first\nsecond\n");
}

TEST_F(OutputFileTest, StandardOutputIsNotReplacedUnderAnyOfItsNames) {
  const fs::path link = directory_.path() / "link";
  fs::create_symlink("/dev/stdout", link);
  const int before = dup(STDOUT_FILENO);
  const int file = open(path_.c_str(), O_RDWR | O_CREAT, 0600);
  dup2(file, STDOUT_FILENO);
  bool written = true;
  for (const fs::path& name : {link, path_, fs::path("/dev/../dev/stdout")}) {
    written = written && write_file(name, "text\n").ok();
  }
  dup2(before, STDOUT_FILENO);
  close(file);
  EXPECT_TRUE(written);
  EXPECT_EQ(content(), "text\ntext\ntext\n");
}

TEST_F(OutputFileTest, ALinkInPlaceOfAKeptFileLosesNothing) {
  write_before("an input");
  const fs::path kept = directory_.path() / "kept";
  fs::create_symlink(path_, kept);
  ASSERT_TRUE(write_kept_file(kept, "new").ok());
  EXPECT_EQ(read_file(kept).value(), "new");
  EXPECT_EQ(content(), "an input");
}

TEST_F(OutputFileTest, APipeInPlaceOfAKeptFileStopsNothing) {
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  ASSERT_TRUE(write_kept_file(path_, "new").ok());
  EXPECT_EQ(content(), "new");
}

TEST_F(OutputFileTest, PermissionsOfWhatIsReplacedStay) {
  write_before("before");
  fs::permissions(path_, fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_TRUE(write_file(path_, "after").ok());
  EXPECT_EQ(fs::status(path_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(OutputFileTest, WhatAnotherProgramWroteIsPutInPlaceUnderTheSameRules) {
  const fs::path finished = directory_.path() / "finished";
  std::ofstream(finished) << "after";
  write_before("before");
  fs::permissions(path_, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("out.txt", directory_.path() / "link");
  ASSERT_TRUE(put_in_place(finished, directory_.path() / "link").ok());
  EXPECT_EQ(content(), "after");
  EXPECT_TRUE(fs::is_symlink(directory_.path() / "link"));
  EXPECT_EQ(fs::status(path_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(OutputFileTest, PlacesWithoutAFileAreToldWithTheReason) {
  EXPECT_NE(write_file(directory_.path(), "text").error().message.find("Is a directory"),
            std::string::npos);
  EXPECT_NE(write_file(directory_.path() / "no" / "x", "text").error().message.find("No such file"),
            std::string::npos);
}

}  // namespace
}  // namespace mixcmp::test::output_file_test
