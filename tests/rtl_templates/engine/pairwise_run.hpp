#pragma once

#include <cstdint>
#include <deque>
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

/// The ports of pairwise_engine, whatever its parameters.
class EngineDut {
public:
  virtual ~EngineDut() = default;
  virtual void eval() = 0;

  harness::Port aclk, aresetn;
  harness::Port s_axis_tvalid, s_axis_tready, s_axis_tdata, s_axis_tlast;
  harness::Port pair_tvalid, pair_tready, pair_items, pair_tag;
  harness::Port result_tvalid, result_tready, result_tdata, result_tag;
  harness::Port s_refetch_tvalid, s_refetch_tready, s_refetch_tdata;
  harness::Port m_answer_tvalid, m_answer_tready, m_answer_tdata;
  harness::Port m_axis_tvalid, m_axis_tready, m_axis_tdata, m_axis_tuser, m_axis_tlast;
  harness::Port reports, busy_cycles, stalled_cycles;
};

struct EngineSpec {
  std::string name;
  std::function<std::unique_ptr<EngineDut>()> make;
  int lanes;
  int references;
  int capacity;
  int index_bits;
  int radix;
  unsigned report;  ///< bit v: verdict v leaves
};

inline void PrintTo(const EngineSpec& spec, std::ostream* stream) {
  *stream << spec.name;
}

/// Chances per cycle, and of a pair being undecided.
struct EngineTraffic {
  const char* name = "";
  double offer = 1.0;      ///< that an item is offered
  double take = 1.0;       ///< that a lane takes a pair
  double give = 1.0;       ///< that a lane gives a result
  double accept = 1.0;     ///< that a report is taken
  double undecided = 0.1;  ///< of a pair
  double reset = 0.0;
  bool quiet = false;  ///< all verdicts are of a kind that is not reported
  bool wary = false;   ///< a report is taken only once it was seen
  /// Of a set, in which `take` and `give` count; from then on lanes are always ready.
  std::uint64_t slow_cycles = ~std::uint64_t{0};
};

/// Puts model lanes and references around an engine, which know the items only by their pairs, and
/// holds what comes out against the items that went in.
class EngineRun {
public:
  static constexpr int item_bits = 20;
  static constexpr std::size_t slots = 16;  ///< pairs that a model lane holds

  EngineRun(const EngineSpec& spec, std::uint64_t seed);

  /// Loads a set and runs until its closing beat has left. A reset throws the set out; it is loaded
  /// again, without resets. `equal`: all items are alike.
  void run_set(int items, const EngineTraffic& traffic, bool equal = false);
  /// Some cycles without items: nothing may leave.
  void idle(int cycles);
  /// Counters against what was seen since reset.
  void check_counters();

  bool failed() const { return !failure_.empty(); }
  const std::string& failure() const { return failure_; }
  std::uint64_t cycles() const { return cycles_; }
  /// Of the last set, from its first item to its closing beat.
  std::uint64_t set_cycles() const { return set_cycles_; }
  /// Since reset, as the hardware counts them.
  std::uint64_t stalled_cycles() const { return dut_->stalled_cycles.field(0, 32); }
  std::uint64_t recomputed() const { return recomputed_; }
  std::uint64_t refetched() const { return refetched_; }
  std::uint64_t reported() const { return reported_; }
  std::uint64_t resets() const { return resets_; }

private:
  using Tag = std::pair<std::uint32_t, std::uint32_t>;  ///< {i, j}
  struct Result {
    Tag tag;
    std::uint32_t flags;  ///< {undecided, recomputed, verdict}
  };
  struct Lane {
    std::deque<Result> results;  ///< ready to leave
    std::size_t inside = 0;      ///< results included
    bool held = false;           ///< a pair was offered and not taken in the last cycle
    std::vector<std::uint64_t> held_pair;
    bool giving = false;
  };
  struct Reference {
    std::deque<std::pair<std::size_t, Tag>> asked;  ///< of which lane; not on offer yet
    std::deque<std::pair<std::size_t, Tag>> awaited;
    bool offering = false;
  };

  void fail(const std::string& what);
  void reset();
  void edge();
  void cycle(const EngineTraffic& traffic);
  void drive(const EngineTraffic& traffic);
  void take_item();
  void take_pair(std::size_t k, const EngineTraffic& traffic);
  void give_result(std::size_t k);
  void serve_reference(std::size_t r);
  void take_report();
  void close(std::uint64_t count, bool overrun);
  std::uint32_t item(std::uint32_t index) const;
  std::uint32_t verdict(Tag tag, const EngineTraffic& traffic) const;
  std::uint32_t kept() const;
  void start_set(int items, bool equal);

  const EngineSpec spec_;
  std::unique_ptr<EngineDut> dut_;
  RandomSource random_;
  std::vector<Lane> lanes_;
  std::vector<Reference> references_;
  std::uint32_t set_ = 0;
  std::uint32_t items_ = 0;  ///< offered in this set
  bool equal_ = false;
  std::uint32_t loaded_ = 0;
  bool offering_ = false;
  bool open_ = false;                     ///< the closing beat is still to come
  std::map<Tag, std::uint32_t> met_;      ///< pairs that a lane took, and what it made of them
  std::map<Tag, std::uint32_t> reports_;  ///< of this set
  bool held_report_ = false;              ///< a report was offered and not taken in the last cycle
  std::uint64_t held_data_ = 0;
  std::uint64_t cycles_ = 0;
  std::uint64_t set_cycles_ = 0;
  std::uint64_t recomputed_ = 0;
  std::uint64_t refetched_ = 0;
  std::uint64_t reported_ = 0;
  std::uint64_t resets_ = 0;
  std::uint32_t counted_reports_ = 0;  ///< since reset
  std::uint32_t busy_cycles_ = 0;
  std::string failure_;
};

}  // namespace mixcmp::test
