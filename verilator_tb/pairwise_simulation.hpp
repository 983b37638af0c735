#pragma once

#include <cstdint>
#include <vector>

#include "verilator_tb/harness/pairwise_protocol.hpp"
#include "verilator_tb/system_simulation.hpp"

namespace mixcmp::verilator_tb {

/// One set for a pairwise engine.
struct ItemSet {
  std::uint64_t items = 0;
  std::uint64_t targets = 0;        ///< the first items, which only meet the others; 0: all meet
  std::vector<std::uint8_t> bytes;  ///< of all items
  std::uint64_t reset_after = 0;    ///< not 0: reset in that cycle of the set
  bool last = false;
};

/// The engine's answer to one set.
struct SetAnswer {
  harness::wire::SetResponse response = {};
  std::vector<harness::wire::ReportedPair> reports;
  std::vector<harness::wire::Violation> violations;
  std::vector<harness::wire::StreamEnd> streams;
  std::vector<std::uint64_t> answers;  ///< of each reference, where they are counted
};

/// A verilated pairwise engine at work in its own process.
class PairwiseSimulation {
public:
  static Result<PairwiseSimulation> start(const Executable& executable,
                                          const SimulationOptions& options);

  /// Sends a set and waits until the closing beats of all `streams`, or the reset.
  /// `answers`: the number of references whose answers are counted.
  Result<SetAnswer> exchange(const ItemSet& set, int streams, int answers);
  Result<Done> finish() { return process_.finish(); }

private:
  explicit PairwiseSimulation(SimulatorProcess process) : process_(std::move(process)) {}

  bool send(const ItemSet& set);
  bool receive(SetAnswer& answer, std::size_t streams, std::size_t answers);

  SimulatorProcess process_;
};

}  // namespace mixcmp::verilator_tb
