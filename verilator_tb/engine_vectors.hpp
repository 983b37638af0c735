#pragma once

#include <cstdint>

#include "generator/hardware/emit/signature.hpp"
#include "generator/hardware/emit/test_vector.hpp"
#include "model/comparison/data/comparisons.hpp"
#include "model/design/design.hpp"

namespace mixcmp::verilator_tb {

/// Picks items, or rows, of the scene's data for a test bench of its engine that runs without this
/// program. They make about `count` comparisons, at most as many as one set or load has. The golden
/// model computes every comparison as the lane that makes it must. Half of the items, and up to a
/// quarter of the rows, come from comparisons whose results are rare. Nothing where the scene has
/// no engine.
emit::EngineVectors engine_vectors(const design::Design& design,
                                   const data::Comparisons& comparisons,
                                   const emit::Signature& signature, std::uint64_t count);

}  // namespace mixcmp::verilator_tb
