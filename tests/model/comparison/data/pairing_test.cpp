#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "model/base/number/exact.hpp"
#include "model/comparison/data/column_names.hpp"
#include "model/comparison/data/comparisons.hpp"

namespace mixcmp::test::pairing_test {
namespace {

const FloatFormat binary32 = FloatFormat::parse("binary32").value();

/// A table with these columns. The number at row i, column k is 100 table + 10 i + k.
data::Table numbered(int table_number, int rows, std::vector<std::string> columns) {
  data::Table table{.format = binary32, .columns = std::move(columns)};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < static_cast<int>(table.columns.size()); ++column) {
      table.values.push_back(from_rational(binary32, 100 * table_number + 10 * row + column));
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

void greater_at_random(const data::Comparisons&, std::span<const data::Items> items,
                       std::span<std::uint8_t> greater) {
  static std::mt19937 random(1);
  for (std::size_t k = 0; k < items.size(); ++k) greater[k] = random() % 3 == 0;
}

TEST(ItemColumn, SubscriptsFollowTheItem) {
  const auto is = [](const char* input, const char* column, bool second) {
    const auto item = data::item_column(input);
    return item && item->name == column && item->second == second;
  };
  EXPECT_TRUE(is("cxi", "cx", false));
  EXPECT_TRUE(is("cj", "c", true));
  EXPECT_TRUE(is("ci_0", "c_0", false));
  EXPECT_TRUE(is("sj_12_3", "s_12_3", true));
  EXPECT_TRUE(is("c_i", "c_", false));
  for (const char* none : {"i", "j", "p", "p_0", "i_0", "_0", "ci_", "ci_0x", "ci0", "ci_x"}) {
    EXPECT_FALSE(data::item_column(none)) << none;
  }
}

TEST(Comparisons, SubscriptedInputsAreColumnsOfItems) {
  const auto data = data::Comparisons::all_pairs(numbered(0, 3, {"c_0", "c_1"}), {"ci_1", "cj_0"});
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  EXPECT_EQ(fetch(*data, 1), (std::vector<int>{1, 20}));  // items 0 and 2
}

TEST(Comparisons, CrossIsEveryRowOfBothTables) {
  const auto data = data::Comparisons::cross(numbered(0, 3, {"a", "b"}), numbered(1, 2, {"a"}),
                                             {"aj", "bi", "ai"});
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  ASSERT_EQ(data->size(), 6U);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 2; ++j) {
      const auto index = static_cast<std::uint64_t>(2 * i + j);
      EXPECT_EQ(fetch(*data, index), (std::vector<int>{100 + 10 * j, 10 * i + 1, 10 * i}));
      EXPECT_EQ(describe(*data, index), "items " + std::to_string(i) + " and " + std::to_string(j));
    }
  }
}

TEST(Comparisons, CandidatesOfArgMinMeetInOrder) {
  // For even rows candidate 2 beats the candidates before it. For odd rows candidate 1 beats
  // candidate 0.
  const data::CompareItems compare = [](const data::Comparisons&,
                                        std::span<const data::Items> items,
                                        std::span<std::uint8_t> greater) {
    for (std::size_t k = 0; k < items.size(); ++k) {
      greater[k] = items[k].second == (items[k].row % 2 == 0 ? 2 : 1);
    }
  };
  const auto data = data::Comparisons::arg_min(numbered(0, 5, {"p"}), numbered(1, 4, {"c"}),
                                               {"p", "ci", "cj"}, compare);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  ASSERT_EQ(data->size(), 15U);
  EXPECT_EQ(data->arg_min(0), 2U);
  EXPECT_EQ(data->arg_min(3), 1U);
  EXPECT_EQ(data->items(2), (data::Items{.row = 0, .first = 2, .second = 3}));
  EXPECT_EQ(data->items(3), (data::Items{.row = 1, .first = 0, .second = 1}));
  EXPECT_EQ(data->items(10), (data::Items{.row = 3, .first = 1, .second = 2}));
  EXPECT_EQ(fetch(*data, 10), (std::vector<int>{30, 110, 120}));
  EXPECT_EQ(describe(*data, 10), "row 3, candidates 1 and 2");
}

/// Checks the promise of run_length comparison by comparison, and that runs are as long as they can
/// be.
void expect_runs(const data::Comparisons& data) {
  const auto follows = [&](std::uint64_t index) {
    data::Items next = data.items(index);
    (data.moving_item() == data::Item::row ? next.row : next.second) += 1;
    data::Items is = data.items(index + 1);
    if (data.pairing() == data::Pairing::rows) is.first = is.second = next.first;
    return is == next;
  };
  for (std::uint64_t index = 0; index < data.size(); ++index) {
    const std::uint64_t length = data.run_length(index);
    ASSERT_GE(length, 1U);
    ASSERT_LE(index + length, data.size());
    for (std::uint64_t k = 0; k + 1 < length; ++k) ASSERT_TRUE(follows(index + k)) << index;
    if (index + length < data.size()) {
      ASSERT_FALSE(follows(index + length - 1)) << index;
    }
  }
}

TEST(Comparisons, RunsDifferInTheMovingItemAlone) {
  expect_runs(data::Comparisons::rows(numbered(0, 5, {"a"}), {"a"}).value());
  expect_runs(data::Comparisons::all_pairs(numbered(0, 6, {"a"}), {"ai", "aj"}).value());
  expect_runs(
      data::Comparisons::cross(numbered(0, 4, {"a"}), numbered(1, 3, {"a"}), {"ai", "aj"}).value());
  expect_runs(data::Comparisons::arg_min(numbered(0, 40, {"p"}), numbered(1, 9, {"c"}),
                                         {"p", "ci", "cj"}, greater_at_random)
                  .value());
}

TEST(Comparisons, TwoTablesMistakesAreTold) {
  const auto message = [](const Result<data::Comparisons>& data) {
    EXPECT_FALSE(data.ok());
    return data.ok() ? "" : data.error().to_string();
  };
  EXPECT_EQ(
      message(data::Comparisons::cross(numbered(0, 3, {"a"}), numbered(1, 2, {"alpha"}),
                                       {"ai", "alhpaj"})),
      "data.with: no column alhpa for the input alhpaj: received no such column; accepted alpha "
      "(the nearest)");
  EXPECT_EQ(message(data::Comparisons::cross(numbered(0, 3, {"a"}), numbered(1, 2, {"a"}), {"ai"})),
            "data.pairs: no input is a column of the second table: received ai; accepted inputs of "
            "item i and inputs of item j");
  EXPECT_EQ(message(data::Comparisons::arg_min(numbered(0, 3, {"p"}), numbered(1, 1, {"c"}),
                                               {"p", "ci", "cj"}, greater_at_random)),
            "data.with: too few rows: received 1 rows; accepted 2..2147483648 rows");
  EXPECT_EQ(message(data::Comparisons::arg_min(numbered(0, 0, {"p"}), numbered(1, 2, {"c"}),
                                               {"p", "ci", "cj"}, greater_at_random)),
            "data.file: nothing to compare: received 0 rows; accepted 1..2147483648 rows");
}

const std::vector<data::ColumnNames> point_names = {{.name = "p",
                                                     .columns = {"x", "y"},
                                                     .is_list = true,
                                                     .field = "data.columns.p",
                                                     .place = {.file = {}, .line = 7}},
                                                    {.name = "r",
                                                     .columns = {"radius"},
                                                     .field = "data.columns.r",
                                                     .place = {.file = "plan.toml", .line = 8}}};

TEST(ColumnNames, ListsNameSubscriptedColumns) {
  const std::vector<std::string> wanted = {"p_1", "r", "p_0", "q"};
  const auto columns = data::file_columns(point_names, wanted);
  ASSERT_TRUE(columns.ok()) << columns.error().to_string();
  const std::vector<data::ColumnKey> expected = {"y", "radius", "x", "q"};
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    EXPECT_EQ((*columns)[k].name, wanted[k]);
    EXPECT_EQ((*columns)[k].column, expected[k]);
  }
  EXPECT_EQ((*columns)[0].field, "data.columns.p");
  EXPECT_EQ((*columns)[3].field, "");
}

