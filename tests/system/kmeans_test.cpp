#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/scratch_directory.hpp"
#include "tests/support/simulated_system.hpp"

/// The assignment step of k-means through the program itself, held against a search in plain C++
/// that shares nothing with it.
namespace mixcmp::test::kmeans_test {
namespace {

namespace fs = std::filesystem;

using Point = std::array<double, 3>;

const fs::path examples = fs::path(MIXCMP_SOURCE_DIR) / "examples";

std::vector<Point> atoms_in(const fs::path& pdb) {
  std::ifstream stream(pdb);
  std::vector<Point> atoms;
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with("ATOM  ") && !line.starts_with("HETATM")) continue;
    atoms.push_back({std::stod(line.substr(30, 8)), std::stod(line.substr(38, 8)),
                     std::stod(line.substr(46, 8))});
  }
  return atoms;
}

std::vector<Point> centres_in(const fs::path& csv) {
  std::ifstream stream(csv);
  std::vector<Point> centres;
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    Point& centre = centres.emplace_back();
    EXPECT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf", &centre[0], &centre[1], &centre[2]), 3);
  }
  return centres;
}

double squared_distance(const Point& a, const Point& b) {
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return (x * x + y * y) + z * z;
}

std::uint64_t nearest(const Point& point, const std::vector<Point>& centres) {
  std::uint64_t best = 0;
  for (std::uint64_t k = 1; k < centres.size(); ++k) {
    if (squared_distance(point, centres[k]) < squared_distance(point, centres[best])) best = k;
  }
  return best;
}

/// Each row's candidate after all of its verdicts. Every comparison must be that of the best so
/// far.
std::vector<std::uint64_t> chosen_by_verdicts(const fs::path& csv, std::size_t candidates) {
  std::ifstream stream(csv);
  std::string line;
  std::getline(stream, line);
  EXPECT_TRUE(line.starts_with("index,row,i,j,")) << line;
  std::vector<std::uint64_t> best;
  while (std::getline(stream, line)) {
    unsigned long long index = 0, row = 0, i = 0, j = 0;
    EXPECT_EQ(std::sscanf(line.c_str(), "%llu,%llu,%llu,%llu", &index, &row, &i, &j), 4) << line;
    if (j == 1) best.push_back(0);
    EXPECT_EQ(row + 1, best.size()) << line;
    EXPECT_EQ(index, row * (candidates - 1) + j - 1) << line;
    EXPECT_EQ(i, best.back()) << line;
    if (line.find(",greater,") != std::string::npos) best.back() = j;
  }
  return best;
}

TEST(KMeans, EveryAtomGetsItsNearestResidue) {
  const fs::path work = test_work_dir("kmeans");
  fs::create_directories(work);
  const fs::path csv = work / "comparisons.csv";
  const std::string command = std::string(MIXCMP_PROGRAM) + " verify " +
                              (examples / "kmeans/residues.toml").string() + " --work " +
                              (work / "simulation").string() + " --csv " + csv.string() + " > " +
                              (work / "report.txt").string();
  ASSERT_EQ(std::system(command.c_str()), 0) << "see " << work / "report.txt";
  const std::vector<Point> atoms = atoms_in(examples / "protein_clash/1A8O.pdb");
  const std::vector<Point> centres = centres_in(examples / "kmeans/residues.csv");
  const std::vector<std::uint64_t> chosen = chosen_by_verdicts(csv, centres.size());
  ASSERT_EQ(chosen.size(), atoms.size());
  for (std::size_t row = 0; row < atoms.size(); ++row) {
    EXPECT_EQ(chosen[row], nearest(atoms[row], centres)) << "atom " << row;
  }
}

