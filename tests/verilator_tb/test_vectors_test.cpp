#include "verilator_tb/test_vectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <set>
#include <vector>

#include "generator/hardware/emit/system.hpp"
#include "model/base/number/exact.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/mixed_spheres.hpp"
#include "verilator_tb/engine_verify.hpp"
#include "verilator_tb/judgement.hpp"

/// The vectors of the test bench that travels: which comparisons they are, and with which words.
namespace mixcmp::test::test_vectors_test {
namespace {

constexpr std::size_t row_count = 4000;
constexpr std::size_t touching_row = 2777;
constexpr std::size_t colliding_row = 1111;

/// Two spheres of radius 1 in each row, at these distances.
data::Comparisons spheres_at(const std::vector<float>& distances) {
  data::Table table{.format = format("s24e8"), .columns = sphere_graph().inputs()};
  for (const float distance : distances) {
    for (const std::string& input : table.columns) {
      const float value = input.starts_with("r") ? 1 : input == "cxj" ? distance : 0;
      table.values.push_back(Bits{std::bit_cast<std::uint32_t>(value)});
    }
  }
  return data::Comparisons::rows(table, sphere_graph().inputs()).value();
}

/// Spheres that are 50 apart or more; those of one row touch exactly, those of another collide.
data::Comparisons spheres_that_meet_twice() {
  std::vector<float> distances(row_count);
  for (std::size_t row = 0; row < row_count; ++row) distances[row] = 50 + static_cast<float>(row);
  distances[touching_row] = 2;
  distances[colliding_row] = 0.5;
  return spheres_at(distances);
}

/// The operands of 32 bits in a vector.
std::vector<Bits> operands_of(const emit::TestVector& vector) {
  std::vector<Bits> operands;
  for (std::size_t at = 0; at + 4 <= vector.tdata.size(); at += 4) {
    std::uint32_t operand = 0;
    for (std::size_t byte = 4; byte-- > 0;) operand = operand << 8 | vector.tdata[at + byte];
    operands.emplace_back(operand);
  }
  return operands;
}

class TestVectors : public testing::Test {
protected:
  std::vector<emit::TestVector> pick(std::uint64_t count) const {
    return verilator_tb::test_vectors(design_, comparisons_, signature_, count);
  }

  design::Design design_ = mixed_sphere_design();
  data::Comparisons comparisons_ = spheres_that_meet_twice();
  emit::Signature signature_ = emit::generate_system(design_, "").value().signature;
};

TEST_F(TestVectors, OneComparisonIn4000ThatIsRecomputedIsFound) {
  const std::vector<emit::TestVector> vectors = pick(64);
  EXPECT_EQ(vectors.size(), 64u);
  int recomputed = 0;
  for (std::size_t k = 0; k < 64 - 64 / 8; ++k) recomputed += vectors[k].expected.is_recomputed();
  EXPECT_EQ(recomputed, 1);
}

TEST_F(TestVectors, OneComparisonIn4000WithAnotherVerdictIsFound) {
  const std::vector<emit::TestVector> vectors = pick(64);
  const ResultWord less = ResultWord::decided(Verdict::less);
  EXPECT_TRUE(std::any_of(vectors.begin(), vectors.end(),
                          [&](const auto& vector) { return vector.expected == less; }));
}

TEST_F(TestVectors, AreAllComparisonsAndTheEdgeCasesWhereThereAreNoMore) {
  const std::size_t edge_cases = pick(2 * row_count).size() - row_count;
  EXPECT_EQ(edge_cases, 9u * (8 + 1)) << "nine values for all inputs, and for each of eight";
  EXPECT_EQ(pick(3 * row_count).size(), row_count + edge_cases);
}

TEST_F(TestVectors, EndWithSpecialValuesInEveryInput) {
  const FloatFormat binary32 = format("s24e8");
  std::set<std::size_t> nan_inputs;
  std::set<Verdict> verdicts;
  for (const emit::TestVector& vector : pick(2 * row_count)) {
    if (vector.expected.is_recomputed()) verdicts.insert(vector.expected.verdict());
    const std::vector<Bits> operands = operands_of(vector);
    const auto is_nan = [&](Bits operand) { return binary32.is_nan(operand); };
    if (std::count_if(operands.begin(), operands.end(), is_nan) != 1) continue;
    nan_inputs.insert(static_cast<std::size_t>(
        std::find_if(operands.begin(), operands.end(), is_nan) - operands.begin()));
    EXPECT_EQ(vector.expected.verdict(), Verdict::unordered);
  }
  EXPECT_EQ(nan_inputs.size(), 8u);
  EXPECT_EQ(verdicts.size(), 4u) << "the data alone have no NaN, and one tie";
}

TEST_F(TestVectors, HaveTheWordOfTheLaneThatTheyGoTo) {
  comparisons_ =
      spheres_at(std::vector<float>(50, 2.06F));  // decided with nine digits, not with six
  const std::vector<emit::TestVector> vectors = pick(50);
  int recomputed = 0;
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    recomputed += vectors[k].expected.is_recomputed();
    const std::size_t group =
        design_.group_of_lane(static_cast<int>(k % static_cast<std::size_t>(signature_.lanes)));
    EXPECT_EQ(vectors[k].expected,
              verilator_tb::expected_word(design_, group, operands_of(vectors[k])))
        << k;
  }
  EXPECT_GT(recomputed, 0);
  EXPECT_LT(recomputed, 50 - 9) << "apart from nine edge cases";
}

TEST_F(TestVectors, FillTheLastWordOfAGroupWithItsFirstComparison) {
  design_.lanes.erase(design_.lanes.begin() + 1, design_.lanes.end());
  design_.lanes[0].count = signature_.lanes = 8;
  const std::vector<emit::TestVector> single = pick(62);
  signature_.lanes_per_group = 4;
  const std::vector<emit::TestVector> vectors = pick(62);
  ASSERT_EQ(vectors.size(), 64u);
  EXPECT_EQ(vectors[60].tdata, single[60].tdata);
  EXPECT_EQ(vectors[61].tdata, single[61].tdata);
  for (const std::size_t k : {62, 63}) {
    EXPECT_EQ(vectors[k].tdata, vectors[60].tdata);
    EXPECT_EQ(vectors[k].expected, vectors[60].expected);
  }
}

/// Two comparisons that share no operand, on data where the first is always less and the second
/// always greater.
struct TwoParts {
  explicit TwoParts(Combination combination)
      : graph(graph_of({{"a", "b"}, {"c", "d"}}, combination)),
        design{.name = "two",
               .inputs = graph.inputs(),
               .lanes = {{.lane = error::certified_lane(
                                      lane_graph(graph, format("s24e8"), {format("s8e8")},
                                                 LaneInputs::rounded),
                                      {.ranges = std::vector<std::optional<Range>>(4)})
                                      .value(),
                          .inputs = LaneInputs::rounded}},
               .reference = reference_graph(graph, {format("s24e8")}),
               .references = {{}},
               .system = {}} {}

