#pragma once

#include <cstdint>

#include "verilator_tb/engine_judge.hpp"
#include "verilator_tb/pairwise_simulation.hpp"

namespace mixcmp::verilator_tb {

/// A set that consists of items first .. first + count - 1 of the scene's table.
struct SetRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};

/// Compares the reports of a pairwise engine with the golden model: each pair of a set must be
/// reported once if its verdict asks for it, else not at all, and with the right result. Judges the
/// closing beat and the counters, too.
class PairwiseJudge : public EngineJudge {
public:
  PairwiseJudge(const emit::Signature& signature, const design::Design& design,
                const data::Comparisons& comparisons, const VerifyOptions& options);

  void take(const SetRange& set, const SetAnswer& answer, Use use);

private:
  /// The reports of one set, in the order of pairs.
  class Reports;

  void judge_closed(const SetRange& set, const SetAnswer& answer, Use use);
  void judge_interrupted(const SetRange& set, const SetAnswer& answer);
  void judge_pair(const SetRange& set, std::uint64_t i, std::uint64_t j, Reports& reports, Use use);
  void judge_closing_beat(const SetAnswer& answer, std::uint64_t due);
  void judge_counters(const SetAnswer& answer, Use use);
  ResultWord expected(const SetRange& set, std::uint64_t i, std::uint64_t j);
  bool is_reported(ResultWord word) const;
  void add_mismatch(const SetRange& set, std::uint64_t i, std::uint64_t j, ResultWord expected,
                    const harness::wire::ReportedPair* got);
  void count(const SetRange& set, std::uint64_t i, std::uint64_t j, ResultWord word);
  std::uint64_t pair_of(const SetRange& set, std::uint64_t i, std::uint64_t j) const;
  std::size_t lane_of(std::uint64_t i) const { return i % group_of_lane_.size(); }
};

}  // namespace mixcmp::verilator_tb
