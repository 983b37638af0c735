#include "model/judge/proof/fixed_proof.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "model/judge/proof/gappa.hpp"
#include "model/judge/proof/provers.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// Tests Gappa's verdicts on lanes in fixed point, and on lanes whose thresholds are too close.
namespace mixcmp::test::fixed_proof_test {
namespace {

using fixed::FixedLane;
using proof::LaneProof;
using proof::Outcome;

struct Case {
  const char* name;
  std::vector<std::pair<std::string, std::string>> parts;
  int bits;
  Range range;
  const char* verdict;
  std::optional<BoundKind> bound = {};
  bool is_block = false;
  int guard_digits = 0;
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.name;
}

FixedLane lane_of(const Case& c) {
  const Graph graph = graph_of(c.parts, Combination::all);
  return fixed::fixed_lane(graph, format_of(53, 8),
                           {.format = {c.bits, c.is_block, c.guard_digits},
                            .bound = c.bound,
                            .ranges = {graph.inputs().size(), std::optional(c.range)}})
      .value();
}

LaneProof proof_of(const FixedLane& lane) {
  proof::QuickProver prover(60);
  return proof::prove_fixed(lane, std::ref(prover));
}

proof::ScriptResult prove_anything(const std::string&) {
  return {Outcome::proven, "", ""};
}

bool is_refused(const FixedLane& lane) {
  return proof::prove_fixed(lane, prove_anything).refused();
}

class FixedProof : public testing::TestWithParam<Case> {};

TEST_P(FixedProof, IsMachineCheckedButForWhatItSays) {
  if (!proof::gappa_version().ok()) GTEST_SKIP() << "gappa is not installed";
  EXPECT_EQ(proof_of(lane_of(GetParam())).verdict(), GetParam().verdict);
}

const std::vector<std::pair<std::string, std::string>> spheres = {
    {"(a - b)^2 + (c - d)^2 + (e - f)^2", "(r + s)^2"}};
const std::vector<std::pair<std::string, std::string>> sum = {{"a * b - 0.3 * c", "-c"}};

INSTANTIATE_TEST_SUITE_P(
    Lanes, FixedProof,
    testing::Values(
        Case{"norm",
             spheres,
             13,
             {0, 100},
             "machine-checked but for theorems 1 (operands) and 4, by hand"},
        Case{"norm_of_a_radius_of_either_sign",
             {{"a^2", "abs(1.3 - b)^2"}},
             9,
             {0, 3},
             "machine-checked but for theorems 1 (operands), 2 (choices), 2 (dropped bits) and 4, "
             "by hand"},
        Case{"norm_of_a_small_radius",
             {{"(a - b)^2 + c^2", "(d / 16)^2"}},
             9,
             {0, 3},
             "machine-checked but for theorems 1 (operands), 2 (dropped bits), 8 and 4, by hand"},
        Case{"constant",
             spheres,
             13,
             {0, 100},
             "machine-checked but for theorems 1 (operands) and 3, by hand",
             BoundKind::constant},
        Case{"constant_that_is_no_dyadic_number",
             sum,
             12,
             {-5, 5},
             "machine-checked but for theorems 1 (operands) and 3, by hand"},
        Case{"dropped_bits",
             {{"a * b * c * d", "min(a, b)"}},
             6,
             {-5, 5},
             "machine-checked but for theorems 1 (operands), 2 (choices), 2 (dropped bits) and 3, "
             "by hand"},
        Case{"two_norms",
             {{"(a - b)^2 + (c - d)^2", "(a - e)^2 + (c - f)^2"}},
             11,
             {0, 64},
             "machine-checked but for theorems 1 (operands) and 4, by hand"},
        Case{"a_tiny_step_beyond_the_constants",
             {{"a - b^4 * (1/1024)^4", "c"}},
             8,
             {0, 1},
             "machine-checked but for theorems 1 (operands), 2 (dropped bits) and 3, by hand"},
        Case{"far_apart",
             {{"a + b * (1/1024)^16 * (1/1024)^16 * (1/1024)^16", "c - (1/1024)^16 * d^4"}},
             8,
             {0, 1},
             "machine-checked but for theorems 1 (operands), 2 (dropped bits) and 3, by hand"},
        Case{"roots",
             {{"sqrt((a - b)^2 + (c - d)^2)", "sqrt(abs(e)) + f"}},
             9,
             {-5, 5},
             "machine-checked but for theorems 1 (operands), 2 (choices), 5 and 3, by hand"},
        Case{"limits",
             {{"within(a - b, -2, 2)^2 * within(c, 1, 2)", "d"}},
             9,
             {-5, 5},
             "machine-checked but for theorems 1 (operands), 2 (dropped bits), 2 (limits) and 3, "
             "by hand"},
        Case{"a_radius_far_off",
             {{"a^2", "(b + 12.31)^2"}},
             10,
             {0, 1},
             "machine-checked but for theorems 1 (operands) and 4, by hand"},
        Case{"a_radius_farther_off_than_the_norm",
             {{"a^2", "(a - 15.6875)^2"}},
             7,
             {0, 1},
             "machine-checked but for theorems 1 (operands), 2 (choices) and 4, by hand"},
        Case{
            "huge_beside_tiny",
            {{"a^2 + (b * 1024^16 * 1024^16 * 1024^16)^2 + (a + b * 1024^16 * 1024^16 * 1024^16)^2",
              "c"}},
            6,
            {0, 1},
            "machine-checked but for theorems 1 (operands), 2 (dropped bits) and 3, by hand"},
        Case{"block",
             {{"(a - b)^2 + (2 * c)^2", "(d + max(e, 0))^2"}},
             9,
             {0, 1},
             "machine-checked but for theorems 1 (operands), 2 (choices), 2 (dropped bits), 6 and "
             "4, by hand",
             {},
             true},
        Case{"running",
             {{"a * b - c * d", "e"}},
             9,
             {-2, 3},
             "machine-checked but for theorems 1 (operands) and 9, by hand",
             BoundKind::running},
        Case{"guard_digits",
             {{"(a - b + 0.3)^2 + 0.7 * a * b", "(d + max(e, 0))^2"}, {"a - c", "0.2"}},
             9,
             {0, 1},
             "machine-checked but for theorems 1 (operands), 2 (choices), 2 (dropped bits), 7 and "
             "3, by hand",
             {},
             false,
             4},
        Case{"parts",
             {{"a - b", "a - a"}, {"a^2 + b^2", "c^2"}},
             17,
             {0, 1},
             "machine-checked but for theorems 1 (operands), 3 and 4, by hand"}),
    [](const auto& tested) { return std::string(tested.param.name); });

class TooClose : public testing::TestWithParam<int> {};

/// Moves each number of a criterion one step closer than the bound that it must exceed permits.
TEST_P(TooClose, IsRefused) {
  if (!proof::gappa_version().ok()) GTEST_SKIP() << "gappa is not installed";
  const auto bound = GetParam() < 3 ? BoundKind::norm : BoundKind::constant;
  FixedLane lane = lane_of({"", spheres, 13, {0, 100}, "", bound});
  auto& criterion = lane.parts.front().criterion;
  ASSERT_FALSE(proof_of(lane).refused());
  if (auto* norm = std::get_if<fixed::NormThresholds>(&criterion)) {
    if (GetParam() == 0) --norm->shift_above;
    if (GetParam() == 1) --norm->shift_below;
    if (GetParam() == 2) --norm->offset_above;
  } else {
    auto& constants = std::get<fixed::ConstantThresholds>(criterion);
    if (GetParam() == 3) --constants.greater_from;
    if (GetParam() == 4) ++constants.less_to;
  }
  EXPECT_TRUE(proof_of(lane).refused());
}

INSTANTIATE_TEST_SUITE_P(Thresholds, TooClose, testing::Range(0, 5));

/// A lane that claims to be in block floating point, but adds numbers of degrees 1 and 2.
TEST(FixedProofOfBlocks, RefusesWhatDoesNotGrowAlike) {
  FixedLane lane = lane_of({"", {{"a + a^2", "b"}}, 9, {0, 1}, ""});
  EXPECT_FALSE(is_refused(lane));
  lane.format.is_block = true;
  EXPECT_TRUE(is_refused(lane));
}

/// A lane that adds a square, which has degree 2, to a number that was cut before squaring and has
/// degree 1.
TEST(FixedProofOfCuts, RefusesWhatDoesNotGrowAlike) {
  const Case guarded{"", {{"(a - b)^2 + c^2", "d^2"}}, 9,     {0, 1},
                     "", BoundKind::constant,          false, 3};
  const FixedLane lane = lane_of(guarded);
  EXPECT_FALSE(is_refused(lane));
  for (std::size_t id = 0; id < lane.nodes.size(); ++id) {
    if (!fixed::is_common_cut(lane.nodes[id])) continue;
    FixedLane mixed = lane;
    const auto added =
        std::find_if(mixed.nodes.begin(), mixed.nodes.end(),
                     [](const fixed::FixedNode& node) { return node.operation == Operation::add; });
    ASSERT_NE(added, mixed.nodes.end());
    added->operands[1] = static_cast<NodeId>(id);
    EXPECT_TRUE(is_refused(mixed)) << id;
  }
}

/// Ranges have any ratio, so that units differ, low bits are dropped, and high bits are beyond
/// reach.
TEST(FixedProofOfNorms, FindsTheThresholdsOfTheorem4WhateverTheRanges) {
  for (const auto& [f, g] : {std::pair("(a - b)^2 + (c - b)^2", "d^2"),
                             {"d^2", "(a - b)^2 + c^2"},
                             {"(a - b)^2", "c^2 + d^2"},
                             {"(3 * a - b)^2 + (c - d)^2", "(d + 1)^2"}}) {
    const Graph graph = graph_of(f, g);
    for (int ratio = -30; ratio <= 30; ++ratio) {
      for (const FixedPoint format : {FixedPoint{2}, {5}, {13}, {3, false, 2}, {9, false, 5}}) {
        std::vector<std::optional<Range>> ranges(4, Range{0, mpq_class(9, 10)});
        for (const int wide : {0, 1}) {
          ranges[wide] = Range{-scaled(mpq_class(7, 10), ratio), scaled(mpq_class(1), ratio)};
        }
        const auto lane =
            fixed::fixed_lane(graph, format_of(53, 8), {.format = format, .ranges = ranges});
        if (!lane.ok()) continue;
        EXPECT_FALSE(is_refused(*lane)) << f << ", " << g << ", " << format.name() << ", " << ratio;
      }
    }
  }
}

/// Makes a reach one bit shorter, which is too short upward, downward or both ways. Then makes the
/// threshold so steep that numbers beyond the reach need not pass it.
TEST(FixedProofOfReaches, RefusesOneThatIsTooShort) {
  for (const auto& [f, g] : {std::pair("(a - b)^2 + c^2", "(d / 16)^2"),
                             {"(a + b)^2 + c^2", "(d / 16)^2"},
                             {"(-a - b)^2 + c^2", "(d / 16)^2"},
                             {"(a - b)^2 + e^2", "(c / 16)^2 + (d / 16)^2"}}) {
    const FixedLane lane = lane_of({"", {{f, g}}, 9, {0, 3}, ""});
    EXPECT_FALSE(is_refused(lane)) << f;
    const auto reach = std::find_if(lane.nodes.begin(), lane.nodes.end(), fixed::is_reach);
    ASSERT_NE(reach, lane.nodes.end()) << f;
    FixedLane shorter = lane;
    --shorter.nodes[reach - lane.nodes.begin()].format.width;
    EXPECT_TRUE(is_refused(shorter)) << f;
    FixedLane steeper = lane;
    std::get<fixed::NormThresholds>(steeper.parts[0].criterion).shift_above += 7;
    EXPECT_TRUE(is_refused(steeper)) << f;
  }
}

/// One element reads the number that another's reach has limited.
TEST(FixedProofOfReaches, RefusesOneThatIsNotSquaredInTheSum) {
  FixedLane lane = lane_of({"", {{"(a - b)^2 + (c - e)^2", "(d / 16)^2"}}, 9, {0, 3}, ""});
  EXPECT_FALSE(is_refused(lane));
  const auto first = std::find_if(lane.nodes.begin(), lane.nodes.end(), fixed::is_reach);
  const auto second = std::find_if(std::next(first), lane.nodes.end(), fixed::is_reach);
  ASSERT_NE(second, lane.nodes.end());
  ASSERT_EQ(first->format, second->format);
  second->operands[0] = static_cast<NodeId>(first - lane.nodes.begin());
  EXPECT_TRUE(is_refused(lane));
}

/// Turns the limit of a radius into a reach.
TEST(FixedProofOfReaches, RefusesOneOfTheRadius) {
  FixedLane lane = lane_of({"", {{"(a - b)^2", "within(c - d, -0.125, 0.117)^2"}}, 9, {0, 3}, ""});
  EXPECT_FALSE(is_refused(lane));
  const auto limit = std::find_if(lane.nodes.begin(), lane.nodes.end(), fixed::is_limit);
  ASSERT_NE(limit, lane.nodes.end());
  limit->conversion = fixed::Conversion::reach;
  EXPECT_TRUE(is_refused(lane));
}

/// Decides a part by constants beyond all differences.
TEST(FixedProofOfReaches, RefusesConstantsOfWhatIsWithinReach) {
  FixedLane lane = lane_of({"", {{"(a - b)^2 + c^2", "(d / 16)^2"}}, 9, {0, 3}, ""});
  const mpz_class far = lane.nodes[lane.parts[0].difference].format.largest();
  lane.parts[0].criterion = fixed::ConstantThresholds{.greater_from = far, .less_to = -far};
  EXPECT_TRUE(is_refused(lane));
}

const Case lanes_of_all_kinds[] = {
    {"", {{"(a - b)^2 + c^2", "(d / 16)^2"}}, 9, {0, 3}, ""},
    {"", {{"abs(a * b - 3 * c) + min(a, d)", "sqrt(a^2 + b^2)"}}, 7, {-2, 3}, ""},
    {"", {{"(a - b)^2 + c^2", "d^2"}}, 9, {0, 1}, "", BoundKind::norm, false, 3},
    {"", {{"(a - b)^2 + c^2", "a * d"}}, 9, {-1, 1}, "", BoundKind::constant, true, 3}};

/// Doubles the unit of each node whose operation sets the unit.
TEST(FixedProofOfUnits, RefusesWhatTheHardwareDoesNotCount) {
  for (const Case& each : lanes_of_all_kinds) {
    const FixedLane lane = lane_of(each);
    for (std::size_t id = 0; id < lane.nodes.size(); ++id) {
      const Operation operation = lane.nodes[id].operation;
      const bool has_own = operation == Operation::constant ||
                           operation == Operation::square_root ||
                           (operation == Operation::input && !each.is_block);
      if (has_own) continue;
      FixedLane coarser = lane;
      ++coarser.nodes[id].format.unit_exponent;
      EXPECT_TRUE(is_refused(coarser)) << each.parts[0].first << ", node " << id;
    }
  }
}

TEST(FixedProofOfConstants, RefusesEqualityWhereSomethingIsRounded) {
  FixedLane lane = lane_of({"", sum, 12, {0, 5}, ""});
  EXPECT_FALSE(is_refused(lane));
  std::get<fixed::ConstantThresholds>(lane.parts[0].criterion).decides_ties = true;
  EXPECT_TRUE(is_refused(lane));
}

TEST(FixedProofOfNorms, RefusesASumInThePlaceOfTheDifference) {
  FixedLane lane = lane_of({"", {{"(a - b)^2 + c^2", "d^2"}}, 9, {0, 3}, "", BoundKind::norm});
  lane.nodes[lane.parts[0].difference].operation = Operation::add;
  EXPECT_TRUE(is_refused(lane));
}

/// Encloses a limit's operand too narrowly, so that hardware would check one side too few.
TEST(FixedProofOfLimits, RefusesASideThatIsNotChecked) {
  FixedLane lane = lane_of({"", {{"within(a - b, -2, 2) * c", "d"}}, 9, {0, 3}, ""});
  EXPECT_FALSE(is_refused(lane));
  const auto limit = std::find_if(lane.nodes.begin(), lane.nodes.end(), fixed::is_limit);
  ASSERT_NE(limit, lane.nodes.end());
  lane.nodes[limit->operands[0]].value.high = limit->value.high;
  EXPECT_TRUE(is_refused(lane));
}

TEST(FixedProofOfNorms, RefusesARadiusThatIsNotTheOtherSides) {
  FixedLane lane = lane_of({"", {{"(a - b)^2 + c^2", "d^2"}}, 9, {0, 3}, ""});
  auto& norm = std::get<fixed::NormThresholds>(lane.parts[0].criterion);
  const auto c = std::find_if(lane.nodes.begin(), lane.nodes.end(),
                              [](const fixed::FixedNode& node) { return node.input == 2; });
  norm.radius = static_cast<NodeId>(c - lane.nodes.begin());
  EXPECT_TRUE(is_refused(lane));
}

/// Makes a format one bit narrower, and a common cut drop one bit less or more.
TEST(FixedProofOfWidths, RefusesResultsThatDoNotFit) {
  for (const Case& each : lanes_of_all_kinds) {
    const FixedLane lane = lane_of(each);
    EXPECT_FALSE(is_refused(lane)) << each.parts[0].first;
    for (std::size_t id = 0; id < lane.nodes.size(); ++id) {
      const Operation operation = lane.nodes[id].operation;
      if (operation == Operation::input || lane.nodes[id].format.width == 1) continue;
      FixedLane narrower = lane;
      --narrower.nodes[id].format.width;
      EXPECT_TRUE(is_refused(narrower)) << each.parts[0].first << ", node " << id;
      if (!fixed::is_common_cut(lane.nodes[id])) continue;
      for (const int more : {-1, 1}) {
        FixedLane other = lane;
        other.nodes[id].most_dropped += more;
        EXPECT_TRUE(is_refused(other)) << "node " << id << ", " << more;
      }
    }
  }
}

/// Lowers each threshold by one unit, and has a part watch one factor less.
TEST(FixedProofOfRunningBounds, RefusesThresholdsThatAreTooNear) {
  const FixedLane lane =
      lane_of({"", {{"a * b - c * d", "e"}}, 9, {-2, 3}, "", BoundKind::running});
  EXPECT_FALSE(is_refused(lane));
  const auto& running = std::get<fixed::RunningThresholds>(lane.parts[0].criterion);
  for (std::size_t step = 0; step < running.of_steps.size(); ++step) {
    FixedLane nearer = lane;
    --std::get<fixed::RunningThresholds>(nearer.parts[0].criterion).of_steps[step];
    EXPECT_TRUE(is_refused(nearer)) << step;
  }
  for (std::size_t k = 0; k < running.watched.size(); ++k) {
    FixedLane blind = lane;
    auto& watched = std::get<fixed::RunningThresholds>(blind.parts[0].criterion).watched;
    watched.erase(watched.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_TRUE(is_refused(blind)) << k;
  }
}

TEST(FixedProofOfOperands, DoesNotBelieveTheLane) {
  FixedLane lane = lane_of({"", sum, 12, {0, 5}, ""});
  const auto input =
      std::find_if(lane.nodes.begin(), lane.nodes.end(),
                   [](const fixed::FixedNode& node) { return node.operation == Operation::input; });
  input->error = {0, 0};
  bool read = false;
  const std::vector<proof::Finding> findings =
      proof::prove_fixed(lane, [&](const std::string& script) {
        read = read || script.find("e0 in [") != std::string::npos;
        EXPECT_EQ(script.find("e0 in [0, 0]"), std::string::npos) << script;
        return proof::ScriptResult{Outcome::proven, "", ""};
      }).findings;
  EXPECT_GT(findings.size(), 2U);
  EXPECT_TRUE(read);
}

FixedLane lane_of_integers(int bits) {
  const Graph graph = graph_of("(a - b) * c", "b^2");
  const std::vector<OperandFormat> formats(3, *OperandFormat::parse("int8"));
  return fixed::fixed_lane(graph, format_of(53, 8),
                           {.format = {bits},
                            .bound = {},
                            .ranges = std::vector<std::optional<Range>>(3),
                            .operand_formats = formats})
      .value();
}

TEST(FixedProofOfIntegers, IsMachineCheckedButForTheDecision) {
  if (!proof::gappa_version().ok()) GTEST_SKIP() << "gappa is not installed";
  EXPECT_EQ(proof_of(lane_of_integers(7)).verdict(),
            "machine-checked but for theorems 1 (operands) and 3, by hand");
  EXPECT_EQ(proof_of(lane_of_integers(4)).verdict(),
            "machine-checked but for theorems 1 (operands), 2 (dropped bits) and 3, by hand");
}

/// A lane may not count a dropped bit as if it were there, nor have a unit that hardware lacks.
TEST(FixedProofOfIntegers, RefusesLanesThatForgetDroppedBits) {
  EXPECT_FALSE(is_refused(lane_of_integers(7)));
  EXPECT_FALSE(is_refused(lane_of_integers(5)));
  FixedLane exact = lane_of_integers(5);
  exact.parts.front().criterion =
      fixed::ConstantThresholds{.greater_from = 1, .less_to = -1, .decides_ties = true};
  EXPECT_TRUE(is_refused(exact));
  FixedLane shifted = lane_of_integers(5);
  shifted.nodes.front().dropped_bits = 1;
  EXPECT_TRUE(is_refused(shifted));
}

}  // namespace
}  // namespace mixcmp::test::fixed_proof_test
