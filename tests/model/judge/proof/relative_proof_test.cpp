#include <algorithm>
#include <array>

#include "generator/present/report/proof_report.hpp"
#include "model/judge/proof/cone.hpp"
#include "model/judge/proof/script.hpp"
#include "model/lane/error/error_analysis.hpp"
#include "tests/model/judge/proof/proof_support.hpp"
#include "tests/model/judge/proof/random_lanes.hpp"

/// Tests that Gappa, which does not know our rules, proves the claims of the analysis and nothing
/// tighter.
namespace mixcmp::test::relative_proof_test {
namespace {

using error::Lane;
using namespace proof;

constexpr std::array both_roundings = {Rounding::nearest_even, Rounding::toward_zero};

bool any_optional(const LaneProof& proof) {
  return std::any_of(proof.findings.begin(), proof.findings.end(),
                     [](const Finding& finding) { return finding.optional; });
}

/// The claims of the same graph analysed in another way.
std::vector<NodeClaim> claims_of(const TypedGraph& graph,
                                 const std::vector<error::RangeCheck>& checks) {
  return relative_claims(error::one_part_lane(graph, {}, checks));
}

class RelativeProof : public WithGappa {
protected:
  LaneProof prove(const Lane& lane, Effort effort) {
    return prove_lane(lane, std::ref(prover_), effort);
  }
  LaneProof prove(const Lane& lane, const std::vector<NodeClaim>& claims, Effort effort) {
    return prove_relative(lane, claims, std::ref(prover_), effort);
  }

