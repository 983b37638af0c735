#pragma once

namespace mixcmp::design {

/// The number of comparisons that may be inside one lane's channel: the smallest power of two with
/// which a lane of this latency runs at full rate, even while some recomputations are under way.
int slots_for(int lane_latency_cycles, bool recomputes);

}  // namespace mixcmp::design
