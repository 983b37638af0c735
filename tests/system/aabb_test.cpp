#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/support/simulated_system.hpp"

/// examples/aabb through the program itself, against whole numbers.
namespace mixcmp::test::aabb_test {
namespace {

namespace fs = std::filesystem;

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

const fs::path example = fs::path(MIXCMP_SOURCE_DIR) / "examples/aabb";

/// The low and the high ends of a box, in thousandths.
using Box = std::array<long, 6>;

std::vector<Box> boxes_in(const fs::path& csv) {
  std::ifstream stream(csv);
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line, "residue,lo_0,lo_1,lo_2,hi_0,hi_1,hi_2");
  std::vector<Box> boxes;
  while (std::getline(stream, line)) {
    std::istringstream fields(line);
    std::string field;
    std::getline(fields, field, ',');
    for (long& end : boxes.emplace_back()) {
      std::getline(fields, field, ',');
      end = std::lround(std::stod(field) * 1000);
    }
  }
  return boxes;
}

bool overlap(const Box& i, const Box& j) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::max(i[k], j[k]) > std::min(i[k + 3], j[k + 3])) return false;
  }
  return true;
}

Pairs overlapping(const std::vector<Box>& boxes) {
  Pairs pairs;
  for (std::size_t j = 0; j < boxes.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      if (overlap(boxes[i], boxes[j])) pairs.emplace(i, j);
    }
  }
  return pairs;
}

/// The pairs of boxes that no axis separates.
Pairs pairs_in(const fs::path& csv, std::size_t& comparisons) {
  std::ifstream stream(csv);
  std::string line;
  std::getline(stream, line);
  Pairs pairs;
  while (std::getline(stream, line)) {
    unsigned long long index = 0, i = 0, j = 0;
    EXPECT_EQ(std::sscanf(line.c_str(), "%llu,%llu,%llu,", &index, &i, &j), 3) << line;
    ++comparisons;
    if (line.find(",greater,") == std::string::npos) pairs.emplace(i, j);
  }
  return pairs;
}

TEST(Boxes, OverlapInHardwareWhereTheirNumbersDo) {
  const fs::path work = test_work_dir("aabb");
  fs::create_directories(work);
  const std::string command =
      std::string(MIXCMP_PROGRAM) + " verify " + (example / "scene.toml").string() +
      " --truth all --work " + (work / "simulation").string() + " --csv " +
      (work / "pairs.csv").string() + " > " + (work / "report.txt").string();
  ASSERT_EQ(std::system(command.c_str()), 0) << "see " << work / "report.txt";
  const std::vector<Box> boxes = boxes_in(example / "boxes.csv");
  ASSERT_EQ(boxes.size(), 158u);
  std::size_t comparisons = 0;
  const Pairs pairs = pairs_in(work / "pairs.csv", comparisons);
  EXPECT_EQ(comparisons, 158u * 157 / 2);
  EXPECT_GT(pairs.size(), 300u);
  EXPECT_EQ(pairs, overlapping(boxes));
}

TEST(Boxes, AreThoseOfTheProtein) {
  const std::string command = "awk -f " + (example / "boxes.awk").string() + " " +
                              (example / "../protein_clash/1A8O.pdb").string() + " | cmp - " +
                              (example / "boxes.csv").string();
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

}  // namespace
}  // namespace mixcmp::test::aabb_test
