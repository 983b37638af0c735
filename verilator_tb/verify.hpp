#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "model/base/common/folder_lock.hpp"
#include "model/base/number/verdict.hpp"
#include "model/comparison/data/comparisons.hpp"
#include "model/design/design.hpp"
#include "verilator_tb/build.hpp"
#include "verilator_tb/report.hpp"
#include "verilator_tb/selection.hpp"
#include "verilator_tb/system_simulation.hpp"
#include "verilator_tb/waves.hpp"

namespace mixcmp::verilator_tb {

enum class SimulatorKind {
  verilator,
  icarus,  ///< for small systems and thousands of comparisons
};

/// The source of the answers that the hardware must give; see Judge.
enum class JudgeKind {
  emulator,
  golden_model,  ///< MPFR and GMP, for every comparison
};

enum class TruthScope {
  recomputed,  ///< only the verdicts of references
  all,
};

/// Asks `verify` to compare verdicts also with the order of the real numbers f and g.
struct TruthCheck {
  const Graph* graph;
  TruthScope scope = TruthScope::all;
};

/// The hardware's result for one comparison.
struct VerifiedResult {
  std::uint64_t index;
  /// The items that were compared: those of `index` in the data. In an arg-min engine the first
  /// item is the engine's best candidate so far; the data have that of the reference's search.
  data::Items items;
  ResultWord word;
  /// Where and when it was a transfer on the streams of a lane: none in an engine.
  struct Transfer {
    std::uint32_t lane;
    std::uint64_t cycle_accepted;
    std::uint64_t cycle_left;
  };
  std::optional<Transfer> transfer = {};
};

/// One of several portions of a long run, for machines that share it. Portion k of `count` makes
/// simulations n k / count to n (k + 1) / count of the n in the run. The joined reports of all
/// portions equal that of the whole run.
struct RunPortion {
  std::uint64_t number = 0;  ///< k, from 0
  std::uint64_t count = 1;
};

struct VerifyOptions {
  SimulatorKind simulator = SimulatorKind::verilator;
  JudgeKind judge = JudgeKind::emulator;
  std::filesystem::path work_dir;  ///< builds and logs
  Selection::Options selection;
  TrafficKind traffic = TrafficKind::full_rate;
  std::uint64_t traffic_seed = 1;
  int resets = 0;  ///< resets in mid-stream, spread over the run
  std::uint64_t hang_cycles = 50'000;
  std::uint64_t block_size = 16'384;  ///< comparisons exchanged at a time
  /// Comparisons that Verilator makes between a reset and the end of a simulation. A longer run is
  /// split into simulations of this size, `jobs` at a time. Its report is the same for any number
  /// of jobs.
  std::uint64_t share_size = std::uint64_t{1} << 20;
  int jobs = 1;
  RunPortion portion = {};
  /// FST file to write; beside it goes a GTKWave save file, .gtkw.
  std::filesystem::path waves;
  WaveFile* wave_file = nullptr;  ///< set by `verify` where there are waves to write
  std::optional<TruthCheck> truth;
  std::string repeat_command;         ///< the report prints it with " --only INDEX" added
  std::vector<std::string> plusargs;  ///< for the simulator, without their plus
  std::function<void(const VerifiedResult&)> on_result;  ///< called in order of index
  Progress progress;
  Waiting waiting;
};

/// Builds the program that simulates the system, in the simulator that the options choose.
Result<Executable> build_executable(const System& system, const VerifyOptions& options);

/// The part of the options that the simulator is given.
SimulationOptions simulation_options(const VerifyOptions& options);

/// Refuses a request that cannot be run, before anything is written: a selection of nothing, a
/// simulator or a selection that an engine does not have, data that do not fit into it.
Result<Done> check_request(const design::Design& design, const data::Comparisons& comparisons,
                           const VerifyOptions& options);

/// Runs a system on the comparisons and compares every result with the golden model of `design`,
/// wherever the system comes from. An error means that it could not be run; wrong results are in
/// the report.
Result<VerifyReport> judge_system(const System& system, const design::Design& design,
                                  const data::Comparisons& comparisons,
                                  const VerifyOptions& options);

/// Checks the request, then judges the system, which is the one that this version generates from
/// the design.
Result<VerifyReport> verify(const design::Design& design, const data::Comparisons& comparisons,
                            const System& system, const VerifyOptions& options);

}  // namespace mixcmp::verilator_tb
