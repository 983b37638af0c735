#pragma once

#include <cstdint>
#include <memory>

#include "model/cost/performance/pairwise_flow.hpp"
#include "verilator_tb/engine_judge.hpp"
#include "verilator_tb/pairwise_simulation.hpp"

namespace mixcmp::verilator_tb {

/// Consecutive rows of a table.
struct RowRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};

/// A set of items: rows of the scene's table, where every two meet; or rows of its first table that
/// meet rows of its second.
struct SetRange {
  RowRange items;
  RowRange others = {};  ///< of the second table; none: all items meet

  std::uint64_t size() const { return items.count + others.count; }
  std::uint64_t targets() const { return others.count > 0 ? items.count : 0; }
  /// The first item of the set that item i meets.
  std::uint64_t first_partner(std::uint64_t i) const {
    return others.count > 0 ? items.count : i + 1;
  }
};

/// Compares the reports of a pairwise engine with the golden model: each pair of a set must be
/// reported once if its verdict asks for it, else not at all, and with the right result. Also
/// judges the closing beat and the counters.
class PairwiseJudge : public EngineJudge {
public:
  PairwiseJudge(const emit::Signature& signature, const design::Design& design,
                const data::Comparisons& comparisons, const VerifyOptions& options);

  void take(const SetRange& set, const SetAnswer& answer, Use use);

  /// The pairs of the set whose figures the report has, with those marked that the design should
  /// report; complete once that set was taken. A pair that leaves the engine undecided is marked by
  /// its verdict in the reference format.
  std::shared_ptr<const performance::PairwiseData> data() const { return data_; }

private:
  /// The reports of one set, in the order of pairs.
  class Reports;

  void judge_closed(const SetRange& set, const SetAnswer& answer, Use use);
  void judge_interrupted(const SetRange& set, const SetAnswer& answer);
  void judge_pair(const SetRange& set, std::uint64_t i, std::uint64_t j, Reports& reports, Use use);
  void judge_closing_beats(const SetAnswer& answer, std::uint64_t due);
  void judge_counters(const SetAnswer& answer, Use use);
  data::Items rows_of(const SetRange& set, std::uint64_t i, std::uint64_t j) const;
  bool is_pair(const SetRange& set, std::uint64_t i, std::uint64_t j) const;
  ResultWord expected(const SetRange& set, std::uint64_t i, std::uint64_t j);
  bool is_reported(ResultWord word) const;
  void add_mismatch(const SetRange& set, std::uint64_t i, std::uint64_t j, ResultWord expected,
                    const harness::wire::ReportedPair* got);
  void count(const SetRange& set, std::uint64_t i, std::uint64_t j, ResultWord word);
  void mark_if_reported(std::uint64_t pair, ResultWord word);
  std::uint64_t pair_of(const SetRange& set, std::uint64_t i, std::uint64_t j) const;
  std::size_t lane_of(std::uint64_t i) const { return i % group_of_lane_.size(); }
  bool counts_only() const { return signature_.engine->report_as == scene::ReportForm::count; }

  std::shared_ptr<performance::PairwiseData> data_;
  std::uint64_t recomputations_ = 0;  ///< by the golden model, since reset
  std::uint64_t due_ = 0;             ///< reports of this set, by the golden model
};

}  // namespace mixcmp::verilator_tb
