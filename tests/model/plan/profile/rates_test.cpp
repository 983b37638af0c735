#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "generator/present/report/profile_report.hpp"
#include "model/base/number/double.hpp"
#include "model/base/number/exact.hpp"
#include "model/base/number/verdict.hpp"
#include "model/comparison/data/sphere_family.hpp"
#include "model/comparison/data/uniform_spheres.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "model/judge/workload/compare_by_reference.hpp"
#include "model/plan/profile/rate_worker.hpp"
#include "model/plan/profile/schemes.hpp"
#include "tests/model/plan/profile/profile_cases.hpp"
#include "tests/support/lane_inputs.hpp"
#include "tests/support/sphere.hpp"
#include "tests/support/unproven_tie.hpp"

/// The counts of profile_rates against the golden model, comparison by comparison.
namespace mixcmp::test::rates_test {
namespace {

using data::Comparisons;
using design::Lane;
using golden::evaluate_lane;
using golden::evaluate_reference;
using golden::true_verdict;
using profile::ErrorProfile;
using profile::ProfileOptions;
using profile::RateProfile;
using profile::SchemeCounts;
using profile::SchemeKind;
using profile::SchemeLanes;
using scene::Scene;

struct Truth {
  Verdict reference, real;
};

std::vector<Truth> truths(const Scene& scene, const Comparisons& data) {
  const TypedGraph reference = reference_graph(scene.graph, scene.reference);
  std::vector<Truth> result;
  std::vector<Bits> operands(data.input_count());
  for (std::uint64_t index = 0; index < data.size(); ++index) {
    data.fetch(index, operands);
    result.push_back({evaluate_reference(reference, operands),
                      true_verdict(scene.graph, scene.reference.format, operands).value()});
  }
  return result;
}

/// The verdict that the lane would give without its error bound.
Verdict order_of_parts(const Lane& lane, const std::vector<Bits>& operands) {
  return evaluate_reference(design::float_lane(lane).graph, operands);
}

golden::LaneResult decision_of_lane(const Lane& lane, const std::vector<Bits>& operands) {
  return std::visit([&](const auto& made) { return evaluate_lane(made, operands); }, lane);
}

SchemeCounts golden_counts(SchemeKind kind, const Lane& lane, const Comparisons& data,
                           const std::vector<Truth>& truth) {
  SchemeCounts counts{.exists = true};
  std::vector<Bits> operands(data.input_count());
  for (std::uint64_t index = 0; index < data.size(); ++index) {
    data.fetch(index, operands);
    Verdict verdict = truth[index].reference;
    bool by_lane = true;
    if (kind == SchemeKind::lanes_alone) {
      verdict = order_of_parts(lane, operands);
    } else if (const auto result = decision_of_lane(lane, operands); result.decided) {
      verdict = result.verdict;
    } else {
      ++counts.undecided;
      by_lane = false;
    }
    if (verdict == truth[index].real) continue;
    ++counts.wrong;
    counts.wrong_by_lane += by_lane ? 1 : 0;
    EXPECT_FALSE(by_lane && kind == SchemeKind::certified) << "comparison " << index;
  }
  return counts;
}

void expect_golden(const Scene& scene, const Comparisons& data, const ErrorProfile& errors,
                   const RateProfile& profile, const std::string& what) {
  const std::vector<Truth> truth = truths(scene, data);
  const auto wrong = std::count_if(truth.begin(), truth.end(),
                                   [](const Truth& t) { return t.reference != t.real; });
  EXPECT_EQ(profile.reference_wrong, static_cast<std::uint64_t>(wrong)) << what;
  const bool are_pairs =
      data.pairing() == data::Pairing::all || data.pairing() == data::Pairing::cross;
  ASSERT_EQ(profile.pairs != nullptr, are_pairs) << what;
  for (std::size_t k = 0; profile.pairs && k < truth.size(); ++k) {
    const bool is_reported = scene.system.engine.report.contains(truth[k].real);
    EXPECT_EQ(profile.pairs->reported[k / 64] >> k % 64 & 1, is_reported ? 1u : 0u)
        << what << ": " << k;
  }
  const std::vector<SchemeLanes> schemes = make_schemes(scene, errors);
  ASSERT_EQ(profile.schemes.size(), schemes.size());
  for (std::size_t s = 0; s < schemes.size(); ++s) {
    ASSERT_EQ(profile.schemes[s].counts.size(), schemes[s].lanes.size());
    for (std::size_t k = 0; k < schemes[s].lanes.size(); ++k) {
      const SchemeCounts& got = profile.schemes[s].counts[k];
      const auto& lane = schemes[s].lanes[k];
      const SchemeCounts expected =
          lane ? golden_counts(schemes[s].kind, *lane, data, truth) : SchemeCounts{};
      EXPECT_EQ(got, expected) << what << ": " << schemes[s].name
                               << " at L = " << errors.precisions[k].precision << ": undecided "
                               << got.undecided << ", expected " << expected.undecided << "; wrong "
                               << got.wrong << ", expected " << expected.wrong;
    }
  }
}

ProfileOptions options_of(int first, int last) {
  return {.first_precision = first, .last_precision = last, .error_samples = 200, .threads = 1};
}

/// The profile, held against the golden model.
RateProfile checked_profile(const Scene& scene, const Comparisons& data, LaneInputs inputs,
                            const ProfileOptions& options, const std::string& what) {
  const ErrorProfile errors = profile_errors(scene, data, {inputs}, options).front();
  RateProfile profile = profile_rates(scene, data, errors, options);
  expect_golden(scene, data, errors, profile, what);
  return profile;
}

const FloatFormat binary64 = format_of(53, 11);

Arithmetic nearest(FloatFormat format) {
  return {format, Rounding::nearest_even, Subnormals::flush};
}

Comparisons spheres(const Scene& scene, std::size_t count, double radius_max) {
  data::Table table = data::uniform_spheres(
      {.count = count, .side = 100, .radius_max = radius_max, .seed = 5}, scene.reference.format);
  return Comparisons::all_pairs(std::move(table), scene.graph.inputs()).value();
}

const FloatFormat sphere_format = format_of(53, 8);

Scene sphere_scene() {
  Scene scene = scene_of(sphere_graph(), sphere_format, nearest(format_of(8, 8)));
  for (auto& range : scene.ranges) range = Range{0, 100};
  return scene;
}

TEST(Rates, OfAllPairsOfSpheresAreTheGoldenModels) {
  const Scene scene = sphere_scene();
  for (const LaneInputs inputs :
       {LaneInputs::exact, LaneInputs::of_digits(20), LaneInputs::rounded}) {
    const RateProfile profile = checked_profile(scene, spheres(scene, 40, 40), inputs,
                                                options_of(4, 52), to_string(inputs));
    // The data is such that dropping nothing would be noticed.
    const std::uint64_t all = profile.comparisons * 49 * 6;
    EXPECT_LT(profile.emulated, all / 4);
    EXPECT_LT(profile.true_verdicts, profile.comparisons / 100);
  }
}

/// Two tables in every pairing that has some; spheres of the second may break the ranges.
TEST(Rates, OfTwoTablesAreTheGoldenModels) {
  const Scene scene = sphere_scene();
  const FloatFormat format = scene.reference.format;
  const auto table = [&](std::size_t count, double side, std::uint64_t seed) {
    return data::uniform_spheres({.count = count, .side = side, .radius_max = 40, .seed = seed},
                                 format);
  };
  const std::vector<std::string>& inputs = scene.graph.inputs();
  checked_profile(scene, Comparisons::cross(table(20, 100, 1), table(25, 130, 2), inputs).value(),
                  LaneInputs::exact, options_of(4, 30), "cross");
  Scene nearest_centre = scene;
  nearest_centre.graph = graph_of("(cx - cxi)^2 + (cy - cyi)^2", "(cx - cxj)^2 + (cy - cyj)^2");
  nearest_centre.ranges.assign(6, Range{0, 100});
  const auto compare =
      workload::compare_by_reference(reference_graph(nearest_centre.graph, {format}));
  const auto data = Comparisons::arg_min(table(40, 100, 3), table(9, 130, 4),
                                         nearest_centre.graph.inputs(), compare);
  checked_profile(nearest_centre, data.value(), LaneInputs::exact, options_of(4, 30), "arg_min");
}

TEST(Rates, CallNobodyWrongWhereTheTruthIsUndetermined) {
  const auto [f, g] = unproven_tie();
  const Scene scene = scene_of(graph_of(f, g), format_of(53, 8), nearest(format_of(8, 8)));
  std::vector<Bits> operands;
  for (int k = 0; k < 10; ++k) {
    for (const int n : {k + 2, 3 * k + 1}) {
      operands.push_back(from_rational(scene.reference.format, mpq_class(n, 7)));
    }
  }
  const Comparisons data = rows_of(scene.graph, scene.reference.format, operands);
  const ProfileOptions options = options_of(8, 12);
  const ErrorProfile errors = profile_errors(scene, data, {LaneInputs::exact}, options).front();
  const RateProfile profile = profile_rates(scene, data, errors, options);
  EXPECT_EQ(profile.comparisons, 10u);
  EXPECT_EQ(profile.true_verdicts, 10u);
  EXPECT_EQ(profile.undetermined, 10u);
  EXPECT_EQ(profile.reference_wrong, 0u);
  for (const auto& scheme : profile.schemes) {
    for (const SchemeCounts& counts : scheme.counts) EXPECT_EQ(counts.wrong, 0u) << scheme.name;
  }
  const report::ProfileReport report{.scene = "tie",
                                     .reference = {.floating = scene.reference.format},
                                     .comparisons = 10,
                                     .rates = {profile}};
  EXPECT_NE(report::to_text(report).find("the truth is undetermined of 10"), std::string::npos);
  EXPECT_EQ(report::to_json(report)["recomputation_rates"][0]["truth_undetermined"], 10);
}

Result<data::Table> pairs_of(const std::string& family) {
  return data::sphere_family({.name = family, .count = 8, .seed = 3}, sphere_format);
}

/// The families that sphere_format holds; of near ties, those at precisions that end with 4 or 7.
std::vector<std::string> hard_families() {
  std::vector<std::string> names = data::sphere_family_names();
  std::erase_if(names, [](const std::string& name) {
    const bool aimed = name.ends_with("4") || name.ends_with("7");
    return (name.starts_with("near_tie_") && !aimed) || !pairs_of(name).ok();
  });
  return names;
}

class RatesOfInputs : public testing::TestWithParam<std::tuple<LaneInputs, std::string>> {};

TEST_P(RatesOfInputs, OnHardFamiliesAreTheGoldenModels) {
  const auto& [inputs, name] = GetParam();
  const Scene scene = sphere_scene();
  const Comparisons data = Comparisons::rows(pairs_of(name).value(), scene.graph.inputs()).value();
  checked_profile(scene, data, inputs, options_of(4, 52), name);
}

INSTANTIATE_TEST_SUITE_P(Inputs, RatesOfInputs,
                         testing::Combine(testing::Values(LaneInputs(LaneInputs::exact),
                                                          LaneInputs::of_digits(20),
                                                          LaneInputs(LaneInputs::rounded)),
                                          testing::ValuesIn(hard_families())));

/// One of `expressions`, by its place.
class RatesOfExpressions : public testing::TestWithParam<std::size_t> {};

/// Every expression on every family of operands, formats and roundings drawn.
TEST_P(RatesOfExpressions, AreTheGoldenModels) {
  std::mt19937_64 random(11 + GetParam());
  const auto& [f, g] = expressions[GetParam()];
  const std::vector<FloatFormat> references = {binary64, format_of(53, 8), format_of(24, 8),
                                               format_of(37, 6)};
  for (const Family family : all_families) {
    const FloatFormat reference = references[random() % references.size()];
    const int exponent_bits = 5 + static_cast<int>(random() % 4);
    const auto arithmetics = every_arithmetic(format_of(8, exponent_bits));
    const Arithmetic reduced = arithmetics[random() % arithmetics.size()];
    Scene scene = scene_of(graph_of(f, g), reference, reduced);
    if (random() % 2 == 0) {
      for (auto& range : scene.ranges) range = Range{0, 4};
    }
    const int first = 4 + static_cast<int>(random() % 4);
    const int last =
        std::min(reference.precision() - 1, first + 7 + static_cast<int>(random() % 36));
    const LaneInputs inputs = any_inputs(first, last, random);
    const std::string what =
        fmt::format("{} against {}, family {}, reference {}, lanes e{} {} {}, {} inputs", f, g,
                    static_cast<int>(family), reference.name(), exponent_bits,
                    to_string(reduced.rounding), to_string(reduced.subnormals), to_string(inputs));
    checked_profile(scene, random_rows(scene, family, 60, random), inputs, options_of(first, last),
                    what);
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Expressions, RatesOfExpressions,
                         testing::Range<std::size_t>(0, expressions.size()));

/// Both are normal numbers and their order is plain, but their difference is flushed: the lane that
/// subtracts them cannot decide, however many digits it has.
TEST(Rates, CountDifferencesThatUnderflow) {
  std::mt19937_64 random(13);
  const FloatFormat lane = format_of(8, 5);
  const Arithmetic reduced{lane, Rounding::nearest_even, Subnormals::flush};
  const Scene scene = scene_of(graph_of("a", "b"), format_of(53, 8), reduced);
  const Comparisons data = random_rows(scene, Family::lowest, 200, random);
  const RateProfile profile =
      checked_profile(scene, data, LaneInputs::exact, options_of(4, 40), "lowest");
  const auto running = std::find_if(profile.schemes.begin(), profile.schemes.end(),
                                    [](const auto& scheme) { return scheme.name == "running_4"; });
  ASSERT_NE(running, profile.schemes.end());
  EXPECT_GT(running->counts.back().undecided, 10u);
}

/// Ties stay open through every band, near ties for some. In this order the second band passes on
/// nearly two blocks at once, where the third one's queue holds nearly one.
TEST(Rates, OfBlocksThatFillTheQueuesOfAllBandsAreThoseOfOneByOne) {
  const auto block = static_cast<int>(profile::RateWorker::block);
  const FloatFormat format = format_of(53, 8);
  const Scene scene = scene_of(graph_of("x * x", "y * y"), format, {format_of(8, 8)});
  const auto number = [&](double value) { return from_double(format, value); };
  std::vector<Bits> values;
  const auto add = [&](double x, double y, int count) {
    for (int k = 0; k < count; ++k) values.insert(values.end(), {number(x), number(y)});
  };
  const double tie = 1.1, near = 1.11, far = 100.3;
  add(tie, tie, block - 1), add(tie, far, 1);
  add(tie, near, 1), add(tie, far, block - 1);
  add(tie, tie, block - 1), add(tie, far, 1);
  add(tie, tie, block);
  const Comparisons data = rows_of(scene.graph, format, values);
  ProfileOptions options{.error_samples = 100, .threads = 1};
  const ErrorProfile errors = profile_errors(scene, data, {LaneInputs::exact}, options).front();
  const RateProfile fast = profile_rates(scene, data, errors, options);
  options.method = profile::ProfileMethod::brute_force;
  options.threads = 2;
  const RateProfile slow = profile_rates(scene, data, errors, options);
  for (std::size_t scheme = 0; scheme < fast.schemes.size(); ++scheme) {
    const auto &one = fast.schemes[scheme].counts, &other = slow.schemes[scheme].counts;
    for (std::size_t k = 0; k < one.size(); ++k) {
      EXPECT_EQ(one[k].undecided, other[k].undecided) << fast.schemes[scheme].name << " " << k;
      EXPECT_EQ(one[k].wrong, other[k].wrong) << fast.schemes[scheme].name << " " << k;
    }
  }
}

TEST(Rates, DoNotDependOnThreadsOrMethod) {
  const Scene scene = sphere_scene();
  const Comparisons data = spheres(scene, 300, 60);
  const ErrorProfile errors =
      profile_errors(scene, data, {LaneInputs::rounded}, options_of(4, 20)).front();
  const auto counts = [&](ProfileOptions options) {
    options.first_precision = 4;
    options.last_precision = 20;
    const RateProfile profile = profile_rates(scene, data, errors, options);
    std::vector<std::vector<SchemeCounts>> all;
    for (const auto& scheme : profile.schemes) all.push_back(scheme.counts);
    return all;
  };
  const auto one = counts({.threads = 1});
  EXPECT_EQ(counts({.threads = 3}), one);
  EXPECT_EQ(counts({.threads = 2, .method = profile::ProfileMethod::brute_force}), one);
}

/// One of seven comparisons, each from another seven of the data.
TEST(Rates, OfASampleAreThoseOfItsComparisons) {
  const Scene scene = sphere_scene();
  const Comparisons data = spheres(scene, 60, 40);
  ProfileOptions options = options_of(4, 20);
  const ErrorProfile errors = profile_errors(scene, data, {LaneInputs::exact}, options).front();
  options.stretch = 7;
  options.method = profile::ProfileMethod::brute_force;  // asks for every true verdict
  const RateProfile sampled = profile_rates(scene, data, errors, options);
  const data::OperandSource source(data);
  const profile::RateJob job{
      .scene = scene,
      .source = source,
      .method = options.method,
      .schemes = {},
      .bands = {},
      .reference = emulator::Emulator(reference_graph(scene.graph, scene.reference)),
      .failing = {},
      .stretch = options.stretch};
  ASSERT_EQ(job.counted(), (data.size() + 6) / 7);
  std::vector<Bits> rows, operands(data.input_count());
  std::set<std::uint64_t> places;
  for (std::uint64_t k = 0; k < job.counted(); ++k) {
    const std::uint64_t comparison = job.comparison(k);
    ASSERT_EQ(comparison / 7, k);
    ASSERT_LT(comparison, data.size());
    places.insert(comparison % 7);
    data.fetch(comparison, operands);
    rows.insert(rows.end(), operands.begin(), operands.end());
  }
  EXPECT_EQ(places.size(), 7u);
  options.stretch = 1;
  const Comparisons alone = rows_of(scene.graph, scene.reference.format, rows);
  const RateProfile expected = profile_rates(scene, alone, errors, options);
  EXPECT_EQ(sampled.comparisons, expected.comparisons);
  EXPECT_EQ(sampled.pairs, nullptr);
  for (std::size_t k = 0; k < expected.schemes.size(); ++k) {
    EXPECT_EQ(sampled.schemes[k].counts, expected.schemes[k].counts) << expected.schemes[k].name;
  }
}

/// Rows of integers, half of them such that f and g are equal or one apart. Factors have 14 digits.
std::vector<Bits> nearly_equal_products(FloatFormat format, int rows) {
  std::mt19937_64 random(3);
  const auto number = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  const auto factor = [&] {
    return number(0, 1) == 0 ? number(8193, 16383) : -number(8193, 16383);
  };
  std::vector<Bits> values;
  const auto add = [&](const std::vector<int>& row) {
    for (const int value : row) values.push_back(from_rational(format, mpq_class(value)));
  };
  for (int row = 0; row < rows; ++row) {
    const int a = factor(), b = factor(), c = factor(), d = factor();
    const int near = row % 4;
    if (near == 0) add({a, b, c, d, d, c, b, a, 0});
    if (near == 1) add({a, b, c, d, d, c, b, a, number(-1, 1)});
    if (near > 1) add({a, b, c, d, factor(), c, b, near == 2 ? a : -d, 0});
  }
  return values;
}

/// f and g have 53 to 56 digits, so double holds few of them.
TEST(Rates, OfLongProductsOfIntegersAreTheGoldenModels) {
  const FloatFormat format = format_of(64, 11);
  Scene scene = scene_of(graph_of("a * b * c * d", "h * k * m * n + p"), format, {format_of(8, 8)});
  scene.operand_formats.assign(9, *OperandFormat::parse("int15"));
  scene.ranges.assign(9, Range{-16384, 16383});
  scene.grids.assign(9, mpq_class(1));
  const Comparisons data = rows_of(scene.graph, format, nearly_equal_products(format, 400));
  const RateProfile profile =
      checked_profile(scene, data, LaneInputs::exact, options_of(8, 24), "integers");
  EXPECT_EQ(profile.reference_wrong, 0u);
  EXPECT_GE(profile.true_verdicts, 150u) << "doubles cannot tell these";
  ASSERT_TRUE(profile::check_profile(scene, options_of(8, 24)).ok());
  scene.operand_formats[3] = *OperandFormat::parse("int60");
  EXPECT_EQ(profile::check_profile(scene, options_of(8, 24)).error().accepted,
            "operands in fixed point of at most 53 digits");
  scene.operand_formats[3] = *OperandFormat::parse("int15");
  scene.graph = graph_of("a * b * c * d / 3", "h * k * m * n + p");
  EXPECT_NE(profile::check_profile(scene, options_of(8, 24))
                .error()
                .message.find("a reference for operands in fixed point is an exact lane"),
            std::string::npos);
}

/// The fast way looks at each part by itself, and separately at the parts that outweigh others.
class RatesOfParts : public testing::TestWithParam<Combination> {};

TEST_P(RatesOfParts, AreTheGoldenModels) {
  std::mt19937_64 random(11);
  const std::vector<std::pair<std::string, std::string>> parts = {
      {"max(a, b)", "min(c, d)"}, {"(a - b)^2", "c * d"}, {"b - c", "d - a"}};
  const Combination combination = GetParam();
  for (const Family family : all_families) {
    Scene scene =
        scene_of(graph_of(parts, combination), format_of(53, 8), nearest(format_of(8, 8)));
    scene.reduced.fixed_point = FixedPoint{.bits = 8, .is_block = true, .guard_digits = 2};
    if (family == Family::uniform) {
      for (auto& range : scene.ranges) range = Range{1, 2};
    }
    const Comparisons data = random_rows(scene, family, 300, random);
    const auto what =
        fmt::format("{}, family {}", to_string(combination), static_cast<int>(family));
    for (const LaneInputs inputs : {LaneInputs::exact, LaneInputs::rounded}) {
      const RateProfile fast = checked_profile(scene, data, inputs, options_of(6, 16), what);
      ProfileOptions slowly = options_of(6, 16);
      slowly.method = profile::ProfileMethod::brute_force;
      const RateProfile slow = checked_profile(scene, data, inputs, slowly, what);
      if (family == Family::uniform) {
        EXPECT_LT(fast.emulated, slow.emulated / 2) << what;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Combinations, RatesOfParts,
                         testing::Values(Combination::all, Combination::any));

/// A comparison that lanes in fixed point decide by norms, of inputs in [0, 4), and how far the
/// roots of f and g are apart; that grows with the last input.
struct Norms {
  const char *f, *g;
  double (*apart)(const std::vector<double>& x);
};
const Norms norms[] = {
    {"a^2 + b^2", "c^2", [](const auto& x) { return x[2] - std::hypot(x[0], x[1]); }},
    {"(a - 4)^2", "(b + c)^2", [](const auto& x) { return x[1] + x[2] - std::fabs(4 - x[0]); }},
    {"a^2", "b^2 + c^2", [](const auto& x) { return std::hypot(x[1], x[2]) - x[0]; }},
    {"a^2 + b^2", "c^2 + d^2",
     [](const auto& x) { return std::hypot(x[2], x[3]) - std::hypot(x[0], x[1]); }},
    {"(a - b)^2 + b^2", "c^2 + d^2",
     [](const auto& x) { return std::hypot(x[2], x[3]) - std::hypot(x[0] - x[1], x[1]); }}};

/// Operands whose last one is moved to a tie and then off it, by a distance of any magnitude.
std::vector<double> near_tie(const Norms& norm, std::size_t inputs, std::mt19937_64& random) {
  const auto fraction = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<double> x(inputs);
  const int scale = 2 - static_cast<int>(random() % 8);
  for (double& operand : x) operand = std::ldexp(fraction(), scale);
  double low = 0, high = 4;
  for (int step = 0; step < 60; ++step) {
    x.back() = (low + high) / 2;
    (norm.apart(x) < 0 ? low : high) = x.back();
  }
  const double off = std::ldexp(fraction() - 0.5, 3 - static_cast<int>(random() % 8));
  x.back() = std::clamp(x.back() + off, 0.0, 3.99);
  return x;
}

/// Most comparisons are far from a tie: where many are open, all are run, and no count would tell
/// which of them should have been.
TEST(Rates, OfLanesThatDecideByNormsAreTheGoldenModels) {
  std::mt19937_64 random(14);
  const FloatFormat format = format_of(53, 8);
  for (const Norms& norm : norms) {
    Scene scene = scene_of(graph_of(norm.f, norm.g), format, nearest(format_of(8, 8)));
    for (auto& range : scene.ranges) range = Range{0, 4};
    scene.reduced.fixed_point = FixedPoint{.bits = 8, .guard_digits = 3};
    std::vector<Bits> values;
    for (int row = 0; row < 4000; ++row) {
      std::vector<double> operands(scene.ranges.size(), 0.0);
      operands.back() = 3.99;
      if (row % 5 == 0) operands = near_tie(norm, scene.ranges.size(), random);
      for (const double operand : operands) {
        values.push_back(from_double(format, operand));
      }
    }
    const Comparisons data = rows_of(scene.graph, format, values);
    const RateProfile profile =
        checked_profile(scene, data, LaneInputs::exact, options_of(4, 12), norm.g);
    const auto has = [&](const char* name) {
      return std::any_of(profile.schemes.begin(), profile.schemes.end(), [&](const auto& scheme) {
        return scheme.name == name && scheme.counts.back().exists;
      });
    };
    EXPECT_TRUE(has("fixed_norm")) << norm.g;
    EXPECT_TRUE(has("fixed_norm_g3")) << norm.g;
  }
}

/// In block floating point the operands of one part set the unit of the others.
TEST(Rates, OfPartsWithOperandsOfTheirOwnAreTheGoldenModels) {
  std::mt19937_64 random(12);
  const FloatFormat format = format_of(53, 8);
  const Scene scene = scene_of(graph_of({{"a^2", "b^2"}, {"c", "d"}}, Combination::any), format,
                               nearest(format_of(8, 8)));
  std::vector<Bits> values;
  for (int row = 0; row < 400; ++row) {
    for (const double scale : {1.0, 1.0, 1000.0, 1000.0}) {
      const double number = 1 + static_cast<double>(random() % 512) / 512;
      values.push_back(from_double(format, row % 2 == 0 ? number : number * scale));
    }
  }
  const Comparisons data = rows_of(scene.graph, format, values);
  const RateProfile profile =
      checked_profile(scene, data, LaneInputs::exact, options_of(6, 24), "parts of their own");
  const auto block = std::find_if(profile.schemes.begin(), profile.schemes.end(),
                                  [](const auto& scheme) { return scheme.name == "block_norm"; });
  ASSERT_NE(block, profile.schemes.end());
  EXPECT_GT(block->counts.front().undecided, 100u);
}

/// f and g are at 2^-560 and above, and so is the power of two that scales a threshold: their
/// product is no double.
TEST(Rates, InBlocksOfTinyOperandsAreTheGoldenModels) {
  std::mt19937_64 random(13);
  const Scene scene = scene_of(graph_of("a^2 + b^2", "c^2"), binary64, nearest(format_of(8, 11)));
  std::vector<Bits> values;
  for (int row = 0; row < 400; ++row) {
    const double a = 3 + static_cast<double>(random() % 64) / 4096;
    for (const double number : {a, 4.0, 5 + static_cast<double>(random() % 64) / 4096}) {
      values.push_back(from_double(binary64, std::ldexp(number, -280)));
    }
  }
  const Comparisons data = rows_of(scene.graph, binary64, values);
  checked_profile(scene, data, LaneInputs::exact, options_of(6, 24), "tiny operands");
}

}  // namespace
}  // namespace mixcmp::test::rates_test
