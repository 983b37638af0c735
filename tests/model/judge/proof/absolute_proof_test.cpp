#include "model/judge/proof/absolute_proof.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "generator/present/report/proof_report.hpp"
#include "model/judge/proof/rule_proof.hpp"
#include "tests/model/judge/proof/proof_support.hpp"
#include "tests/model/judge/proof/random_lanes.hpp"

/// Tests running and constant bounds: true bounds are proven, wrong ones are refused.
namespace mixcmp::test::absolute_proof_test {
namespace {

using error::ErrorAnalysis;
using error::Lane;
using namespace proof;

constexpr std::array both_roundings = {Rounding::nearest_even, Rounding::toward_zero};

Result<Lane> absolute_lane(const Graph& graph, BoundKind kind,
                           Rounding rounding = Rounding::nearest_even,
                           const char* format = "s17e8") {
  return lane_of(graph, {.format = format,
                         .rounding = rounding,
                         .inputs = LaneInputs::rounded,
                         .kind = kind,
                         .ranges = nonnegative_ranges(graph)});
}

error::AbsoluteBoundCriterion& decision_of(Lane& lane) {
  return std::get<error::AbsoluteBoundCriterion>(lane.criterion());
}

class AbsoluteProof : public WithGappa {
protected:
  LaneProof prove(const Lane& lane, const ErrorAnalysis& analysis) {
    return prove_absolute(lane, analysis, std::ref(prover_), Effort::whole);
  }
  LaneProof prove(const Lane& lane) { return prove(lane, analysis_of(lane)); }

