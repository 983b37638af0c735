#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/data/table.hpp"

namespace mixcmp::model {

/// A set of sphere pairs made to be hard, by its name; docs/scene_file.md says what is hard in
/// each.
struct SphereFamily {
  std::string name;
  std::uint64_t count = 8192;
  std::uint64_t seed = 1;
};

/// Every family, "near_tie_4" to "near_tie_52" included.
std::vector<std::string> sphere_family_names();

/// For an error about `received`: the nearest name first, near ties in one phrase.
std::string accepted_sphere_families(std::string_view received);

/// One pair a row, columns cxi, cxj, cyi, cyj, czi, czj, ri, rj, in `format`. Row n is a function
/// of (name, seed, n, format) alone: RowRandom with the 32-bit FNV-1a hash of the name for a
/// stream. Errors: an unknown name; a family whose numbers exceed the format; a near tie of more
/// digits than the format has.
Result<Table> sphere_family(const SphereFamily& family, FloatFormat format);

}  // namespace mixcmp::model
