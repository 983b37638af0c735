#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "verilator_tb/build.hpp"
#include "verilator_tb/harness/protocol.hpp"

namespace mixcmp::tb {

enum class TrafficKind {
  full_rate,  ///< every lane is offered a comparison and may deliver a result in every cycle
  stressed,   ///< random gaps and backpressure, of changing density
};

struct SimulationOptions {
  TrafficKind traffic = TrafficKind::full_rate;
  std::uint64_t seed = 1;
  std::uint64_t hang_cycles = 50'000;  ///< without a result: lost, or the lane hangs
  std::filesystem::path waves;         ///< FST file to write; needs a build with waves
  std::vector<std::string> plusargs;   ///< for $test$plusargs and $value$plusargs
};

/// Comparisons for the simulator, in order; positions go on from the last block.
struct Block {
  std::uint64_t comparisons = 0;
  std::vector<std::uint8_t> operands;
  std::vector<std::uint64_t> resets;  ///< rising; reset when so many comparisons were offered
  bool last = false;
};

/// What came back for a block.
struct Answer {
  std::vector<wire::Result> results;
  std::vector<wire::Violation> violations;
  std::vector<wire::LaneEnd> lanes;  ///< of the last block
  std::uint64_t cycles = 0;          ///< so far
  wire::State state = wire::State::running;
};

/// A verilated system at work in its own process.
class SystemSimulation {
public:
  static model::Result<SystemSimulation> start(const Executable& executable,
                                               const SimulationOptions& options);

  /// Sends a block and waits for what it has led to.
  model::Result<Answer> exchange(const Block& block, int lanes);

private:
  SystemSimulation(Child child, std::filesystem::path log)
      : child_(std::move(child)), log_(std::move(log)) {}

  bool send(const Block& block);
  bool receive(Answer& answer, std::size_t lanes);

  Child child_;
  std::filesystem::path log_;
};

}  // namespace mixcmp::tb