/// The points and centres of a scene whose reference takes each distance for 0.
struct TinyPoints {
  static constexpr const char* scene =
      "[comparison]\nname = \"tiny\"\nf = \"(p[0] - ci[0])^2 + (p[1] - ci[1])^2\"\n"
      "g = \"(p[0] - cj[0])^2 + (p[1] - cj[1])^2\"\n[reference]\nformat = \"s12e6\"\n"
      "[reduced]\nformat = \"block10\"\n[system]\nlanes = 3\nreferences = 1\n"
      "[engine]\nkind = \"arg_min\"\n"
      "[data]\nfile = \"points.csv\"\nwith = \"centres.csv\"\npairs = \"arg_min\"\n";

  std::vector<Point> points, centres = {{1, 6, 0}, {6, 6, 0}, {0, 1, 0}, {5, 0, 0}};

  TinyPoints() {
    for (int k = 0; k < 49; ++k) points.push_back({double(k % 7), double(k / 7), 0});
  }

  void write(const fs::path& folder) const {
    std::ofstream(folder / "scene.toml") << scene;
    write_table(folder / "points.csv", "p_0,p_1", points);
    write_table(folder / "centres.csv", "c_0,c_1", centres);
  }

  static void write_table(const fs::path& file, const char* columns,
                          const std::vector<Point>& rows) {
    std::ofstream stream(file);
    stream << columns << "\n";
    for (const Point& row : rows) stream << "0x" << row[0] << "p-25,0x" << row[1] << "p-25\n";
  }
};

/// The CSV has all comparisons of the engine's own contest, whatever the reference would choose.
TEST(KMeans, LanesFindTheNearestWhereTheReferenceUnderflows) {
  const ScratchDirectory scratch;
  const TinyPoints tiny;
  tiny.write(scratch.path());
  const fs::path csv = scratch.path() / "comparisons.csv";
  const fs::path report = scratch.path() / "report.txt";
  const std::string command =
      std::string(MIXCMP_PROGRAM) + " verify " + (scratch.path() / "scene.toml").string() +
      " --simulator icarus --work " + test_work_dir("kmeans_tiny").string() + " --csv " +
      csv.string() + " > " + report.string();
  const int status = std::system(command.c_str());
  std::ifstream stream(report);
  ASSERT_EQ(status, 0) << std::string{std::istreambuf_iterator<char>(stream), {}};
  const std::vector<std::uint64_t> chosen = chosen_by_verdicts(csv, tiny.centres.size());
  ASSERT_EQ(chosen.size(), tiny.points.size());
  for (std::size_t row = 0; row < chosen.size(); ++row) {
    EXPECT_EQ(chosen[row], nearest(tiny.points[row], tiny.centres)) << "point " << row;
  }
}

/// The chain of lanes: `verify` fails unless every flower leaves it with the model's centre.
class KMeansChain : public testing::TestWithParam<const char*> {};

TEST_P(KMeansChain, EveryFlowerLeavesItWithItsNearestCentre) {
  // The three share the builds; each has its report, for they run side by side.
  const fs::path work = test_work_dir("kmeans_chain");
  fs::create_directories(work);
  const ScratchDirectory scratch;
  const fs::path report = scratch.path() / "report.txt";
  const std::string command =
      std::string(MIXCMP_PROGRAM) + " verify " + (examples / "kmeans/iris_chain.toml").string() +
      " --work " + (work / "simulation").string() + " " + GetParam() + " > " + report.string();
  const int status = std::system(command.c_str());
  std::ifstream stream(report);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  ASSERT_EQ(status, 0) << text;
  EXPECT_NE(text.find("one of all 3 candidates"), std::string::npos) << text;
  EXPECT_NE(text.find("rows                   150"), std::string::npos) << text;
}

INSTANTIATE_TEST_SUITE_P(Traffic, KMeansChain,
                         testing::Values("", "--traffic stressed --resets 3",
                                         "--set data.with=" MIXCMP_SOURCE_DIR
                                         "/examples/kmeans/centres_1.csv"));

}  // namespace
}  // namespace mixcmp::test::kmeans_test
