#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/comparison/data/comparisons.hpp"

namespace mixcmp::test {

/// A named set of sphere pairs made to be hard; columns are the inputs of sphere_graph().
struct SphereFamily {
  std::string name;
  data::Table pairs;
};

/// `count` pairs of each of data::sphere_family_names() that fits the format; of the near ties
/// only those aimed at the lane.
std::vector<SphereFamily> sphere_families(FloatFormat format, int lane_precision, std::size_t count,
                                          std::uint64_t seed);

}  // namespace mixcmp::test
