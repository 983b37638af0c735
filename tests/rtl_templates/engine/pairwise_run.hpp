#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "tests/rtl_templates/stream/random_source.hpp"
#include "verilator_tb/harness/ports.hpp"

namespace mixcmp::test {

/// The ports of pairwise_bench, whatever its parameters.
class EngineDut {
public:
  virtual ~EngineDut() = default;
  virtual void eval() = 0;

  harness::Port aclk, aresetn;
  harness::Port s_axis_tvalid, s_axis_tready, s_axis_tdata, s_axis_tuser, s_axis_tlast;
  harness::Port reference_ready;
  harness::Port m_axis_tvalid, m_axis_tready, m_axis_tdata, m_axis_tuser, m_axis_tlast;
  harness::Port reports, recomputations, busy_cycles, stalled_cycles;
};

/// Which pairs leave, and how.
enum class ReportForm { pairs, bitmap, count };

/// The parameters of pairwise_bench.
struct EngineSpec {
  std::string name;
  std::function<std::unique_ptr<EngineDut>()> make;
  int segments;
  int lanes_per_segment;
  int last_lanes;
  int streams;
  int references;
  int capacity;
  int index_bits;
  unsigned report;  ///< bit v: verdict v leaves
  ReportForm form;
  unsigned undecided;  ///< undecided pairs among 16
  int lane_latency;
  int word_latency;
  bool tiered;
  unsigned tier_undecided;  ///< pairs still undecided, of 16 that the segment left undecided
  int tier_latency;

  int lanes() const { return (segments - 1) * lanes_per_segment + last_lanes; }
};

inline void PrintTo(const EngineSpec& spec, std::ostream* stream) {
  *stream << spec.name;
}

/// The chances of events per cycle.
struct EngineTraffic {
  const char* name = "";
  double offer = 1.0;   ///< that an item is offered
  double answer = 1.0;  ///< that a reference takes a pair
  double accept = 1.0;  ///< that a report is taken
  double reset = 0.0;
  bool wary = false;  ///< a report is taken only once it was seen
  /// The cycles of a set during which `accept` applies; from then on reports are always taken.
  std::uint64_t slow_cycles = ~std::uint64_t{0};
};

/// The items of one set. The first `targets` of them meet only the others; 0: all meet.
struct ItemSet {
  int items = 0;
  int targets = 0;
  bool equal = false;  ///< all items are alike
};

/// Loads sets of random items and compares the reports with those that are due for the items.
class EngineRun {
public:
  static constexpr int item_bits = 20;

  EngineRun(const EngineSpec& spec, std::uint64_t seed);

  /// Loads a set and runs until its last closing beat has left. A reset throws the set out; it is
  /// loaded again, without resets.
  void run_set(const ItemSet& set, const EngineTraffic& traffic);
  /// Runs some cycles without items, in which nothing may leave.
  void idle(int cycles);
  /// Compares the counters with the events seen since reset.
  void check_counters();

  bool failed() const { return !failure_.empty(); }
  const std::string& failure() const { return failure_; }
  /// Cycles of the last set, from its first item to its closing beat.
  std::uint64_t set_cycles() const { return set_cycles_; }
  /// Stalled cycles since reset, as the hardware counts them.
  std::uint64_t stalled_cycles() const { return dut_->stalled_cycles.field(0, 32); }
  std::uint64_t recomputed() const { return recomputed_; }
  std::uint64_t reported() const { return reported_; }
  std::uint64_t resets() const { return resets_; }

private:
  using Tag = std::pair<std::uint32_t, std::uint32_t>;  ///< {i, j}
  struct Stream {
    bool held = false;  ///< a beat was offered and not taken in the last cycle
    std::vector<std::uint64_t> held_beat;
    bool closed = false;
    std::uint64_t pairs = 0;      ///< pairs of this set
    std::uint64_t set_beats = 0;  ///< reports of this set
    std::uint32_t beats = 0;      ///< reports since reset
  };

  void fail(const std::string& what);
  void reset();
  void edge();
  void start_set(const ItemSet& set);
  void expect_pair(std::uint32_t i, std::uint32_t j);
  void cycle(const EngineTraffic& traffic);
  void drive(const EngineTraffic& traffic);
  void take_item();
  void take_beat(std::size_t s);
  void take_report(Stream& stream, std::uint32_t i, std::uint32_t j, std::uint64_t flags,
                   std::uint32_t user);
  void take_closing_beat(Stream& stream, std::uint64_t count, std::uint32_t user);
  void close();
  std::uint32_t item(std::uint32_t index) const;
  bool is_target(std::uint32_t index) const;
  std::uint32_t kept() const;

  const EngineSpec spec_;
  std::unique_ptr<EngineDut> dut_;
  RandomSource random_;
  std::vector<Stream> streams_;
  std::uint32_t set_number_ = 0;
  ItemSet set_;
  std::uint32_t loaded_ = 0;
  bool offering_ = false;
  bool open_ = false;                 ///< a closing beat is still to come
  std::map<Tag, std::uint32_t> due_;  ///< reports of this set: {undecided, recomputed, verdict}
  std::map<Tag, std::uint32_t> reports_;
  std::uint64_t asked_ = 0;  ///< recomputations that this set needs
  std::uint64_t set_cycles_ = 0;
  std::uint64_t cycles_ = 0;
  std::uint64_t recomputed_ = 0;
  std::uint64_t reported_ = 0;
  std::uint64_t resets_ = 0;
  std::uint32_t counted_recomputations_ = 0;  ///< since reset
  std::uint32_t busy_cycles_ = 0;
  std::string failure_;
};

}  // namespace mixcmp::test
