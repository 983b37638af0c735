#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "model/error/relative_bound.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/sphere.hpp"

/// Gappa, which knows nothing of our rules, proves the bounds of the sphere comparison.
namespace mixcmp::test {
namespace {

using model::RelativeBound;

bool gappa_is_there() {
  return std::system("gappa --version > /dev/null 2>&1") == 0;
}

/// Whether Gappa proves every property of the script. Without dichotomy: a bound that does not
/// follow at once would be searched for hours.
bool proves(const std::string& script) {
  const char* command = "timeout 10 gappa -Eprecision=512 -Edichotomy=0 > /dev/null 2>&1";
  FILE* gappa = popen(command, "w");
  if (gappa == nullptr) return false;
  std::fwrite(script.data(), 1, script.size(), gappa);
  return pclose(gappa) == 0;
}

/// A dyadic rational as Gappa writes it.
std::string dyadic(const mpq_class& value) {
  return fmt::format("{}b-{}", value.get_num().get_str(),
                     mpz_sizeinbase(value.get_den_mpz_t(), 2) - 1);
}

mpq_class power(const mpq_class& base, int exponent) {
  return exponent == 0 ? mpq_class(1) : mpq_class(base * power(base, exponent - 1));
}

/// computed = true * (1 + e) with e in this interval, after `count` roundings to nearest.
struct RelativeError {
  mpq_class low;
  mpq_class high;
};

RelativeError after(int count, int precision) {
  const mpq_class u(1, mpz_class(1) << precision);
  return {power(1 - u, count) - 1, power(1 + u, count) - 1};
}

/// The same, seen from the computed value.
RelativeBound bound(const RelativeError& error) {
  return {1 / (1 + error.high), 1 / (1 + error.low)};
}

/// f before its last rounding, with the coordinates of `axes` different from zero: Gappa's relative
/// errors do not reach through zero.
std::string sum_script(int precision, const std::string& axes, const RelativeError& error) {
  std::string script = fmt::format("@rnd = float<{}, {}, ne>;\n", precision, -125 - precision);
  std::string sum, truth, ranges;
  for (const char axis : axes) {
    script += fmt::format("s{0} = rnd(rnd({0}) * rnd({0}));\n", axis);
    sum = sum.empty() ? fmt::format("s{}", axis) : fmt::format("rnd({}) + s{}", sum, axis);
    truth += fmt::format("{0}{1} * {1}", truth.empty() ? "" : " + ", axis);
    ranges += fmt::format("{}|{}| in [1b-60, 1b60]", ranges.empty() ? "" : " /\\ ", axis);
  }
  return script + fmt::format("f = {};\nF = {};\n{{ {} -> f -/ F in [{}, {}] }}\n", sum, truth,
                              ranges, dyadic(error.low), dyadic(error.high));
}

std::string square_script(int precision, const RelativeError& error) {
  return fmt::format(
      "@rnd = float<{}, {}, ne>;\nr = rnd(R);\ng = r * r;\nG = R * R;\n"
      "{{ |R| in [1b-60, 1b60] -> g -/ G in [{}, {}] }}\n",
      precision, -125 - precision, dyadic(error.low), dyadic(error.high));
}

class Gappa : public testing::TestWithParam<int> {
protected:
  void SetUp() override {
    if (!gappa_is_there()) GTEST_SKIP() << "gappa is not installed";
  }
};

TEST_P(Gappa, ProvesTheBoundsOfTheSphere) {
  const int precision = GetParam();
  for (const char* axes : {"x", "y", "z", "xy", "xz", "yz", "xyz"}) {
    EXPECT_TRUE(proves(sum_script(precision, axes, after(4, precision)))) << axes;
  }
  EXPECT_TRUE(proves(square_script(precision, after(2, precision))));
}

TEST_P(Gappa, CannotProveLess) {
  const int precision = GetParam();
  EXPECT_FALSE(proves(sum_script(precision, "xyz", after(3, precision))));
  EXPECT_FALSE(proves(square_script(precision, after(1, precision))));
}

TEST_P(Gappa, ArrivesAtTheLanesGuard) {
  const int precision = GetParam();
  const model::Lane lane = sphere_design(format_of(precision, 8), format_of(53, 8), 1, 1).lane;
  EXPECT_EQ(std::get<model::UlpDistanceDecision>(lane.decision).guard_ulp,
            model::guard_ulp_before_rounding(bound(after(4, precision)), bound(after(2, precision)),
                                             precision));
}

INSTANTIATE_TEST_SUITE_P(Precisions, Gappa, testing::Values(4, 8, 17, 24, 52),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace mixcmp::test
