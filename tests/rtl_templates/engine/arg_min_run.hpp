#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "tests/rtl_templates/stream/random_source.hpp"
#include "verilator_tb/harness/ports.hpp"

namespace mixcmp::test {

/// The ports of arg_min_engine, whatever its parameters.
class ArgMinDut {
public:
  virtual ~ArgMinDut() = default;
  virtual void eval() = 0;

  harness::Port aclk, aresetn;
  harness::Port s_candidate_tvalid, s_candidate_tready, s_candidate_tdata, s_candidate_tlast;
  harness::Port candidate, candidate_word;
  harness::Port s_axis_tvalid, s_axis_tready, s_axis_tdata, s_axis_tuser, s_axis_tlast, row_word;
  harness::Port pair_tvalid, pair_tready, pair_best, pair_own, pair_tag;
  harness::Port result_tvalid, result_tready, result_tdata, result_tag;
  harness::Port refetch_tvalid, refetch_tready, refetch_tdata;
  harness::Port refetched_tvalid, refetched_tready, refetched_tdata;
  harness::Port m_axis_tvalid, m_axis_tready, m_axis_tdata, m_axis_tuser, m_axis_tlast;
  harness::Port overrun, rows, stalled_cycles;
};

struct ArgMinSpec {
  std::string name;
  std::function<std::unique_ptr<ArgMinDut>()> make;
  std::uint32_t candidates;
  int index_bits;
  int place_bits;
  int word_latency;
  int references;
};

inline void PrintTo(const ArgMinSpec& spec, std::ostream* stream) {
  *stream << spec.name;
}

/// The chances of events per cycle, and of a cost that is NaN.
struct ArgMinTraffic {
  const char* name = "";
  double load = 1.0;       ///< that a candidate is offered
  double offer = 1.0;      ///< that a row is offered
  double take = 1.0;       ///< that a lane takes a pair
  double give = 1.0;       ///< that a lane gives a result
  double accept = 1.0;     ///< that a result is taken
  double undecided = 0.0;  ///< that a lane leaves a pair to its reference
  double recompute = 1.0;  ///< that a reference takes the operands of a pair
  double nan = 0.1;
  double reset = 0.0;
  int lane_latency = 1;
  bool wary = false;       ///< a result is taken only once it was seen
  bool impatient = false;  ///< rows are offered even before and while candidates are loaded
};

/// Puts model lanes and model references around an engine. The lanes know rows and candidates only
/// by their words; the references get full operands for the pairs that lanes leave undecided.
/// Results are compared with a search that is made here, one candidate after the other.
class ArgMinRun {
public:
  static constexpr int candidate_bits = 21;
  static constexpr int row_bits = 13;
  static constexpr int word_bits = 23;
  static constexpr int row_word_bits = 15;
  static constexpr int tag_bits = 9;
  static constexpr std::size_t slots = 17;  ///< pairs that a lane holds

  ArgMinRun(const ArgMinSpec& spec, std::uint64_t seed) : ArgMinRun(spec, seed, {}) {}
  ArgMinRun(const ArgMinSpec& spec, std::uint64_t seed, ArgMinTraffic traffic);

  /// Offers `candidates` candidates while rows of the load before may be inside, and then (if
  /// impatient, at the same time) `rows` rows. Returns when all rows have been accepted. A reset
  /// throws the load out and starts it again.
  void run_load(std::uint32_t candidates, std::uint32_t rows);
  /// Runs until everything has left, and a while longer.
  void drain();
  void check_counters();

