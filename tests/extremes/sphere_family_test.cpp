#include "model/comparison/data/sphere_family.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <set>

#include "model/base/number/exact.hpp"
#include "tests/extremes/sphere_families_under_test.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/sphere.hpp"

/// Each family keeps the promise of its name.
namespace mixcmp::test::sphere_family_test {
namespace {

using data::Table;

constexpr std::size_t count = 400;

/// One row as exact numbers, without the library's evaluation.
struct Pair {
  std::array<mpq_class, 8> numbers;

  mpq_class distance(std::size_t axis) const {
    return abs(numbers[2 * axis] - numbers[2 * axis + 1]);
  }
  mpq_class f() const {
    mpq_class sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) sum += distance(axis) * distance(axis);
    return sum;
  }
  mpq_class radii() const { return numbers[6] + numbers[7]; }
  mpq_class g() const { return radii() * radii(); }
  /// |f - g| / g.
  double gap() const { return mpq_class(abs(f() - g()) / g()).get_d(); }
};

std::vector<Pair> pairs_of(const Table& table) {
  std::vector<Pair> pairs(table.rows());
  for (std::size_t row = 0; row < pairs.size(); ++row) {
    for (std::size_t k = 0; k < 8; ++k) {
      pairs[row].numbers[k] = to_rational(table.format, table.at(row, k));
    }
  }
  return pairs;
}

std::vector<Pair> wide_pairs(const std::string& name, std::uint64_t seed = 1) {
  return pairs_of(family_of(name, format("s53e8"), count, seed));
}

double share_of(const std::vector<Pair>& pairs, const std::function<bool(const Pair&)>& holds) {
  const auto holding = std::count_if(pairs.begin(), pairs.end(), holds);
  return static_cast<double>(holding) / static_cast<double>(pairs.size());
}

bool is_tie(const Pair& pair) {
  return pair.f() == pair.g();
}

double share_of_encodings(const Table& table, const std::function<bool(Bits)>& holds) {
  const auto holding = std::count_if(table.values.begin(), table.values.end(), holds);
  return static_cast<double>(holding) / static_cast<double>(table.values.size());
}

std::string error_of(const std::string& name, const char* format_name) {
  const auto table = data::sphere_family({.name = name, .count = 64}, format(format_name));
  return table.ok() ? "" : table.error().to_string();
}

TEST(SphereFamily, EveryOneFitsTheUsualFormats) {
  for (const char* name : {"s53e8", "binary64", "binary128", "binary32", "bfloat16"}) {
    for (const std::string& family : data::sphere_family_names()) {
      const auto table = data::sphere_family({.name = family, .count = 20}, format(name));
      if (table.ok()) {
        EXPECT_EQ(table->rows(), 20u) << family;
        EXPECT_EQ(table->columns, sphere_graph().inputs()) << family;
      } else {
        EXPECT_NE(table.error().message.find(" digits"), std::string::npos)
            << name << ": " << table.error().to_string();
      }
    }
  }
}

TEST(SphereFamily, IsFiniteUnlessItsNameSaysOtherwise) {
  const FloatFormat wide = format("s53e8");
  for (const std::string& name : data::sphere_family_names()) {
    const double share = share_of_encodings(family_of(name, wide, 50), [&](Bits bits) {
      return wide.is_nan(bits) || wide.is_infinite(bits);
    });
    EXPECT_EQ(share > 0, name == "infinities_and_nans") << name;
  }
}

TEST(SphereFamily, RowsDependOnSeedAndNumberAlone) {
  std::set<std::vector<Bits>> known;
  for (const std::string& name : data::sphere_family_names()) {
    const Table few = family_of(name, format("s53e8"), 10);
    const Table many = family_of(name, format("s53e8"), 30);
    EXPECT_TRUE(std::equal(few.values.begin(), few.values.end(), many.values.begin())) << name;
    EXPECT_TRUE(known.insert(few.values).second) << name;
    EXPECT_TRUE(known.insert(family_of(name, format("s53e8"), 10, 2).values).second) << name;
  }
}

TEST(SphereFamily, UnknownNamesAreToldTheNearest) {
  const std::string error = error_of("tangents", "s53e8");
  EXPECT_EQ(error.find("data.family: not a family of sphere pairs: received \"tangents\"; accepted "
                       "tangent (the nearest), uniform, coincident"),
            0u)
      << error;
  EXPECT_NE(error.find("counterexample, near_tie_4 to near_tie_52"), std::string::npos) << error;
  for (const char* name :
       {"near_tie_3", "near_tie_53", "near_tie_", "near_tie_08", "near_tie_8 "}) {
    EXPECT_NE(error_of(name, "s53e8").find("not a family"), std::string::npos) << name;
  }
}

TEST(SphereFamily, NumbersBeyondTheFormatAreAnError) {
  EXPECT_EQ(error_of("offset_1e6", "binary16"),
            "data.family: offset_1e6 has numbers beyond the largest of s11e5: received "
            "\"offset_1e6\"; accepted a family of smaller numbers, or a reference of more exponent "
            "bits");
  EXPECT_EQ(error_of("offset_1e4", "binary16"), "");
  for (const char* name : {"s11e2", "s11e3", "s24e4", "s113e15", "s8e8"}) {
    for (const std::string& family : data::sphere_family_names()) {
      const std::string error = error_of(family, name);
      EXPECT_TRUE(error.empty() || error.find("data.family: " + family) == 0) << error;
    }
  }
}

TEST(SphereFamily, NearTiesOfMoreDigitsThanTheFormatAreAnError) {
  EXPECT_EQ(error_of("near_tie_12", "binary16"),
            "data.family: near_tie_12 needs operands of 12 digits: received s11e5, a reference of "
            "11; accepted a reference of 12 digits or more");
  EXPECT_EQ(error_of("near_tie_11", "binary16"), "");
  EXPECT_NE(error_of("counterexample", "bfloat16").find("needs operands of 11 digits"),
            std::string::npos);
}

TEST(SphereFamily, UniformFillsThePapersCube) {
  const auto pairs = wide_pairs("uniform");
  for (const Pair& pair : pairs) {
    for (std::size_t k = 0; k < 8; ++k) {
      ASSERT_GE(pair.numbers[k], 0);
      ASSERT_LE(pair.numbers[k], k < 6 ? 100 : 25);
    }
  }
  EXPECT_GT(share_of(pairs, [](const Pair& pair) { return pair.numbers[0] > 50; }), 0.4);
  EXPECT_GT(share_of(pairs, [](const Pair& pair) { return pair.numbers[7] > 12; }), 0.4);
}

TEST(SphereFamily, TangentTouchesExactlyOrAPlaceAside) {
  for (const char* name : {"s53e8", "binary16"}) {
    const auto pairs = pairs_of(family_of("tangent", format(name), count));
    const double ties = share_of(pairs, is_tie);
    EXPECT_GT(ties, 0.6) << name;
    EXPECT_LT(ties, 0.8) << name;
  }
  const auto nearly = [](const Pair& pair) { return pair.g() == 0 || pair.gap() < 0x1p-40; };
  EXPECT_GT(share_of(wide_pairs("tangent"), nearly), 0.98);
}

TEST(SphereFamily, CoincidentCentresAreEqual) {
  const auto pairs = wide_pairs("coincident");
  EXPECT_EQ(share_of(pairs, [](const Pair& pair) { return pair.f() == 0; }), 1);
  EXPECT_GT(share_of(pairs, is_tie), 0.15);
  const auto vanishes = [](const Pair& pair) { return pair.g() > 0 && pair.g() < 0x1p-126; };
  EXPECT_GT(share_of(pairs, vanishes), 0.15);
}

TEST(SphereFamily, NestedSpheresAreInsideOneAnother) {
  const auto inside = [](const Pair& pair) {
    const mpq_class room = pair.numbers[6] - pair.numbers[7];
    return room > 0 && pair.f() < room * room;
  };
  EXPECT_EQ(share_of(wide_pairs("nested"), inside), 1);
}

TEST(SphereFamily, OffsetsAreFarAway) {
  double away = 100;
  for (const char* name :
       {"offset_1e2", "offset_1e4", "offset_1e6", "offset_1e8", "offset_1e10", "offset_1e12"}) {
    const auto pairs = wide_pairs(name);
    for (const Pair& pair : pairs) {
      ASSERT_GE(*std::min_element(pair.numbers.begin(), pair.numbers.begin() + 6), away);
      ASSERT_LE(*std::max_element(pair.numbers.begin(), pair.numbers.begin() + 6), away + 100);
    }
    const auto touches = [](const Pair& pair) { return pair.g() > 0 && pair.gap() < 0x1p-16; };
    EXPECT_GT(share_of(pairs, touches), 0.25) << name;
    EXPECT_LT(share_of(pairs, touches), 0.75) << name;
    away *= 100;
  }
}

TEST(SphereFamily, SmallestHasSubnormalsAndSquaresThatVanish) {
  const FloatFormat wide = format("s53e8");
  const Table table = family_of("smallest", wide, count);
  EXPECT_GT(share_of_encodings(table, [&](Bits bits) { return wide.is_subnormal(bits); }), 0.3);
  EXPECT_GT(share_of_encodings(table, [&](Bits bits) { return wide.magnitude(bits) == 1; }), 0.01);
  EXPECT_GT(share_of_encodings(table, [&](Bits bits) { return wide.is_zero(bits); }), 0.005);
  EXPECT_GT(
      share_of_encodings(
          table, [&](Bits bits) { return wide.magnitude(bits) == wide.smallest_normal(false); }),
      0.005);
  const auto pairs = pairs_of(table);
  const auto straddles = [](double low, double high) {
    return [=](const Pair& pair) { return pair.g() > low && pair.g() < high; };
  };
  EXPECT_GT(share_of(pairs, straddles(0x1p-140, 0x1p-126)), 0.05);
  EXPECT_GT(share_of(pairs, straddles(0x1p-126, 0x1p-110)), 0.05);
}

TEST(SphereFamily, LargestReachesTheLargestFiniteNumber) {
  const FloatFormat wide = format("s53e8");
  const Table table = family_of("largest", wide, count);
  EXPECT_GT(
      share_of_encodings(
          table, [&](Bits bits) { return wide.magnitude(bits) == wide.largest_finite(false); }),
      0.01);
  const auto pairs = pairs_of(table);
  const mpq_class end = to_rational(wide, wide.largest_finite(false));
  EXPECT_GT(share_of(pairs, [&](const Pair& pair) { return pair.f() > end; }), 0.3);
  EXPECT_GT(
      share_of(pairs, [&](const Pair& pair) { return pair.f() > end / 4096 && pair.f() < end; }),
      0.05);
}

TEST(SphereFamily, ScalesCoverEveryExponent) {
  const FloatFormat wide = format("s53e8");
  for (const char* name : {"scales", "mixed_scales"}) {
    std::set<int> exponents;
    const Table table = family_of(name, wide, 4 * count);
    for (const Bits bits : table.values) exponents.insert(wide.biased_exponent(bits));
    EXPECT_GT(exponents.size(), 250u) << name;
  }
  const auto alike = [](const Pair& pair) { return pair.g() > 0 && pair.gap() < 0.6; };
  EXPECT_GT(share_of(wide_pairs("scales"), alike), 0.7);
}

TEST(SphereFamily, MixedScalesHaveDistancesThatVanishYetDecide) {
  const auto vanishing = [](const Pair& pair) {
    return pair.g() > 0 && pair.f() > pair.g() && pair.gap() < 0x1p-50;
  };
  const auto pairs = wide_pairs("mixed_scales");
  EXPECT_GT(share_of(pairs, vanishing), 0.3);
  EXPECT_GT(share_of(pairs, is_tie), 0.02);
}

TEST(SphereFamily, ZeroRadiiMakePoints) {
  const FloatFormat wide = format("s53e8");
  const Table table = family_of("zero_radii", wide, count);
  const auto pairs = pairs_of(table);
  EXPECT_EQ(share_of(pairs, [](const Pair& pair) { return pair.g() == 0; }), 1);
  EXPECT_GT(share_of(pairs, is_tie), 0.15);
  EXPECT_GT(share_of(pairs, [](const Pair& pair) { return pair.f() > 0 && pair.f() < 0x1p-80; }),
            0.1);
  EXPECT_GT(share_of_encodings(table, [&](Bits bits) { return bits == wide.zero(true); }), 0.05);
}

TEST(SphereFamily, NegativeRadiiAreNegative) {
  const auto pairs = wide_pairs("negative_radii");
  EXPECT_GT(share_of(pairs, [](const Pair& pair) { return pair.numbers[6] < 0; }), 0.95);
  EXPECT_GT(share_of(pairs, [](const Pair& pair) { return pair.numbers[7] < 0; }), 0.3);
}

TEST(SphereFamily, GridHasManyExactTies) {
  for (const char* name : {"s53e8", "binary16"}) {
    EXPECT_GT(share_of(pairs_of(family_of("grid", format(name), 4 * count)), is_tie), 0.15) << name;
  }
}

TEST(SphereFamily, InfinitiesAndNansAreInEveryRow) {
  const FloatFormat wide = format("s53e8");
  const Table table = family_of("infinities_and_nans", wide, count);
  bool nan = false, infinity = false;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto operands = row_of(table, row);
    const auto special = [&](Bits bits) { return wide.is_nan(bits) || wide.is_infinite(bits); };
    ASSERT_TRUE(std::any_of(operands.begin(), operands.end(), special)) << row;
    for (const Bits bits : operands) {
      nan = nan || wide.is_nan(bits);
      infinity = infinity || bits == wide.infinity(true);
    }
  }
  EXPECT_TRUE(nan && infinity);
}

