#include "model/cost/performance/pairwise_flow.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <numeric>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/design/slots.hpp"

namespace mixcmp::performance {
namespace {

/// Cycles in which an engine converts the first item, and in which the closing beats pass the
/// trees: about as many in the simulated engines of docs/theory.md.
constexpr int closing_cycles = 20;

/// Above this many cycles for each word the busiest stream or the references set the pace, and the
/// simulation, which would take long, is skipped.
constexpr double overloaded = 3;
/// Walks that are kept; one takes about a megabyte.
constexpr std::size_t most_walks = 64;

constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();

/// A beat in a queue of exceptions: what its pairs send out, and those to recompute among them.
struct Beat {
  std::uint64_t ready = 0;  ///< the cycle in which it can leave
  int reports = 0;
  int undecided = 0;
};

/// The link in front of a segment: stream_fifo.v of two words with its output register, and the
/// register behind the segment before.
class Link {
public:
  static constexpr int latency_cycles = 3;

  bool is_full() const { return count_ == places; }
  void push(std::uint32_t word, std::uint64_t cycle) {
    const unsigned place = (head_ + count_++) % places;
    words_[place] = word;
    ready_[place] = cycle + latency_cycles;
  }
  bool is_ready(std::uint64_t cycle) const { return count_ > 0 && ready_[head_] <= cycle; }
  std::uint32_t front() const { return words_[head_]; }
  void pop() {
    head_ = (head_ + 1) % places;
    --count_;
  }

private:
  static constexpr unsigned places = 4;

  std::array<std::uint32_t, places> words_ = {};  ///< their numbers in the walk
  std::array<std::uint64_t, places> ready_ = {};
  unsigned head_ = 0, count_ = 0;
};

struct Segment {
  Link link;
  bool was_full = false;  ///< the link, when the cycle began
  std::deque<Beat> queue;
  int stream = 0;
  int arrived = 0;                     ///< beats of the queue that have left the lanes
  std::uint64_t next_arrival = never;  ///< the cycle in which the next one has
  double undecided = 0;                ///< pairs that are due to be undecided
  double reported_later = 0;  ///< reported pairs that are due to be reported by a reference
};

/// A stream of reports with the segments that it serves.
struct Stream {
  int first = 0, segments = 1;
  int arrived = 0;                         ///< beats that wait in its segments
  int turn = 0;                            ///< the segment served next
  int subtrees = 0;                        ///< of the tree's root; 0: segments are its inputs
  std::array<std::uint64_t, 4> free = {};  ///< the cycle in which each subtree can send
  std::deque<Beat> entries;
  Beat current;

  bool is_idle() const { return current.reports == 0 && current.undecided == 0; }
};

/// Inputs of the root of stream_tree.v, of which each has at most four; 0 if it is the only node.
int subtrees_of(int inputs) {
  constexpr int radix = 4;
  int subtrees = 0;
  for (; inputs > radix; inputs = (inputs + radix - 1) / radix) {
    subtrees = (inputs + radix - 1) / radix;
  }
  return subtrees;
}

/// The words that leave for a word with so many reported pairs in a segment.
int reports_of(int reported, scene::ReportForm form) {
  switch (form) {
    case scene::ReportForm::pairs: return reported;
    case scene::ReportForm::bitmap: return std::min(reported, 1);
    case scene::ReportForm::count: return 0;
  }
  MIXCMP_CHECK(false);
}

/// The segment at which the segments of a stream begin, as in pairwise_engine.v.
int first_segment(int stream, int segments, int streams) {
  return stream * segments / streams;
}

/// Cycles that the busiest stream of reports and the references need at least.
double least_cycles(const PairwiseWalk& walk, const PairwiseEngine& engine) {
  std::vector<std::uint64_t> of_segment(static_cast<std::size_t>(walk.segments));
  for (int s = 0; s < walk.segments; ++s) {
    for (std::uint64_t word = 0; word < walk.words.size(); ++word) {
      of_segment[s] +=
          static_cast<std::uint64_t>(reports_of(walk.count(word, s), engine.report_as));
    }
  }
  const double undecided = engine.undecided * static_cast<double>(walk.pairs);
  const bool has_references = engine.recomputations_per_cycle > 0;
  double least = has_references ? undecided / engine.recomputations_per_cycle : 0;
  for (int s = 0; s < engine.streams; ++s) {
    const auto from = of_segment.begin() + first_segment(s, walk.segments, engine.streams);
    const auto to = of_segment.begin() + first_segment(s + 1, walk.segments, engine.streams);
    const auto reports = static_cast<double>(std::accumulate(from, to, std::uint64_t{0}));
    const double of_stream = undecided / engine.streams;
    least = std::max(least, of_stream + std::max(0.0, reports - of_stream / 2));
  }
  return least;
}

/// One engine on one walk, cycle by cycle.
class Simulation {
public:
  /// `items`: those that are loaded meanwhile.
  Simulation(const PairwiseWalk& walk, const PairwiseEngine& engine, std::uint64_t items)
      : walk_(walk),
        engine_(engine),
        to_load_(items),
        segments_(static_cast<std::size_t>(walk.segments)),
        streams_(static_cast<std::size_t>(engine.streams)) {
    const int count = engine.streams;
    for (int s = 0; s < count; ++s) {
      streams_[s].first = first_segment(s, walk.segments, count);
      streams_[s].segments = first_segment(s + 1, walk.segments, count) - streams_[s].first;
      streams_[s].subtrees = subtrees_of(streams_[s].segments);
      for (int k = 0; k < streams_[s].segments; ++k) segments_[streams_[s].first + k].stream = s;
    }
    const double undecided = engine.undecided * static_cast<double>(walk.pairs);
    is_spread_ = static_cast<double>(walk.reported) < undecided;
    undecided_ =
        undecided / std::max(1.0, static_cast<double>(is_spread_ ? walk.passes() : walk.reported));
    const int bits = design::segment_queue_bits(engine.lane_latency_cycles);
    most_queued_ = design::beats_before_stop(bits, engine.lane_latency_cycles);
  }

