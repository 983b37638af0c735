#include "model/lane/fixed/square_tables.hpp"

#include <gtest/gtest.h>

#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

namespace mixcmp::test::square_tables_test {
namespace {

using fixed::FixedLane;
using fixed::SquareTable;

constexpr int block_bits = 18'432;

FixedLane lane_of(const char* f, const char* g, int bits, const Range& range) {
  const Graph graph = graph_of(f, g);
  const std::vector<std::optional<Range>> ranges(graph.inputs().size(), range);
  return fixed::fixed_lane(graph, format_of(53, 8), {.format = {bits}, .ranges = ranges}).value();
}

std::vector<int> address_bits(const std::vector<SquareTable>& tables) {
  std::vector<int> bits;
  for (const SquareTable& table : tables) bits.push_back(table.address_bits);
  return bits;
}

/// Differences of q13 have magnitudes of 13 bits, and the sum of the radii has 14.
TEST(SquareTables, TheWidestTwoShareTheFirstMemory) {
  const FixedLane lane =
      lane_of("(cxi - cxj)^2 + (cyi - cyj)^2 + (czi - czj)^2", "(ri + rj)^2", 13, {0, 100});
  const auto tables = fixed::square_tables(lane, 2, block_bits);
  ASSERT_EQ(address_bits(tables), (std::vector{14, 13}));
  EXPECT_EQ(tables[0].squares.size(), 2u);
  EXPECT_EQ(tables[1].squares.size(), 2u);
  EXPECT_LT(tables[0].squares[0], tables[1].squares[0]);
  EXPECT_EQ(fixed::magnitude_bits(lane, tables[0].squares[1]), 14) << "the sum of the radii";
  EXPECT_EQ(tables[0].word_bits, 26) << "28 bits, but two";
  EXPECT_EQ(tables[1].word_bits, 24);
}

TEST(SquareTables, WithOnePortThereIsOneForEachSquare) {
  const FixedLane lane = lane_of("(a - b)^2 + a^2", "(b + 1)^2", 9, {-6, 6});
  const auto tables = fixed::square_tables(lane, 1, block_bits);
  ASSERT_EQ(tables.size(), 3u);
  for (const SquareTable& table : tables) {
    ASSERT_EQ(table.squares.size(), 1u);
    EXPECT_EQ(lane.nodes[table.squares[0]].operation, Operation::square);
    EXPECT_EQ(fixed::table_of(tables, table.squares[0]), &table);
  }
  EXPECT_EQ(fixed::square_tables(lane, 2, block_bits).size(), 2u);
  EXPECT_EQ(fixed::square_tables(lane, 2, block_bits)[0].squares.size() +
                fixed::square_tables(lane, 2, block_bits)[1].squares.size(),
            3u);
}

/// 1024 words of 17 bits fill one block, as 512 of 16 bits do. 2048 words fill more.
TEST(SquareTables, NegativeOperandsHaveWordsWhereTheyFit) {
  const auto tables_of = [](int bits) {
    return fixed::square_tables(lane_of("(a - b)^2", "(a + b)^2", bits, {0, 100}), 1, block_bits);
  };
  const auto short_tables = tables_of(9), long_tables = tables_of(10);
  EXPECT_EQ(address_bits(short_tables), (std::vector{10, 10}));
  EXPECT_TRUE(short_tables[0].has_signed_address) << "the difference";
  EXPECT_FALSE(short_tables[1].has_signed_address) << "the sum has no sign";
  EXPECT_EQ(address_bits(long_tables), (std::vector{10, 11}));
  EXPECT_FALSE(long_tables[0].has_signed_address);
  EXPECT_EQ(fixed::blocks_of(short_tables[0], block_bits), 1);
}

TEST(SquareTables, ProductsHaveNone) {
  const FixedLane lane = lane_of("a * b", "c", 9, {0, 6});
  EXPECT_TRUE(fixed::square_tables(lane, 2, block_bits).empty());
  EXPECT_EQ(fixed::table_of({}, lane.parts[0].difference), nullptr);
}

}  // namespace
}  // namespace mixcmp::test::square_tables_test
