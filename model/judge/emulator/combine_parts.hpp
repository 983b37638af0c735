#pragma once

#include <span>

#include "model/base/number/verdict.hpp"
#include "model/comparison/expression/combination.hpp"

namespace mixcmp::emulator {

/// Replaces each of `decisions` by its combination with the decision on a further part. `all` takes
/// the last of the two in the order less, equal, unordered, undecided, greater; `any` takes the
/// first in the order less, undecided, unordered, equal, greater.
void combine_parts(Combination combination, std::span<Decision> decisions,
                   std::span<const Decision> further);

}  // namespace mixcmp::emulator