  /// Cycles until the word that closes the set has passed the last lanes and all reports have left.
  std::uint64_t run() {
    while (next_ < walk_.words.size() || in_chain_ > 0 || beats_ > 0 || waiting_ > 0 ||
           !answers_.empty() || verdicts_ >= 1 || !are_streams_idle()) {
      step();
      ++cycle_;
    }
    return std::max(cycle_, last_answer_);
  }

private:
  static constexpr int entry_places = 3;  ///< of the FIFO in front of a stream's expander
  static constexpr int pair_places = 20;  ///< of the FIFOs in front of the items' memory

  bool are_streams_idle() const {
    return std::all_of(streams_.begin(), streams_.end(),
                       [](const Stream& stream) { return stream.is_idle(); });
  }

  void step() {
    use_memory();
    for (Stream& stream : streams_) serve(stream);
    for (int s = walk_.segments; s-- > 0;) pass(s);
    enter();
  }

  /// The items' memory reads a pair, or else an item can be stored. References answer; half of the
  /// recomputed pairs are reported.
  void use_memory() {
    const double rate = engine_.recomputations_per_cycle;
    starts_ = std::min(1 + rate, starts_ + rate);
    for (; !answers_.empty() && answers_.front() <= cycle_; answers_.pop_front()) {
      if (engine_.report_as != scene::ReportForm::count) verdicts_ += 0.5;
    }
    if (waiting_ > 0 && starts_ >= 1) {
      --waiting_;
      starts_ -= 1;
      answers_.push_back(cycle_ + static_cast<std::uint64_t>(engine_.reference_latency_cycles));
    } else if (to_load_ > 0) {
      --to_load_;
      ++loaded_;
    }
  }

  /// The stream's expander sends a pair, and its tree fetches a beat. The first stream also sends
  /// the references' verdicts, in turn with its own.
  void serve(Stream& stream) {
    Beat& current = stream.current;
    bool is_port_free = true;
    if (&stream == &streams_.front() && verdicts_ >= 1 && (current.reports == 0 || was_report_)) {
      verdicts_ -= 1;
      is_port_free = was_report_ = false;
    }
    if (current.reports > 0) {
      if (is_port_free) --current.reports;
      was_report_ = was_report_ || (is_port_free && &stream == &streams_.front());
    } else if (current.undecided > 0 && waiting_ < pair_places) {
      --current.undecided;
      ++waiting_;
    }
    if (stream.is_idle() && !stream.entries.empty()) {
      current = stream.entries.front();
      stream.entries.pop_front();
      --beats_;
    }
    if (static_cast<int>(stream.entries.size()) < entry_places) fetch(stream);
  }

  /// A subtree below the root sends in every other cycle.
  void fetch(Stream& stream) {
    if (stream.arrived == 0) return;
    for (int k = 0; k < stream.segments; ++k) {
      const int place = (stream.turn + k) % stream.segments;
      Segment& segment = segments_[stream.first + place];
      if (segment.arrived == 0) continue;
      if (stream.subtrees > 0) {
        std::uint64_t& free = stream.free[place * stream.subtrees / stream.segments];
        if (free > cycle_) continue;
        free = cycle_ + 2;
      }
      stream.entries.push_back(segment.queue.front());
      segment.queue.pop_front();
      --segment.arrived;
      --stream.arrived;
      stream.turn = (place + 1) % stream.segments;
      return;
    }
  }

