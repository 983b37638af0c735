#include "model/judge/proof/constant_proof.hpp"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "generator/present/report/proof_report.hpp"
#include "model/base/number/exact.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/judge/proof/absolute_proof.hpp"
#include "model/judge/proof/hazard_proof.hpp"
#include "model/judge/proof/node_ranges.hpp"
#include "model/judge/proof/rule_proof.hpp"
#include "model/lane/error/hazards.hpp"
#include "tests/model/judge/proof/proof_support.hpp"
#include "tests/model/judge/proof/random_lanes.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/lane_inputs.hpp"

/// Tests claims about ranges that Gappa checks: constants that bound errors, and hardware that
/// lanes leave out.
namespace mixcmp::test::constant_proof_test {
namespace {

using error::Lane;
using error::RangeCheck;
using namespace proof;

using Ranges = std::vector<std::optional<Range>>;

struct Ranged {
  const char* f;
  const char* g;
  const char* format;
  Ranges ranges;  ///< one per input, in the order in which f and g name them
};

Result<Lane> lane_of(const Ranged& ranged, LaneInputs inputs, Rounding rounding,
                     BoundKind kind = BoundKind::constant) {
  const Arithmetic arithmetic = {format(ranged.format), rounding, Subnormals::gradual};
  const Graph graph = graph_of(ranged.f, ranged.g);
  return error::certified_lane(lane_graph(graph, format("s53e11"), arithmetic, inputs),
                               {.kind = kind, .ranges = ranged.ranges});
}

/// Comparisons whose bounds have every kind of term. In the first, a constant leaves a magnitude of
/// nearly twice its binade.
const std::vector<Ranged>& every_term() {
  static const Range wide = {1, mpq_class(15, 4)}, small = {1, mpq_class(7, 4)};
  static const std::vector<Ranged> terms = {
      {"sqrt(a * d)", "3.14159", "s23e10", {wide, wide}},
      {"(a * b - d) / e", "c", "s11e8", {small, small, Range{2, 4}, wide, Range{-4, 4}}},
      {"a / (b * d + e)", "c", "s17e8", {wide, Range{-2, -1}, small, Range{9, 10}, small}},
      {"max(a * b - d, min(a, b) * d)", "c * c", "s17e8", {wide, small, Range{-2, 3}, wide}},
      {"sqrt(a * b - d)", "abs(c)", "s17e8", {Range{4, 5}, Range{4, 5}, small, Range{-4, -1}}},
      {"(a * b - d)^2", "-(c * e)", "s6e8", {small, small, Range{4, 6}, wide, wide}},
      {"a - b", "0.1", "s8e8", {wide, wide}}};
  return terms;
}

class ConstantProof : public WithGappa {
protected:
  LaneProof prove(const Lane& lane, Effort effort) {
    return prove_lane(lane, std::ref(prover_), effort);
  }
  void for_every_lane(const std::function<void(const Lane&)>& visit) {
    for (const Ranged& ranged : every_term()) {
      for (const auto rounding : {Rounding::nearest_even, Rounding::toward_zero}) {
        const int digits = format(ranged.format).precision();
        for (const LaneInputs inputs : all_inputs(digits)) {
          SCOPED_TRACE(std::string(ranged.f) + " : " + ranged.g);
          const auto lane = lane_of(ranged, inputs, rounding);
          ASSERT_TRUE(lane.ok()) << lane.error().to_string();
          visit(*lane);
        }
      }
    }
  }

