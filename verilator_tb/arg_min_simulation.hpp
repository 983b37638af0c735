#pragma once

#include <cstdint>
#include <vector>

#include "verilator_tb/harness/arg_min_protocol.hpp"
#include "verilator_tb/system_simulation.hpp"

namespace mixcmp::verilator_tb {

/// One load for an arg-min engine, and its rows.
struct CandidateLoad {
  harness::wire::LoadRequest request = {};
  std::vector<std::uint8_t> candidates;
  std::vector<std::uint8_t> rows;
};

/// The engine's answer to one load.
struct LoadAnswer {
  harness::wire::LoadResponse response = {};
  std::vector<harness::wire::RowResult> rows;
  std::vector<harness::wire::Violation> violations;
  std::vector<harness::wire::CounterValues> lanes;
  std::vector<std::uint64_t> answers;  ///< of each reference, where they are counted
};

/// A verilated arg-min engine at work in its own process.
class ArgMinSimulation {
public:
  static Result<ArgMinSimulation> start(const Executable& executable,
                                        const SimulationOptions& options);

  /// Sends a load and waits until its rows have left, or the reset.
  /// `answers`: the number of references whose answers are counted.
  Result<LoadAnswer> exchange(const CandidateLoad& load, int lanes, int answers);
  Result<Done> finish() { return process_.finish(); }

private:
  explicit ArgMinSimulation(SimulatorProcess process) : process_(std::move(process)) {}

  bool receive(LoadAnswer& answer, std::size_t lanes, std::size_t answers);

  SimulatorProcess process_;
};

}  // namespace mixcmp::verilator_tb
