#include "model/comparison/data/uniform_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "model/base/number/exact.hpp"
#include "model/comparison/data/row_random.hpp"

namespace mixcmp::test::uniform_table_test {
namespace {

using data::Table;
using data::uniform_table;
using data::UniformNumbers;
using data::UniformTable;

const FloatFormat binary64 = FloatFormat::parse("binary64").value();

Table one_column(const UniformNumbers& numbers, std::uint64_t count,
                 FloatFormat format = binary64) {
  return uniform_table({.columns = {{"x", numbers}}, .count = count}, format).value();
}

std::map<mpq_class, int> counts_of(const Table& table) {
  std::map<mpq_class, int> counts;
  for (const Bits bits : table.values) ++counts[to_rational(table.format, bits)];
  return counts;
}

TEST(UniformTable, DrawsEveryMultipleOfTheGridAsOften) {
  const auto counts = counts_of(one_column({mpq_class(-3, 2), 2, mpq_class(1, 2)}, 8000));
  ASSERT_EQ(counts.size(), 8u);
  EXPECT_EQ(counts.begin()->first, mpq_class(-3, 2));
  EXPECT_EQ(counts.rbegin()->first, 2);
  for (const auto& [number, count] : counts) EXPECT_NEAR(count, 1000, 150) << number;
}

TEST(UniformTable, FillsTheRange) {
  const Table table = one_column({-1, 3}, 20'000);
  double sum = 0, squares = 0;
  for (const Bits bits : table.values) {
    const double x = to_rational(binary64, bits).get_d();
    EXPECT_GE(x, -1);
    EXPECT_LE(x, 3);
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / 20'000, 1, 0.05);
  EXPECT_NEAR(squares / 20'000, 1 + 16.0 / 12, 0.1);
}

TEST(UniformTable, IsTheDocumentedFunctionOfSeedNameAndRow) {
  const UniformTable uniform{.columns = {{"x", {2, 10}}}, .count = 5, .seed = 77, .which = 1};
  const Table table = uniform_table(uniform, binary64).value();
  data::RowRandom random(77, data::stream_of("x") + 1, 3);
  const double share = static_cast<double>(random.bits() >> 11) * 0x1p-53;
  EXPECT_EQ(to_rational(binary64, table.at(3, 0)).get_d(), 2 + 8 * share);
  EXPECT_EQ(data::stream_of(""), 0x811c9dc5u);
  EXPECT_EQ(data::stream_of("a"), 0xe40c292cu) << "as in the authors' test vectors of FNV-1a";
}

TEST(UniformTable, NumbersDependNeitherOnOtherColumnsNorOnTheirRows) {
  const UniformNumbers numbers{0, 1};
  const Table few = one_column(numbers, 10);
  const Table two =
      uniform_table({.columns = {{"y", numbers}, {"x", numbers}}, .count = 30}, binary64).value();
  for (std::size_t row = 0; row < 10; ++row) {
    EXPECT_EQ(few.at(row, 0), two.at(row, 1));
    EXPECT_NE(two.at(row, 0), two.at(row, 1));
  }
}

/// With three digits, 1.9 rounds to 2, which is beyond the range.
TEST(UniformTable, RoundsToNoNumberBeyondTheRange) {
  const auto counts =
      counts_of(one_column({1, mpq_class(19, 10)}, 2000, FloatFormat::make(3, 4).value()));
  EXPECT_EQ(counts.size(), 4u);
  EXPECT_EQ(counts.rbegin()->first, mpq_class(7, 4));
}

TEST(UniformTable, DrawsNoNanOfAFormatWithoutInfinities) {
  const auto table =
      uniform_table({.columns = {{"cx", {440, 600}, FloatFormat::e4m3()}}, .count = 100},
                    FloatFormat::make(24, 8).value());
  ASSERT_TRUE(table.ok()) << table.error().to_string();
  for (const Bits number : table->values) EXPECT_EQ(to_rational(table->format, number), 448);
}

TEST(UniformTable, AFormatWithoutSuchNumbersIsRefused) {
  const FloatFormat coarse = FloatFormat::make(3, 4).value();
  const auto error_of = [&](const UniformNumbers& numbers) {
    const auto table = uniform_table({.columns = {{"cx", numbers}}, .count = 2}, coarse);
    return table.ok() ? std::string("no error") : table.error().to_string();
  };
  const std::string none = "data.items: s3e4 has no number to draw for the column cx";
  EXPECT_TRUE(error_of({mpq_class(11, 10), mpq_class(12, 10)}).starts_with(none));
  EXPECT_NE(error_of({3, 5, mpq_class(8)}).find("[3, 5], multiples of 8"), std::string::npos);
  EXPECT_TRUE(error_of({100'000, 200'000}).starts_with(none));
  EXPECT_EQ(error_of({2, 2}), "no error");
}

}  // namespace
}  // namespace mixcmp::test::uniform_table_test
