#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/data/comparisons.hpp"

namespace mixcmp::test {

/// A named set of sphere pairs made to be hard; columns are the inputs of sphere_graph().
struct SphereFamily {
  std::string name;
  model::Table pairs;
};

/// `count` pairs each of: uniform, tangent (exact and one last place off), near_tangent in the
/// lane's last places, coincident, nested, offset by 1e6, the whole exponent range, mixed scales,
/// zeros and subnormals, infinities and NaNs. Seeded; in binary64's values rounded to `format`.
std::vector<SphereFamily> sphere_families(model::FloatFormat format, int lane_precision,
                                          std::size_t count, std::uint64_t seed);

}  // namespace mixcmp::test
