#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "verilator_tb/harness/protocol.hpp"
#include "verilator_tb/verify.hpp"

namespace mixcmp::verilator_tb {

/// The base of the judges of all engines: the report, the lanes' counters since reset, and how a
/// fault is recorded.
class EngineJudge {
public:
  /// Which findings of a trial enter the report.
  enum class Use {
    check,    ///< only mismatches and violations
    figures,  ///< also the report's numbers; for the one trial that is the scene's data
  };

  VerifyReport& report() { return report_; }

protected:
  EngineJudge(const emit::Signature& signature, const design::Design& design,
              const data::Comparisons& comparisons, const VerifyOptions& options);

  /// Compares the lanes' own counters with `lanes_`. Returns the totals, by name.
  std::vector<CounterTotal> check_lanes(const std::vector<harness::wire::CounterValues>& counted);
  /// Compares the answers of each reference of a system inside with the recomputations of its
  /// lanes, and adds the total. Does nothing where answers are not counted.
  void check_answers(const std::vector<std::uint64_t>& counted, std::vector<CounterTotal>& totals);
  void check_counter(const std::string& name, std::uint64_t counted, std::uint64_t observed,
                     CounterTotal& total);
  /// How much the engine's counter of stalled cycles, which may wrap, has grown since the last
  /// call; `counted` is its value now.
  std::uint64_t stalls_gained(std::uint64_t counted);
  void add_violation(std::string fault, std::uint64_t cycle, std::string details);

  const emit::Signature& signature_;
  const design::Design& design_;
  const data::Comparisons& comparisons_;
  const VerifyOptions& options_;
  std::vector<std::size_t> group_of_lane_;
  std::vector<harness::wire::CounterValues>
      lanes_;  ///< `observed`: by the golden model, since reset
  std::vector<Bits> operands_;
  std::uint64_t stalled_before_ = 0;  ///< the stall counter after the last trial
  VerifyReport report_;
};

}  // namespace mixcmp::verilator_tb
