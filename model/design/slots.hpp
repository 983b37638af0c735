#pragma once

#include "model/scene/scene.hpp"

namespace mixcmp::design {

/// The number of comparisons that may be inside one lane's channel: the smallest power of two with
/// which a lane of this latency runs at full rate, even while some recomputations are under way.
int slots_for(int lane_latency_cycles, bool recomputes);

/// The number of rows that may be inside one lane of an arg-min engine's chain. A comparison that
/// is recomputed holds up the rows behind it, and the lanes before it go on for as long as these
/// find slots.
int chain_slots_for(int lane_latency_cycles);

/// The number of comparisons that may be inside a lane of the second tier of a system of streams.
/// Its results leave in order: while one is recomputed, as many may wait behind it as come in that
/// time.
int second_tier_slots_for(const scene::SystemSpec& system, int lane_latency_cycles,
                          int reference_latency_cycles);

}  // namespace mixcmp::design