  /// The word in front of a segment goes past its lanes and to the next segment.
  void pass(int number) {
    Segment& segment = segments_[number];
    segment.was_full = segment.link.is_full();  // nothing has entered or left it in this cycle
    if (segment.next_arrival <= cycle_) count_arrivals(segment);
    if (!segment.link.is_ready(cycle_) || segment.arrived > most_queued_) return;
    const std::uint32_t word = segment.link.front();
    const bool leaves = walk_.words[word].stays != number && number + 1 < walk_.segments;
    if (leaves && segments_[number + 1].was_full) return;
    segment.link.pop();
    if (leaves) {
      segments_[number + 1].link.push(word, cycle_);
    } else {
      --in_chain_;
      last_answer_ = cycle_ + 1 + static_cast<std::uint64_t>(engine_.lane_latency_cycles);
    }
    push_exceptions(segment, walk_.count(word, number));
  }

  void count_arrivals(Segment& segment) {
    const auto queued = static_cast<int>(segment.queue.size());
    while (segment.arrived < queued && segment.queue[segment.arrived].ready <= cycle_) {
      ++segment.arrived;
      ++streams_[segment.stream].arrived;
    }
    const bool is_last = segment.arrived == queued;
    segment.next_arrival = is_last ? never : segment.queue[segment.arrived].ready;
  }

  void push_exceptions(Segment& segment, int reported) {
    if (reported == 0 && !is_spread_) return;
    int undecided = 0;
    segment.undecided += is_spread_ ? undecided_ : reported * undecided_;
    for (; segment.undecided >= 1; segment.undecided -= 1) {
      ++undecided;
      segment.reported_later += 0.5;
      if (segment.reported_later < 1 || reported == 0) continue;
      segment.reported_later -= 1;
      --reported;
    }
    reported = reports_of(reported, engine_.report_as);
    if (engine_.recomputations_per_cycle == 0) reported += std::exchange(undecided, 0);
    if (reported + undecided == 0) return;
    constexpr std::uint64_t way_to_queue_cycles = 3;
    const auto latency = static_cast<std::uint64_t>(engine_.lane_latency_cycles);
    const std::uint64_t ready = cycle_ + latency + way_to_queue_cycles;
    segment.queue.push_back({ready, reported, undecided});
    segment.next_arrival = std::min(segment.next_arrival, ready);
    ++beats_;
  }

  void enter() {
    if (next_ == walk_.words.size() || segments_.front().was_full) return;
    if (to_load_ > 0 && walk_.words[next_].needs > loaded_) return;
    segments_.front().link.push(static_cast<std::uint32_t>(next_), cycle_);
    ++in_chain_;
    ++next_;
  }

  const PairwiseWalk& walk_;
  const PairwiseEngine& engine_;
  std::uint64_t to_load_;  ///< items
  std::vector<Segment> segments_;
  std::vector<Stream> streams_;
  bool is_spread_ = false;  ///< undecided pairs are spread over all words
  double undecided_ = 0;    ///< pairs for a word in a segment if spread, else for a reported pair
  int most_queued_ = 0;
  std::uint64_t cycle_ = 0;
  std::uint64_t last_answer_ = 0;      ///< cycles until lanes have answered for the last word
  std::uint64_t next_ = 0;             ///< the word that enters next
  std::uint64_t in_chain_ = 0;         ///< words
  std::uint64_t beats_ = 0;            ///< in queues
  std::uint64_t loaded_ = 0;           ///< items
  int waiting_ = 0;                    ///< pairs in front of the items' memory
  double starts_ = 0;                  ///< recomputations that may start
  std::deque<std::uint64_t> answers_;  ///< the cycles in which references will answer
  double verdicts_ = 0;                ///< of references, to be reported
  bool was_report_ = false;            ///< the last word of the first stream was its own
};

}  // namespace

PairwiseFlow::PairwiseFlow(std::shared_ptr<const PairwiseData> data)
    : data_(std::move(data)), reported_share_(data_->reported_share()), walks_(most_walks) {}

double PairwiseFlow::cycles(const PairwiseEngine& engine) const {
  return *cycles_.of(engine, [&] { return count_cycles(engine); });
}

double PairwiseFlow::count_cycles(const PairwiseEngine& engine) const {
  const std::pair lanes(engine.lanes, engine.lanes_per_segment);
  const auto walk = walks_.of(lanes, [&] { return walk_pairs(*data_, lanes.first, lanes.second); });
  const ItemSet& set = data_->set;
  const double part = walk->part();
  // Cycles in which the last word passes the chain and the last lanes; a sample has them once.
  const double way = Link::latency_cycles * walk->segments + engine.lane_latency_cycles;
  double cycles = least_cycles(*walk, engine);
  bool is_loaded = false;  // `cycles` has those in which items come
  if (cycles < overloaded * static_cast<double>(walk->words.size())) {
    // In a sample all items count as loaded.
    Simulation simulation(*walk, engine, walk->is_sample() ? 0 : set.items + set.others);
    cycles = static_cast<double>(simulation.run()) - way;
    is_loaded = !walk->is_sample();
  }
  cycles = cycles / part + way + closing_cycles;
  // Targets come before the first word.
  if (!is_loaded && set.others > 0) cycles += static_cast<double>(set.items);
  return cycles;
}

}  // namespace mixcmp::performance
