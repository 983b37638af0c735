#include "model/lane/fixed/square_tables.hpp"

#include <gtest/gtest.h>

#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

namespace mixcmp::test::square_tables_test {
namespace {

using fixed::FixedLane;
using fixed::SquareTable;

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
  const auto tables = fixed::square_tables(lane, 2);
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
  const auto tables = fixed::square_tables(lane, 1);
  ASSERT_EQ(tables.size(), 3u);
  for (const SquareTable& table : tables) {
    ASSERT_EQ(table.squares.size(), 1u);
    EXPECT_EQ(lane.nodes[table.squares[0]].operation, Operation::square);
    EXPECT_EQ(fixed::table_of(tables, table.squares[0]), &table);
  }
  EXPECT_EQ(fixed::square_tables(lane, 2).size(), 2u);
  EXPECT_EQ(fixed::square_tables(lane, 2)[0].squares.size() +
                fixed::square_tables(lane, 2)[1].squares.size(),
            3u);
}

TEST(SquareTables, ProductsHaveNone) {
  const FixedLane lane = lane_of("a * b", "c", 9, {0, 6});
  EXPECT_TRUE(fixed::square_tables(lane, 2).empty());
  EXPECT_EQ(fixed::table_of({}, lane.parts[0].difference), nullptr);
}

}  // namespace
}  // namespace mixcmp::test::square_tables_test
