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

/// QUEUE_BITS of pair_segment.v and pair_tier.v, log2 of the beats that their queue of exceptions
/// holds, with lanes or a tier's lane of this latency. Beside the beats that may still come when it
/// says stop there is room for 16: a burst of exceptions in one segment would otherwise hold up the
/// whole chain.
int segment_queue_bits(int lane_latency_cycles);
int tier_queue_bits(int lane_latency_cycles);

/// The largest number of beats in the queue with which a segment takes another word.
int beats_before_stop(int queue_bits, int lane_latency_cycles);

}  // namespace mixcmp::design
