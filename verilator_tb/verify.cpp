#include "verilator_tb/verify.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <deque>
#include <future>
#include <iterator>
#include <mutex>

#include "model/base/common/counter_random.hpp"
#include "model/base/number/double.hpp"
#include "model/design/engine_data.hpp"
#include "verilator_tb/arg_min_verify.hpp"
#include "verilator_tb/engine_verify.hpp"
#include "verilator_tb/icarus.hpp"
#include "verilator_tb/judge.hpp"
#include "verilator_tb/judgement.hpp"
#include "verilator_tb/pairwise_verify.hpp"
#include "verilator_tb/waves.hpp"

namespace mixcmp::verilator_tb {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The input of a run.
struct Run {
  const System& system;
  const design::Design& design;
  const data::Comparisons& comparisons;
  const Selection& selection;
  const VerifyOptions& options;
  const ExpectedWords* emulator;  ///< null where only the golden model judges
};

/// One simulation, from reset to the end: `number` counts them in a run.
struct Share {
  std::uint64_t number;
  Selection selection;
  std::vector<std::uint64_t> resets;  ///< positions in the selection
};

/// The findings of one simulation.
struct ShareOutcome {
  VerifyReport report;
  std::optional<harness::wire::Result> first_undecided;
  std::vector<VerifiedResult> results;  ///< only if they are asked for
};

/// Adds up the progress of all shares, and tells them when to stop. Thread-safe.
class Tally {
public:
  Tally(const Run& run, std::uint64_t comparisons) : run_(run), comparisons_(comparisons) {}

  void stop() { stopped_ = true; }
  bool stopped() const { return stopped_; }

  void add(std::uint64_t comparisons, std::uint64_t mismatches) {
    const std::lock_guard held(mutex_);
    done_ += comparisons;
    mismatches_ += mismatches;
    if (!run_.options.progress) return;
    run_.options.progress(fmt::format("{}: {} of {} comparisons, {} mismatches{}",
                                      run_.system.signature.top, done_, comparisons_, mismatches_,
                                      time_left()));
  }

private:
  /// ", 2 min 5 s left" at the speed so far; empty in the first second.
  std::string time_left() const {
    const double seconds = seconds_since(start_);
    if (seconds < 1) return "";
    const auto left = static_cast<double>(comparisons_ - done_);
    const auto rest = std::llround(seconds * left / static_cast<double>(done_));
    return rest < 60 ? fmt::format(", {} s left", rest)
                     : fmt::format(", {} min {} s left", rest / 60, rest % 60);
  }

