#pragma once

#include <verilated.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <unordered_map>
#include <vector>

#include "tests/rtl_templates/stream/random_source.hpp"

namespace mixcmp::test {

/// The ports of stream_system_bench, whatever its parameters.
class SystemDut {
public:
  virtual ~SystemDut() = default;
  virtual void eval() = 0;

  CData* aclk = nullptr;
  CData* aresetn = nullptr;
  IData* s_valid = nullptr;
  IData* s_ready = nullptr;
  VlWide<32>* s_operands = nullptr;
  VlWide<32>* s_tags = nullptr;
  IData* m_valid = nullptr;
  IData* m_ready = nullptr;
  VlWide<32>* m_results = nullptr;
  VlWide<32>* m_tags = nullptr;
  VlWide<32>* comparisons = nullptr;
  VlWide<32>* recomputations = nullptr;
  VlWide<32>* stalls = nullptr;
  SData* m_refetch_valid = nullptr;
  SData* m_refetch_ready = nullptr;
  VlWide<16>* m_refetch_tags = nullptr;
  SData* s_refetch_valid = nullptr;
  SData* s_refetch_ready = nullptr;
  VlWide<16>* s_refetch_operands = nullptr;
};

struct SystemSpec {
  std::string name;
  std::function<std::unique_ptr<SystemDut>()> make;
  int lanes;  ///< number of lanes, or of groups of lanes
  int references;
  bool in_order;
  bool carried;
  int lane_latency_cycles;
  int reference_latency_cycles;
  int slot_bits;
  int initiation_interval;  ///< the references'
  int beat_bits;            ///< a request has 2^beat_bits beats
  int group;                ///< lanes in lock step; 1: each by itself
};

inline void PrintTo(const SystemSpec& spec, std::ostream* stream) {
  *stream << spec.name;
}

/// The chances of events per cycle, and of an undecided comparison.
struct SystemTraffic {
  const char* name = "";
  double offer = 1.0;
  double accept = 1.0;
  double undecided = 0.0;
  double reset = 0.0;
  double refetch = 1.0;  ///< that the user's memory takes a tag; that it gives operands
};

/// Drives a system and compares every result with the one that its operands determine. The class
/// knows nothing of slots, queues or requests: a comparison is outstanding from acceptance until
/// its result. In a system of groups each group counts as a lane, and a word of one comparison for
/// each lane of the group as a comparison.
class SystemRun {
public:
  SystemRun(const SystemSpec& spec, std::uint64_t seed);

  void reset();
  void cycle(const SystemTraffic& traffic);
  /// Runs until nothing is outstanding, for at most `limit` cycles. Returns the number of cycles.
  int drain(int limit);

  bool failed() const { return !failure_.empty(); }
  const std::string& failure() const { return failure_; }
  std::uint64_t outstanding() const;
  std::uint64_t accepted() const { return accepted_; }
  std::uint64_t received() const { return received_; }
  std::uint64_t recomputed() const { return recomputed_; }
  std::uint64_t overtaken() const { return overtaken_; }
  std::uint64_t cycles() const { return cycles_; }
  const std::vector<std::uint64_t>& received_of_lane() const { return received_of_lane_; }
  /// Compares the counters with the events seen since reset. To be called when nothing is
  /// outstanding.
  void check_counters();

private:
  struct Comparison {
    std::uint32_t tag;
    std::uint32_t word;
  };
  struct Lane {
    bool offering = false;
    Comparison offer{};
    std::deque<std::uint32_t> order;  ///< outstanding tags, oldest first
    bool held = false;                ///< a result was valid and not taken in the last cycle
    std::uint32_t held_result = 0;
    std::uint32_t held_tag = 0;
    std::uint32_t comparisons = 0;
    std::uint32_t undecided = 0;
    std::uint32_t stalls = 0;
  };
  struct Memory {  ///< the user's memory: one port per reference
    std::deque<std::uint32_t> asked;
    bool giving = false;
    bool held = false;
    std::uint32_t held_tag = 0;
  };

  void fail(const std::string& what);
  std::uint8_t expected_result(std::uint32_t word) const;
  std::uint32_t expected_results(std::uint32_t word) const;
  std::uint32_t undecided_lanes(std::uint32_t word) const;
  std::uint32_t random_word(double undecided);
  void edge();
  void drive(const SystemTraffic& traffic);
  void drive_memories(const SystemTraffic& traffic);
  void check_that_valid_ignores_ready();
  void take_input(int i);
  void take_result(int i);
  void check_that_result_holds(int i);
  void serve_memory(int r);

  const SystemSpec spec_;
  const std::uint64_t seed_;
  std::unique_ptr<SystemDut> dut_;
  RandomSource random_;
  std::vector<Lane> lanes_;
  std::vector<Memory> memories_;
  std::unordered_map<std::uint32_t, std::uint32_t> word_of_tag_;      ///< outstanding words
  std::unordered_map<std::uint32_t, std::uint32_t> operands_of_tag_;  ///< one per comparison
  std::uint32_t issued_ = 0;
  std::uint64_t accepted_ = 0;
  std::uint64_t received_ = 0;
  std::uint64_t recomputed_ = 0;
  std::uint64_t overtaken_ = 0;
  std::uint64_t cycles_ = 0;
  std::vector<std::uint64_t> received_of_lane_;
  std::string failure_;
};

}  // namespace mixcmp::test
