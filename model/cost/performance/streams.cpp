#include "model/cost/performance/streams.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>

#include "model/base/common/check.hpp"

namespace mixcmp::performance {
namespace {

constexpr int crossbar_radix = 4;
constexpr int beat_interval_cycles = 2;
constexpr int answer_cycles = 2;  ///< through the crossbar

/// Cycles from accepted operands to an offered request, without the lane's latency.
constexpr int request_cycles = 4;
/// Cycles in which a request passes the crossbar, from its first beat at the lane to the reference.
/// At each level, requests of several beats are granted in one cycle and begin to move in the next.
/// They are joined in front of the reference.
int crossbar_cycles(const LaneStreams& streams) {
  const int levels = crossbar_levels(streams.lanes_served);
  if (streams.request_beats == 1) return levels;
  const int joining = 1;
  return 2 * levels + beat_interval_cycles * (streams.request_beats - 1) + joining;
}

/// Cycles from an answer at the lane until its slot may be taken again.
int retire_cycles(scene::ResultOrder order) {
  switch (order) {
    case scene::ResultOrder::tagged: return 5;
    case scene::ResultOrder::in_order: return 3;
  }
  MIXCMP_CHECK(false);
}

/// Simulates in which cycles a lane accepts comparisons: at most one per cycle, each into a free
/// slot.
class Channel {
public:
  explicit Channel(const LaneStreams& streams) : streams_(streams) {
    MIXCMP_CHECK(streams.lanes_per_group == 1);
  }

