#pragma once

#include <optional>
#include <set>
#include <string>

#include "model/cost/measured/measurement.hpp"
#include "model/scene/engine.hpp"

namespace mixcmp::optimise {

/// The area of an engine without its references.
struct EngineArea {
  /// Conversion, loading, recomputation and reports, whatever the number of lanes. In an arg-min
  /// engine without the part that belongs to its references.
  devices::Area own;
  devices::Area group;        ///< a segment, its second tier, and its share of the connections
  devices::Area lane;         ///< a lane with its share of both, rounded up
  std::optional<double> mhz;  ///< the lowest clock of these parts; none if none was measured
};

/// The facts about a system, other than its lanes, on which its engine's area depends.
struct EngineUse {
  scene::EngineKind kind = scene::EngineKind::none;
  bool recomputes = true;               ///< there are references
  bool arrives_in_fixed_point = false;  ///< some operands, so items may be stored as they arrive
};

/// The area of an engine whose lanes are those of `row`, a segment. The connections of
/// segments (the merge of a pairwise engine, the stages of a chain) grow with their number: the
/// slope is that between the smallest and the largest engine of the table. Parts that the table
/// lacks are added to `missing`, in words, but not a conversion if items may be stored as they
/// arrive. If it lacks the engine itself, there is no area.
std::optional<EngineArea> engine_area(const measured::Characterisation& table,
                                      const measured::Measurement& row, EngineUse use,
                                      std::set<std::string>& missing);

/// A reference's share of an arg-min engine's operand memory: its register, and its part of the
/// tree of arbiters, by the smallest and the largest memory of the table. Zero for other engines.
devices::Area memory_share(const measured::Characterisation& table, scene::EngineKind kind,
                           std::set<std::string>& missing);

/// A reference with the streams around it, and its share of an engine's memory. A table of a system
/// of streams may lack both; a port that an engine lacks is added to `missing`.
devices::Area area_with_port(const measured::Characterisation& table,
                             const measured::Measurement& reference, scene::EngineKind kind,
                             std::set<std::string>& missing);

/// Recomputations that an engine can start per cycle: its memory gives the operands of one pair.
inline constexpr double engine_recomputations_per_cycle = 1;

/// The area of one of `parts` equal parts of `area`, rounded up.
devices::Area share(const devices::Area& area, int parts);

}  // namespace mixcmp::optimise
