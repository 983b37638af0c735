#include "tests/support/sphere_families.hpp"

#include <cstdint>

#include "model/comparison/data/sphere_family.hpp"

namespace mixcmp::test {

std::vector<SphereFamily> sphere_families(FloatFormat format, int lane_precision, std::size_t count,
                                          std::uint64_t seed) {
  const std::string aimed = "near_tie_" + std::to_string(lane_precision);
  std::vector<SphereFamily> families;
  for (const std::string& name : data::sphere_family_names()) {
    if (name.starts_with("near_tie_") && name != aimed) continue;
    auto pairs = data::sphere_family({.name = name, .count = count, .seed = seed}, format);
    if (pairs.ok()) families.push_back({name, std::move(pairs).value()});
  }
  return families;
}

}  // namespace mixcmp::test
