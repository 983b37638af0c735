#include "model/base/common/workers.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "model/base/common/memo.hpp"

namespace mixcmp::test::workers_test {
namespace {

TEST(Workers, TakeEveryItemOnce) {
  for (const unsigned threads : {1u, 2u, 5u}) {
    std::vector<int> taken(1003, 0);
    std::mutex mutex;
    run_workers({.size = taken.size(), .block = 17, .threads = threads},
                [&](const BlockSource& next) {
                  std::uint64_t first = 0, count = 0;
                  while (next(first, count)) {
                    const std::lock_guard lock(mutex);
                    for (std::uint64_t k = first; k < first + count; ++k) ++taken[k];
                  }
                });
    EXPECT_EQ(taken, std::vector<int>(taken.size(), 1));
  }
}

TEST(Workers, PassOnWhatOneThrows) {
  const auto run = [] {
    run_workers({.size = 100, .block = 1, .threads = 3}, [](const BlockSource& next) {
      std::uint64_t first = 0, count = 0;
      while (next(first, count)) {
        if (first == 40) throw std::runtime_error("forty");
      }
    });
  };
  EXPECT_THROW(run(), std::runtime_error);
}

/// The second item fails late, and the third one early.
TEST(ForEachInThreads, ReturnsTheErrorThatALoopWouldReturn) {
  for (const unsigned threads : {1u, 2u, 5u}) {
    std::atomic<int> done = 0;
    std::atomic<bool> third_failed = threads == 1;
    const auto result = for_each_in_threads({.size = 1000, .threads = threads},
                                            [&](std::uint64_t item) -> Result<Done> {
                                              ++done;
                                              if (item == 1) {
                                                while (!third_failed) std::this_thread::yield();
                                                return Error{.message = "second"};
                                              }
                                              if (item != 2) return Done{};
                                              third_failed = true;
                                              return Error{.message = "third"};
                                            });
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().message, "second") << threads << " threads";
    EXPECT_LT(done, 1000) << "items after an error are not needed";
  }
}

TEST(ForEachInThreads, TellsARisingShareFromOneThreadAtATime) {
  std::vector<double> shares;
  std::atomic<int> inside = 0;
  const WorkSplit split{.size = 1000, .threads = 4, .progress = [&](double share) {
                          EXPECT_EQ(++inside, 1);
                          shares.push_back(share);
                          --inside;
                        }};
  EXPECT_TRUE(for_each_in_threads(split, [](std::uint64_t) { return Result<Done>(Done{}); }).ok());
  ASSERT_GT(shares.size(), 1U);
  for (std::size_t k = 1; k < shares.size(); ++k) EXPECT_GE(shares[k], shares[k - 1] + 0.01);
  EXPECT_LE(shares.back(), 1);
}

TEST(Memo, MakesAValueOnceWhoeverAsks) {
  for (int round = 0; round < 100; ++round) {
    Memo<int, std::string> memo;
    std::atomic<int> made = 0;
    const WorkSplit split{.size = 40, .threads = 4};
    const auto asked = for_each_in_threads(split, [&](std::uint64_t item) -> Result<Done> {
      const int key = static_cast<int>(item) % 5;
      const auto value = memo.of(key, [&] {
        ++made;
        return std::to_string(key);
      });
      if (*value == std::to_string(key)) return Done{};
      return Error{.message = "the value of another key"};
    });
    EXPECT_TRUE(asked.ok());
    EXPECT_EQ(made, 5);
  }
}

TEST(Memo, MakesAValueAgainAfterAnException) {
  Memo<int, int> memo;
  EXPECT_THROW(memo.of(1, []() -> int { throw std::runtime_error("none"); }), std::runtime_error);
  EXPECT_EQ(*memo.of(1, [] { return 7; }), 7);
}

}  // namespace
}  // namespace mixcmp::test::workers_test
