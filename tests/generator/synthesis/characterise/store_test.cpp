#include "generator/synthesis/characterise/store.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "generator/synthesis/characterise/job_hash.hpp"
#include "generator/synthesis/characterise/sqlite.hpp"
#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test::store_test {
namespace {

namespace fs = std::filesystem;

characterise::SynthesisResult measured(int luts) {
  return {
      .area =
          {.luts = luts, .registers = 2, .dsps = 3, .memories = 4, .carries = 5, .shift_luts = 6},
      .clock = measured::Clock{.mhz = 0.1,
                               .low_mhz = 0.05,
                               .high_mhz = 300,
                               .seeds = 5,
                               .source = measured::ClockSource::routed},
      .no_clock = ""};
}

class Store : public testing::Test {
protected:
  void expect_refused(const std::string& words) {
    const auto store = characterise::ResultStore::open(path_);
    ASSERT_FALSE(store.ok());
    EXPECT_EQ(store.error().file, path_.string());
    EXPECT_NE(store.error().to_string().find(words), std::string::npos)
        << store.error().to_string();
  }

  void change(const std::string& sql) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(path_.c_str(), &database), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(database);
    sqlite3_close(database);
  }

  ScratchDirectory directory_;
  const fs::path path_ = directory_.path() / "folder" / "results.sqlite";
};

TEST_F(Store, GivesBackWhatItWasGiven) {
  characterise::SynthesisResult no_clock{
      .area = {.luts = 1}, .clock = std::nullopt, .no_clock = "it's \"so\""};
  {
    characterise::ResultStore store = characterise::ResultStore::open(path_).value();
    ASSERT_TRUE(store.add("a", measured(7), "Yosys").ok());
    ASSERT_TRUE(store.add("b", no_clock, "Yosys").ok());
    ASSERT_TRUE(store.add("a", measured(8), "Yosys").ok());
  }
  const auto store = characterise::ResultStore::open(path_);
  ASSERT_TRUE(store.ok()) << store.error().to_string();
  EXPECT_EQ(store->size().value(), 2);
  const auto a = store->find("a").value(), b = store->find("b").value();
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->area, measured(8).area);
  ASSERT_TRUE(a->clock);
  EXPECT_EQ(a->clock->mhz, 0.1);
  EXPECT_EQ(a->clock->low_mhz, 0.05);
  EXPECT_EQ(a->clock->high_mhz, 300);
  EXPECT_EQ(a->clock->seeds, 5);
  EXPECT_EQ(a->clock->source, measured::ClockSource::routed);
  EXPECT_FALSE(b->clock);
  EXPECT_EQ(b->no_clock, no_clock.no_clock);
  EXPECT_FALSE(store->find("c").value());
}

/// The shards of a sweep share the folder: each finds the others' results. A cut file counts as
/// none.
TEST_F(Store, AFolderHasAFileForEachResult) {
  fs::create_directories(path_);
  {
    characterise::ResultStore store = characterise::ResultStore::open(path_).value();
    ASSERT_TRUE(store.add("a", measured(8), "Yosys").ok());
    ASSERT_TRUE(
        store.add("b", {.area = {.luts = 1}, .clock = {}, .no_clock = "\xff \"so\""}, "").ok());
  }
  const auto store = characterise::ResultStore::open(path_).value();
  const auto a = store.find("a").value(), b = store.find("b").value();
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->area, measured(8).area);
  ASSERT_TRUE(a->clock);
  EXPECT_EQ(a->clock->mhz, 0.1);
  EXPECT_EQ(a->clock->low_mhz, 0.05);
  EXPECT_EQ(a->clock->high_mhz, 300);
  EXPECT_EQ(a->clock->seeds, 5);
  EXPECT_EQ(a->clock->source, measured::ClockSource::routed);
  EXPECT_FALSE(b->clock);
  EXPECT_EQ(b->no_clock, "\xEF\xBF\xBD \"so\"");
  EXPECT_FALSE(store.find("c").value());
  fs::copy_file(path_ / "a.json", path_ / "c.json");
  EXPECT_FALSE(store.find("c").value()) << "the result of another job";
  fs::resize_file(path_ / "a.json", 40);
  EXPECT_FALSE(store.find("a").value());
}

TEST_F(Store, RefusesWhatIsNoDatabase) {
  fs::create_directory(path_.parent_path());
  std::ofstream(path_) << std::string(5000, 'x');
  expect_refused("no SQLite file");
  EXPECT_EQ(fs::file_size(path_), 5000u);
}

TEST_F(Store, RefusesADatabaseOfSomethingElse) {
  fs::create_directory(path_.parent_path());
  change("CREATE TABLE result (hash TEXT);");
  expect_refused("something else");
}

TEST_F(Store, RefusesAnotherVersion) {
  ASSERT_TRUE(characterise::ResultStore::open(path_).ok());
  change("PRAGMA user_version = 99;");
  expect_refused("another version");
}

