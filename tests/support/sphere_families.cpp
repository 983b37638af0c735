#include "tests/support/sphere_families.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>

#include "model/golden/arithmetic.hpp"

namespace mixcmp::test {
namespace {

using model::FloatFormat;

/// cxi, cxj, cyi, cyj, czi, czj, ri, rj.
using Pair = std::array<double, 8>;

class Maker {
public:
  Maker(FloatFormat format, int lane_precision, std::uint64_t seed)
      : format_(format), lane_precision_(lane_precision), random_(seed) {}

  Pair uniform() {
    Pair pair;
    for (int k = 0; k < 6; ++k) pair[k] = 100 * unit();
    pair[6] = 25 * unit();
    pair[7] = 25 * unit();
    return pair;
  }

  /// (3, 4, 12) * s is 13 * s long: exact in few digits. A third of them is one last place off.
  Pair tangent() {
    const double scale = std::ldexp(1 + whole(1 << 10), -6);
    const double x = whole(64), y = whole(64), z = whole(64);
    const double share = std::ldexp(whole(1 << 8), -8);
    const double sum = 13 * scale;
    Pair pair = {x, x + 3 * scale,  y,           y + 4 * scale,
                 z, z + 12 * scale, sum * share, sum * (1 - share)};
    if (whole(3) == 0) pair[6] = std::nextafter(pair[6], whole(2) == 0 ? -1e9 : 1e9);
    return pair;
  }

  /// Radii whose sum is the distance to within a few of the lane's last places.
  Pair near_tangent() {
    Pair pair = uniform();
    const double distance = std::hypot(pair[0] - pair[1], pair[2] - pair[3], pair[4] - pair[5]);
    const double off = std::ldexp(distance * (whole(33) - 16), -lane_precision_ - 2);
    const double share = unit();
    pair[6] = (distance + off) * share;
    pair[7] = (distance + off) - pair[6];
    return pair;
  }

  Pair coincident() {
    Pair pair = uniform();
    for (const int axis : {0, 2, 4}) pair[axis + 1] = pair[axis];
    if (whole(2) == 0) pair[6] = pair[7] = whole(2) == 0 ? 0 : std::ldexp(1, -100);
    return pair;
  }

  Pair nested() {
    Pair pair = uniform();
    for (const int axis : {0, 2, 4}) pair[axis + 1] = pair[axis] + std::ldexp(unit(), -whole(40));
    return pair;
  }

  Pair offset() {
    Pair pair = near_tangent();
    for (int k = 0; k < 6; ++k) pair[k] += 1e6;
    return pair;
  }

  Pair any_exponent() {
    Pair pair;
    for (double& value : pair) value = any_scale();
    pair[6] = std::fabs(pair[6]);
    pair[7] = std::fabs(pair[7]);
    return pair;
  }

  /// One scale for all, up to where squares overflow and down to where they vanish.
  Pair extreme_scale() {
    Pair pair = near_tangent();
    const int span = format_.bias() + 8;
    const int exponent = whole(2 * span) - span;
    for (double& value : pair) value = std::ldexp(value, exponent);
    return pair;
  }

  Pair tiny() {
    Pair pair;
    const int lowest = format_.min_exponent() - format_.fraction_bits();
    for (double& value : pair) {
      value = whole(3) == 0 ? 0 : std::ldexp(whole(16) - 8, lowest + whole(4));
      if (whole(4) == 0) value = -0.0;
    }
    return pair;
  }

  Pair special() {
    const double infinity = std::numeric_limits<double>::infinity();
    Pair pair = uniform();
    for (int changes = 1 + whole(3); changes > 0; --changes) {
      const double values[] = {infinity, -infinity, std::nan(""), 0.0, -0.0, 3e38, -3e38, 1e-45};
      pair[whole(8)] = values[whole(8)];
    }
    return pair;
  }

  /// Negative radii break what the name promises, not what f and g are.
  Pair negative_radius() {
    Pair pair = near_tangent();
    pair[6] = -pair[6];
    if (whole(2) == 0) pair[7] = -pair[7];
    return pair;
  }

private:
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  int whole(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }
  double any_scale() {
    const int span = format_.bias() + format_.fraction_bits();
    return std::ldexp(unit() - 0.5, whole(span + format_.bias()) - span);
  }

  FloatFormat format_;
  int lane_precision_;
  std::mt19937_64 random_;
};

model::Bits encode(FloatFormat format, double value) {
  if (std::isnan(value)) return format.quiet_nan();
  if (std::isinf(value)) return format.infinity(value < 0);
  if (value == 0) return format.zero(std::signbit(value));
  return model::golden::from_rational(format, mpq_class(value));
}

}  // namespace

std::vector<SphereFamily> sphere_families(FloatFormat format, int lane_precision, std::size_t count,
                                          std::uint64_t seed) {
  using Member = Pair (Maker::*)();
  const std::pair<const char*, Member> kinds[] = {{"uniform", &Maker::uniform},
                                                  {"tangent", &Maker::tangent},
                                                  {"near_tangent", &Maker::near_tangent},
                                                  {"coincident", &Maker::coincident},
                                                  {"nested", &Maker::nested},
                                                  {"offset_1e6", &Maker::offset},
                                                  {"any_exponent", &Maker::any_exponent},
                                                  {"extreme_scale", &Maker::extreme_scale},
                                                  {"tiny", &Maker::tiny},
                                                  {"special", &Maker::special},
                                                  {"negative_radius", &Maker::negative_radius}};
  std::vector<SphereFamily> families;
  Maker maker(format, lane_precision, seed);
  for (const auto& [name, make] : kinds) {
    SphereFamily family = {
        name, {format, {"cxi", "cxj", "cyi", "cyj", "czi", "czj", "ri", "rj"}, {}, {}}};
    for (std::size_t k = 0; k < count; ++k) {
      for (const double value : (maker.*make)())
        family.pairs.values.push_back(encode(format, value));
    }
    families.push_back(std::move(family));
  }
  return families;
}

}  // namespace mixcmp::test
