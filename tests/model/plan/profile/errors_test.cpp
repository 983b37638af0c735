#include <gtest/gtest.h>

#include "model/base/number/decimal.hpp"
#include "model/comparison/data/uniform_spheres.hpp"
#include "model/plan/profile/profiled_error.hpp"
#include "model/plan/profile/schemes.hpp"
#include "tests/model/plan/profile/profile_cases.hpp"
#include "tests/support/sphere.hpp"

namespace mixcmp::test::errors_test {
namespace {

using data::Comparisons;
using error::ProfiledError;
using profile::ErrorProfile;
using profile::ProfileOptions;
using scene::Scene;

/// Expects got <= expected <= got * (1 + 2^-46).
void expect_same(const mpq_class& got, const mpq_class& expected, const std::string& what) {
  EXPECT_LE(got, expected) << what;
  EXPECT_GE(got * (1 + mpq_class(1, mpz_class(1) << 46)), expected) << what;
}

void expect_slow_profile(const Scene& scene, const Comparisons& data,
                         const ProfileOptions& options) {
  const std::vector<LaneInputs> all = {LaneInputs::rounded, LaneInputs::exact,
                                       LaneInputs::of_digits(12)};
  const std::vector<ErrorProfile> profiles = profile_errors(scene, data, all, options);
  ASSERT_EQ(profiles.size(), all.size());
  for (const ErrorProfile& profile : profiles) {
    for (const profile::ErrorAtPrecision& error : profile.precisions) {
      const TypedGraph lane = profile::graph_at(scene, error.precision, profile.inputs);
      const ProfiledError slow =
          profile::profile_error(scene.graph, lane, data, options.error_samples, 1);
      const std::string what = "L = " + std::to_string(error.precision);
      expect_same(error.f.value_or(0), slow.f, what);
      expect_same(error.g.value_or(0), slow.g, what);
      EXPECT_EQ(error.f_unbounded, slow.f_unbounded) << what;
      EXPECT_EQ(error.g_unbounded, slow.g_unbounded) << what;
      EXPECT_EQ(profile.comparisons, slow.comparisons);
    }
  }
}

Comparisons spheres(const Scene& scene, std::size_t count) {
  data::Table table = data::uniform_spheres(
      {.count = count, .side = 100, .radius_max = 30, .seed = 2}, scene.reference.format);
  return Comparisons::all_pairs(std::move(table), scene.graph.inputs()).value();
}

Scene sphere_scene() {
  const Arithmetic reduced{format_of(8, 8), Rounding::nearest_even, Subnormals::flush};
  Scene scene = scene_of(sphere_graph(), format_of(53, 11), reduced);
  for (auto& range : scene.ranges) range = Range{0, 100};
  return scene;
}

TEST(Errors, AreThoseThatMpfrFinds) {
  const Scene scene = sphere_scene();
  expect_slow_profile(
      scene, spheres(scene, 100),
      {.first_precision = 4, .last_precision = 52, .error_samples = 300, .threads = 2});
}

TEST(Errors, OfAnyExpressionAreThoseThatMpfrFinds) {
  std::mt19937_64 random(4);
  for (const auto& [f, g] : expressions) {
    for (const Family family : all_families) {
      const auto arithmetics = every_arithmetic(format_of(8, 11));
      const Scene scene = scene_of(graph_of(f, g), format_of(53, 11), arithmetics[random() % 4]);
      expect_slow_profile(scene, random_rows(scene, family, 20, random),
                          {.first_precision = 47, .last_precision = 52, .threads = 1});
    }
  }
}

TEST(Errors, StayWithinTheCertifiedBound) {
  const Scene scene = sphere_scene();
  const auto profiles = profile::profile_errors(scene, spheres(scene, 200), {LaneInputs::exact},
                                                {.error_samples = 5000, .threads = 1});
  for (const profile::ErrorAtPrecision& error : profiles.front().precisions) {
    ASSERT_TRUE(error.f_bound && error.g_bound);
    EXPECT_LE(*error.f, mpq_class(*error.f_bound));
    EXPECT_LE(*error.g, mpq_class(*error.g_bound));
    // Worst cases of 5000 samples come near: RESEARCH.md 2.
    EXPECT_GT(*error.f, mpq_class(*error.f_bound) / 3);
    EXPECT_GT(*error.g, mpq_class(*error.g_bound) / 3);
  }
}

TEST(Errors, WhatIsExactHasABoundOfZero) {
  std::mt19937_64 random(5);
  const Scene scene = scene_of(graph_of("a * b", "1"), format_of(53, 8), {format_of(8, 8)});
  const auto profiles = profile::profile_errors(
      scene, random_rows(scene, all_families[0], 20, random), {LaneInputs::exact}, {.threads = 1});
  for (const profile::ErrorAtPrecision& error : profiles.front().precisions) {
    EXPECT_GT(error.f_bound, 0.0);
    EXPECT_EQ(error.g_bound, 0.0);
  }
}

TEST(Errors, SayWhereNoBoundExists) {
  const Scene scene = sphere_scene();
  const auto profiles = profile::profile_errors(scene, spheres(scene, 20), {LaneInputs::rounded},
                                                {.error_samples = 10, .threads = 1});
  EXPECT_FALSE(profiles.front().precisions.back().f_bound);
  EXPECT_TRUE(profiles.front().precisions.back().g_bound);
  EXPECT_NE(profiles.front().no_f_bound, "");
  EXPECT_EQ(profiles.front().no_g_bound, "");
}

/// In the first case f_T needs 700 digits. In the others f_T is zero: with fewer digits the residue
/// of a rounding would be taken for it. In the last case f_L misses that zero.
TEST(Errors, AreMeasuredThroughAnyCancellation) {
  const FloatFormat wide = format_of(53, 11);
  const auto number = [&](const char* text) { return from_text(wide, text).value(); };
  struct Case {
    const char* f;
    std::vector<Bits> row;
    std::optional<mpq_class> error;
  };
  const std::vector<Bits> thirds = {number("1.1"), number("2.3"), number("3.7")};
  for (const Case& each : {Case{"(a + b) - a + c - c", {number("1e100"), number("1e-100"), 0}, 1},
                           Case{"a^16 - b^16 + c - c", {thirds[0], thirds[0], 0}, 0},
                           Case{"sqrt(a) * sqrt(b) * sqrt(c) - sqrt(a * b * c)", thirds, {}}}) {
    const Scene scene = scene_of(graph_of(each.f, "1"), wide, {format_of(9, 11)});
    const Comparisons data = rows_of(scene.graph, wide, each.row);
    const ProfileOptions options{.first_precision = 9, .last_precision = 9, .threads = 1};
    const auto profiles = profile_errors(scene, data, {LaneInputs::exact}, options);
    EXPECT_TRUE(profiles.front().precisions.front().f == each.error) << each.f;
    expect_slow_profile(scene, data, options);
  }
}

TEST(Errors, OfWhatIsInfiniteAreCountedAndMakeNoConstants) {
  const FloatFormat wide = format_of(24, 8);
  const auto number = [&](const char* text) { return from_text(wide, text).value(); };
  const Scene scene = scene_of(graph_of("a * b", "a"), wide, {format_of(8, 6)});
  const Comparisons data =
      rows_of(scene.graph, wide,
              {number("1e20"), number("1e10"), number("3e25"), number("1e11"), number("1"), 0});
  const ProfileOptions options{.first_precision = 8, .last_precision = 8, .threads = 1};
  const auto profiles = profile_errors(scene, data, {LaneInputs::rounded}, options);
  const profile::ErrorAtPrecision& error = profiles.front().precisions.front();
  EXPECT_EQ(profiles.front().comparisons, 3u);
  EXPECT_EQ(error.f_unbounded, 2u);
  EXPECT_EQ(error.g_unbounded, 2u);
  EXPECT_TRUE(error.f && error.g);
  const Comparisons infinite =
      rows_of(scene.graph, wide, {number("1e20"), number("1e10"), number("3e25"), number("1e11")});
  const ErrorProfile none = profile_errors(scene, infinite, {LaneInputs::rounded}, options).front();
  EXPECT_FALSE(none.precisions.front().f || none.precisions.front().g);
  for (const profile::SchemeLanes& scheme : make_schemes(scene, none)) {
    if (scheme.kind == profile::SchemeKind::certified) continue;
    EXPECT_EQ(scheme.exists(), scheme.kind == profile::SchemeKind::lanes_alone) << scheme.name;
  }
}

TEST(Errors, DoNotDependOnThreads) {
  const Scene scene = sphere_scene();
  const Comparisons data = spheres(scene, 200);
  const auto errors = [&](unsigned threads) {
    const auto profiles = profile::profile_errors(scene, data, {LaneInputs::rounded},
                                                  {.error_samples = 12000, .threads = threads});
    std::vector<mpq_class> all;
    for (const auto& error : profiles.front().precisions)
      all.insert(all.end(), {*error.f, *error.g});
    return all;
  };
  EXPECT_EQ(errors(1), errors(3));
}

TEST(Errors, OfSeveralPartsAreTheLargest) {
  std::mt19937_64 random(4);
  const Arithmetic reduced{format_of(8, 8), Rounding::nearest_even, Subnormals::flush};
  const std::vector<std::pair<std::string, std::string>> parts = {{"a * b", "c"},
                                                                  {"a + b * c", "a"}};
  const Scene scene = scene_of(graph_of(parts, Combination::any), format_of(53, 8), reduced);
  const Comparisons data = random_rows(scene, Family::uniform, 300, random);
  const ProfileOptions options{.first_precision = 7, .last_precision = 9, .error_samples = 300};
  const ErrorProfile profile = profile_errors(scene, data, {LaneInputs::rounded}, options).front();
  for (const profile::ErrorAtPrecision& error : profile.precisions) {
    const TypedGraph lane = profile::graph_at(scene, error.precision, profile.inputs);
    const ProfiledError one =
        profile::profile_error(scene.graph.part(0), part_of(lane, 0).graph, data, 300, 1);
    const ProfiledError other =
        profile::profile_error(scene.graph.part(1), part_of(lane, 1).graph, data, 300, 1);
    expect_same(*error.f, std::max(one.f, other.f), "f");
    expect_same(*error.g, std::max(one.g, other.g), "g");
    EXPECT_NE(other.f, one.f);
  }
  EXPECT_EQ(profile.comparisons, 300u);
}

}  // namespace
}  // namespace mixcmp::test::errors_test