  QuickProver prover_ = patient_prover();  ///< remembers its proofs
};
class AbsoluteProofIn : public AbsoluteProof, public testing::WithParamInterface<std::string> {};

TEST_P(AbsoluteProofIn, SphereWithRoundedInputsIsProven) {
  for (const Rounding rounding : both_roundings) {
    for (const BoundKind kind : {BoundKind::running, BoundKind::constant}) {
      const auto lane = absolute_lane(sphere_graph(), kind, rounding, GetParam().c_str());
      ASSERT_TRUE(lane.ok()) << lane.error().to_string();
      const LaneProof proof = prove(*lane);
      EXPECT_TRUE(proof.machine_checked()) << report::to_text(proof, "");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, AbsoluteProofIn,
                         testing::Values("s4e8", "s8e8", "s17e8", "s24e8", "s52e8"),
                         [](const auto& tested) { return tested.param; });

TEST_F(AbsoluteProof, ConstantBoundsAreProvenWholeFromTheRanges) {
  const Lane lane = absolute_lane(sphere_graph(), BoundKind::constant).value();
  const LaneProof proof = prove(lane);
  ASSERT_EQ(proof.findings.size(), 1U) << report::to_text(proof, "");
  EXPECT_EQ(proof.findings[0].what, "f - g, the whole expression, from the ranges");
}

TEST_F(AbsoluteProof, EveryOperationIsProven) {
  int lanes = 0;
  for (const auto& [f, g] : std::initializer_list<std::pair<const char*, const char*>>{
           {"a * b - c * d", "sqrt(a - b) * e / h"},
           {"min(a - b, b) * c", "max(a * b, c - 0.1) + abs(d - c)"},
           {"0.1 * a - 4 * b", "abs(-a * 0.3)"},
           {"a / (b - 0.3)", "sqrt(c * d - a)"},
           {"(a - b) / (c - d)", "(a * b - c)^2 * (d - a)"},
           {"(a - b) * (c - d)", "-(a - 1)"}}) {
    const Graph graph = graph_of(f, g);
    for (const Rounding rounding : both_roundings) {
      for (const BoundKind kind : {BoundKind::running, BoundKind::constant}) {
        const auto lane = absolute_lane(graph, kind, rounding);
        if (!lane.ok()) continue;  // there is no constant bound if a divisor may be zero
        ++lanes;
        const LaneProof proof = prove(*lane);
        EXPECT_TRUE(proof.machine_checked()) << f << " : " << g << "\n"
                                             << report::to_text(proof, "");
      }
    }
  }
  EXPECT_GE(lanes, 18);
}

/// The lane rounds these constants to zero; operations that read them still have error factors.
TEST_F(AbsoluteProof, OperationsOnConstantsThatAreLostAreProven) {
  for (const auto& [f, g] : std::initializer_list<std::pair<const char*, const char*>>{
           {"-0x1p-200", "a"},
           {"a + 0x1p-200", "b"},
           {"0x1p-200 * a - b", "sqrt(0x1p-200)"},
           {"min(a - b, 0x1p-200)", "0x1p-200 / a"}}) {
    const Lane lane = absolute_lane(graph_of(f, g), BoundKind::running).value();
    const LaneProof proof = prove(lane);
    EXPECT_TRUE(proof.machine_checked()) << f << " : " << g << "\n" << report::to_text(proof, "");
  }
}

/// Gappa concludes nothing from a sign and a magnitude that spans many binades.
TEST_F(AbsoluteProof, QuotientsOfManyExponentBitsAreProven) {
  const Lane lane = absolute_lane(graph_of("a / b + c", "d"), BoundKind::running,
                                  Rounding::nearest_even, "s17e14")
                        .value();
  const LaneProof proof = prove(lane);
  EXPECT_TRUE(proof.machine_checked()) << report::to_text(proof, "");
}

/// Gappa 1.4 narrows no interval whose ends are 2^1024 or more.
TEST_F(AbsoluteProof, ChoicesAmongNumbersBeyondDoubleAreProven) {
  for (const char* f : {"max(d, 2 * d)", "min(abs(d), d + d)"}) {
    const auto lane = lane_of(graph_of(f, "c"), {.format = "s12e12",
                                                 .inputs = LaneInputs::rounded,
                                                 .kind = BoundKind::running,
                                                 .reference = "s53e11"});
    ASSERT_TRUE(lane.ok()) << lane.error().to_string();
    const LaneProof proof = prove_lane(*lane, std::ref(prover_), Effort::operations);
    EXPECT_TRUE(proof.machine_checked()) << f << "\n" << report::to_text(proof, "");
  }
}

TEST_F(AbsoluteProof, RandomLanesAreProven) {
  int lanes = 0;
  for (std::uint64_t seed = 5000; seed < 5025; ++seed) {
    const Graph graph = random_comparison(seed);
    LaneOptions options = random_options(seed);
    options.kind = seed % 4 == 0 ? BoundKind::constant : BoundKind::running;
    if (seed % 3 == 0) options.ranges = nonnegative_ranges(graph);
    const auto lane = lane_of(graph, options);
    if (!lane.ok()) continue;
    ++lanes;
    const LaneProof proof = prove(*lane);
    EXPECT_TRUE(proof.machine_checked()) << "seed " << seed << "\n" << report::to_text(proof, "");
  }
  EXPECT_GE(lanes, 12);
}

/// The lane's inflation, with the part above 1 shrunk by one part in 1024.
mpq_class shrunken(const mpq_class& inflation) {
  return 1 + (inflation - 1) * (1 - mpq_class(1, 1 << 10));
}

TEST_F(AbsoluteProof, AFudgeShrunkenByOneInAThousandIsRefused) {
  for (const Rounding rounding : both_roundings) {
    const Lane lane = absolute_lane(sphere_graph(), BoundKind::running, rounding).value();
    const ErrorAnalysis analysis = analysis_of(lane);
    int shrunk = 0;
    for (std::size_t id = 0; id < analysis.nodes.size(); ++id) {
      ErrorAnalysis wrong = analysis;
      auto& mixed = *wrong.nodes[id].mixed;
      if (mixed.is_relative() || mixed.absolute.inflation == 1) continue;
      mixed.absolute.inflation = shrunken(mixed.absolute.inflation);
      EXPECT_TRUE(prove(lane, wrong).refused()) << "node " << id;
      ++shrunk;
    }
    EXPECT_GE(shrunk, 6);
  }
}

TEST_F(AbsoluteProof, AFactorShrunkenByOneInAThousandIsRefused) {
  const Lane lane = absolute_lane(sphere_graph(), BoundKind::running).value();
  const ErrorAnalysis analysis = analysis_of(lane);
  for (std::size_t id = 0; id < analysis.nodes.size(); ++id) {
    ErrorAnalysis wrong = analysis;
    mpq_class& high = wrong.nodes[id].mixed->factor.high;
    if (high == 1) continue;
    high = shrunken(high);
    EXPECT_TRUE(prove(lane, wrong).refused()) << "node " << id;
  }
}

TEST_F(AbsoluteProof, ABoundThatForgetsATermIsRefused) {
  const Graph graph = graph_of("(a - b) * (c - d)", "(a - d) / (b - c)");
  const Lane lane = absolute_lane(graph, BoundKind::running).value();
  const ErrorAnalysis analysis = analysis_of(lane);
  int forgotten = 0;
  for (std::size_t id = 0; id < analysis.nodes.size(); ++id) {
    const auto& mixed = analysis.nodes[id].mixed;
    if (mixed->is_relative()) continue;
    const auto& bound = analysis.bounds[mixed->absolute.bound];
    if (bound.operation != error::BoundOperation::add) continue;
    for (const int kept : bound.operands) {
      ErrorAnalysis wrong = analysis;
      wrong.nodes[id].mixed->absolute.bound = kept;
      EXPECT_TRUE(prove(lane, wrong).refused()) << "node " << id;
      ++forgotten;
    }
  }
  EXPECT_GE(forgotten, 4);
}

TEST_F(AbsoluteProof, BoundsOfTheOtherRoundingAreRefused) {
  Lane lane = absolute_lane(sphere_graph(), BoundKind::running).value();
  const ErrorAnalysis analysis = analysis_of(lane);
  EXPECT_FALSE(prove(lane, analysis).refused());
  lane.graph.arithmetic.rounding = Rounding::toward_zero;
  EXPECT_TRUE(prove(lane, analysis).refused());
}

TEST_F(AbsoluteProof, AConversionThatTheBoundsForgetIsRefused) {
  const Lane lane = absolute_lane(sphere_graph(), BoundKind::running).value();
  Lane forgetful = lane;
  for (TypedNode& node : forgetful.graph.nodes) {
    if (node.operation == Operation::convert) node.operand_format = node.format;
  }
  EXPECT_TRUE(prove(lane, analysis_of(forgetful)).refused());
}

TEST_F(AbsoluteProof, ALaneThatDoesNotKeepToItsAnalysisIsRefused) {
  const Graph graph = graph_of("(a - d) / (b - c)", "a * b");
  const Lane lane = absolute_lane(graph, BoundKind::running, Rounding::toward_zero).value();
  ASSERT_TRUE(prove(lane).machine_checked()) << report::to_text(prove(lane), "");
  Lane unguarded = lane;
  ASSERT_GT(decision_of(unguarded).guard_ulp, 0U);
  decision_of(unguarded).guard_ulp -= 1;
  EXPECT_TRUE(prove(unguarded).refused());
  Lane unconditional = lane;
  ASSERT_FALSE(decision_of(unconditional).conditions.empty());
  decision_of(unconditional).conditions.clear();
  EXPECT_TRUE(prove(unconditional).refused());
  Lane cheaper = lane;
  for (error::BoundNode& node : decision_of(cheaper).bound.nodes) {
    if (node.operation == error::BoundOperation::constant) {
      node.constant *= 1 - mpq_class(1, 1 << 10);
      break;
    }
  }
  EXPECT_TRUE(prove(cheaper).refused());
}

TEST_F(AbsoluteProof, ASmallerConstantIsRefused) {
  for (const Rounding rounding : both_roundings) {
    Lane lane = absolute_lane(sphere_graph(), BoundKind::constant, rounding).value();
    decision_of(lane).bound.nodes.back().constant /= 2;
    EXPECT_TRUE(prove(lane).refused()) << report::to_text(prove(lane), "");
  }
}

TEST_F(AbsoluteProof, RangesThatAreNotCheckedProveNothing) {
  Lane lane = absolute_lane(sphere_graph(), BoundKind::constant).value();
  lane.checks.pop_back();
  EXPECT_FALSE(prove(lane).machine_checked());
}

}  // namespace
}  // namespace mixcmp::test::absolute_proof_test
