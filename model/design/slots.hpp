#pragma once

#include "model/scene/scene.hpp"

namespace mixcmp::design {

/// The number of comparisons that may be inside one lane's channel: the smallest power of two with
/// which a lane of this latency runs at full rate, even during some recomputations.
int slots_for(int lane_latency_cycles, bool recomputes);

/// The number of rows that may be inside one lane of an arg-min engine's chain. A recomputed
/// comparison delays the rows behind it. The previous lanes continue as long as the delayed rows
/// find slots.
int chain_slots_for(int lane_latency_cycles);

/// The number of comparisons that may be inside a lane of the second tier of a system of streams.
/// Its results leave in order. While one is recomputed, all comparisons that arrive in that time
/// may wait behind it.
int second_tier_slots_for(const scene::SystemSpec& system, int lane_latency_cycles,
                          int reference_latency_cycles);

}  // namespace mixcmp::design
