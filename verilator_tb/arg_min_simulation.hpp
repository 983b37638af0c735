#pragma once

#include <cstdint>
#include <vector>

#include "verilator_tb/harness/arg_min_protocol.hpp"
#include "verilator_tb/system_simulation.hpp"

namespace mixcmp::tb {

/// One load for an arg-min engine, and its rows.
struct CandidateLoad {
  wire::LoadRequest request = {};
  std::vector<std::uint8_t> candidates;
  std::vector<std::uint8_t> rows;
};

/// The engine's answer to one load.
struct LoadAnswer {
  wire::LoadResponse response = {};
  std::vector<wire::RowResult> rows;
  std::vector<wire::Violation> violations;
  std::vector<wire::LaneEnd> lanes;
};

/// A verilated arg-min engine at work in its own process.
class ArgMinSimulation {
public:
  static model::Result<ArgMinSimulation> start(const Executable& executable,
                                               const SimulationOptions& options);

  /// Sends a load and waits until its rows have left, or the reset.
  model::Result<LoadAnswer> exchange(const CandidateLoad& load, int lanes);
  model::Result<model::Done> finish() { return process_.finish(); }

private:
  explicit ArgMinSimulation(SimulatorProcess process) : process_(std::move(process)) {}

  bool receive(LoadAnswer& answer, std::size_t lanes);

  SimulatorProcess process_;
};

}  // namespace mixcmp::tb
