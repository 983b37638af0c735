#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "model/base/common/folder_lock.hpp"
#include "model/base/common/scratch_folder.hpp"
#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test::work_folder_test {
namespace {

namespace fs = std::filesystem;

class WorkFolders : public testing::Test {
protected:
  int entries() const {
    int count = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(directory_.path())) ++count;
    return count;
  }

  test::ScratchDirectory directory_;
};

TEST_F(WorkFolders, AScratchFolderGoesWithItsOwner) {
  {
    const auto folder = ScratchFolder::make_in(directory_.path(), "job");
    ASSERT_TRUE(folder.ok());
    std::ofstream(folder->path() / "file") << "text";
    const auto second = ScratchFolder::make_in(directory_.path(), "job");
    ASSERT_TRUE(second.ok());
    EXPECT_EQ(entries(), 2) << "a folder in use was taken for abandoned";
  }
  EXPECT_EQ(entries(), 0);
}

TEST_F(WorkFolders, WhatAKilledRunLeftIsRemovedByTheNext) {
  const pid_t child = fork();
  if (child == 0) {
    const auto folder = ScratchFolder::make_in(directory_.path(), "job");
    std::ofstream(folder->path() / "file") << "text";
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  EXPECT_EQ(entries(), 1);
  fs::create_directory(directory_.path() / "job.of_the_user");
  fs::create_directory(directory_.path() / ".mixcmp-other.XXXXXX");
  { EXPECT_TRUE(ScratchFolder::make_in(directory_.path(), "job").ok()); }
  EXPECT_EQ(entries(), 2) << "and nothing else";
}

TEST_F(WorkFolders, AKeptFolderStaysUntilTheNextRun) {
  const pid_t child = fork();
  if (child == 0) {
    for (int k = 0; k < 2; ++k) {
      auto folder = ScratchFolder::make_in(directory_.path(), "job");
      auto kept = std::move(folder).value();
      kept.keep();
    }
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  EXPECT_EQ(entries(), 2) << "no run removes what it has kept itself";
  { EXPECT_TRUE(ScratchFolder::make_in(directory_.path(), "job").ok()); }
  EXPECT_EQ(entries(), 0);
}

TEST_F(WorkFolders, AFolderIsKeptForAnErrorThatNamesAFileInIt) {
  for (const auto& [named, written] : {std::pair(false, true), {true, false}, {true, true}}) {
    {
      auto made = ScratchFolder::make_in(directory_.path(), "job");
      auto folder = std::move(made).value();
      if (written) std::ofstream(folder.path() / "map.log") << "a line";
      folder.keep_for({.file = named ? (folder.path() / "map.log").string() : "scene.toml",
                       .message = "is wrong"});
    }
    EXPECT_EQ(entries(), named && written ? 1 : 0);
  }
}

TEST_F(WorkFolders, ATmpdirThatDoesNotExistIsNamed) {
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before == nullptr ? "" : before;
  setenv("TMPDIR", "/no/such/folder", 1);
  const auto folder = ScratchFolder::make();
  kept.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", kept.c_str(), 1);
  ASSERT_FALSE(folder.ok());
  EXPECT_EQ(folder.error().file, "/no/such/folder");
  EXPECT_EQ(folder.error().field, "TMPDIR");
}

TEST_F(WorkFolders, ALockIsHeldByOneAtATime) {
  const fs::path folder = directory_.path() / "a" / "b";
  std::atomic<bool> waited = false, second_has_it = false;
  std::thread second;
  {
    const auto first = FolderLock::take(folder);
    ASSERT_TRUE(first.ok());
    second = std::thread([&] {
      const auto lock = FolderLock::take(folder, [&](const auto&) { waited = true; });
      second_has_it = lock.ok();
    });
    while (!waited) std::this_thread::yield();
    EXPECT_FALSE(second_has_it);
  }
  second.join();
  EXPECT_TRUE(second_has_it);
  EXPECT_TRUE(fs::is_empty(folder)) << "a lock leaves no file";
}

TEST_F(WorkFolders, ALockOfAFolderThatWasReplacedIsTakenAnew) {
  const fs::path folder = directory_.path() / "folder";
  std::atomic<bool> waited = false;
  std::thread second;
  {
    const auto first = FolderLock::take(folder);
    second = std::thread([&] {
      const auto lock = FolderLock::take(folder, [&](const auto&) { waited = true; });
      EXPECT_TRUE(lock.ok());
      const auto third = fork();
      if (third == 0) {
        alarm(1);  // ends this process if it waits for the lock, as it should
        signal(SIGALRM, [](int) { _exit(42); });
        const auto taken = FolderLock::take(folder);
        _exit(0);
      }
      int status = 0;
      waitpid(third, &status, 0);
      EXPECT_EQ(WEXITSTATUS(status), 42) << "the lock is on a folder that is not there any more";
    });
    while (!waited) std::this_thread::yield();
    fs::remove_all(folder);
  }
  second.join();
}

TEST_F(WorkFolders, AFolderThatCannotBeMadeIsNamed) {
  std::ofstream(directory_.path() / "file") << "text";
  const auto lock = FolderLock::take(directory_.path() / "file" / "folder");
  ASSERT_FALSE(lock.ok());
  EXPECT_EQ(lock.error().file, (directory_.path() / "file" / "folder").string());
  EXPECT_NE(lock.error().message.find("Not a directory"), std::string::npos);
}

}  // namespace
}  // namespace mixcmp::test::work_folder_test
