#include "model/plan/profile/envelope.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "model/base/number/bound_format.hpp"
#include "model/base/number/exact.hpp"
#include "model/judge/golden/bound_arithmetic.hpp"
#include "model/judge/golden/enclosure.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "model/plan/profile/bound_envelope.hpp"
#include "model/plan/profile/threshold.hpp"
#include "tests/model/plan/profile/profile_cases.hpp"
#include "tests/support/lane_inputs.hpp"

/// Theorems 1 and 3 of docs/theory.md, held against the golden model.
namespace mixcmp::test::envelope_test {
namespace {

using data::Comparisons;
using error::AbsoluteBoundCriterion;
using error::Lane;
using golden::bound_is_at_most;
using golden::evaluate;
using golden::Rounded;
using profile::BoundEnvelope;
using profile::Envelope;
using profile::envelope_width;
using profile::EnvelopeBlock;
using profile::EnvelopeRow;
using profile::NodeMagnitude;
using scene::Scene;

mpq_class power_of_two(int exponent) {
  const mpq_class power(mpz_class(1) << std::abs(exponent));
  return exponent < 0 ? 1 / power : power;
}

/// One scene and a block of its comparisons, with their envelope.
struct Case {
  Case(const Scene& of_scene, LaneInputs of_inputs, int anchor, int last, Family family,
       std::mt19937_64& random)
      : scene(of_scene),
        inputs(of_inputs),
        data(random_rows(scene, family, envelope_width, random)),
        source(data),
        envelope(graph(anchor), options(anchor, last)) {
    data::OperandBlock operands(data.input_count(), envelope_width);
    source.fetch(0, envelope_width, operands);
    envelope.evaluate(operands.columns(), block);
  }

  TypedGraph graph(int precision) const {
    Arithmetic arithmetic = {*scene.reduced.format, scene.reduced.rounding,
                             scene.reduced.subnormals};
    arithmetic.format = format_of(precision, arithmetic.format.exponent_bits());
    return lane_graph(scene.graph, scene.reference.format, arithmetic, inputs);
  }

  Envelope::Options options(int anchor, int last) const {
    std::vector<NodeMagnitude> magnitudes;
    for (std::size_t k = 0; k < data.input_count(); ++k) {
      magnitudes.push_back(profile::magnitude_of(source.values(k)));
    }
    return {
        .anchor = anchor, .last = last, .reference = scene.reference.format, .inputs = magnitudes};
  }

  std::vector<Bits> operands(std::size_t k) const {
    std::vector<Bits> result(data.input_count());
    data.fetch(k, result);
    return result;
  }

