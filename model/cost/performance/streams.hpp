#pragma once

#include <vector>

#include "model/scene/scene.hpp"

/// How the streams around a lane limit the throughput of the analytical model: by slots, by
/// requests, and by random or clustered recomputations. Times are in cycles of one clock, at full
/// rate: a comparison is always offered, a result always taken. docs/theory.md derives each
/// formula.
namespace mixcmp::performance {

/// One lane, or one group of lanes in lock step, and the reference that it shares. Their contract
/// is that of rtl_templates/stream/README.md. A group takes words with one comparison for each
/// lane. Statements about comparisons per cycle and lane then hold for words; an undecided word
/// asks once for each of its undecided comparisons.
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
/// Cycles for which an undecided comparison holds a slot, if it finds the reference free.
int undecided_slot_cycles(const LaneStreams& streams);

/// Cycles from one request to the next at a reference: N, or the time in which a request of several
/// beats arrives if that is longer.
int service_cycles(const LaneStreams& streams);

/// Cycles between answers to one lane while all lanes of the reference ask. A reference takes one
/// request per service_cycles, a lane sends one beat per two cycles.
int answer_interval_cycles(const LaneStreams& streams);

/// The fraction of a group's words that have an undecided comparison, if comparisons are undecided
/// independently: 1 - (1 - R)^G.
double undecided_words(double recomputation_rate, int lanes_per_group);

/// The most comparisons per cycle that a lane's requests allow, whatever serves them. It is above 1
/// if less than 1 / (2 B) of the comparisons is undecided, and infinite for a rate of 0.
double highest_lane_throughput(double recomputation_rate, int request_beats = 1);

/// Comparisons that the lane accepts per cycle if a fraction `recomputation_rate` is undecided,
/// evenly spread: equation 8 for one lane, limited by requests and slots as well.
double even_throughput(const LaneStreams& streams, double recomputation_rate);

/// Mean cycles that a request waits if each of the k lanes asks in any cycle with probability
/// `rate`, independently. It waits for its lane's request register, a queue with a service time of
/// two cycles. Then it waits for the reference: for the next cycle in which that starts a
/// comparison, and in a queue with a service time of N. A request of several beats waits only for
/// the crossbar, which one request at a time passes. Infinite if either queue is fully loaded.
double mean_wait_cycles(const LaneStreams& streams, double rate);

/// Comparisons that the lane accepts per cycle if each is undecided independently with this
/// probability, so that waiting requests hold slots. An estimate; docs/theory.md has its
/// accuracy.
double random_throughput(const LaneStreams& streams, double recomputation_rate);

/// Comparisons that a lane accepts per cycle if a second tier stands between lanes and references.
/// `first`: the lanes; `lanes_served` of them share a lane of the second tier. `second`: that
/// tier's lanes in front of the references, which determine how long answers take. The first tier
/// leaves the fraction `rate` of all comparisons undecided, the second tier the fraction `again` of
/// these.
double two_tier_throughput(LaneStreams first, const LaneStreams& second, double rate, double again);

/// The longest burst of undecided comparisons, in all lanes of the reference at the same time, that
/// a lane takes without refusing any comparison, if there were only decided ones before. Not for
/// groups.
int absorbed_burst(const LaneStreams& streams);

/// The mean number of cycles in which a lane accepts a sequence of comparisons that is repeated
/// endlessly, in all lanes of the reference at the same time. `undecided` marks the undecided ones
/// of the sequence; it must not be empty. Not for groups.
double repeated_cycles(const LaneStreams& streams, const std::vector<bool>& undecided);

}  // namespace mixcmp::performance