  QuickProver prover_ = patient_prover();  ///< remembers its proofs
};

struct Comparison {
  const char* f;
  const char* g;
};

class EveryPrecision : public RelativeProof, public testing::WithParamInterface<std::string> {};

TEST_P(EveryPrecision, SphereIsProvenWhole) {
  for (const Rounding rounding : both_roundings) {
    const Lane lane =
        lane_of(sphere_graph(), {.format = GetParam().c_str(), .rounding = rounding}).value();
    const LaneProof proof = prove(lane, Effort::whole);
    EXPECT_TRUE(proof.machine_checked() && !any_optional(proof)) << report::to_text(proof, "");
    ASSERT_GE(proof.findings.size(), 3U);
    EXPECT_EQ(proof.findings[1].what, "f, the whole expression, 7 cases of zero terms");
    EXPECT_EQ(proof.findings[2].what, "g, the whole expression, 1 case");
  }
}

TEST_P(EveryPrecision, SphereIsProvenOperationByOperation) {
  for (const Rounding rounding : both_roundings) {
    const Lane lane =
        lane_of(sphere_graph(), {.format = GetParam().c_str(), .rounding = rounding}).value();
    const LaneProof proof = prove(lane, Effort::operations);
    EXPECT_TRUE(proof.machine_checked()) << report::to_text(proof, "");
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, EveryPrecision,
                         testing::Values("s4e8", "s8e8", "s17e8", "s24e8", "s52e8", "s24e15"),
                         [](const auto& tested) { return tested.param; });

TEST_F(RelativeProof, EveryOperationIsProven) {
  for (const auto& [f, g] :
       std::initializer_list<Comparison>{{"a * b + c * d", "sqrt(a) * b / c"},
                                         {"min(a, b * c) * d", "max(a * b, c)"},
                                         {"0.1 * a + 4 * b", "abs(-a * 0.3)"},
                                         {"a / (b + 0.5)", "sqrt(c * d + a)"},
                                         {"abs(a - b)", "-(-c - d)"},
                                         {"max(-a * b, -c)", "a / 4 - 0 * b"},
                                         {"((a + b) * c)^2", "7"}}) {
    const Graph graph = graph_of(f, g);
    for (const Rounding rounding : both_roundings) {
      const auto lane = lane_of(graph, {.rounding = rounding, .ranges = nonnegative_ranges(graph)});
      ASSERT_TRUE(lane.ok()) << lane.error().to_string();
      for (const Effort effort : {Effort::whole, Effort::operations}) {
        const LaneProof proof = prove(*lane, effort);
        EXPECT_TRUE(proof.machine_checked()) << f << " : " << g << "\n"
                                             << report::to_text(proof, "");
      }
    }
  }
}

/// A product of operands that arrive with few digits is proven to round nothing; a lane that only
/// believes so is not.
TEST_F(RelativeProof, OperandsOfNarrowFormatsHaveFewDigits) {
  const auto proof_of = [&](bool arrive_narrow) {
    Graph graph = graph_of("a * b", "a * c + b");
    for (int input = 0; arrive_narrow && input < 3; ++input) {
      graph.arrives_in(input, OperandFormat(format("s8e8")));
    }
    TypedGraph typed = lane_graph(graph, format("s24e8"), {format("s17e8")}, LaneInputs::rounded);
    for (TypedNode& node : typed.nodes) {
      if (node.operation == Operation::multiply) node.arriving_digits = 8;
    }
    const Lane lane = error::certified_lane(typed, {.ranges = nonnegative_ranges(graph)}).value();
    return prove(lane, Effort::operations);
  };
  const LaneProof proof = proof_of(true);
  EXPECT_TRUE(proof.machine_checked()) << report::to_text(proof, "");
  const auto says = [&](const char* what) {
    return std::any_of(proof.findings.begin(), proof.findings.end(),
                       [&](const Finding& finding) { return finding.what == what; });
  };
  EXPECT_TRUE(says("multiply of 8 digits into 17 rounds nothing")) << report::to_text(proof, "");
  EXPECT_FALSE(proof_of(false).machine_checked());
}

/// The proofs' own largest number of a format without infinities lies below that of its NaN's
/// fields.
TEST_F(RelativeProof, TheLargestNumberIsTheFormats) {
  const FloatFormat e4m3 = FloatFormat::e4m3();
  EXPECT_EQ(proof::largest_number(e4m3), 448);
  EXPECT_EQ(proof::smallest_number(e4m3), power_of_two(-9));
  EXPECT_EQ(proof::largest_number(format("s3e5")), 57344);
  EXPECT_EQ(proof::largest_number(format("s4e4")), 240);
}

/// 146 * 448 is a number of s12e5, and 147 * 448 is none: the analysis finds no overflow in the
/// first product of an operand in E4M3, and the proof agrees.
TEST_F(RelativeProof, OperandsWithoutInfinitiesEndAtTheirLargestNumber) {
  for (const int factor : {146, 147}) {
    Graph graph = graph_of(std::to_string(factor) + " * a", "b");
    graph.arrives_in(0, OperandFormat(FloatFormat::e4m3()));
    const TypedGraph typed =
        lane_graph(graph, format("s24e8"), {format("s12e5")}, LaneInputs::rounded);
    const Lane lane = error::certified_lane(typed, {.ranges = {std::nullopt, Range{0, 1}}}).value();
    const auto product =
        std::find_if(lane.graph.nodes.begin(), lane.graph.nodes.end(),
                     [](const TypedNode& node) { return node.operation == Operation::multiply; });
    const auto id = static_cast<std::size_t>(product - lane.graph.nodes.begin());
    EXPECT_EQ(lane.hazards[id].overflow, factor == 147) << factor;
    const LaneProof proof = prove(lane, Effort::operations);
    EXPECT_TRUE(proof.machine_checked()) << factor << "\n" << report::to_text(proof, "");
  }
}

/// Products of few digits, conversions to more digits and scalings by powers of two round nothing.
TEST_F(RelativeProof, WhatRoundsNothingIsProvenToRoundNothing) {
  const Graph graph = graph_of("a * b", "b + c / 4");
  const Arithmetic reduced = {format("s24e8"), Rounding::toward_zero, Subnormals::flush};
  const TypedGraph typed = lane_graph(graph, format("s11e5"), reduced, LaneInputs::exact);
  const Lane lane = error::certified_lane(typed, {.ranges = nonnegative_ranges(graph)}).value();
  const LaneProof proof = prove(lane, Effort::whole);
  EXPECT_TRUE(proof.machine_checked()) << report::to_text(proof, "");
  const auto says = [&](const char* what) {
    return std::any_of(proof.findings.begin(), proof.findings.end(),
                       [&](const Finding& finding) { return finding.what == what; });
  };
  EXPECT_TRUE(says("multiply of 11 digits into 24 rounds nothing")) << report::to_text(proof, "");
  EXPECT_TRUE(says("convert of 11 digits into 24 rounds nothing")) << report::to_text(proof, "");
}

TEST_F(RelativeProof, OneDigitTooManyRounds) {
  const auto proves = [&](ExactOperation operation, int from, int to) {
    const std::string script = exactness_script(operation, from, to, Rounding::nearest_even);
    return prover_(script).outcome == proof::Outcome::proven;
  };
  for (const int digits : {2, 11, 26}) {
    EXPECT_TRUE(proves(ExactOperation::convert, digits, digits));
    EXPECT_FALSE(proves(ExactOperation::convert, digits + 1, digits));
    EXPECT_TRUE(proves(ExactOperation::multiply, digits, 2 * digits));
    EXPECT_FALSE(proves(ExactOperation::multiply, digits, 2 * digits - 1));
    EXPECT_TRUE(proves(ExactOperation::square, digits, 2 * digits));
    EXPECT_FALSE(proves(ExactOperation::square, digits, 2 * digits - 1));
  }
}

TEST_F(RelativeProof, TheoremOneHoldsFromTwoDigitsToMost) {
  for (const int precision : {2, 3, 4, 5, 8, 11, 16, 17, 24, 32, 52, 53, 64, 112, 113}) {
    for (const Rounding rounding : both_roundings) {
      for (const std::string& script : rounding_scripts(precision, rounding)) {
        EXPECT_EQ(prover_(script).outcome, proof::Outcome::proven) << script;
      }
    }
  }
}

TEST_F(RelativeProof, RandomLanesAreProvenOperationByOperation) {
  int lanes = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Graph graph = random_comparison(seed);
    LaneOptions options = random_options(seed);
    options.ranges = nonnegative_ranges(graph);
    const auto lane = lane_of(graph, options);
    if (!lane.ok()) continue;
    ++lanes;
    const LaneProof proof = prove(*lane, Effort::operations);
    EXPECT_TRUE(proof.machine_checked()) << "seed " << seed << "\n" << report::to_text(proof, "");
  }
  EXPECT_GE(lanes, 15);
}

TEST_F(RelativeProof, RandomLanesAreProvenWholeOrByTheirOperations) {
  for (std::uint64_t seed = 1000; seed < 1015; ++seed) {
    const Graph graph = random_comparison(seed);
    LaneOptions options = random_options(seed);
    options.ranges = nonnegative_ranges(graph);
    const auto lane = lane_of(graph, options);
    if (!lane.ok()) continue;
    const LaneProof proof = prove(*lane, Effort::whole);
    EXPECT_TRUE(proof.machine_checked()) << "seed " << seed << "\n" << report::to_text(proof, "");
  }
}

/// The end of a bound that is moved towards the exact result, 1, by 1/1024 of its distance. The
/// other end stays.
enum class End { low, high };
error::RelativeBound shrunken(const error::RelativeBound& bound, End end) {
  const mpq_class kept = 1 - mpq_class(1, 1 << 10);
  error::RelativeBound result = bound;
  mpq_class& moved = end == End::low ? result.low : result.high;
  moved = 1 + (moved - 1) * kept;
  return result;
}

/// Lanes whose intervals are all as narrow as their operations permit: nothing is slack.
std::vector<Lane> tight_lanes() {
  std::vector<Lane> lanes;
  for (const Rounding rounding : both_roundings) {
    lanes.push_back(lane_of(sphere_graph(), {.format = "s8e8", .rounding = rounding}).value());
    const Graph graph = graph_of("min(a * b, c / d) * a", "sqrt(a * c) + b + abs(d * d * 3)");
    lanes.push_back(lane_of(graph, {.rounding = rounding,
                                    .inputs = LaneInputs::rounded,
                                    .ranges = nonnegative_ranges(graph)})
                        .value());
  }
  return lanes;
}

TEST_F(RelativeProof, AnyIntervalShrunkenByOneInAThousandIsRefused) {
  for (const Lane& lane : tight_lanes()) {
    const std::vector<NodeClaim> claims = relative_claims(lane);
    for (std::size_t id = 0; id < claims.size(); ++id) {
      if (arity(lane.graph.nodes[id].operation) == 0) continue;
      for (const End end : {End::low, End::high}) {
        std::vector<NodeClaim> wrong = claims;
        wrong[id].relative = shrunken(*claims[id].relative, end);
        const auto& moved =
            end == End::low ? &error::RelativeBound::low : &error::RelativeBound::high;
        if ((*wrong[id].relative).*moved == (*claims[id].relative).*moved) continue;
        EXPECT_TRUE(prove(lane, wrong, Effort::operations).refused()) << "node " << id;
      }
    }
  }
}

TEST_F(RelativeProof, TheWholeExpressionsIntervalShrunkenIsRefused) {
  for (const Lane& lane : tight_lanes()) {
    for (const NodeId root : {lane.graph.f(), lane.graph.g()}) {
      for (const bool unrounded : {false, true}) {
        std::vector<NodeClaim> wrong = relative_claims(lane);
        auto& bound = unrounded ? wrong[root].unrounded : wrong[root].relative;
        bound = shrunken(*bound, End::high);
        EXPECT_TRUE(prove(lane, wrong, Effort::whole).refused()) << root;
      }
    }
  }
}

TEST_F(RelativeProof, BoundsOfTheOtherRoundingAreRefused) {
  for (const Effort effort : {Effort::whole, Effort::operations}) {
    Lane lane = lane_of(sphere_graph(), {.rounding = Rounding::nearest_even}).value();
    const std::vector<NodeClaim> claims = relative_claims(lane);
    EXPECT_FALSE(prove(lane, claims, effort).refused());
    lane.graph.arithmetic.rounding = Rounding::toward_zero;
    EXPECT_TRUE(prove(lane, claims, effort).refused());
  }
}

TEST_F(RelativeProof, AConversionThatTheBoundsForgetIsRefused) {
  const Graph graph = graph_of("a * b", "c * d");
  const Lane lane = lane_of(graph, {.inputs = LaneInputs::rounded}).value();
  TypedGraph forgetful = lane.graph;
  int conversions = 0;
  for (TypedNode& node : forgetful.nodes) {
    if (node.operation != Operation::convert) continue;
    node.operand_format = node.format;
    ++conversions;
  }
  ASSERT_GT(conversions, 0);
  const std::vector<NodeClaim> claims = claims_of(forgetful, lane.checks);
  for (const Effort effort : {Effort::whole, Effort::operations}) {
    EXPECT_FALSE(prove(lane, relative_claims(lane), effort).refused());
    EXPECT_TRUE(prove(lane, claims, effort).refused());
  }
}

TEST_F(RelativeProof, ASignThatTheLaneDoesNotCheckIsRefused) {
  const Graph graph = graph_of("a * b + c", "d");
  Lane lane = lane_of(graph, {.ranges = nonnegative_ranges(graph)}).value();
  const std::vector<NodeClaim> claims = relative_claims(lane);
  for (const Effort effort : {Effort::whole, Effort::operations}) {
    EXPECT_FALSE(prove(lane, claims, effort).refused());
    Lane unchecked = lane;
    unchecked.checks.clear();
    EXPECT_TRUE(prove(unchecked, claims, effort).refused());
    std::vector<NodeClaim> tacit = claims;  // used, but not claimed for the inputs
    for (std::size_t id = 0; id < tacit.size(); ++id) {
      const bool input = lane.graph.nodes[id].operation == Operation::input;
      if (input) tacit[id].nonnegative = false;
    }
    EXPECT_TRUE(prove(unchecked, tacit, effort).refused());
  }
}

TEST_F(RelativeProof, AGuardOneStepLowerIsRefused) {
  for (const char* format : {"s4e8", "s17e8", "s52e8"}) {
    Lane lane = lane_of(sphere_graph(), {.format = format}).value();
    std::get<error::UlpDistanceCriterion>(lane.criterion()).guard_ulp -= 1;
    const LaneProof proof = prove(lane, Effort::operations);
    EXPECT_TRUE(proof.refused());
    EXPECT_NE(proof.verdict().find("a guard of 6 ulp"), std::string::npos) << proof.verdict();
  }
}

/// The same inexact factor on both sides cancels exactly. No interval of binary digits shows that,
/// and yet the lane is sound.
TEST_F(RelativeProof, AGuardThatFollowsFromExactBoundsAloneIsByHand) {
  for (const char* f : {"0.1 * a", "a / 0.3", "0.1 / a"}) {
    std::string g = f;
    g[g.find('a')] = 'b';
    Lane lane = lane_of(graph_of(f, g), {.format = "s8e8"}).value();
    const LaneProof sound = prove(lane, Effort::operations);
    EXPECT_FALSE(sound.refused()) << f << ": " << sound.verdict();
    EXPECT_FALSE(sound.machine_checked()) << f << ": " << sound.verdict();
    std::get<error::UlpDistanceCriterion>(lane.criterion()).guard_ulp -= 1;
    EXPECT_TRUE(prove(lane, Effort::operations).refused()) << f;
  }
}

/// Hypotheses that contradict one another would prove anything.
TEST_F(RelativeProof, NoScriptAssumesTheImpossible) {
  int scripts = 0;
  for (const Lane& lane : tight_lanes()) {
    const std::vector<NodeClaim> claims = relative_claims(lane);
    for (NodeId id = 0; id < static_cast<NodeId>(claims.size()); ++id) {
      if (arity(lane.graph.nodes[id].operation) == 0) continue;
      if (is_inexpressible(lane.graph, claims, id)) continue;
      const auto cases = cases_of(whole_cone(lane.graph, claims, lane.checks, id));
      for (const ConeCase& one : cases.value()) {
        const std::size_t goal = one.script.rfind("->\n"), end = one.script.rfind('}');
        const std::string absurd =
            one.script.substr(0, goal) + "-> 1 in [2, 3] " + one.script.substr(end);
        EXPECT_EQ(prover_(absurd).outcome, proof::Outcome::not_proven) << absurd;
        ++scripts;
      }
    }
  }
  EXPECT_GE(scripts, 40);
}

TEST_F(RelativeProof, ManyTermsThatMayBeZeroAreProvenOneOperationAtATime) {
  const Graph graph = graph_of("a*a + b*b + c*c + d*d + e*e + h*h + k*k", "m");
  const LaneProof proof = prove(lane_of(graph, {}).value(), Effort::whole);
  EXPECT_TRUE(proof.machine_checked() && any_optional(proof)) << report::to_text(proof, "");
}

TEST(RelativeProofWithoutGappa, SaysSo) {
  const Lane lane = lane_of(sphere_graph(), {}).value();
  const Prove absent = [](const std::string&) {
    return ScriptResult{proof::Outcome::unchecked, "gappa is not installed", ""};
  };
  for (const Effort effort : {Effort::whole, Effort::operations}) {
    const LaneProof proof = prove_lane(lane, absent, effort);
    EXPECT_FALSE(proof.machine_checked() || proof.refused());
    EXPECT_EQ(proof.verdict(), "not machine-checked: gappa is not installed");
  }
}

}  // namespace
}  // namespace mixcmp::test::relative_proof_test