  Scene scene;
  LaneInputs inputs;
  Comparisons data;
  data::OperandSource source;
  Envelope envelope;
  EnvelopeBlock block;
};

struct Truth {
  mpq_class f, g;
};

std::optional<Truth> truth_of(const Case& test, std::size_t k) {
  golden::Enclosure enclosure(test.scene.graph, 900);
  if (enclosure.compute(test.scene.reference.format, test.operands(k)) !=
      golden::Knowledge::enclosed) {
    return std::nullopt;
  }
  Truth truth;
  mpfr_get_q(truth.f.get_mpq_t(), enclosure.f().low.get());
  mpfr_get_q(truth.g.get_mpq_t(), enclosure.g().low.get());
  return truth;
}

/// Theorem 1 on comparison k for one datapath of `precision` digits.
void expect_within(const Case& test, std::size_t k, const TypedGraph& graph, int precision,
                   const Truth& truth) {
  const std::vector<Rounded> values = evaluate(graph, test.operands(k));
  for (const Rounded& value : values) ASSERT_FALSE(value.exceptional);
  const mpq_class shrunk = power_of_two(test.envelope.anchor() - precision);
  const auto expect = [&](const char* name, NodeId computed, NodeId id, const mpq_class& real) {
    const mpq_class value = to_rational(graph.nodes[computed].format, values[computed].bits);
    const mpq_class error = test.block.nodes[id].error[k] * shrunk;
    EXPECT_LE(abs(value - real), error)
        << name << " with " << precision << " digits: off by " << mpq_class(value - real).get_d()
        << ", envelope " << error.get_d();
  };
  const TypedGraph& shared = test.envelope.graph();
  expect("f", graph.f(), shared.f(), truth.f);
  expect("g", graph.g(), shared.g(), truth.g);
}

/// How many comparisons were tame.
int expect_theorem_1(const Case& test, int last) {
  int tame = 0;
  const TypedGraph reference = reference_graph(test.scene.graph, test.scene.reference);
  for (std::size_t k = 0; k < envelope_width; k += 3) {
    if (test.block.wild[k] != 0) continue;
    ++tame;
    const std::optional<Truth> truth = truth_of(test, k);
    EXPECT_TRUE(truth) << "tame, without real values";
    if (!truth) continue;
    const int anchor = test.envelope.anchor();
    for (const int precision : {anchor, std::min(anchor + 1, last), std::min(anchor + 3, last),
                                (anchor + last) / 2, last}) {
      expect_within(test, k, test.graph(precision), precision, *truth);
    }
    expect_within(test, k, reference, test.scene.reference.format.precision(), *truth);
    const TypedGraph& shared = test.envelope.graph();
    const mpq_class in_double = power_of_two(anchor - 53);
    const auto& f = test.block.nodes[shared.f()];
    EXPECT_LE(abs(mpq_class(f.value[k]) - truth->f), f.error[k] * in_double);
  }
  return tame;
}

struct Drawn {
  Scene scene;
  std::string what;
};

Drawn draw(const std::string& f, const std::string& g, std::mt19937_64& random) {
  const std::vector<FloatFormat> references = {format_of(53, 11), format_of(53, 8),
                                               format_of(30, 7)};
  const FloatFormat reference = references[random() % references.size()];
  const FloatFormat lane = format_of(4, 5 + static_cast<int>(random() % 7));
  const auto arithmetics = every_arithmetic(lane);
  const Arithmetic reduced = arithmetics[random() % arithmetics.size()];
  return {scene_of(graph_of(f, g), reference, reduced),
          fmt::format("{} against {}, reference {}, e{} {} {}", f, g, reference.name(),
                      lane.exponent_bits(), to_string(reduced.rounding),
                      to_string(reduced.subnormals))};
}

int draw_and_expect(const std::string& f, const std::string& g, Family family,
                    std::mt19937_64& random) {
  const auto [scene, what] = draw(f, g, random);
  const LaneInputs inputs = any_inputs(4, 53, random);
  const int highest = std::min(52, scene.reference.format.precision());
  const int anchor =
      std::min(highest, 4 + static_cast<int>(random() % (random() % 2 == 0 ? 8 : 48)));
  const int last = random() % 2 == 0 ? highest : std::min(highest, anchor + 3);
  SCOPED_TRACE(fmt::format("{}, family {}, L = {}..{}, {} inputs", what, static_cast<int>(family),
                           anchor, last, to_string(inputs)));
  const Case test(scene, inputs, anchor, last, family, random);
  return expect_theorem_1(test, last);
}

TEST(Envelope, HoldsWhatEveryLaneComputes) {
  std::mt19937_64 random(8);
  for (const Family family : all_families) {
    int tame = 0;
    for (int round = 0; round < 12; ++round) {
      for (const auto& [f, g] : expressions) {
        tame += draw_and_expect(f, g, family, random);
        if (testing::Test::HasFailure()) return;
      }
    }
    // Some of every family, most of the harmless one.
    EXPECT_GT(tame, family == Family::uniform ? 2000 : 200) << static_cast<int>(family);
  }
}

/// Squared differences of all sizes. In some, the lane's few digits separate operands or make them
/// equal, and the reference underflows. In others the true value is far from underflow, and the
/// lane underflows.
TEST(Envelope, KnowsWhatUnderflowsAfterCancellation) {
  std::mt19937_64 random(10);
  const std::vector<std::pair<std::string, std::string>> squares = {
      {"((a - b)^2)^2", "c * d"}, {"((a - b) + (c - d))^2", "1 / 1024"}};
  const std::vector<std::pair<FloatFormat, int>> formats = {{format_of(30, 7), 8},
                                                            {format_of(53, 8), 5}};
  for (int round = 0; round < 200; ++round) {
    const auto& [f, g] = squares[random() % 2];
    const auto& [reference, exponent_bits] = formats[random() % 2];
    const auto arithmetics = every_arithmetic(format_of(4, exponent_bits));
    const Scene scene = scene_of(graph_of(f, g), reference, arithmetics[random() % 4]);
    const int anchor = 4 + static_cast<int>(random() % 10);
    const int last = random() % 2 == 0 ? anchor + 3 : std::min(52, reference.precision());
    const LaneInputs inputs = any_inputs(4, 53, random);
    SCOPED_TRACE(fmt::format("{}, reference {}, e{}, L = {}..{}", f, reference.name(),
                             exponent_bits, anchor, last));
    expect_theorem_1(Case(scene, inputs, anchor, last, Family::cancelling, random), last);
    if (testing::Test::HasFailure()) return;
  }
}

/// A true value just above the smallest normal number here belongs to computed values of a third of
/// it.
TEST(Envelope, KnowsThatComputedValuesUnderflowBeforeTrueOnes) {
  std::mt19937_64 random(12);
  const auto arithmetics = every_arithmetic(format_of(4, 5));
  for (int round = 0; round < 400; ++round) {
    const Scene scene = scene_of(graph_of("((a - b) + (c - d)) * 0.013", "1 / 1024"),
                                 format_of(53, 8), arithmetics[random() % 4]);
    const int anchor = 7 + static_cast<int>(random() % 3);
    SCOPED_TRACE(anchor);
    expect_theorem_1(Case(scene, LaneInputs::rounded, anchor, 52, Family::cancelling, random), 52);
    if (testing::Test::HasFailure()) return;
  }
}

/// Theorem 3 on comparison k; the bound of one lane.
void expect_bound_within(const Case& test, std::size_t k, const Lane& lane, double scaled,
                         double fixed) {
  const auto& criterion = std::get<AbsoluteBoundCriterion>(lane.criterion());
  const std::vector<Rounded> values = evaluate(lane.graph, test.operands(k));
  const std::vector<Bits> bounds = golden::evaluate_bound(criterion.bound, lane.graph, values);
  const BoundFormat format = criterion.bound.format;
  ASSERT_NE(bounds.back(), format.infinity());
  const int steps = lane.graph.arithmetic.format.precision() - test.envelope.anchor();
  const mpq_class allowed = mpq_class(scaled) * power_of_two(-steps) + mpq_class(fixed);
  EXPECT_LE(bound_value(format, bounds.back()), allowed);
  for (const error::BoundCondition& condition : criterion.conditions) {
    EXPECT_TRUE(bound_is_at_most(format, bounds[condition.bound], lane.graph.arithmetic.format,
                                 values[condition.value].bits));
  }
}

int expect_theorem_3(const Case& test, const std::vector<const Lane*>& lanes, int last) {
  const BoundEnvelope bound(lanes, test.envelope.anchor(), last, test.envelope);
  EnvelopeRow scaled = {}, fixed = {}, wild = test.block.wild;
  bound.raise(test.block, scaled, fixed, wild);
  int tame = 0;
  for (std::size_t k = 0; k < envelope_width; k += 9) {
    if (wild[k] != 0) continue;
    ++tame;
    for (const Lane* lane : lanes) expect_bound_within(test, k, *lane, scaled[k], fixed[k]);
  }
  return tame;
}

/// The least |f - g|, as computed, for which the lane decides: the bound plus its guard in steps.
std::optional<mpq_class> least_decided(const Lane& lane, const std::vector<Bits>& operands) {
  const auto& criterion = std::get<AbsoluteBoundCriterion>(lane.criterion());
  const FloatFormat format = lane.graph.arithmetic.format;
  const auto values = evaluate(lane.graph, operands);
  const Bits bound = golden::evaluate_bound(criterion.bound, lane.graph, values).back();
  const Bits encoded =
      (bound << (format.precision() - criterion.bound.format.precision)) + criterion.guard_ulp;
  if (encoded > format.largest_finite(false)) return std::nullopt;
  return to_rational(format, encoded);
}

/// Theorem 2 for absolute bounds, with their guards.
TEST(Threshold, IsNeverBelowBoundAndGuard) {
  std::mt19937_64 random(14);
  int checked = 0, guarded = 0;
  for (const auto& [f, g] : expressions) {
    auto [scene, what] = draw(f, g, random);
    for (auto& range : scene.ranges) range = Range{0, 4};
    const int last = std::min(52, scene.reference.format.precision());
    SCOPED_TRACE(what);
    const Case test(scene, LaneInputs::rounded, 6, last, Family::uniform, random);
    std::vector<Lane> all;
    for (int precision = 6; precision <= last; ++precision) {
      auto lane = error::certified_lane(test.graph(precision),
                                        {.kind = BoundKind::running, .ranges = scene.ranges});
      if (lane.ok()) all.push_back(std::move(lane).value());
    }
    std::vector<const Lane*> lanes;
    for (const Lane& lane : all) lanes.push_back(&lane);
    if (static_cast<int>(lanes.size()) != last - 5) continue;
    EnvelopeRow scaled = {}, fixed = {}, wild = test.block.wild;
    profile::Threshold::of_lanes(lanes, test.envelope).evaluate(test.block, scaled, fixed, wild);
    for (std::size_t k = 0; k < envelope_width; k += 8) {
      for (std::size_t n = 0; n < lanes.size() && wild[k] == 0; n += 4) {
        const auto least = least_decided(*lanes[n], test.operands(k));
        ASSERT_TRUE(least);
        const mpq_class allowed =
            mpq_class(scaled[k]) * power_of_two(-static_cast<int>(n)) + mpq_class(fixed[k]);
        EXPECT_LE(*least, allowed * (1 - mpq_class(test.envelope.unit())));
        ++checked;
        guarded += std::get<AbsoluteBoundCriterion>(lanes[n]->criterion()).guard_ulp != 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(checked, 500);
  EXPECT_GT(guarded, 200);
}

/// The lanes of one kind from the anchor on, where all exist and are of one structure.
std::vector<const Lane*> lanes_of_kind(
    const std::map<int, std::vector<error::CandidateLane>>& candidates, std::size_t kind) {
  std::vector<const Lane*> lanes;
  for (const auto& [precision, all] : candidates) {
    if (!all[kind].lane.ok()) return {};
    const Lane& lane = *all[kind].lane;
    if (!std::holds_alternative<AbsoluteBoundCriterion>(lane.criterion())) return {};
    const auto& criterion = std::get<AbsoluteBoundCriterion>(lane.criterion());
    const auto& first = lanes.empty() ? lane.criterion() : lanes.front()->criterion();
    if (!BoundEnvelope::same_structure(criterion, std::get<AbsoluteBoundCriterion>(first)))
      return {};
    lanes.push_back(&lane);
  }
  return lanes;
}

TEST(BoundEnvelope, IsNeverBelowWhatTheHardwareComputes) {
  std::mt19937_64 random(9);
  int tame = 0, kinds = 0;
  for (const auto& [f, g] : expressions) {
    for (const Family family :
         {Family::uniform, Family::neighbours, Family::lowest, Family::wide}) {
      auto [scene, what] = draw(f, g, random);
      for (auto& range : scene.ranges) range = Range{0, 4};
      const int last = std::min(52, scene.reference.format.precision());
      const int anchor = 6 + static_cast<int>(random() % 10);
      SCOPED_TRACE(fmt::format("{}, family {}, anchor {}", what, static_cast<int>(family), anchor));
      const Case test(scene, LaneInputs::rounded, anchor, last, family, random);
      std::map<int, std::vector<error::CandidateLane>> candidates;
      for (int precision = anchor; precision <= last; ++precision) {
        candidates[precision] = error::candidate_lanes(test.graph(precision), scene.ranges);
      }
      for (std::size_t kind = 0; kind < candidates[last].size(); ++kind) {
        const std::vector<const Lane*> lanes = lanes_of_kind(candidates, kind);
        if (lanes.empty()) continue;
        ++kinds;
        tame += expect_theorem_3(test, lanes, last);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
  EXPECT_GT(kinds, 40);
  EXPECT_GT(tame, 500);
}

}  // namespace
}  // namespace mixcmp::test::envelope_test
