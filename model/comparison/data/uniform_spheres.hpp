#pragma once

#include <cstdint>

#include "model/comparison/data/table.hpp"

namespace mixcmp::data {

struct UniformSpheres {
  std::uint64_t count = 8192;
  double side = 100;
  double radius_max = 25;
  std::uint64_t seed = 1;
};

/// Columns cx, cy, cz, r: centres uniform in [0, side)^3, radii uniform in [0, radius_max). Number
/// k of sphere n is limit * u / 2^53, rounded once to `format` (which may round up to the limit),
/// where u is the high 53 bits of the two words 2(k mod 2) and 2(k mod 2) + 1 (high word first) of
/// philox(counter = {n low, n high, k / 2, 0}, key = {seed low, seed high}).
Table uniform_spheres(const UniformSpheres& spheres, FloatFormat format);

}  // namespace mixcmp::data