  bool failed() const { return !failure_.empty(); }
  const std::string& failure() const { return failure_; }
  std::uint64_t left() const { return left_; }
  std::uint64_t resets() const { return resets_; }
  /// The candidate that was chosen for row `index`, counted over all rows that left.
  std::uint64_t chosen(std::uint32_t index) const { return chosen_[index]; }
  std::uint64_t ties() const { return ties_; }
  /// Pairs whose operands a reference got.
  std::uint64_t recomputed() const { return recomputed_; }
  std::uint64_t incomparable() const { return incomparable_; }
  /// Cycles of the last row, from its acceptance to its departure.
  std::uint64_t latency() const { return latency_; }
  /// Cycles from the last candidate's acceptance to that of the first row behind it.
  std::uint64_t settling() const { return settling_; }
  /// Cycles between the departures of the last two rows.
  std::uint64_t interval() const { return interval_; }
  std::uint64_t stalled_cycles() const { return dut_->stalled_cycles.field(0, 32); }

private:
  struct Expected {
    std::uint32_t index, tag;
    bool last;
    std::uint64_t accepted;  ///< beats accepted in this cycle
  };
  /// A pair inside a lane, by the numbers that its words encode.
  struct Pair {
    std::uint32_t row, best, own;
    std::uint64_t tag;
    std::uint64_t due;  ///< no result before this cycle
    bool undecided;     ///< true until a reference has decided it
  };
  struct Lane {
    std::deque<Pair> inside;
    bool held = false;  ///< a pair was offered and not taken in the last cycle
    std::vector<std::uint64_t> held_pair;
    bool giving = false;
  };
  struct Reference {
    std::deque<std::size_t> asking;   ///< lanes with a pair of which it has not asked yet
    std::deque<std::size_t> waiting;  ///< lanes with a pair whose operands are on their way
    bool held = false;                ///< operands were offered and not taken in the last cycle
    std::vector<std::uint64_t> held_operands;
  };

  void fail(const std::string& what);
  void edge();
  void reset();
  void start_load();
  void cycle();
  void drive();
  void drive_streams();
  void take_candidate();
  void take_row();
  void take_pair(std::size_t k);
  void give_result(std::size_t k);
  void ask(std::size_t r);
  void recompute(std::size_t r);
  void take_result();
  void convert();
  int name_bits() const { return 2 * spec_.index_bits + spec_.place_bits; }
  Pair* undecided_pair(std::size_t lane);
  std::uint32_t cost(std::uint32_t row, std::uint32_t candidate) const;
  std::uint32_t verdict(std::uint32_t row, std::uint32_t best, std::uint32_t own) const;
  std::uint32_t least(std::uint32_t row);

  const ArgMinSpec spec_;
  const ArgMinTraffic traffic_;
  std::unique_ptr<ArgMinDut> dut_;
  RandomSource random_;
  std::vector<Lane> lanes_;
  std::vector<Reference> references_;
  /// The contents of the conversions, the newest first.
  std::deque<std::uint32_t> converting_candidates_, converting_rows_;
  std::vector<std::uint32_t> candidates_;  ///< all that this load offers
  std::vector<std::uint32_t> held_;        ///< those of the last whole load
  std::size_t loaded_ = 0;                 ///< candidates of this load that were accepted
  std::uint32_t rows_left_ = 0;            ///< rows of this load that are not accepted yet
  bool loading_ = false;                   ///< a candidate is on offer
  bool was_loading_ = false;               ///< a candidate was on offer in the cycle before
  bool offering_ = false;                  ///< a row is on offer
  std::uint32_t row_ = 0, tag_ = 0;
  bool row_last_ = false;
  bool may_reset_ = false;
  std::deque<Expected> expected_;
  bool held_result_ = false;  ///< a result was offered and not taken in the last cycle
  std::uint64_t held_data_ = 0;
  std::uint64_t cycles_ = 0;
  std::uint64_t loaded_at_ = 0, left_at_ = 0;
  std::uint64_t left_ = 0, resets_ = 0, ties_ = 0, incomparable_ = 0, recomputed_ = 0;
  std::uint64_t latency_ = 0, settling_ = 0, interval_ = 0;
  std::uint32_t counted_ = 0;     ///< rows that left since reset
  std::uint32_t stalled_ = 0;     ///< cycles since reset in which a row waited only for room
  std::uint32_t rows_taken_ = 0;  ///< accepted rows of the last whole load
  std::vector<std::uint64_t> chosen_;
  std::string failure_;
};

}  // namespace mixcmp::test