TEST(SphereFamily, NearTiesAreWithinWhatTheirLaneCanTell) {
  for (int precision = 4; precision <= 52; ++precision) {
    const auto pairs = wide_pairs("near_tie_" + std::to_string(precision));
    const double u = std::ldexp(1, -precision);
    // Radii are moved by up to 10u of their sum, and then rounded to the grid of the centres.
    const double widest = 1 / std::pow(1 - 10 * u, 2) - 1 + 0x1p-42;
    EXPECT_EQ(share_of(pairs, [&](const Pair& pair) { return pair.gap() <= widest; }), 1)
        << precision;
    const auto hair = [&](const Pair& pair) { return pair.gap() <= std::max(u / 8, 0x1p-42); };
    EXPECT_GT(share_of(pairs, hair), 0.4) << precision;
    const auto clear = [&](const Pair& pair) { return pair.gap() > 6 * u; };
    EXPECT_GT(share_of(pairs, clear), precision < 48 ? 0.15 : 0) << precision;
    EXPECT_GT(share_of(pairs, [](const Pair& pair) { return pair.f() < pair.g(); }), 0.3);
    EXPECT_GT(share_of(pairs, [](const Pair& pair) { return pair.f() > pair.g(); }), 0.3);
  }
}

TEST(SphereFamily, CounterexamplesAreNearTiesOfTheOperandsOwnDigits) {
  const auto pairs = wide_pairs("counterexample");
  EXPECT_EQ(share_of(pairs, [](const Pair& pair) { return pair.gap() < 0x1p-48; }), 1);
  EXPECT_EQ(share_of(pairs, is_tie), 0);
}

}  // namespace
}  // namespace mixcmp::test::sphere_family_test
