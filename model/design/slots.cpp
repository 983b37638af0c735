#include "model/design/slots.hpp"

#include <bit>

namespace mixcmp::design {
namespace {

/// Cycles a comparison spends in a channel beside the lane itself, at full rate
/// (docs/rtl.md): with this many slots more than the lane's latency nothing waits.
constexpr int channel_overhead_cycles = 6;
/// Slots that recomputations may hold while the lane goes on at full rate.
constexpr int recomputation_slots = 16;

}  // namespace

int slots_for(int lane_latency_cycles, bool recomputes) {
  const int needed =
      lane_latency_cycles + channel_overhead_cycles + (recomputes ? recomputation_slots : 0);
  return static_cast<int>(std::bit_ceil(static_cast<unsigned>(needed)));
}

}  // namespace mixcmp::design
