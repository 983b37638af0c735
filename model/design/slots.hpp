#pragma once

#include "model/scene/scene.hpp"

namespace mixcmp::design {

/// The number of comparisons that may be inside one lane's channel: the smallest power of two with
/// which a lane of this latency runs at full rate, even during some recomputations.
int slots_for(int lane_latency_cycles, bool recomputes);

/// The number of rows that may be inside one lane of an arg-min engine's chain. A recomputed
/// comparison delays the rows behind it. The previous lanes continue as long as the delayed rows
/// find slots. Without references nothing is delayed.
int chain_slots_for(int lane_latency_cycles, bool recomputes);

/// The number of comparisons that may be inside a lane of the second tier of a system of streams.
/// Its results leave in order. While one is recomputed, all comparisons that arrive in that time
/// may wait behind it.
int second_tier_slots_for(const scene::SystemSpec& system, int lane_latency_cycles,
                          int reference_latency_cycles);

/// QUEUE_BITS of pair_segment.v, log2 of the beats that its queue of exceptions holds, with lanes
/// of this latency. The queue has room for 16 beats besides those that may come after it says stop;
/// otherwise a burst in one segment would stop the whole chain.
int segment_queue_bits(int lane_latency_cycles);

/// QUEUE_BITS of pair_tier.v, with room for four such beats: the queue in front of it takes bursts.
int tier_queue_bits(int lane_latency_cycles);

/// A segment takes a word while its queue holds at most this many beats.
int beats_before_stop(int queue_bits, int lane_latency_cycles);

}  // namespace mixcmp::design