TEST_F(Store, RefusesADamagedFile) {
  {
    characterise::ResultStore store = characterise::ResultStore::open(path_).value();
    for (int k = 0; k < 200; ++k) {
      ASSERT_TRUE(store.add(std::string(30, 'h') + std::to_string(k), measured(k), "t").ok());
    }
  }
  std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(3 * 4096);
  file << std::string(2000, '\x55');
  file.close();
  expect_refused("damaged");
}

TEST_F(Store, RefusesADeviceAndATruncatedFile) {
  EXPECT_FALSE(characterise::ResultStore::open("/dev/null").ok());
  ASSERT_TRUE(characterise::ResultStore::open(path_).ok());
  fs::resize_file(path_, 100);
  expect_refused("");
}

TEST_F(Store, TakesFromManyProcessesAtOnce) {
  constexpr int processes = 6, each = 25;
  std::vector<pid_t> children;
  for (int process = 0; process < processes; ++process) {
    const pid_t child = fork();
    if (child == 0) {
      for (int k = 0; k < each; ++k) {
        auto opened = characterise::ResultStore::open(path_);
        if (!opened.ok()) _exit(1);
        characterise::ResultStore store = std::move(opened).value();
        const std::string hash = std::to_string(process) + "." + std::to_string(k);
        if (!store.add(hash, measured(k), "t").ok()) _exit(1);
      }
      _exit(0);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }
  EXPECT_EQ(characterise::ResultStore::open(path_).value().size().value(), processes * each);
}

TEST(StorePath, FollowsTheXdgSpecification) {
  setenv("HOME", "/home/someone", 1);
  setenv("XDG_CACHE_HOME", "/cache", 1);
  EXPECT_EQ(characterise::default_store_path().value(), "/cache/mixcmp/characterisation.sqlite");
  setenv("XDG_CACHE_HOME", "relative", 1);
  EXPECT_EQ(characterise::default_store_path().value(),
            "/home/someone/.cache/mixcmp/characterisation.sqlite");
  unsetenv("XDG_CACHE_HOME");
  EXPECT_EQ(characterise::default_store_path().value(),
            "/home/someone/.cache/mixcmp/characterisation.sqlite");
  unsetenv("HOME");
  ASSERT_FALSE(characterise::default_store_path().ok());
  EXPECT_EQ(characterise::default_store_path().error().field, "--store");
}

class JobHash : public testing::Test {
protected:
  std::string hash() const { return job_hash(job_, device_, options_, tools_); }

  characterise::SynthesisJob job_{.sources = {{"a.v", "module a; endmodule\n"}}, .top = "a"};
  devices::Device device_{.name = "d",
                          .synthesis = "synth_ice40",
                          .timing = devices::TimingTool::nextpnr_ice40,
                          .timing_arguments = {"--hx8k"}};
  characterise::SynthesisOptions options_;
  std::string tools_ = "Yosys 0.23";
  const std::string before_ = hash();
};

TEST_F(JobHash, TellsEverythingApartThatAResultDependsOn) {
  const auto expect_change = [this](auto& place, const auto& value) {
    const auto kept = place;
    place = value;
    EXPECT_NE(hash(), before_);
    place = kept;
    EXPECT_EQ(hash(), before_);
  };
  expect_change(tools_, std::string("Yosys 0.52"));
  expect_change(job_.top, std::string("b"));
  expect_change(job_.clock_port, std::string("clk"));
  expect_change(job_.sources[0].text, std::string("module a;endmodule\n"));
  expect_change(job_.sources[0].name, std::string("b.v"));
  expect_change(device_.synthesis, std::string("synth_ice40 -dsp"));
  expect_change(device_.timing, devices::TimingTool::none);
  expect_change(device_.timing_arguments, std::vector<std::string>{"--up5k"});
  expect_change(device_.timing_synthesis, std::string("synth_ice40 -abc9"));
  expect_change(device_.available.luts, 7);
  expect_change(options_.seeds, 4);
  expect_change(options_.effort, characterise::TimingEffort::area_only);
}

TEST_F(JobHash, AsksNothingOfWhatDoesNotMatter) {
  device_.name = "the same silicon under another name";
  device_.delays.lut_ns = 100;
  EXPECT_EQ(hash(), before_);
  options_.effort = characterise::TimingEffort::area_only;
  const std::string area = hash();
  options_.seeds = 9;
  device_.available.luts = 7;
  device_.timing = devices::TimingTool::none;
  EXPECT_EQ(hash(), area);
  options_.effort = characterise::TimingEffort::timing;
  device_.timing = devices::TimingTool::yosys_sta;
  const std::string estimated = hash();
  options_.seeds = 1;
  EXPECT_EQ(hash(), estimated) << "an estimate has no seeds";
}

}  // namespace
}  // namespace mixcmp::test::store_test