  QuickProver prover_ = patient_prover();
};

bool any_finding(const LaneProof& proof, const std::string& words) {
  return std::any_of(proof.findings.begin(), proof.findings.end(), [&](const Finding& finding) {
    return finding.what.find(words) != std::string::npos;
  });
}

TEST_F(ConstantProof, EveryTermIsProvenOperationByOperation) {
  for_every_lane([&](const Lane& lane) {
    const LaneProof proof = prove(lane, Effort::operations);
    EXPECT_TRUE(proof.machine_checked()) << report::to_text(proof, "");
    EXPECT_TRUE(any_finding(proof, "the constant, from that bound and the ranges"));
  });
}

/// Interval analysis folds constants as small as they may be, and Gappa asks for all of them.
/// Exceptions are reciprocals, up to twice too large as a power of two, and the slack from rounding
/// up to few digits.
TEST_F(ConstantProof, AConstantSmallerByOneInAThousandIsRefused) {
  for_every_lane([&](Lane lane) {
    auto& criterion = std::get<error::AbsoluteBoundCriterion>(lane.criterion());
    const std::vector<error::BoundNode> bounds = analysis_of(lane).bounds;
    const bool divides = std::any_of(bounds.begin(), bounds.end(), [](const auto& node) {
      return node.operation == error::BoundOperation::reciprocal;
    });
    const int one_in = lane.graph.arithmetic.format.precision() < 16 ? 25 : 1000;
    criterion.bound.nodes.back().constant *= 1 - mpq_class(1, divides ? 2 : one_in);
    const LaneProof proof = prove(lane, Effort::operations);
    EXPECT_TRUE(proof.refused()) << report::to_text(proof, "");
  });
}

/// One step of a check's limit is 12 %.
TEST_F(ConstantProof, ChecksThatLetMorePassAreRefused) {
  Lane lane = lane_of(every_term()[0], LaneInputs::rounded, Rounding::nearest_even).value();
  ASSERT_TRUE(prove(lane, Effort::operations).machine_checked());
  lane.checks[0].greatest += 1;
  EXPECT_TRUE(prove(lane, Effort::operations).refused());
}

TEST_F(ConstantProof, AConditionThatTheRangesBreakIsRefused) {
  const auto with_divisor = [](const Range& e) {
    return Ranged{
        "a / (b * d - e)", "c", "s8e8", {Range{1, 2}, Range{2, 3}, Range{2, 3}, e, Range{1, 2}}};
  };
  const auto constant = [&](const Range& e) {
    return lane_of(with_divisor(e), LaneInputs::rounded, Rounding::nearest_even);
  };
  Lane lane = constant({20, 30}).value();
  const LaneProof proof = prove(lane, Effort::operations);
  EXPECT_TRUE(proof.machine_checked()) << report::to_text(proof, "");
  EXPECT_TRUE(any_finding(proof, "is never closer to zero than its condition asks"));
  // e of 11 leaves a divisor of 1.4 and more in magnitude, with an error of more than 1/32 of it.
  const auto refused = constant({11, 30});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().to_string().find("closer to zero than its own error"),
            std::string::npos);
  for (RangeCheck& check : lane.checks) {
    if (check.input == 3) check = error::range_check(3, lane.graph.input_format, {11, 30});
  }
  std::get<error::AbsoluteBoundCriterion>(lane.criterion()).bound.nodes.back().constant *= 1000;
  const LaneProof wider =
      prove_absolute(lane, analysis_of(lane), std::ref(prover_), Effort::operations);
  ASSERT_TRUE(wider.refused()) << report::to_text(wider, "");
  EXPECT_NE(wider.verdict().find("is never closer to zero"), std::string::npos) << wider.verdict();
}

TEST_F(ConstantProof, TheVerdictNamesWhatIsByHand) {
  const Ranged& ranged = every_term()[1];
  const auto verdict = [&](BoundKind kind) {
    const Lane lane = lane_of(ranged, LaneInputs::rounded, Rounding::nearest_even, kind).value();
    return prove(lane, Effort::operations).verdict();
  };
  EXPECT_EQ(verdict(BoundKind::constant),
            "machine-checked but for theorems 1 (exponents), 7, 8 and 10, by hand");
  EXPECT_EQ(verdict(BoundKind::running),
            "machine-checked but for theorems 1 (exponents), 7, 8, 9 and 10, by hand");
  const LaneProof relative =
      prove(mixcmp::test::lane_of(sphere_graph(), {}).value(), Effort::operations);
  EXPECT_EQ(relative.verdict(),
            "machine-checked but for theorems 1 (exponents) and 2 to 4, by hand");
  const auto report = report::to_json(relative, "1.4.1");
  EXPECT_EQ(report.at("by_hand").at(1).at("theorem"), "2 to 4");
}

/// Makes every promise of every unit in turn. Either it is proven, or a lane that makes it is
/// refused.
TEST_F(ConstantProof, HazardsAreLeftOutWhereGappaSaysSoAndNowhereElse) {
  const Ranged ranged = {"(a * b - d) / e",
                         "sqrt(c * a)",
                         "s8e4",
                         {Range{1, 8}, Range{1, 8}, Range{2, 4}, Range{-1, 3}, Range{1, 8}}};
  Lane lane =
      lane_of(ranged, LaneInputs::exact, Rounding::nearest_even, BoundKind::running).value();
  const auto refused = [&](const Lane& one) {
    const std::vector<Finding> findings = prove_hazards(one, std::ref(prover_));
    return std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
      return finding.outcome != proof::Outcome::proven;
    });
  };
  EXPECT_FALSE(refused(lane));
  int promises = 0;
  for (std::size_t id = 0; id < lane.graph.nodes.size(); ++id) {
    if (!error::has_unit(lane.graph.nodes[id].operation)) continue;
    const bool sums = lane.graph.nodes[id].operation == Operation::subtract;
    for (bool error::Hazards::*const hazard :
         {&error::Hazards::special_operand, &error::Hazards::overflow, &error::Hazards::underflow,
          &error::Hazards::cancellation}) {
      Lane bold = lane;
      const bool counts = hazard != &error::Hazards::cancellation || sums;
      if (!counts || !(bold.hazards[id].*hazard)) continue;
      bold.hazards[id].*hazard = false;
      EXPECT_TRUE(refused(bold)) << "node " << id;
      ++promises;
    }
  }
  EXPECT_GE(promises, 8);
}

