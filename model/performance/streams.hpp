#pragma once

#include <vector>

#include "model/scene/scene.hpp"

/// What the streams around a lane make of the analytical model: the limits that come from slots,
/// requests and random or clustered recomputations. All in cycles of one clock, at full rate: a
/// comparison is always offered, a result always taken. docs/performance.md derives each.
namespace mixcmp::model {

/// One lane and the reference that it shares (docs/rtl.md, contract of the streams).
struct LaneStreams {
  ResultOrder order = ResultOrder::tagged;
  int lane_latency_cycles = 0;
  int reference_latency_cycles = 0;
  int slots = 0;         ///< comparisons that may be inside the lane's channel
  int lanes_served = 1;  ///< k: lanes of the reference, this one included; 0: p_H = 0
};

/// Levels of the crossbar's tree, as many cycles on a request's way.
int crossbar_levels(int lanes_served);

/// Cycles for which a decided comparison holds a slot, if nothing waits.
int decided_slot_cycles(const LaneStreams& streams);
/// The cycles that an undecided comparison keeps its slot, if it finds the reference free.
int undecided_slot_cycles(const LaneStreams& streams);

/// Cycles between answers to one lane while all lanes of the reference ask: a reference takes one
/// request per cycle, a lane sends one in two.
int answer_interval_cycles(const LaneStreams& streams);

/// Comparisons per cycle that a lane's requests alone allow, whatever serves them: above 1 where
/// less than half is undecided. Infinite for a rate of 0.
double highest_lane_throughput(double recomputation_rate);

/// Comparisons that the lane accepts per cycle where the share `recomputation_rate` is undecided,
/// evenly spread: equation 8 of one lane, with requests and slots.
double even_throughput(const LaneStreams& streams, double recomputation_rate);

/// Cycles that a request waits, on average, where each of the k lanes asks in any cycle with the
/// probability `rate`, independently: for its lane's request register, a queue with service in two
/// cycles, then for the reference, one in one. Infinite at or above what either serves.
double mean_wait_cycles(const LaneStreams& streams, double rate);

/// `even_throughput` where each comparison is undecided by itself, with this probability: waiting
/// requests hold slots. An estimate; docs/performance.md says how good.
double random_throughput(const LaneStreams& streams, double recomputation_rate);

/// How many undecided comparisons in a row, in all lanes of the reference at the same time, a lane
/// takes without refusing any comparison, if only decided ones were inside before.
int absorbed_burst(const LaneStreams& streams);

/// Cycles that comparisons take to be accepted, of which those marked are undecided, in all lanes
/// of the reference at the same time; over and over: the mean of a repetition. `undecided` is not
/// empty.
double repeated_cycles(const LaneStreams& streams, const std::vector<bool>& undecided);

}  // namespace mixcmp::model
