#include "model/lane/fixed/bilinear_form.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/comparison/data/pairing.hpp"
#include "tests/model/lane/fixed/lanes.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

namespace mixcmp::test::bilinear_form_test {
namespace {

using fixed::FixedLane;
using fixed::ItemInput;
using fixed::ItemRole;

/// A comparison of two items, whose inputs' names end in i or j, and of a row.
struct Comparison {
  Graph graph;
  std::vector<ItemInput> inputs;
  std::vector<std::string> columns, row_columns;
};

Comparison comparison_of(const std::string& f, const std::string& g) {
  Comparison made{.graph = graph_of(f, g), .inputs = {}, .columns = {}, .row_columns = {}};
  for (const std::string& input : made.graph.inputs()) {
    const auto item = data::item_column(input);
    std::vector<std::string>& names = item ? made.columns : made.row_columns;
    const std::string& name = item ? item->name : input;
    const auto known = std::find(names.begin(), names.end(), name);
    const ItemRole role = !item ? ItemRole::row : item->second ? ItemRole::second : ItemRole::first;
    made.inputs.push_back({static_cast<int>(known - names.begin()), role});
    if (known == names.end()) names.push_back(name);
  }
  return made;
}

FixedLane lane_of(const Comparison& comparison, const Range& range,
                  BoundKind bound = BoundKind::constant) {
  return test::lane_of(comparison.graph, 9, range, bound);
}

std::optional<FixedLane> bilinear(const Comparison& comparison, const Range& range = {-6, 6}) {
  return fixed::in_bilinear_form(lane_of(comparison, range), comparison.inputs);
}

/// The products and squares that a pair needs, behind the words.
int products_of(const Comparison& comparison, const FixedLane& lane) {
  const fixed::ItemSplit split =
      fixed::split_by_item({&lane}, comparison.inputs, comparison.columns, comparison.row_columns);
  const auto& nodes = split.lanes.front().nodes;
  return static_cast<int>(std::count_if(nodes.begin(), nodes.end(), [](const auto& node) {
    return node.operation == Operation::multiply || node.operation == Operation::square;
  }));
}

constexpr const char* nearer[] = {"(p - ai)^2 + (q - bi)^2 + (r - ci)^2",
                                  "(p - aj)^2 + (q - bj)^2 + (r - cj)^2"};

TEST(BilinearForm, DistancesToTwoCandidatesHaveHalfOfTheProducts) {
  const Comparison comparison = comparison_of(nearer[0], nearer[1]);
  EXPECT_EQ(products_of(comparison, lane_of(comparison, {0, 6})), 6);
  const FixedLane lane = bilinear(comparison, {0, 6}).value();
  EXPECT_EQ(products_of(comparison, lane), 3);
  const fixed::ItemSplit split =
      fixed::split_by_item({&lane}, comparison.inputs, comparison.columns, comparison.row_columns);
  EXPECT_EQ(split.items.lane.outputs.size(), 4u) << "three coordinates and one norm for both roles";
  EXPECT_EQ(split.rows.lane.outputs.size(), 3u) << "no norm of the row: it cancels";
}

/// Every difference is the same integer, whatever the operands, those outside of ranges included.
TEST(BilinearForm, DifferencesStay) {
  const std::vector<std::pair<std::string, std::string>> comparisons = {
      {nearer[0], nearer[1]},
      {"(ai - aj)^2 + (bi - bj)^2", "(ri + rj)^2"},
      {"(ai - aj + 3)^2", "(bi + bj) * (bi - aj)"},
      {"(2 * ai - aj) * 3", "bi * bj + 1"},
      {"-(ai * aj)", "(aj - ai) * (bj - bi)"},
      {"(p - ai) * (q - bi)", "(p - aj) * (q - bj)"},
      {"(ai + aj)^2", "4 * ai * aj"},
      {"p * ai + q * bi", "p * aj + q * bj"}};
  std::mt19937_64 random(7);
  for (const auto& [f, g] : comparisons) {
    for (const Range& range : {Range{-6, 6}, Range{0, 5}}) {
      const Comparison comparison = comparison_of(f, g);
      const FixedLane whole = lane_of(comparison, range);
      const auto lane = fixed::in_bilinear_form(whole, comparison.inputs);
      ASSERT_TRUE(lane.has_value()) << f;
      const NodeId before = whole.parts[0].difference, after = lane->parts[0].difference;
      EXPECT_LE(lane->nodes[after].format.width, whole.nodes[before].format.width) << f;
      for (int k = 0; k < 300; ++k) {
        std::vector<std::string> texts;
        for (std::size_t input = 0; input < comparison.inputs.size(); ++input) {
          texts.push_back(
              fmt::format("{}", std::ldexp(random() % 4096, -9) * (random() % 2 == 0 ? 1 : -1)));
        }
        std::vector<const char*> operands;
        for (const std::string& text : texts) operands.push_back(text.c_str());
        EXPECT_EQ(integers_of(*lane, operands)[after], integers_of(whole, operands)[before])
            << f << " against " << g << " at " << fmt::format("{}", fmt::join(texts, ", "));
      }
    }
  }
}

/// The squares of a wide row cancel, so the sum is narrower than the difference of distances.
TEST(BilinearForm, ASumIsNoWiderThanItsOperandsNeed) {
  const Comparison comparison = comparison_of("(p - ai)^2", "(p - aj)^2");
  std::vector<std::optional<Range>> ranges;
  for (const std::string& input : comparison.graph.inputs()) {
    ranges.push_back(input == "p" ? Range{0, 1000} : Range{0, 63});
  }
  const FixedLane whole =
      fixed::fixed_lane(comparison.graph, format_of(53, 8),
                        {.format = {12}, .bound = BoundKind::constant, .ranges = ranges})
          .value();
  const FixedLane lane = fixed::in_bilinear_form(whole, comparison.inputs).value();
  const fixed::FixedNode& sum = lane.nodes[lane.parts[0].difference];
  int widest = 0;
  for (const NodeId id : sum.operands) {
    const FixedFormat& format = lane.nodes[id].format;
    widest = std::max(widest, format.width + format.unit_exponent - sum.format.unit_exponent);
  }
  EXPECT_LE(sum.format.width, widest + 1);
}

TEST(BilinearForm, TermsShareTheFactorOfEitherItem) {
  for (const auto& [f, g] :
       {std::pair("(ai - aj)^2", "(ai - bj)^2"), std::pair("(ai - aj)^2", "(bi - aj)^2")}) {
    const Comparison comparison = comparison_of(f, g);
    EXPECT_EQ(products_of(comparison, bilinear(comparison).value()), 1) << f << " and " << g;
  }
}

TEST(BilinearForm, OtherDifferencesStayAsTheyAre) {
  EXPECT_FALSE(bilinear(comparison_of("ai + aj", "bi")).has_value()) << "no product";
  EXPECT_FALSE(bilinear(comparison_of("abs(ai - aj)", "bi")).has_value());
  EXPECT_FALSE(bilinear(comparison_of("wi * (p - ai)^2", "wj * (p - aj)^2")).has_value())
      << "the square loses bits";
  EXPECT_FALSE(bilinear(comparison_of("max(ai, aj)^2", "bi")).has_value());
  EXPECT_FALSE(bilinear(comparison_of("p * ai * aj", "bi")).has_value()) << "of three";
  EXPECT_FALSE(bilinear(comparison_of("sqrt((ai - aj)^2 + 1)", "bi")).has_value());
}

/// A comparison is left undecided if an operand does not fit or a number is beyond its limit, also
/// where that number is on both sides.
TEST(BilinearForm, NothingThatIsCheckedCancels) {
  EXPECT_FALSE(
      bilinear(comparison_of("within(bi + 1, 0, 4) + ai * aj", "within(bi + 1, 0, 4) + bj"))
          .has_value());
  EXPECT_FALSE(bilinear(comparison_of("within(p + 1, 0, 2) + (p - ai)^2",
                                      "within(p + 1, 0, 2) + (p - aj)^2"))
                   .has_value());
  EXPECT_FALSE(bilinear(comparison_of("ai * aj + bi", "bi + cj")).has_value());
  EXPECT_TRUE(bilinear(comparison_of("ai * aj + bi", "bj + cj")).has_value());
}

}  // namespace
}  // namespace mixcmp::test::bilinear_form_test
