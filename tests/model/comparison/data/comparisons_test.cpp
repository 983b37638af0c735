#include "model/comparison/data/comparisons.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "model/base/number/exact.hpp"
#include "model/judge/workload/load_comparisons.hpp"

namespace mixcmp::test::comparisons_test {
namespace {

const FloatFormat binary32 = FloatFormat::parse("binary32").value();

/// A table with columns a, b, ... The number at row i, column k is 10 i + k.
data::Table counting_table(int rows, std::vector<std::string> columns) {
  data::Table table{.format = binary32, .columns = std::move(columns)};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < static_cast<int>(table.columns.size()); ++column) {
      table.values.push_back(from_rational(binary32, 10 * row + column));
    }
  }
  return table;
}

std::vector<int> fetch(const data::Comparisons& comparisons, std::uint64_t index) {
  std::vector<Bits> operands(comparisons.input_count());
  comparisons.fetch(index, operands);
  std::vector<int> numbers;
  for (const Bits bits : operands) {
    numbers.push_back(static_cast<int>(to_rational(binary32, bits).get_d()));
  }
  return numbers;
}

TEST(PairItems, EnumerateEveryPairOfSmallSetsInOrder) {
  for (std::uint64_t count = 2; count <= 40; ++count) {
    std::uint64_t index = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
      for (std::uint64_t j = i + 1; j < count; ++j, ++index) {
        ASSERT_EQ(data::pair_items(index, count), std::pair(i, j)) << index << " of " << count;
        ASSERT_EQ(data::pair_index(i, j, count), index) << i << ", " << j << " of " << count;
      }
    }
    ASSERT_EQ(index, data::pair_count(count));
  }
}

TEST(PairItems, AreExactAtTheEdgesOfRowsOfTheLargestSets) {
  for (const std::uint64_t count :
       {data::max_paired_items, data::max_paired_items - 1, std::uint64_t{94906267}}) {
    __extension__ using Wide = unsigned __int128;
    for (const std::uint64_t i : {std::uint64_t{0}, std::uint64_t{1}, count / 3, count / 2,
                                  count - 67108864 / 2, count - 3, count - 2}) {
      const Wide first = Wide{i} * (2 * Wide{count} - i - 1) / 2;
      const auto start = static_cast<std::uint64_t>(first);
      EXPECT_EQ(data::pair_items(start, count), std::pair(i, i + 1)) << i << " of " << count;
      if (i > 0) {
        EXPECT_EQ(data::pair_items(start - 1, count), std::pair(i - 1, count - 1)) << i;
      }
    }
    EXPECT_EQ(data::pair_items(data::pair_count(count) - 1, count),
              std::pair(count - 2, count - 1));
  }
}

TEST(Comparisons, RowsServeInputsByName) {
  const auto comparisons = data::Comparisons::rows(counting_table(3, {"a", "b", "c"}), {"c", "a"});
  ASSERT_TRUE(comparisons.ok());
  EXPECT_EQ(comparisons->size(), 3U);
  EXPECT_EQ(fetch(*comparisons, 2), (std::vector<int>{22, 20}));
  EXPECT_EQ(comparisons->items(2).row, 2U);
}

TEST(Comparisons, PairsServeInputsOfItemsIAndJ) {
  const auto comparisons =
      data::Comparisons::all_pairs(counting_table(4, {"a", "b"}), {"bj", "ai", "aj", "bi"});
  ASSERT_TRUE(comparisons.ok());
  EXPECT_EQ(comparisons->size(), 6U);
  EXPECT_EQ(fetch(*comparisons, 4), (std::vector<int>{31, 10, 30, 11}));  // items 1 and 3
}

TEST(Comparisons, InputsWithoutColumnAreNamed) {
  const auto rows = data::Comparisons::rows(counting_table(3, {"alpha", "b"}), {"b", "alpah"});
  ASSERT_FALSE(rows.ok());
  EXPECT_EQ(
      rows.error().to_string(),
      "data.file: no column alpah for the input alpah: received no such column; accepted alpha "
      "(the nearest), b");
  const auto pairs = data::Comparisons::all_pairs(counting_table(3, {"a"}), {"ai", "qj"});
  ASSERT_FALSE(pairs.ok());
  EXPECT_EQ(pairs.error().message, "no column q for the input qj");
  const auto unpaired = data::Comparisons::all_pairs(counting_table(3, {"a"}), {"ai", "radius"});
  ASSERT_FALSE(unpaired.ok());
  EXPECT_EQ(unpaired.error().received, "radius");
  const auto bare = data::Comparisons::all_pairs(counting_table(3, {"a"}), {"i"});
  EXPECT_FALSE(bare.ok());
}

TEST(Comparisons, TooFewItemsAreRefused) {
  EXPECT_FALSE(data::Comparisons::all_pairs(counting_table(1, {"a"}), {"ai"}).ok());
  EXPECT_FALSE(data::Comparisons::rows(counting_table(0, {"a"}), {"a"}).ok());
}

TEST(LoadComparisons, TheProteinHas207046Pairs) {
  const std::filesystem::path examples = MIXCMP_SOURCE_DIR "/examples";
  const Result<scene::Scene> scene = scene::load_scene(examples / "protein_clash/scene.toml", {});
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  const Result<data::Comparisons> comparisons = workload::load_comparisons(*scene);
  ASSERT_TRUE(comparisons.ok()) << comparisons.error().to_string();
  EXPECT_EQ(comparisons->table().rows(), 644U);
  EXPECT_EQ(comparisons->size(), 207'046U);
}

TEST(LoadComparisons, TheBenchmarkHas33550336Pairs) {
  const std::filesystem::path examples = MIXCMP_SOURCE_DIR "/examples";
  const std::vector<std::string> overrides = {"data.radius_max=5"};
  const Result<scene::Scene> scene =
      scene::load_scene(examples / "sphere_collision/scene.toml", overrides);
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  const Result<data::Comparisons> comparisons = workload::load_comparisons(*scene);
  ASSERT_TRUE(comparisons.ok()) << comparisons.error().to_string();
  EXPECT_EQ(comparisons->size(), 33'550'336U);
}

TEST(LoadComparisons, MistakesStandInTheScenesDataSection) {
  const std::filesystem::path path = MIXCMP_SOURCE_DIR "/examples/protein_clash/scene.toml";
  Result<scene::Scene> scene = scene::load_scene(path, {});
  ASSERT_TRUE(scene.ok());
  scene::Scene changed = std::move(scene).value();
  const Place file = changed.data.value().places.at("file");
  changed.data->pairing = data::Pairing::rows;
  const Result<data::Comparisons> rows = workload::load_comparisons(changed);
  ASSERT_FALSE(rows.ok());
  EXPECT_EQ(rows.error().file, path.string());
  EXPECT_EQ(rows.error().line, file.line);
  EXPECT_EQ(rows.error().message, "no column cxi, which the input cxi needs");
  changed.data->file = "/nowhere/atoms.pdb";
  EXPECT_EQ(workload::load_comparisons(changed).error().message,
            "cannot read the file /nowhere/atoms.pdb");
  changed.data.reset();
  EXPECT_EQ(workload::load_comparisons(changed).error().message, "the scene has no data");
}

}  // namespace
}  // namespace mixcmp::test::comparisons_test
