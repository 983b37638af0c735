#pragma once

namespace mixcmp::model {

/// Comparisons that may be inside one lane's channel: the power of two from which on a lane of this
/// latency runs at full rate, even while some recomputations are under way.
int slots_for(int lane_latency_cycles, bool recomputes);

}  // namespace mixcmp::model
