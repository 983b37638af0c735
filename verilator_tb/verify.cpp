#include "verilator_tb/verify.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <future>

#include "generator/emit/system.hpp"
#include "model/design/engine_data.hpp"
#include "verilator_tb/arg_min_verify.hpp"
#include "verilator_tb/engine_verify.hpp"
#include "verilator_tb/icarus.hpp"
#include "verilator_tb/judge.hpp"
#include "verilator_tb/pairwise_verify.hpp"
#include "verilator_tb/waves.hpp"

namespace mixcmp::verilator_tb {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A run in progress: what is simulated, and who judges it.
struct Run {
  const System& system;
  const data::Comparisons& comparisons;
  const Selection& selection;
  const VerifyOptions& options;
  Judge& judge;
};

Result<Done> check_selection(const data::Comparisons& comparisons,
                             const Selection::Options& selection) {
  if (Selection(comparisons.size(), selection).size() > 0) return Done{};
  return Error{.field = selection.only ? "--only" : "data",
               .message = "no comparison to verify",
               .received = selection.only ? std::to_string(*selection.only) : "",
               .accepted = fmt::format("an index below {}", comparisons.size())};
}

/// One random position in each of options.resets equal parts of the run.
std::vector<std::uint64_t> reset_positions(const Run& run) {
  std::vector<std::uint64_t> positions;
  const auto resets = static_cast<std::uint64_t>(std::max(run.options.resets, 0));
  for (std::uint64_t k = 0; k < resets; ++k) {
    const auto start = static_cast<std::uint64_t>(Bits{run.selection.size()} * k / resets);
    const std::uint64_t part = std::max<std::uint64_t>(run.selection.size() / resets, 1);
    positions.push_back(start + counter_random(run.options.traffic_seed, k) % part);
  }
  return positions;
}

Block make_block(const Run& run, const std::vector<std::uint64_t>& resets, std::uint64_t first) {
  const emit::Signature& s = run.system.signature;
  const std::uint64_t count = std::min(run.options.block_size, run.selection.size() - first);
  Block block{.comparisons = count,
              .operands = stimulus(run.comparisons, run.selection, s.reference_format.width(),
                                   s.tdata_bytes, first, count),
              .last = first + count == run.selection.size()};
  std::copy_if(resets.begin(), resets.end(), std::back_inserter(block.resets),
               [&](std::uint64_t at) { return at >= first && at < first + count; });
  return block;
}

void tell(const Run& run, std::uint64_t done) {
  if (!run.options.progress) return;
  run.options.progress(fmt::format("{}: {} of {} comparisons, {} mismatches",
                                   run.system.signature.top, done, run.selection.size(),
                                   run.judge.report().mismatch_count));
}

Result<Done> run_verilator(const Run& run) {
  MIXCMP_TRY(
      executable,
      build_simulator(run.system, {.work_dir = run.options.work_dir,
                                   .waves = run.options.waves.empty() ? Waves::off : Waves::on,
                                   .progress = run.options.progress,
                                   .waiting = run.options.waiting}));
  run.judge.report().build_seconds = executable.build_seconds;
  MIXCMP_TRY(simulation, SystemSimulation::start(executable, simulation_options(run.options)));
  const std::vector<std::uint64_t> resets = reset_positions(run);
  Answer answer;  // to the previous block
  for (std::uint64_t first = 0; answer.state == harness::wire::State::running;) {
    const Block block = make_block(run, resets, first);
    // The simulator works on one core while the golden model judges its last answer on another.
    auto exchange = std::async(
        std::launch::async, [&] { return simulation.exchange(block, run.system.signature.lanes); });
    run.judge.take(answer);
    run.judge.announce(block.comparisons);
    MIXCMP_TRY(next, exchange.get());
    answer = std::move(next);
    first += block.comparisons;
    tell(run, first);
  }
  run.judge.take(answer);
  return simulation.finish();
}

Result<Done> run_icarus(const Run& run) {
  const Block all{.comparisons = run.selection.size(),
                  .operands = stimulus(run.comparisons, run.selection,
                                       run.system.signature.reference_format.width(),
                                       run.system.signature.tdata_bytes, 0, run.selection.size()),
                  .resets = reset_positions(run),
                  .last = true};
  MIXCMP_TRY(answer, simulate_in_icarus(run.system, all, run.options.work_dir,
                                        simulation_options(run.options), run.options.progress,
                                        run.options.waiting));
  run.judge.announce(all.comparisons);
  run.judge.take(answer);
  tell(run, all.comparisons);
  return Done{};
}

std::string save_file(const Run& run) {
  const bool icarus = run.options.simulator == SimulatorKind::icarus;
  return gtkwave_save_file(
      run.system.signature,
      {.waves = run.options.waves,
       .scope = icarus ? std::string("testbench.system") : "TOP." + run.system.signature.top,
       .time_per_cycle = icarus ? icarus_time_per_cycle : 2,
       .marked = run.judge.first_undecided()});
}

Result<VerifyReport> run_system(const System& system, const design::Design& design,
                                const data::Comparisons& comparisons,
                                const VerifyOptions& options) {
  switch (design.system.engine.kind) {
    case scene::EngineKind::none: break;
    case scene::EngineKind::pairwise: return verify_pairwise(system, design, comparisons, options);
    case scene::EngineKind::arg_min: return verify_arg_min(system, design, comparisons, options);
  }
  const Selection selection(comparisons.size(), options.selection);
  Judge judge(system.signature, design, comparisons, selection, options);
  const Run run{system, comparisons, selection, options, judge};
  const auto start = Clock::now();
  const bool icarus = options.simulator == SimulatorKind::icarus;
  judge.report().simulator = icarus ? "Icarus Verilog" : "Verilator";
  MIXCMP_TRY(done, icarus ? run_icarus(run) : run_verilator(run));
  judge.report().run_seconds = seconds_since(start) - judge.report().build_seconds;
  if (options.wave_file != nullptr) options.wave_file->set_save_file(save_file(run));
  return std::move(judge.report());
}

}  // namespace

