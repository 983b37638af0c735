#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/comparison/data/table.hpp"

namespace mixcmp::data {

/// A set of hard sphere pairs, by its name; docs/scene_file.md describes the difficulty of each.
struct SphereFamily {
  std::string name;
  std::uint64_t count = 8192;
  std::uint64_t seed = 1;
};

/// The names of all families, "near_tie_4" to "near_tie_52" included.
std::vector<std::string> sphere_family_names();

/// The list of accepted names for an error about `received`. The nearest name comes first, and one
/// phrase covers all near ties.
std::string accepted_sphere_families(std::string_view received);

/// Makes one pair per row, with columns cxi, cxj, cyi, cyj, czi, czj, ri, rj in `format`. Row n is
/// a function of only (name, seed, n, format): its random numbers are those of RowRandom with the
/// 32-bit FNV-1a hash of the name as the stream. Errors: an unknown name; a family whose numbers
/// exceed the format; a near tie of more digits than the format has.
Result<Table> sphere_family(const SphereFamily& family, FloatFormat format);

}  // namespace mixcmp::data