  const Run& run_;
  const std::uint64_t comparisons_;  ///< to be made
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  std::uint64_t done_ = 0;
  std::uint64_t mismatches_ = 0;
  std::atomic<bool> stopped_ = false;
};

/// Refuses portions of a run that is made in one piece, or of too few simulations.
Result<Done> check_portion(const design::Design& design, const data::Comparisons& comparisons,
                           const VerifyOptions& options) {
  if (options.portion.count <= 1) return Done{};
  Error error{.field = "--portion",
              .message = "the run is made in one piece",
              .received = fmt::format("{} portions", options.portion.count),
              .accepted = "no portions with an engine"};
  if (design.system.engine.kind != scene::EngineKind::none) return error;
  const std::uint64_t size = Selection(comparisons.size(), options.selection).size();
  const std::uint64_t simulations = (size + options.share_size - 1) / options.share_size;
  if (options.portion.count <= simulations) return Done{};
  error.message =
      fmt::format("{} comparisons in simulations of {} are too few", size, options.share_size);
  error.accepted = fmt::format("at most {}, or a smaller --share", simulations);
  return error;
}

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

std::vector<Share> shares_of(const Run& run) {
  const std::vector<std::uint64_t> resets = reset_positions(run);
  const std::uint64_t size = run.options.share_size;
  MIXCMP_CHECK(size > 0);
  std::vector<Share> shares;
  for (std::uint64_t first = 0; first < run.selection.size(); first += size) {
    const std::uint64_t count = std::min(size, run.selection.size() - first);
    Share& share = shares.emplace_back(Share{shares.size(), run.selection.part(first, count), {}});
    for (const std::uint64_t at : resets) {
      if (at >= first && at < first + count) share.resets.push_back(at - first);
    }
  }
  return shares;
}

/// The simulations of options.portion.
std::vector<Share> shares_of_portion(const Run& run) {
  std::vector<Share> shares = shares_of(run);
  const RunPortion& portion = run.options.portion;
  const auto border = [&](std::uint64_t k) {
    return static_cast<std::ptrdiff_t>(Bits{shares.size()} * k / portion.count);
  };
  return {std::make_move_iterator(shares.begin() + border(portion.number)),
          std::make_move_iterator(shares.begin() + border(portion.number + 1))};
}

std::uint64_t comparisons_of(const std::vector<Share>& shares) {
  std::uint64_t comparisons = 0;
  for (const Share& share : shares) comparisons += share.selection.size();
  return comparisons;
}

/// Comparisons that are exchanged with the simulator at a time. Icarus makes about a thousand a
/// second, and progress is told after each block.
std::uint64_t block_size(const VerifyOptions& options) {
  constexpr std::uint64_t most_in_icarus = 1024;
  return options.simulator == SimulatorKind::icarus ? std::min(options.block_size, most_in_icarus)
                                                    : options.block_size;
}

Block make_block(const Run& run, const Share& share, std::uint64_t first) {
  const std::uint64_t count = std::min(block_size(run.options), share.selection.size() - first);
  Block block{
      .comparisons = count,
      .operands = stimulus(run.comparisons, share.selection, run.system.signature, first, count),
      .last = first + count == share.selection.size()};
  std::copy_if(share.resets.begin(), share.resets.end(), std::back_inserter(block.resets),
               [&](std::uint64_t at) { return at >= first && at < first + count; });
  return block;
}

/// The options of one share. Each keeps its results and has a seed of its own; only the first has
/// waves.
VerifyOptions options_of(const Run& run, const Share& share, ShareOutcome& outcome) {
  VerifyOptions options = run.options;
  if (options.on_result) {
    options.on_result = [&outcome](const VerifiedResult& result) {
      outcome.results.push_back(result);
    };
  }
  if (share.number > 0) {
    options.traffic_seed = counter_random(run.options.traffic_seed, share.number);
  }
  if (share.number > 0) options.wave_file = nullptr;
  return options;
}

Result<ShareOutcome> run_share(const Run& run, const Share& share, const Executable& executable,
                               Tally& tally) {
  ShareOutcome outcome;
  const VerifyOptions options = options_of(run, share, outcome);
  Judge judge(run.system.signature, run.design, run.comparisons, share.selection, options,
              run.emulator);
  MIXCMP_TRY(simulation, SystemSimulation::start(executable, simulation_options(options)));
  Answer answer;  // to the previous block
  std::uint64_t told = 0;
  for (std::uint64_t first = 0; answer.state == harness::wire::State::running;) {
    const Block block = make_block(run, share, first);
    // The simulator works on one core while its last answer is judged on another.
    auto exchange = std::async(std::launch::async, [&] {
      const emit::Signature& signature = run.system.signature;
      return simulation.exchange(block, emit::group_count(signature),
                                 emit::counted_answers(signature));
    });
    judge.take(answer);
    judge.announce(block.comparisons);
    MIXCMP_TRY(next, exchange.get());
    if (tally.stopped()) return outcome;  // which nobody reads
    answer = std::move(next);
    first += block.comparisons;
    tally.add(block.comparisons, judge.report().mismatch_count - told);
    told = judge.report().mismatch_count;
  }
  judge.take(answer);
  MIXCMP_DO(simulation.finish());
  outcome.report = std::move(judge.report());
  outcome.first_undecided = judge.first_undecided();
  return outcome;
}

/// Tells the shares to stop when it goes out of scope, also by an error or an exception.
struct StopAtEnd {
  Tally& tally;
  ~StopAtEnd() { tally.stop(); }
};

/// Runs the shares, options.jobs at a time, and adds their findings in order, up to and with the
/// first that a fault of the hardware ended early.
Result<ShareOutcome> run_shares(const Run& run) {
  ShareOutcome all{.report = empty_report(run.system.signature, run.design, run.options),
                   .first_undecided = {},
                   .results = {}};
  MIXCMP_TRY(executable, build_executable(run.system, run.options));
  all.report.build_seconds = executable.build_seconds;
  const std::vector<Share> shares = shares_of_portion(run);
  Tally tally(run, comparisons_of(shares));
  MIXCMP_CHECK(run.options.jobs > 0);
  const auto jobs = static_cast<std::size_t>(run.options.jobs);
  std::deque<std::future<Result<ShareOutcome>>> running;
  const StopAtEnd stop_at_end{tally};  // before `running` waits for those that still run
  for (std::size_t next = 0, taken = 0; taken < shares.size(); ++taken) {
    for (; next < shares.size() && next < taken + jobs; ++next) {
      running.push_back(std::async(std::launch::async, [&, number = next] {
        return run_share(run, shares[number], executable, tally);
      }));
    }
    MIXCMP_TRY(outcome, running.front().get());
    running.pop_front();
    for (const VerifiedResult& result : outcome.results) run.options.on_result(result);
    const bool ended_early = outcome.report.comparisons < outcome.report.requested;
    all.report.add(std::move(outcome.report), shares[taken].number);
    if (taken == 0) all.first_undecided = outcome.first_undecided;  // which the waves show
    if (ended_early) break;
  }
  all.report.requested = comparisons_of(shares);
  return all;
}

std::string save_file(const Run& run, const std::optional<harness::wire::Result>& marked) {
  const bool icarus = run.options.simulator == SimulatorKind::icarus;
  return gtkwave_save_file(
      run.system.signature,
      {.waves = run.options.waves,
       .scope = icarus ? std::string("testbench.system") : "TOP." + run.system.signature.top,
       .time_per_cycle = 2,
       .marked = marked});
}

/// Refuses tags that are too few for the harness: with refetched operands no two comparisons that
/// may be inside have the same.
Result<Done> check_tags(const emit::Signature& signature) {
  const bool refetched = emit::refetch_streams(signature) > 0;
  const auto bits_for = [](int count) { return std::bit_width(static_cast<unsigned>(count - 1)); };
  const int needed = static_cast<int>(bits_for(emit::group_count(signature)) +
                                      bits_for(signature.lanes_per_group));
  if (!refetched || signature.tag_bits >= needed) return Done{};
  return Error{.field = "system.tag_bits",
               .message = "too few for a tag for each lane, by which operands are fetched again",
               .received = std::to_string(signature.tag_bits),
               .accepted = fmt::format("at least {} to verify", needed)};
}

Result<VerifyReport> run_system(const System& system, const design::Design& design,
                                const data::Comparisons& comparisons,
                                const VerifyOptions& options) {
  switch (design.system.engine.kind) {
    case scene::EngineKind::none: break;
    case scene::EngineKind::pairwise: return verify_pairwise(system, design, comparisons, options);
    case scene::EngineKind::arg_min: return verify_arg_min(system, design, comparisons, options);
  }
  MIXCMP_DO(check_tags(system.signature));
  const Selection selection(comparisons.size(), options.selection);
  std::optional<ExpectedWords> emulator;
  if (options.judge == JudgeKind::emulator && fits_double(comparisons.format())) {
    emulator.emplace(design, comparisons);
  }
  const Run run{system, design, comparisons, selection, options, emulator ? &*emulator : nullptr};
  const auto start = Clock::now();
  const bool icarus = options.simulator == SimulatorKind::icarus;
  MIXCMP_TRY(outcome, run_shares(run));
  outcome.report.simulator = icarus ? icarus_name : verilator_name;
  outcome.report.run_seconds = seconds_since(start) - outcome.report.build_seconds;
  if (options.wave_file != nullptr) {
    options.wave_file->set_save_file(save_file(run, outcome.first_undecided));
  }
  return std::move(outcome.report);
}

}  // namespace

