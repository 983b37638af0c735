#include "model/base/number/verdict.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "model/base/number/bound_format.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/data/uniform_spheres.hpp"
#include "model/judge/golden/bound_arithmetic.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "model/lane/error/profiled_lane.hpp"
#include "model/plan/profile/profiled_error.hpp"
#include "tests/extremes/sphere_families_under_test.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/sphere.hpp"

/// Certified lanes of every kind on every family: every decided verdict is the truth. Profiled
/// lanes decide some verdicts wrongly. MIXCMP_FAMILY_ROWS and MIXCMP_PROFILE_SAMPLES set the
/// effort.
namespace mixcmp::test::verdict_test {
namespace {

using error::Lane;

constexpr std::uint64_t family_rows = MIXCMP_FAMILY_ROWS;
constexpr std::uint64_t profile_samples = MIXCMP_PROFILE_SAMPLES;

/// Rows of one family with the order of their f and g.
struct Judged {
  std::string family;
  FloatFormat format;
  std::vector<std::vector<Bits>> rows;
  std::vector<Verdict> truths;
};

/// The verdict by exact rationals, a second judge that golden::true_verdict must agree with.
Verdict rational_verdict(FloatFormat format, const std::vector<Bits>& row) {
  std::vector<mpq_class> numbers;
  for (const Bits bits : row) numbers.push_back(to_rational(format, bits));
  const auto square = [](const mpq_class& value) { return mpq_class(value * value); };
  const mpq_class f = square(numbers[0] - numbers[1]) + square(numbers[2] - numbers[3]) +
                      square(numbers[4] - numbers[5]);
  const mpq_class g = square(numbers[6] + numbers[7]);
  return f < g ? Verdict::less : f > g ? Verdict::greater : Verdict::equal;
}

Judged judged(const std::string& family, FloatFormat format, std::uint64_t rows) {
  const data::Table table = family_of(family, format, rows);
  const Graph graph = sphere_graph();
  Judged result = {family, format, {}, {}};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto& operands = result.rows.emplace_back(row_of(table, row));
    const Verdict truth = golden::true_verdict(graph, format, operands).value();
    const bool finite = std::all_of(operands.begin(), operands.end(), [&](Bits bits) {
      return !format.is_nan(bits) && !format.is_infinite(bits);
    });
    EXPECT_EQ(truth, finite ? rational_verdict(format, operands) : Verdict::unordered);
    result.truths.push_back(truth);
  }
  return result;
}

struct Counts {
  std::uint64_t decided = 0;
  std::uint64_t wrong = 0;
  std::size_t first_wrong_row = 0;
};

Counts count(const Lane& lane, const Judged& data) {
  Counts counts;
  for (std::size_t row = 0; row < data.rows.size(); ++row) {
    const auto result = golden::evaluate_lane(lane, data.rows[row]);
    if (!result.decided) continue;
    ++counts.decided;
    if (result.verdict == data.truths[row]) continue;
    if (counts.wrong++ == 0) counts.first_wrong_row = row;
  }
  return counts;
}

struct NamedLane {
  std::string name;
  Lane lane;
};

std::vector<std::optional<Range>> paper_ranges() {
  std::vector<std::optional<Range>> ranges(6, Range{0, 100});
  ranges.resize(8, Range{0, 25});
  return ranges;
}

/// Every certified lane of a precision: the bounds that exist without ranges and with the paper's.
std::vector<NamedLane> certified_lanes(FloatFormat reference, int precision) {
  const FloatFormat format = format_of(precision, reference.exponent_bits());
  std::vector<NamedLane> lanes;
  for (const Arithmetic& arithmetic : every_arithmetic(format)) {
    for (const LaneInputs inputs : {LaneInputs::exact, LaneInputs::rounded}) {
      for (const bool ranged : {false, true}) {
        const auto graph = lane_graph(sphere_graph(), reference, arithmetic, inputs);
        const std::vector<std::optional<Range>> open(8);
        for (auto& candidate : error::candidate_lanes(graph, ranged ? paper_ranges() : open)) {
          if (!candidate.lane.ok()) continue;
          lanes.push_back(
              {fmt::format("{} {} {} {}, bound {} {}{}", format.name(),
                           to_string(arithmetic.rounding), to_string(arithmetic.subnormals),
                           to_string(inputs), to_string(candidate.bound.kind),
                           candidate.bound.digits, ranged ? ", with ranges" : ""),
               *candidate.lane});
        }
      }
    }
  }
  return lanes;
}

/// All but the near ties aimed at quite another precision.
bool concerns(const std::string& family, int precision) {
  if (!family.starts_with("near_tie_")) return true;
  return std::abs(std::stoi(family.substr(9)) - precision) <= 1;
}

bool exists(const std::string& family, FloatFormat format) {
  return data::sphere_family({.name = family, .count = 64}, format).ok();
}

struct Case {
  const char* reference;
  int precision;
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << "s" << c.precision << "_of_" << c.reference;
}

class CertifiedLanes : public testing::TestWithParam<Case> {};

TEST_P(CertifiedLanes, AreNeverWrong) {
  const FloatFormat reference = format(GetParam().reference);
  const int precision = GetParam().precision;
  const std::vector<NamedLane> lanes = certified_lanes(reference, precision);
  ASSERT_GE(lanes.size(), 20u);
  for (const std::string& name : data::sphere_family_names()) {
    if (!concerns(name, precision) || !exists(name, reference)) continue;
    const Judged data = judged(name, reference, family_rows);
    for (const auto& [lane_name, lane] : lanes) {
      const Counts counts = count(lane, data);
      EXPECT_EQ(counts.wrong, 0u) << lane_name << " on " << name << ", seed 1, first in row "
                                  << counts.first_wrong_row;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Precisions, CertifiedLanes,
                         testing::Values(Case{"s53e8", 4}, Case{"s53e8", 8}, Case{"s53e8", 11},
                                         Case{"s53e8", 17}, Case{"s53e8", 24}, Case{"s53e8", 40},
                                         Case{"s53e8", 52}, Case{"binary64", 17},
                                         Case{"binary16", 8}, Case{"binary32", 24}),
                         testing::PrintToStringParamName());

/// Without this test the families would prove nothing: lanes might decide nothing on them.
TEST(CertifiedLanes, DecideWhatIsClear) {
  const FloatFormat reference = format("s53e8");
  const Arithmetic reduced = {format("s17e8"), Rounding::nearest_even, Subnormals::flush};
  for (const LaneInputs inputs : {LaneInputs::exact, LaneInputs::rounded}) {
    const Lane lane =
        error::certified_lane(lane_graph(sphere_graph(), reference, reduced, inputs), {}).value();
    for (const char* family : {"uniform", "nested", "grid"}) {
      const Counts counts = count(lane, judged(family, reference, 200));
      EXPECT_GT(counts.decided, family == std::string("grid") ? 80u : 190u) << family;
    }
  }
}

/// Seven steps are proven to be enough; the search finds pairs on which five are not.
TEST(NearTies, MisleadALaneWhoseGuardIsTooSmall) {
  const FloatFormat reference = format("s53e8");
  for (const int precision : {17, 24, 40, 52}) {
    const Arithmetic reduced = {format_of(precision, 8), Rounding::nearest_even, Subnormals::flush};
    Lane lane =
        error::certified_lane(lane_graph(sphere_graph(), reference, reduced, LaneInputs::exact), {})
            .value();
    auto& criterion = std::get<error::UlpDistanceCriterion>(lane.criterion());
    ASSERT_EQ(criterion.guard_ulp, Bits{7});
    const Judged data = judged(fmt::format("near_tie_{}", precision), reference, 400);
    EXPECT_EQ(count(lane, data).wrong, 0u) << precision;
    criterion.guard_ulp = 5;
    EXPECT_GT(count(lane, data).wrong, 0u) << precision;
  }
}

/// The largest wrong difference as a share of its bound, of a lane with rounded inputs.
double attained(int precision, int bound_digits) {
  const FloatFormat reference = format("s53e8");
  const Arithmetic reduced = {format_of(precision, 8), Rounding::nearest_even, Subnormals::flush};
  const Lane lane =
      error::certified_lane(lane_graph(sphere_graph(), reference, reduced, LaneInputs::rounded),
                            {.kind = BoundKind::running, .bound_digits = bound_digits})
          .value();
  const auto& criterion = std::get<error::AbsoluteBoundCriterion>(lane.criterion());
  const Judged data = judged(fmt::format("near_tie_{}", precision), reference, 2000);
  mpq_class most = 0;
  for (std::size_t row = 0; row < data.rows.size(); ++row) {
    const auto values = golden::evaluate(lane.graph, data.rows[row]);
    const auto bounds = golden::evaluate_bound(criterion.bound, lane.graph, values);
    const mpq_class difference = to_rational(reduced.format, values[criterion.difference].bits);
    const Verdict verdict = difference < 0 ? Verdict::less : Verdict::greater;
    if (difference == 0 || verdict == data.truths[row]) continue;
    const mpq_class bound = bound_value(criterion.bound.format, bounds.back());
    most = std::max<mpq_class>(most, abs(difference) / bound);
  }
  return most.get_d();
}

/// Rounding the bound itself up to few digits costs part of its tightness.
TEST(NearTies, NearlyAttainRunningBounds) {
  EXPECT_GT(attained(17, 8), 0.9);
  EXPECT_GT(attained(17, 4), 0.7);
  EXPECT_LT(attained(17, 1), 0.3);
  EXPECT_GT(attained(17, 1), 0.1);
}

/// The paper's constants: the largest errors that a sample of its uniform spheres shows.
Lane profiled_lane(int precision, LaneInputs inputs) {
  const FloatFormat reference = format("s53e8");
  const Graph graph = sphere_graph();
  const auto spheres =
      data::uniform_spheres({.count = 4096, .side = 100, .radius_max = 25, .seed = 1}, reference);
  const auto data = data::Comparisons::all_pairs(spheres, graph.inputs()).value();
  const Arithmetic reduced = {format_of(precision, 8), Rounding::nearest_even, Subnormals::flush};
  TypedGraph typed = lane_graph(graph, reference, reduced, inputs);
  const auto error = profile::profile_error(graph, typed, data, profile_samples, 1);
  return error::profiled_lane(typed, error.f, error.g);
}

TEST(ProfiledLanes, AreWrongOnCounterexamples) {
  const FloatFormat reference = format("s53e8");
  const Judged data = judged("counterexample", reference, 440);
  for (int precision = 11; precision <= 32; precision += MIXCMP_PRECISION_STEP) {
    const Counts profiled = count(profiled_lane(precision, LaneInputs::exact), data);
    EXPECT_GT(profiled.wrong, 0u) << precision;
  }
}

TEST(ProfiledLanes, AreWrongOnRoundedInputsFarFromTheOrigin) {
  const Lane lane = profiled_lane(17, LaneInputs::rounded);
  const FloatFormat reference = format("s53e8");
  EXPECT_GT(count(lane, judged("offset_1e4", reference, 200)).wrong, 10u);
  EXPECT_GT(count(lane, judged("offset_1e6", reference, 200)).wrong, 10u);
}

}  // namespace
}  // namespace mixcmp::test::verdict_test