SimulationOptions simulation_options(const VerifyOptions& options) {
  return {.traffic = options.traffic,
          .seed = options.traffic_seed,
          .hang_cycles = options.hang_cycles,
          .waves = options.wave_file == nullptr ? "" : options.wave_file->unfinished(),
          .plusargs = options.plusargs};
}

Result<Done> check_request(const design::Design& design, const data::Comparisons& comparisons,
                           const VerifyOptions& options) {
  switch (design.system.engine.kind) {
    case scene::EngineKind::none: return check_selection(comparisons, options.selection);
    case scene::EngineKind::pairwise: {
      MIXCMP_TRY(possible, check_engine_options(options, "every pair of its items"));
      break;
    }
    case scene::EngineKind::arg_min: {
      MIXCMP_TRY(possible, check_engine_options(options, "every candidate for every row"));
      break;
    }
  }
  return design::check_engine_data(design.system.engine, design.lane_count(), comparisons);
}

Result<Done> check_design(const System& system, const design::Design& design) {
  MIXCMP_TRY(expected, emit::generate_system(design, ""));
  const auto origin = [](const emit::Signature& signature) {
    return fmt::format("{} of version {}, hash {}", signature.top, signature.generator_version,
                       signature.spec_hash);
  };
  const std::string there = origin(system.signature), here = origin(expected.signature);
  if (there == here) return Done{};
  return Error{.file = system.directory.string(),
               .message = "was generated from another design or by another version",
               .received = there,
               .accepted = here + ": generate it again"};
}

Result<VerifyReport> judge_system(const System& system, const design::Design& design,
                                  const data::Comparisons& comparisons,
                                  const VerifyOptions& options) {
  if (options.waves.empty()) return run_system(system, design, comparisons, options);
  MIXCMP_TRY(waves, WaveFile::open(options.waves));
  VerifyOptions with_waves = options;
  with_waves.wave_file = &waves;
  MIXCMP_TRY(report, run_system(system, design, comparisons, with_waves));
  MIXCMP_TRY(kept, waves.commit());
  return report;
}

Result<VerifyReport> verify(const design::Design& design, const data::Comparisons& comparisons,
                            const fs::path& generated_dir, const VerifyOptions& options) {
  MIXCMP_TRY(requested, check_request(design, comparisons, options));
  MIXCMP_TRY(system, load_system(generated_dir));
  MIXCMP_TRY(of_design, check_design(system, design));
  return judge_system(system, design, comparisons, options);
}

}  // namespace mixcmp::verilator_tb