  data::Comparisons data() const {
    data::Table table{.format = format("s24e8"), .columns = design.inputs};
    for (int row = 0; row < 4000; ++row) {
      for (const float value : {1.0f, 9.0f + static_cast<float>(row), 7.0f, 2.0f}) {
        table.values.push_back(Bits{std::bit_cast<std::uint32_t>(value)});
      }
    }
    return data::Comparisons::rows(table, design.inputs).value();
  }

  Graph graph;
  design::Design design;
};

TEST(TestVectorsOfParts, HaveATieInOnePartBesideEachOtherVerdict) {
  for (const Combination combination : {Combination::all, Combination::any}) {
    const TwoParts two(combination);
    const auto signature = emit::generate_system(two.design, "").value().signature;
    const Graph parts[] = {two.graph.part(0), two.graph.part(1)};
    std::set<std::pair<Verdict, Verdict>> seen;
    for (const auto& vector : verilator_tb::test_vectors(two.design, two.data(), signature, 400)) {
      const auto of = [&](int part) {
        return golden::true_verdict(parts[part], format("s24e8"), operands_of(vector)).value();
      };
      seen.insert({of(0), of(1)});
    }
    EXPECT_TRUE(seen.contains({Verdict::less, Verdict::equal})) << to_string(combination);
    EXPECT_TRUE(seen.contains({Verdict::equal, Verdict::greater})) << to_string(combination);
  }
}

/// The first bytes of vectors of operands that arrive in a format of eight bits.
std::set<int> words_of_vectors_in(const char* name) {
  const OperandFormat arriving = OperandFormat::parse(name).value();
  Graph graph = graph_of("a * b", "c");
  for (int input = 0; input < 3; ++input) graph.arrives_in(input, arriving);
  TypedGraph lane = lane_graph(graph, format("s24e8"), {format("s8e8")}, LaneInputs::exact);
  const design::Design design{
      .name = "narrow",
      .inputs = graph.inputs(),
      .lanes = {{.lane = relative_lane(std::move(lane), std::vector<bool>(3, false)).value()}},
      .reference = reference_graph(graph, {format("s24e8")}),
      .references = {{}},
      .system = {},
      .operand_formats = std::vector(3, arriving)};
  const auto signature = emit::generate_system(design, "").value().signature;
  const data::Table table{.format = format("s24e8"),
                          .columns = design.inputs,
                          .values = std::vector<Bits>(3 * 500, from_rational(format("s24e8"), 1))};
  const auto data = data::Comparisons::rows(table, design.inputs).value();
  std::set<int> words;
  for (const auto& vector : verilator_tb::test_vectors(design, data, signature, 400)) {
    EXPECT_EQ(vector.tdata.size(), 3u);
    words.insert(vector.tdata[0]);
  }
  return words;
}

/// Special values are those of the format in which an operand arrives.
TEST(TestVectorsOfNarrowOperands, HoldTheEndsOfTheirFormat) {
  EXPECT_EQ(words_of_vectors_in("E5M2"),
            (std::set<int>{0x00, 0x80, 0x01, 0x3c, 0x7b, 0xfb, 0x7c, 0xfc, 0x7e}));
  EXPECT_EQ(words_of_vectors_in("E4M3"), (std::set<int>{0x00, 0x80, 0x01, 0x38, 0x7e, 0xfe, 0x7f}));
}

/// A table of "cross" has only the columns that something reads of its items.
TEST(RowBytes, AColumnThatATableLacksIsZero) {
  const data::Table table{.format = FloatFormat::make(3, 4).value(),
                          .columns = {"y"},
                          .values = {0x7f, 0x15},
                          .labels = {}};
  const std::vector<OperandFormat> formats(3, OperandFormat(table.format));
  const std::vector<std::uint8_t> bytes =
      verilator_tb::row_bytes(table, {"x", "y", "z"}, formats, 3, 0, 2);
  ASSERT_EQ(bytes.size(), 6u);
  // Seven bits a column: y in [13:7]; padding in [23:21], zeros and then ones.
  const auto row = [&](std::size_t k) {
    return bytes[3 * k] | bytes[3 * k + 1] << 8 | bytes[3 * k + 2] << 16;
  };
  EXPECT_EQ(row(0), 0x7f << 7);
  EXPECT_EQ(row(1), 0x15 << 7 | 0b111 << 21);
}

}  // namespace
}  // namespace mixcmp::test::test_vectors_test
