#include "model/design/slots.hpp"

#include <bit>

namespace mixcmp::design {
namespace {

/// Cycles that a comparison spends in a channel outside the lane, at full rate
/// (rtl_templates/stream/README.md). If the slots exceed the lane's latency by that number, nothing
/// waits.
constexpr int channel_overhead_cycles = 6;
/// Slots that recomputations may hold while the lane continues at full rate.
constexpr int recomputation_slots = 16;
/// Slots in which rows of a chain wait behind one that is recomputed. Most of them are needed for
/// as long as a reference takes (the paper's, about 30 cycles).
constexpr int chain_slots = 32;

/// The cycles that a recomputed comparison stays in an in-order lane beyond those that the
/// reference takes, if nothing waits and the crossbar has one level: D_u - D_d in docs/theory.md.
constexpr int way_to_reference_cycles = 6;

int slots_beside(int lane_latency_cycles, int waiting) {
  const int needed = lane_latency_cycles + channel_overhead_cycles + waiting;
  return static_cast<int>(std::bit_ceil(static_cast<unsigned>(needed)));
}

/// MAY_COME of pair_segment.v and pair_tier.v, without the latency of the lanes.
constexpr int segment_cycles = 3;
constexpr int tier_cycles = 4;

int queue_bits(int may_come, int waiting) {
  return std::bit_width(static_cast<unsigned>(may_come + waiting - 1));
}

}  // namespace

int slots_for(int lane_latency_cycles, bool recomputes) {
  return slots_beside(lane_latency_cycles, recomputes ? recomputation_slots : 0);
}

int second_tier_slots_for(const scene::SystemSpec& system, int lane_latency_cycles,
                          int reference_latency_cycles) {
  // Fetched operands pass the registers of the input ports.
  const bool refetches = system.operands == scene::OperandStore::refetched;
  return slots_beside(lane_latency_cycles + (refetches ? system.input_registers : 0),
                      way_to_reference_cycles + reference_latency_cycles);
}

int chain_slots_for(int lane_latency_cycles, bool recomputes) {
  return slots_beside(lane_latency_cycles, recomputes ? chain_slots : 0);
}

int segment_queue_bits(int lane_latency_cycles) {
  constexpr int waiting = 16;
  return queue_bits(lane_latency_cycles + segment_cycles, waiting);
}

int tier_queue_bits(int lane_latency_cycles) {
  constexpr int waiting = 4;
  return queue_bits(lane_latency_cycles + tier_cycles, waiting);
}

int beats_before_stop(int queue_bits, int lane_latency_cycles) {
  return (1 << queue_bits) - lane_latency_cycles - segment_cycles;
}

}  // namespace mixcmp::design