TEST(ColumnNames, MistakesAreTold) {
  const std::vector<std::string> beyond = {"p_2", "r"}, unused = {"p_0", "rr"};
  EXPECT_EQ(data::file_columns(point_names, beyond).error().to_string(),
            ":7: data.columns.p: no column for p_2: received a list of 2; accepted 3 columns or "
            "more");
  EXPECT_EQ(
      data::file_columns(point_names, unused).error().to_string(),
      "plan.toml:8: data.columns.r: no input needs such a column: received r; accepted rr (the "
      "nearest), p_0");
  const std::vector<data::ColumnNames> twice = {
      {.name = "p", .columns = {"x", "y"}, .is_list = true, .field = "data.columns.p", .place = {}},
      {.name = "p_1", .columns = {"y"}, .field = "data.columns.p_1", .place = {}}};
  const std::vector<std::string> both = {"p_0", "p_1"};
  EXPECT_EQ(data::file_columns(twice, both).error().to_string(),
            "data.columns.p_1: a second column for p_1: received data.columns.p_1 beside "
            "data.columns.p; accepted one of them");
  const std::vector<data::WantedColumn> misspelt = {{.name = "r", .column = "radiu"}};
  EXPECT_EQ(data::select_columns(numbered(0, 1, {"x", "radius"}), misspelt).error().to_string(),
            "radiu: no such column: received nothing; accepted radius (the nearest), x");
}

TEST(ColumnNames, SelectedColumnsAreInTheWantedOrder) {
  const std::vector<data::WantedColumn> wanted = {{.name = "p_0", .column = "c"},
                                                  {.name = "p_1", .column = std::uint64_t{0}}};
  const auto table = data::select_columns(numbered(0, 2, {"a", "b", "c"}), wanted);
  ASSERT_TRUE(table.ok());
  EXPECT_EQ(table->columns, (std::vector<std::string>{"p_0", "p_1"}));
  EXPECT_EQ(table->origins[0].number, 2U);
  EXPECT_EQ(table->origins[1].name, "a");
  EXPECT_EQ(table->at(1, 0), from_rational(binary32, 12));
  EXPECT_EQ(table->at(1, 1), from_rational(binary32, 10));
}

}  // namespace
}  // namespace mixcmp::test::pairing_test