  /// The cycle in which the next comparison is accepted.
  std::int64_t accept(bool undecided) {
    std::int64_t entry = last_entry_ + 1;
    if (static_cast<int>(inside_.size()) == streams_.slots) {
      // At most one enters per cycle and later than an exit, so one exit per cycle is no limit.
      entry = std::max(entry, inside_.top());
      inside_.pop();
    }
    std::int64_t ready = entry + decided_slot_cycles(streams_);
    if (undecided) {
      // A folded reference may have started just before the request.
      const int start = streams_.lanes_served > 0 ? streams_.initiation_interval_cycles - 1 : 0;
      ready = std::max(entry + undecided_slot_cycles(streams_) + start,
                       last_answer_ + answer_interval_cycles(streams_));
      last_answer_ = ready;
    }
    if (streams_.order == scene::ResultOrder::in_order) ready = std::max(ready, last_ready_ + 1);
    last_ready_ = ready;
    inside_.push(ready);
    last_entry_ = entry;
    return entry;
  }

private:
  LaneStreams streams_;
  /// For each slot in use, the first cycle in which it may be taken again.
  std::priority_queue<std::int64_t, std::vector<std::int64_t>, std::greater<>> inside_;
  std::int64_t last_entry_ = -1;
  std::int64_t last_answer_ = std::numeric_limits<std::int64_t>::min() / 2;
  std::int64_t last_ready_ = last_answer_;
};

/// Whether the lane takes one comparison per cycle while decided ones fill it, then a burst of
/// undecided ones, then decided ones until every slot has been used anew.
bool absorbs(const LaneStreams& streams, int burst) {
  Channel channel(streams);
  const int before = streams.slots;
  const int all = before + burst + streams.slots;
  for (int k = 0; k < all; ++k) {
    const bool undecided = before <= k && k < before + burst;
    if (channel.accept(undecided) != k) return false;
  }
  return true;
}

/// The largest x in 0..limit for which `holds`; `holds` is true up to some x and false beyond.
double largest(double limit, const std::function<bool(double)>& holds) {
  if (holds(limit)) return limit;
  double low = 0;
  double high = limit;
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

/// Requests for each word.
double requests(const LaneStreams& streams, double recomputation_rate) {
  return streams.lanes_per_group * recomputation_rate;
}

/// The throughput that a reference allows if a lane never waits for a slot.
double unbuffered_throughput(const LaneStreams& streams, double recomputation_rate) {
  if (recomputation_rate == 0 || streams.lanes_served == 0) return 1;
  const double asked = requests(streams, recomputation_rate);
  return std::min(1.0, 1 / (answer_interval_cycles(streams) * asked));
}

/// Mean cycles from the first request of an undecided word to its last, plus the cycles for naming
/// its undecided lanes and completing it. 0 for a single lane.
double mean_naming_cycles(const LaneStreams& streams, double recomputation_rate) {
  const bool asks = streams.lanes_served > 0 && recomputation_rate > 0;
  if (streams.lanes_per_group == 1 || !asks) return 0;
  const double of_a_word = requests(streams, recomputation_rate) /
                           undecided_words(recomputation_rate, streams.lanes_per_group);
  const double interval = beat_interval_cycles * streams.request_beats;
  const int naming = 1, completing = 1;
  return naming + completing +
         (of_a_word - 1) * std::max<double>(interval, service_cycles(streams));
}

/// Mean cycles until a free reference starts a comparison. A folded one starts in one cycle of N,
/// whenever the request comes.
double mean_start_cycles(const LaneStreams& streams) {
  return streams.lanes_served > 0 ? (streams.initiation_interval_cycles - 1) / 2.0 : 0;
}

/// Cycles that a request waits behind others: first in its lane's request register, then at the
/// reference. That serves one request per N cycles, in which the k lanes have k N chances to ask.
double mean_queue_cycles(const LaneStreams& streams, double rate) {
  const double interval = service_cycles(streams);
  const double chances = streams.lanes_served * interval;
  const double register_load = beat_interval_cycles * rate;
  const double reference_load = chances * rate;
  if (register_load >= 1 || reference_load >= 1) return std::numeric_limits<double>::infinity();
  const double in_register = streams.request_beats == 1 ? rate / (1 - register_load) : 0;
  return in_register +
         interval * (chances - 1) / chances * reference_load / (2 * (1 - reference_load));
}

/// The throughput that slots allow if a request waits for `wait` cycles on average.
double slot_throughput(const LaneStreams& streams, double recomputation_rate, double wait) {
  const double slots = streams.slots;
  const double rate = undecided_words(recomputation_rate, streams.lanes_per_group);
  const double undecided =
      undecided_slot_cycles(streams) + mean_naming_cycles(streams, recomputation_rate);
  switch (streams.order) {
    case scene::ResultOrder::tagged:
      return slots / ((1 - rate) * decided_slot_cycles(streams) + rate * (undecided + wait));
    case scene::ResultOrder::in_order: {
      // A period runs from an undecided comparison to the first undecided one that is not among the
      // next `slots`. `beyond` is the wait that slots do not cover: the mean of an exponential
      // distribution's tail.
      const double decided = std::max(1.0, decided_slot_cycles(streams) / slots);
      const double covered = std::max(0.0, slots * decided - undecided);
      const double beyond = wait > 0 ? wait * std::exp(-covered / wait) : 0;
      const double whole = std::max(undecided, slots * decided) + beyond;
      return (1 - rate + rate * slots) / ((1 - rate) * decided + rate * whole);
    }
  }
  MIXCMP_CHECK(false);
}

}  // namespace

int crossbar_levels(int lanes_served) {
  int levels = 1;
  for (int streams = crossbar_radix; streams < lanes_served; streams *= crossbar_radix) ++levels;
  return levels;
}

int decided_slot_cycles(const LaneStreams& streams) {
  const bool merges = streams.order == scene::ResultOrder::tagged && streams.lanes_served > 0;
  const int beside = streams.order == scene::ResultOrder::in_order ? 4 : merges ? 6 : 5;
  return streams.lane_latency_cycles + beside;
}

int undecided_slot_cycles(const LaneStreams& streams) {
  if (streams.lanes_served == 0) return decided_slot_cycles(streams);
  return streams.lane_latency_cycles + request_cycles + crossbar_cycles(streams) +
         streams.reference_latency_cycles + answer_cycles + retire_cycles(streams.order);
}

int service_cycles(const LaneStreams& streams) {
  if (streams.request_beats == 1) return streams.initiation_interval_cycles;
  // The crossbar's last node begins another lane's request one cycle after the last beat.
  const int saved = streams.lanes_served > 1 ? beat_interval_cycles - 1 : 0;
  return std::max(streams.initiation_interval_cycles,
                  beat_interval_cycles * streams.request_beats - saved);
}

int answer_interval_cycles(const LaneStreams& streams) {
  return std::max(beat_interval_cycles, streams.lanes_served * service_cycles(streams));
}

double undecided_words(double recomputation_rate, int lanes_per_group) {
  return 1 - std::pow(1 - recomputation_rate, lanes_per_group);
}

double highest_lane_throughput(double recomputation_rate, int request_beats) {
  return 1 / (beat_interval_cycles * request_beats * recomputation_rate);
}

double even_throughput(const LaneStreams& streams, double recomputation_rate) {
  const double by_slots = slot_throughput(streams, recomputation_rate, mean_start_cycles(streams));
  return std::min(unbuffered_throughput(streams, recomputation_rate), by_slots);
}

double mean_wait_cycles(const LaneStreams& streams, double rate) {
  return mean_start_cycles(streams) + mean_queue_cycles(streams, rate);
}

double random_throughput(const LaneStreams& streams, double recomputation_rate) {
  if (recomputation_rate == 0 || streams.lanes_served == 0) {
    return even_throughput(streams, recomputation_rate);
  }
  return largest(unbuffered_throughput(streams, recomputation_rate), [&](double x) {
    const double asked = x * requests(streams, recomputation_rate);
    // A stalled lane takes comparisons at regular intervals instead of at random. The variance of
    // its requests is then proportional to 1 - R instead of 1 - x R, and so is the wait (Kingman).
    const double undecided = undecided_words(recomputation_rate, streams.lanes_per_group);
    const double regular = (1 - undecided) / (1 - x * undecided);
    const double queue = regular > 0 ? regular * mean_queue_cycles(streams, asked) : 0;
    return x <= slot_throughput(streams, recomputation_rate, mean_start_cycles(streams) + queue);
  });
}

double two_tier_throughput(LaneStreams first, const LaneStreams& second, double rate,
                           double again) {
  first.initiation_interval_cycles = 1;
  first.reference_latency_cycles = static_cast<int>(std::lround(
      (1 - again) * decided_slot_cycles(second) + again * undecided_slot_cycles(second)));
  const double asked = first.lanes_served * requests(first, rate);
  return std::min(random_throughput(first, rate), random_throughput(second, again) / asked);
}

int absorbed_burst(const LaneStreams& streams) {
  if (streams.lanes_served == 0) return std::numeric_limits<int>::max();
  int burst = 0;
  while (absorbs(streams, burst + 1)) ++burst;
  return burst;
}

double repeated_cycles(const LaneStreams& streams, const std::vector<bool>& undecided) {
  MIXCMP_CHECK(!undecided.empty() && streams.slots > 0);
  constexpr int settling = 16;
  constexpr int measured = 48;
  Channel channel(streams);
  std::int64_t begin = 0;
  std::int64_t end = 0;
  for (int repetition = 0; repetition < settling + measured; ++repetition) {
    if (repetition == settling) begin = end;
    for (const bool hard : undecided) end = channel.accept(hard);
  }
  return static_cast<double>(end - begin) / measured;
}

}  // namespace mixcmp::performance
