#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <set>

#include "model/base/number/verdict.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/judge/workload/load_comparisons.hpp"
#include "model/scene/scene.hpp"
#include "tests/support/simulated_system.hpp"

/// The main job, as a user runs it: the clashes of 1A8O through the program itself.
namespace mixcmp::test::protein_test {
namespace {

namespace fs = std::filesystem;

using Pairs = std::set<std::pair<std::uint64_t, std::uint64_t>>;

/// The colliding pairs by exact arithmetic, without hardware, lanes or reference.
Pairs truly_colliding(const fs::path& scene_file) {
  const auto scene = scene::load_scene(scene_file, {});
  EXPECT_TRUE(scene.ok()) << scene.error().to_string();
  const auto data = workload::load_comparisons(*scene);
  EXPECT_TRUE(data.ok()) << data.error().to_string();
  EXPECT_EQ(data->size(), 207'046u);
  Pairs pairs;
  std::vector<Bits> operands(data->input_count());
  for (std::uint64_t index = 0; index < data->size(); ++index) {
    data->fetch(index, operands);
    const auto verdict = golden::true_verdict(scene->graph, scene->reference.format, operands);
    if (verdict != Verdict::less) continue;
    const data::Items items = data->items(index);
    pairs.emplace(items.first, items.second);
  }
  return pairs;
}

Pairs pairs_in(const fs::path& csv) {
  std::ifstream stream(csv);
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line, "index,i,j,label_i,label_j,verdict,recomputed");
  Pairs pairs;
  while (std::getline(stream, line)) {
    unsigned long long index = 0, i = 0, j = 0;
    EXPECT_EQ(std::sscanf(line.c_str(), "%llu,%llu,%llu,", &index, &i, &j), 3) << line;
    EXPECT_NE(line.find(",less,"), std::string::npos) << line;
    EXPECT_TRUE(pairs.emplace(i, j).second) << "twice: " << line;
  }
  return pairs;
}

/// `work`: a folder of the test's own.
void expect_true_pairs(const fs::path& scene, const fs::path& work) {
  fs::create_directories(work);
  const fs::path csv = work / "pairs.csv";
  const std::string command = std::string(MIXCMP_PROGRAM) + " verify " + scene.string() +
                              " --work " + (work / "simulation").string() + " --csv " +
                              csv.string() + " --csv-verdict less > " +
                              (work / "report.txt").string();
  ASSERT_EQ(std::system(command.c_str()), 0) << "see " << work / "report.txt";
  const Pairs colliding = pairs_in(csv);
  EXPECT_GT(colliding.size(), 644u);
  EXPECT_EQ(colliding, truly_colliding(scene));
}

TEST(Protein, CollidingPairsOfTheSimulatedSystemAreTheTrueOnes) {
  expect_true_pairs(fs::path(MIXCMP_SOURCE_DIR) / "examples/protein_clash/scene.toml",
                    test_work_dir("protein"));
}

/// The same pairs from the atoms only, loaded once.
TEST(Protein, ReportsOfThePairwiseEngineAreTheTrueOnes) {
  expect_true_pairs(fs::path(MIXCMP_SOURCE_DIR) / "examples/pairwise_engine/protein.toml",
                    test_work_dir("protein_pairwise"));
}

}  // namespace
}  // namespace mixcmp::test::protein_test
