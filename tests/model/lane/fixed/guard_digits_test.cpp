#include <gtest/gtest.h>

#include <algorithm>

#include "model/scene/lane_bound.hpp"
#include "tests/model/lane/fixed/lanes.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// Tests lanes whose operands have guard digits.
namespace mixcmp::test::guard_digits_test {
namespace {

using fixed::FixedLane;
using fixed::FixedNode;
using fixed::NormThresholds;

using Values = std::vector<std::optional<mpz_class>>;

FixedLane guarded(const Graph& graph, FixedPoint format, const Range& range,
                  std::optional<BoundKind> bound = {}) {
  return fixed::fixed_lane(graph, format_of(24, 8),
                           {.format = format,
                            .bound = bound,
                            .ranges = {graph.inputs().size(), std::optional(range)}})
      .value();
}

TEST(GuardDigits, OperandsHaveThemAndWhatIsMultipliedHasNot) {
  const FixedLane lane =
      guarded(graph_of("(a - b)^2", "c^2"), {.bits = 9, .guard_digits = 3}, {0, 100});
  EXPECT_EQ(formats_of(lane),
            (std::vector<std::string>{"input ufix12_En5", "input ufix12_En5", "subtract sfix13_En5",
                                      "input ufix12_En5", "convert sfix10_En5", "convert ufix9_En5",
                                      "square ufix19_En10", "square ufix18_En10",
                                      "subtract sfix20_En10"}));
}

/// A difference is off by at most one unit. In the units behind the cut it is off by less than one
/// unit, even though the cut drops its last bit. So the thresholds are those of a lane without
/// guard digits.
TEST(GuardDigits, BoundsAreThoseOfTheUnitBehindTheCut) {
  const Graph graph = graph_of(spheres, "(ri + rj)^2");
  const FixedLane lane = guarded(graph, {.bits = 13, .guard_digits = 4}, {0, 100});
  const auto& norm = std::get<NormThresholds>(lane.parts.front().criterion);
  EXPECT_EQ(norm.shift_above, 3);
  EXPECT_EQ(norm.shift_below, 2);
  EXPECT_EQ(norm.offset_above, 14);
  EXPECT_EQ(lane.nodes[norm.radius].format.name(), "ufix13_En10");
  EXPECT_EQ(lane.parts.front().degree, 2);
  EXPECT_EQ(to_string(scene::bound_of(lane)), "fixed_norm_g4");
}

std::vector<std::optional<mpz_class>> cut_by(const FixedLane& lane,
                                             const std::vector<const char*>& operands) {
  const auto values = integers_of(lane, operands);
  std::vector<std::optional<mpz_class>> cut;
  for (std::size_t id = 0; id < values.size(); ++id) {
    if (fixed::is_common_cut(lane.nodes[id])) cut.push_back(values[id]);
  }
  return cut;
}

/// Operands below 8 have 4 + 3 bits, in units of 1/16.
TEST(GuardDigits, ACutDropsNoMoreThanTheLargestNeeds) {
  const FixedLane lane = guarded(graph_of("(a - b)^2", "(c - b)^2"), {.bits = 4, .guard_digits = 3},
                                 {0, mpq_class(15, 2)});
  EXPECT_EQ(cut_by(lane, {"1.9375", "1", "0.5"}), (Values{15, -8})) << "15/16 and -8/16";
  EXPECT_EQ(cut_by(lane, {"1", "2", "0.5"}), (Values{-8, -12})) << "-24 needs one bit";
  EXPECT_EQ(cut_by(lane, {"7", "0.1875", "0"}), (Values{mpz_class(109 / 8), -1}))
      << "109 needs three bits, -3/8 is rounded down";
  EXPECT_EQ(cut_by(lane, {"8", "1", "1"}), (Values{{}, {}})) << "out of range";
}

TEST(GuardDigits, AffinePartsAreDecidedWithAllDigits) {
  const Graph graph = graph_of({{"a - b", "0.3"}, {"a * b", "c^2"}}, Combination::all);
  const FixedLane lane = guarded(graph, {.bits = 5, .guard_digits = 6}, {0, 1});
  const FixedNode& affine = lane.nodes[lane.parts[0].difference];
  EXPECT_EQ(affine.operation, Operation::subtract);
  EXPECT_LT(affine.format.unit_exponent, -11) << "0.3 has eleven digits, from 2^-2 on";
  EXPECT_EQ(lane.parts[0].degree, 0);
  EXPECT_EQ(lane.parts[1].degree, 2);
}

/// Finer units of a radius would only take digits from the coordinates.
TEST(GuardDigits, NormsHaveOneUnit) {
  const Graph graph = graph_of("(a - b)^2", "c^2");
  const fixed::FixedOptions options{.format = {.bits = 6, .guard_digits = 4},
                                    .ranges = {Range{0, 100}, Range{0, 100}, Range{0, 3}}};
  const FixedLane lane = fixed::fixed_lane(graph, format_of(24, 8), options).value();
  for (const FixedNode& node : lane.nodes) {
    if (fixed::is_common_cut(node)) {
      EXPECT_EQ(node.format.unit_exponent, -3);
    }
  }
}

/// Operands go up to 100. The factors only go up to 1 and have few bits, so none of them has to be
/// cut.
TEST(GuardDigits, NothingIsCutThatIsShortAlready) {
  const FixedLane lane = guarded(graph_of("within(a, 0, 1)^2", "within(b, 0, 1)^2"),
                                 {.bits = 9, .guard_digits = 3}, {0, 100});
  EXPECT_TRUE(std::none_of(lane.nodes.begin(), lane.nodes.end(), fixed::is_common_cut));
  EXPECT_TRUE(std::any_of(lane.nodes.begin(), lane.nodes.end(), fixed::is_limit));
}

TEST(GuardDigits, MistakesSayWhatTheyNeed) {
  const auto error_of = [](const char* f, const char* g) {
    const Graph graph = graph_of(f, g);
    return fixed::fixed_lane(graph, format_of(24, 8),
                             {.format = {.bits = 9, .guard_digits = 3},
                              .ranges = {graph.inputs().size(), Range{0, 1}}})
        .error();
  };
  EXPECT_NE(error_of("a - b", "c").message.find("guard digits serve what is multiplied"),
            std::string::npos);
  const Error mixed = error_of("(a - b)^2", "c");
  EXPECT_EQ(mixed.message,
            "guard digits need f and g that are homogeneous of one degree in what is linear in the "
            "operands; f has the degree 2 and g 1: (a - b)^2");
  EXPECT_EQ(mixed.received, "q9g3");
  EXPECT_NE(error_of("within((a - b)^2, 0, 1)", "c^2").message.find("a limit does not grow"),
            std::string::npos);
}

}  // namespace
}  // namespace mixcmp::test::guard_digits_test
