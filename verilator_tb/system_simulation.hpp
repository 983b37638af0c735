#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/base/common/scratch_folder.hpp"
#include "verilator_tb/build.hpp"
#include "verilator_tb/harness/protocol.hpp"

namespace mixcmp::verilator_tb {

enum class TrafficKind {
  full_rate,  ///< every lane is offered a comparison and may deliver a result in every cycle
  stressed,   ///< random gaps and backpressure, of changing density
};

struct SimulationOptions {
  TrafficKind traffic = TrafficKind::full_rate;
  std::uint64_t seed = 1;
  std::uint64_t hang_cycles = 50'000;  ///< limit for a result; then it is lost or its lane hangs
  std::filesystem::path waves;         ///< FST file to write; needs a build with waves
  std::vector<std::string> plusargs;   ///< for $test$plusargs and $value$plusargs
};

/// Comparisons for the simulator, in order; positions go on from the last block.
struct Block {
  std::uint64_t comparisons = 0;
  std::vector<std::uint8_t> operands;
  std::vector<std::uint64_t> resets;  ///< rising; a reset once this many comparisons were offered
  bool last = false;
};

/// The simulator's answer to one block.
struct Answer {
  std::vector<harness::wire::Result> results;
  std::vector<harness::wire::Violation> violations;
  /// One for each lane or group of lanes; only in the answer to the last block.
  std::vector<harness::wire::CounterValues> groups;
  std::vector<std::uint64_t>
      answers;               ///< of each reference, where counted; only in the last answer
  std::uint64_t cycles = 0;  ///< cycles simulated so far
  harness::wire::State state = harness::wire::State::running;
};

/// A simulator at work in its own process, and the socket to it.
class SimulatorProcess {
public:
  static Result<SimulatorProcess> start(const Executable& executable,
                                        const SimulationOptions& options);

  /// Returns false if the simulator is gone, as receive does.
  template <class T, std::size_t extent>
  bool send(std::span<T, extent> items) {
    return child_.send(std::as_bytes(items));
  }
  template <class T, std::size_t extent>
  bool receive(std::span<T, extent> items) {
    return child_.receive(std::as_writable_bytes(items));
  }
  /// Waits until the simulator, which has answered its last request, has ended: only then are its
  /// waves complete.
  Result<Done> finish();
  /// The error of a simulator that is gone; keeps its log for the user.
  Error ended_unexpectedly();

private:
  SimulatorProcess(ScratchFolder folder, Child child)
      : folder_(std::move(folder)), child_(std::move(child)) {}

  ScratchFolder folder_;  ///< the run's own folder, beside the executable
  Child child_;
};

/// A verilated system at work.
class SystemSimulation {
public:
  static Result<SystemSimulation> start(const Executable& executable,
                                        const SimulationOptions& options);

  /// Sends a block and waits for the simulator's answer. `groups`: of lanes; `answers`: the number
  /// of references whose answers are counted.
  Result<Answer> exchange(const Block& block, int groups, int answers);
  Result<Done> finish() { return process_.finish(); }

private:
  explicit SystemSimulation(SimulatorProcess process) : process_(std::move(process)) {}

  bool send(const Block& block);
  bool receive(Answer& answer, std::size_t groups, std::size_t answers);

  SimulatorProcess process_;
};

}  // namespace mixcmp::verilator_tb