Result<Executable> build_executable(const System& system, const VerifyOptions& options) {
  const BuildOptions build{.work_dir = options.work_dir,
                           .waves = options.waves.empty() ? Waves::off : Waves::on,
                           .progress = options.progress,
                           .waiting = options.waiting};
  switch (options.simulator) {
    case SimulatorKind::verilator: return build_simulator(system, build);
    case SimulatorKind::icarus: return build_in_icarus(system, build);
  }
  MIXCMP_CHECK(!"a simulator of no enumerator");
}

SimulationOptions simulation_options(const VerifyOptions& options) {
  return {.traffic = options.traffic,
          .seed = options.traffic_seed,
          .hang_cycles = options.hang_cycles,
          .waves = options.wave_file == nullptr ? "" : options.wave_file->unfinished(),
          .plusargs = options.plusargs};
}

Result<Done> check_request(const design::Design& design, const data::Comparisons& comparisons,
                           const VerifyOptions& options) {
  MIXCMP_DO(check_portion(design, comparisons, options));
  switch (design.system.engine.kind) {
    case scene::EngineKind::none: return check_selection(comparisons, options.selection);
    case scene::EngineKind::pairwise: {
      MIXCMP_TRY(possible, check_engine_options(options, "every pair of its items"));
      break;
    }
    case scene::EngineKind::arg_min: {
      MIXCMP_DO(check_engine_options(options, "every candidate for every row"));
      break;
    }
  }
  return design::check_engine_data(design.system.engine, design.lane_count(), comparisons);
}

Result<VerifyReport> judge_system(const System& system, const design::Design& design,
                                  const data::Comparisons& comparisons,
                                  const VerifyOptions& options) {
  if (options.waves.empty()) return run_system(system, design, comparisons, options);
  MIXCMP_TRY(waves, WaveFile::open(options.waves));
  VerifyOptions with_waves = options;
  with_waves.wave_file = &waves;
  MIXCMP_TRY(report, run_system(system, design, comparisons, with_waves));
  MIXCMP_DO(waves.commit());
  return report;
}

Result<VerifyReport> verify(const design::Design& design, const data::Comparisons& comparisons,
                            const System& system, const VerifyOptions& options) {
  MIXCMP_DO(check_request(design, comparisons, options));
  return judge_system(system, design, comparisons, options);
}

}  // namespace mixcmp::verilator_tb
