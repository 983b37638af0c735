#pragma once

#include <cstdint>

#include "verilator_tb/pairwise_simulation.hpp"
#include "verilator_tb/verify.hpp"

namespace mixcmp::tb {

/// Items first .. first + count - 1 of the scene's table as one set.
struct SetRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};

/// Holds what a pairwise engine reports against the golden model: of every pair of a set, whether
/// it is reported, once, and what is said of it; the closing beat; the counters.
class PairwiseJudge {
public:
  /// What becomes of a set's findings.
  enum class Use {
    check,    ///< mismatches and violations alone
    figures,  ///< the report's numbers, too; for the one set that is the scene's data
  };

  PairwiseJudge(const gen::Signature& signature, const model::Design& design,
                const model::Comparisons& comparisons, const VerifyOptions& options);

  void take(const SetRange& set, const SetAnswer& answer, Use use);
  VerifyReport& report() { return report_; }

private:
  /// The reports of one set, in the order of pairs.
  class Reports;

  void judge_closed(const SetRange& set, const SetAnswer& answer, Use use);
  void judge_interrupted(const SetRange& set, const SetAnswer& answer);
  void judge_pair(const SetRange& set, std::uint64_t i, std::uint64_t j, Reports& reports, Use use);
  void judge_closing_beat(const SetAnswer& answer, std::uint64_t due);
  void judge_counters(const SetAnswer& answer, Use use);
  std::uint32_t expected(const SetRange& set, std::uint64_t i, std::uint64_t j);
  bool is_reported(std::uint32_t tdata) const;
  void add_mismatch(const SetRange& set, std::uint64_t i, std::uint64_t j, std::uint32_t expected,
                    const wire::Report* got);
  void add_violation(std::string fault, std::uint64_t cycle, std::string details);
  void count(const SetRange& set, std::uint64_t i, std::uint64_t j, std::uint32_t tdata);
  void check_counter(const std::string& name, std::uint64_t counted, std::uint64_t observed,
                     CounterTotal& total);
  std::uint64_t pair_of(const SetRange& set, std::uint64_t i, std::uint64_t j) const;
  std::size_t lane_of(std::uint64_t i) const { return i % group_of_lane_.size(); }

  const gen::Signature& signature_;
  const model::Design& design_;
  const model::Comparisons& comparisons_;
  const VerifyOptions& options_;
  std::vector<std::size_t> group_of_lane_;
  std::vector<wire::LaneEnd> lanes_;  ///< since reset: what the model makes of their pairs
  std::vector<model::Bits> operands_;
  std::uint64_t stalled_before_ = 0;  ///< the counter, when the last set had closed
  VerifyReport report_;
};

}  // namespace mixcmp::tb
