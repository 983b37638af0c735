#include "verilator_tb/build.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/verilator_tb/fake_system.hpp"

namespace mixcmp::test::build_test {
namespace {

namespace fs = std::filesystem;

TEST(Build, IsFoundAgainByItsContent) {
  const auto system = verilator_tb::load_system(write_fake_system({.name = "good"}));
  ASSERT_TRUE(system.ok()) << system.error().to_string();
  const verilator_tb::BuildOptions options{.work_dir = fake_work_dir() / "builds"};
  const auto first = verilator_tb::build_simulator(*system, options);
  ASSERT_TRUE(first.ok()) << first.error().to_string();
  const auto second = verilator_tb::build_simulator(*system, options);
  ASSERT_TRUE(second.ok());
  EXPECT_EQ(second->path, first->path);
  EXPECT_EQ(second->build_seconds, 0);
}

/// The remains of a killed compiler or linker are newer than their sources.
TEST(Build, StartsAnewWhereItWasInterrupted) {
  const auto system = verilator_tb::load_system(write_fake_system({.name = "good"}));
  ASSERT_TRUE(system.ok()) << system.error().to_string();
  const verilator_tb::BuildOptions options{.work_dir = fake_work_dir() / "interrupted"};
  const auto first = verilator_tb::build_simulator(*system, options);
  ASSERT_TRUE(first.ok()) << first.error().to_string();
  const fs::path objects = first->path.parent_path();
  ASSERT_TRUE(fs::remove(objects.parent_path() / "complete"));
  fs::resize_file(first->path, 0);
  std::ofstream(objects / "half.o") << "half";
  const auto second = verilator_tb::build_simulator(*system, options);
  ASSERT_TRUE(second.ok()) << second.error().to_string();
  EXPECT_GT(fs::file_size(second->path), 0u);
  EXPECT_FALSE(fs::exists(objects / "half.o")) << "nothing of it is used again";
}

TEST(Build, OfOtherSourcesIsAnother) {
  const auto folder = write_fake_system({.name = "broken"});
  const auto good = verilator_tb::load_system(write_fake_system({.name = "good"}));
  const verilator_tb::BuildOptions options{.work_dir = fake_work_dir() / "builds"};
  std::ofstream(folder / "fake_fifo.v", std::ios::app) << "module unfinished;\n";
  const auto broken = verilator_tb::load_system(folder);
  ASSERT_TRUE(broken.ok());
  ASSERT_TRUE(verilator_tb::build_simulator(*good, options).ok());
  const auto built = verilator_tb::build_simulator(*broken, options);
  ASSERT_FALSE(built.ok());
  EXPECT_TRUE(fs::exists(built.error().file)) << "the log";
  EXPECT_NE(built.error().message.find("syntax error"), std::string::npos)
      << built.error().to_string();
}

TEST(Build, NamesAMissingSource) {
  const auto folder = write_fake_system({.name = "incomplete"});
  fs::remove(folder / "fake_fifo.v");
  const auto system = verilator_tb::load_system(folder);
  ASSERT_TRUE(system.ok());
  const auto built =
      verilator_tb::build_simulator(*system, {.work_dir = fake_work_dir() / "builds"});
  ASSERT_FALSE(built.ok());
  EXPECT_EQ(fs::path(built.error().file).filename(), "fake_fifo.v");
}

TEST(Build, NamesAFolderWithoutASystem) {
  const auto system = verilator_tb::load_system(fake_work_dir() / "nothing_here");
  ASSERT_FALSE(system.ok());
  EXPECT_NE(system.error().message.find("no generated system"), std::string::npos);
}

}  // namespace
}  // namespace mixcmp::test::build_test
