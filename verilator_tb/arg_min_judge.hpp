#pragma once

#include <cstdint>

#include "verilator_tb/arg_min_simulation.hpp"
#include "verilator_tb/verify.hpp"

namespace mixcmp::tb {

/// Candidates 0 .. candidates - 1 of the scene's and rows first .. first + rows - 1.
struct LoadRange {
  std::uint64_t candidates = 0;
  std::uint64_t first = 0;
  std::uint64_t rows = 0;
};

/// Holds what an arg-min engine answers against the golden model, which makes every comparison of
/// the chain as its lane must; and where the design is certified, against the arg-min by the
/// reference alone.
class ArgMinJudge {
public:
  /// What becomes of a load's findings.
  enum class Use {
    check,    ///< mismatches and violations alone
    figures,  ///< the report's numbers, too; for the one load that is the scene's data
  };

  ArgMinJudge(const gen::Signature& signature, const model::Design& design,
              const model::Comparisons& comparisons, const VerifyOptions& options);

  void take(const LoadRange& load, const LoadAnswer& answer, Use use);
  VerifyReport& report() { return report_; }

private:
  std::uint64_t chain(const LoadRange& load, std::uint64_t row, Use use);
  void count(std::uint64_t row, std::uint64_t best, std::uint64_t own, std::uint32_t tdata);
  void judge_row(const LoadRange& load, std::uint64_t row, const wire::RowResult& got, Use use);
  void judge_end(const LoadRange& load, const LoadAnswer& answer, Use use);
  void judge_counters(const LoadAnswer& answer, Use use);
  void check_counter(const std::string& name, std::uint64_t counted, std::uint64_t observed,
                     CounterTotal& total);
  void add_mismatch(std::uint64_t row, std::uint64_t expected, const wire::RowResult& got);
  void add_violation(std::string fault, std::uint64_t cycle, std::string details);

  const gen::Signature& signature_;
  const model::Design& design_;
  const model::Comparisons& comparisons_;
  const VerifyOptions& options_;
  std::vector<std::size_t> group_of_lane_;
  std::vector<wire::LaneEnd> lanes_;  ///< since reset: what the model makes of their pairs
  std::vector<model::Bits> operands_;
  std::uint64_t stalled_before_ = 0;  ///< the counter, after the last load
  VerifyReport report_;
};

}  // namespace mixcmp::tb