/// A wider format's range is promised to a narrow one.
TEST_F(ConstantProof, HazardsOfFewerExponentBitsAreRefused) {
  const Ranged ranged = {"a * b", "c", "s8e8", {Range{1, 100}, Range{1, 100}, Range{1, 100}}};
  Lane lane =
      lane_of(ranged, LaneInputs::exact, Rounding::nearest_even, BoundKind::running).value();
  EXPECT_TRUE(prove(lane, Effort::operations).machine_checked());
  for (TypedNode& node : lane.graph.nodes) {
    if (node.format == format("s8e8")) node.format = format("s8e4");
  }
  const std::vector<Finding> findings = prove_hazards(lane, std::ref(prover_));
  EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.outcome == proof::Outcome::not_proven;
  }));
}

TEST_F(ConstantProof, RandomLanesWithRangesAreProven) {
  const Ranges ranges = {Range{mpq_class(1, 3), 5}, Range{3, mpq_class(7, 2)}, Range{-9, -1}};
  int lanes = 0;
  for (std::uint64_t seed = 1; seed < 24; ++seed) {
    const Graph graph = random_comparison(seed);
    LaneOptions options = random_options(seed);
    options.kind = seed % 4 == 0 ? BoundKind::running : BoundKind::constant;
    options.ranges = {ranges.begin(), ranges.begin() + static_cast<long>(graph.inputs().size())};
    const auto lane = mixcmp::test::lane_of(graph, options);
    if (!lane.ok()) continue;
    ++lanes;
    const LaneProof proof = prove(*lane, Effort::operations);
    EXPECT_TRUE(proof.machine_checked()) << "seed " << seed << "\n" << report::to_text(proof, "");
  }
  EXPECT_GE(lanes, 12);
}

/// The range that is read off the bits is as wide as the passing values, and no wider.
TEST(EnforcedRange, EnclosesWhatPassesTightly) {
  const FloatFormat format = format_of(6, 5);
  for (const Range& range : {Range{0, 100}, Range{1, 3}, Range{-4, 4}, Range{-9, -1}, Range{0, 0},
                             Range{mpq_class(1, 20000), mpq_class(1, 3)}}) {
    const RangeCheck check = error::range_check(0, format, range);
    const std::optional<Range> enforced = enforced_range(check, format);
    ASSERT_TRUE(enforced);
    std::optional<Range> passing;
    for (Bits bits = 0; bits < Bits{1} << format.width(); ++bits) {
      if (!golden::passes(check, format, bits)) continue;
      const mpq_class value = to_rational(format, bits);
      if (!passing) passing = Range{value, value};
      passing = Range{std::min(passing->low, value), std::max(passing->high, value)};
    }
    EXPECT_EQ(*enforced, *passing) << range.low << " " << range.high;
  }
}

TEST(EnforcedRange, IsNoneWhereInfinitiesOrNansPass) {
  const FloatFormat format = format_of(6, 5);
  RangeCheck check = error::range_check(0, format, {1, 3});
  check.greatest = low_mask(check.leading_bits);
  EXPECT_FALSE(enforced_range(check, format));
  EXPECT_FALSE(enforced_range(error::sign_check(0, error::RequiredSign::nonnegative), format));
}

}  // namespace
}  // namespace mixcmp::test::constant_proof_test
