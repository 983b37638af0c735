#include "model/plan/profile/profiled_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>

#include "model/base/number/exact.hpp"
#include "model/lane/error/profiled_lane.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

namespace mixcmp::test::profiled_error_test {
namespace {

using data::Comparisons;
using error::IntervalCriterion;
using error::Lane;
using error::ProfiledError;

const FloatFormat wide = format_of(53, 11);
const FloatFormat narrow = format_of(5, 6);

/// Comparisons whose rows have these a and b.
Comparisons rows(const std::vector<std::pair<mpq_class, mpq_class>>& values) {
  data::Table table{.format = wide, .columns = {"a", "b"}};
  for (const auto& [a, b] : values) {
    table.values.push_back(from_rational(wide, a));
    table.values.push_back(from_rational(wide, b));
  }
  return Comparisons::rows(std::move(table), {"a", "b"}).value();
}

TypedGraph typed(const Graph& graph, Subnormals subnormals = Subnormals::gradual) {
  const Arithmetic arithmetic{narrow, Rounding::nearest_even, subnormals};
  return lane_graph(graph, wide, arithmetic, LaneInputs::rounded);
}

ProfiledError profile(const Comparisons& data, std::uint64_t count, std::uint64_t seed = 1) {
  const Graph graph = graph_of("a^2", "a + b");
  return profile::profile_error(graph, typed(graph), data, count, seed);
}

TEST(ProfileError, IsTheLargestRelativeErrorOfEach) {
  // In s5: 33/32 rounds to 1, 1 to itself; (33/32)^2 = 1089/1024 against 1, 33/32 + 1 against 2.
  const ProfiledError error = profile(rows({{1, 1}, {mpq_class(33, 32), 1}, {1, 2}}), 100);
  EXPECT_EQ(error.comparisons, 3u);
  const mpq_class f = mpq_class(1089, 1024), g = mpq_class(65, 32);
  const mpq_class hair(1, mpz_class(1) << 60);
  EXPECT_GE(error.f, (f - 1) / f);
  EXPECT_LE(error.f, (f - 1) / f + hair);
  EXPECT_GE(error.g, (g - 2) / g);
  EXPECT_LE(error.g, (g - 2) / g + hair);
}

TEST(ProfileError, SkipsZeroAndWhatIsNotFinite) {
  const ProfiledError none = profile(rows({{0, 0}, {1, -1}}), 100);
  EXPECT_EQ(none.f, 0);
  EXPECT_EQ(none.g, 0);
  EXPECT_EQ(none.f_unbounded, 0u);
  // The square overflows s5e6; the sum, 2^31 + 2^26 against 2^31, is measured.
  const mpz_class large = mpz_class(1) << 31;
  const ProfiledError overflow = profile(rows({{large, mpz_class(1) << 26}}), 100);
  EXPECT_EQ(overflow.f, 0);
  EXPECT_EQ(overflow.f_unbounded, 1u);
  EXPECT_EQ(overflow.g_unbounded, 0u);
  EXPECT_GT(overflow.g, 0);
}

TEST(ProfileError, MeasuresEachComparisonAtMostOnce) {
  // Every row has its own error: a hundred draws with replacement would miss the largest of a
  // hundred for a third of the seeds.
  std::vector<std::pair<mpq_class, mpq_class>> values;
  for (int k = 0; k < 100; ++k) values.emplace_back(mpq_class(3200 + k, 3200), 1);
  const Comparisons data = rows(values);
  const ProfiledError all = profile(data, 100);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    EXPECT_EQ(profile(data, 100, seed).f, all.f);
    EXPECT_EQ(profile(data, 100, seed).comparisons, 100u);
  }
}

TEST(ProfileError, SamplesBySeed) {
  std::vector<std::pair<mpq_class, mpq_class>> values;
  for (int k = 0; k < 100; ++k) values.emplace_back(mpq_class(3200 + k, 3200), 1);
  const Comparisons data = rows(values);
  std::set<std::string> maxima;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const ProfiledError error = profile(data, 5, seed);
    EXPECT_EQ(error.comparisons, 5u);
    EXPECT_EQ(error.f, profile(data, 5, seed).f) << "the same seed, the same sample";
    EXPECT_LE(error.f, profile(data, 100).f);
    maxima.insert(error.f.get_str());
  }
  EXPECT_GT(maxima.size(), 5u);
}

TEST(ProfiledLane, AppendsThePapersErrorUnit) {
  const Lane lane =
      error::profiled_lane(typed(graph_of("a^2", "a + b")), mpq_class(1, 8), mpq_class(1, 4));
  ASSERT_FALSE(lane.certified());
  std::string operations;
  for (const TypedNode& node : lane.graph.nodes) {
    operations += to_string(node.operation);
    operations += ' ';
  }
  // f is a square and needs no absolute, g may be negative.
  EXPECT_EQ(operations,
            "input convert square input convert add "
            "subtract constant multiply absolute constant multiply add subtract add ");
  const auto& criterion = std::get<IntervalCriterion>(lane.criterion());
  EXPECT_EQ(criterion.maximum, static_cast<int>(lane.graph.nodes.size()) - 1);
  EXPECT_EQ(criterion.minimum, criterion.maximum - 1);
}

TEST(ProfiledLane, RoundsItsConstantsUp) {
  const auto constant = [](const mpq_class& value, Subnormals subnormals) {
    const Lane lane = error::profiled_lane(typed(graph_of("a^2", "b^2"), subnormals), value, 0);
    const auto node =
        std::find_if(lane.graph.nodes.begin(), lane.graph.nodes.end(),
                     [](const TypedNode& each) { return each.operation == Operation::constant; });
    return to_rational(narrow, node->constant);
  };
  EXPECT_EQ(constant(mpq_class(1, 8), Subnormals::flush), mpq_class(1, 8));
  EXPECT_EQ(constant(mpq_class(1, 10), Subnormals::flush), mpq_class(13, 128));
  EXPECT_EQ(constant(mpq_class(33, 32), Subnormals::flush), mpq_class(17, 16));
  const mpq_class smallest_normal(1, mpz_class(1) << 30);
  EXPECT_EQ(constant(smallest_normal / 1000, Subnormals::flush), smallest_normal);
  EXPECT_EQ(constant(smallest_normal / 1000, Subnormals::gradual), smallest_normal / 16);
  EXPECT_EQ(constant(0, Subnormals::flush), 0);
}

}  // namespace
}  // namespace mixcmp::test::profiled_error_test
