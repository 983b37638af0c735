#pragma once

#include <cstdint>

#include "verilator_tb/arg_min_chain.hpp"
#include "verilator_tb/arg_min_simulation.hpp"
#include "verilator_tb/engine_judge.hpp"

namespace mixcmp::verilator_tb {

/// The part of the scene's data in one load: candidates 0 .. candidates - 1, and rows
/// first .. first + rows - 1.
struct LoadRange {
  std::uint64_t candidates = 0;
  std::uint64_t first = 0;
  std::uint64_t rows = 0;
};

/// Compares the answers of an arg-min engine with the golden model, which plays the engine's
/// contest: each comparison has the verdict of the lane that makes it or, where the lane does not
/// decide, that of the reference. The reference's own search may find other candidates, since it
/// rounds.
class ArgMinJudge : public EngineJudge {
public:
  ArgMinJudge(const emit::Signature& signature, const design::Design& design,
              const data::Comparisons& comparisons, const VerifyOptions& options);

  void take(const LoadRange& load, const LoadAnswer& answer, Use use);

private:
  /// The candidate that the chain chooses for a row; counts what each lane does.
  std::uint64_t choose(const LoadRange& load, std::uint64_t row, Use use);
  void count(const ChainComparison& made);
  void judge_row(const LoadRange& load, std::uint64_t row, const harness::wire::RowResult& got,
                 Use use);
  void judge_end(const LoadRange& load, const LoadAnswer& answer, Use use);
  void judge_counters(const LoadAnswer& answer, Use use);
  void add_mismatch(std::uint64_t row, std::uint64_t expected, const harness::wire::RowResult& got);

  ArgMinChain chain_;
};

}  // namespace mixcmp::verilator_tb
