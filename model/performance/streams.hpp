#pragma once

#include <vector>

#include "model/scene/scene.hpp"

/// How the streams around a lane limit the throughput of the analytical model: by slots, requests
/// and random or clustered recomputations. Times are in cycles of one clock, at full rate: a
/// comparison is always offered, a result always taken. docs/performance.md derives each.
namespace mixcmp::performance {

/// One lane, or one group of lanes in lock step, and the reference that it shares (docs/rtl.md,
/// contract of the streams). A group takes words of a comparison for each lane: what is said of
/// comparisons per cycle and lane is then true of words, of which the undecided one asks as often
/// as it has undecided comparisons.
struct LaneStreams {
  scene::ResultOrder order = scene::ResultOrder::tagged;
  int lane_latency_cycles = 0;
  int reference_latency_cycles = 0;
  int initiation_interval_cycles = 1;  ///< N: the reference takes a request in one of N cycles
  int request_beats = 1;               ///< B: beats of a request; above 1 they take 2 B cycles
  int slots = 0;                       ///< comparisons that may be inside the lane's channel
  int lanes_served = 1;     ///< k: lanes or groups of the reference, this one included; 0: p_H = 0
  int lanes_per_group = 1;  ///< G
};

/// Levels of the crossbar's tree; a request takes one cycle per level.
int crossbar_levels(int lanes_served);

/// Cycles for which a decided comparison holds a slot, if nothing waits.
int decided_slot_cycles(const LaneStreams& streams);
/// The cycles that an undecided comparison keeps its slot, if it finds the reference free.
int undecided_slot_cycles(const LaneStreams& streams);

/// Cycles from one request to the next at a reference: N, and not fewer than requests of several
/// beats take to arrive.
int service_cycles(const LaneStreams& streams);

/// Cycles between answers to one lane while all lanes of the reference ask: a reference takes one
/// request in as many cycles as service_cycles says, a lane sends a beat in two.
int answer_interval_cycles(const LaneStreams& streams);

/// The part of the words of a group that have an undecided comparison, where comparisons are
/// undecided independently: 1 - (1 - R)^G.
double undecided_words(double recomputation_rate, int lanes_per_group);

/// The most comparisons per cycle that a lane's requests allow, whatever serves them. It is above 1
/// where less than 1 / (2 B) of the comparisons is undecided, and infinite for a rate of 0.
double highest_lane_throughput(double recomputation_rate, int request_beats = 1);

/// Comparisons that the lane accepts per cycle where a fraction `recomputation_rate` is undecided,
/// evenly spread: equation 8 for one lane, limited by requests and slots, too.
double even_throughput(const LaneStreams& streams, double recomputation_rate);

/// Cycles that a request waits, on average, where each of the k lanes asks in any cycle with the
/// probability `rate`, independently. It waits for its lane's request register, a queue with a
/// service time of two cycles, then for the reference: for the next cycle in which that starts a
/// comparison, in a queue with a service time of N. A request of several beats waits for the
/// crossbar alone, which one request at a time passes. Infinite where either is fully loaded.
double mean_wait_cycles(const LaneStreams& streams, double rate);

/// Comparisons that the lane accepts per cycle where each is undecided independently, with this
/// probability, so that waiting requests hold slots. An estimate; docs/performance.md has its
/// accuracy.
double random_throughput(const LaneStreams& streams, double recomputation_rate);

/// Comparisons that a lane accepts per cycle where a second tier stands between lanes and
/// references. `first`: the lanes, of which `lanes_served` share a lane of the second tier; how
/// long answers take follows from `second`, its lanes before the references. The
/// first tier leaves the part `rate` of all comparisons undecided, the second the part `again` of
/// these.
double two_tier_throughput(LaneStreams first, const LaneStreams& second, double rate, double again);

/// The longest burst of undecided comparisons, in all lanes of the reference at the same time, that
/// a lane takes without refusing any comparison, if only decided ones were inside before. Not for
/// groups.
int absorbed_burst(const LaneStreams& streams);

/// The mean number of cycles in which a lane accepts a sequence of comparisons that is repeated
/// over and over, in all lanes of the reference at the same time. `undecided` marks the undecided
/// ones of the sequence; it must not be empty. Not for groups.
double repeated_cycles(const LaneStreams& streams, const std::vector<bool>& undecided);

}  // namespace mixcmp::performance
