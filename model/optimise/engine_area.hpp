#pragma once

#include <optional>
#include <set>
#include <string>

#include "model/characterise/measurement.hpp"
#include "model/scene/engine.hpp"

namespace mixcmp::optimise {

/// What a pairwise engine takes of a device beside its references.
struct EngineArea {
  devices::Area own;          ///< conversion, loading, recomputation, reports: whatever its lanes
  devices::Area group;        ///< a segment, its second tier, and its share of the merge
  devices::Area lane;         ///< a lane with its share of both, rounded up
  std::optional<double> mhz;  ///< the lowest clock of these parts; none if none was measured
};

/// The area of an engine whose lanes are those of `segment`, a row of that kind. The merge grows
/// with the number of segments: its slope is that between the smallest and the largest engine of
/// the table. Parts that the table lacks are added to `missing`, in words; where the engine itself
/// lacks, there is no area.
std::optional<EngineArea> engine_area(const characterise::Characterisation& table,
                                      const characterise::Measurement& segment,
                                      std::set<std::string>& missing);

/// Recomputations that a pairwise engine can start per cycle: its memory gives both items of a
/// pair.
inline constexpr double engine_recomputations_per_cycle = 1;

}  // namespace mixcmp::optimise
