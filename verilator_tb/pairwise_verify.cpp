#include "verilator_tb/pairwise_verify.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "verilator_tb/pairwise_judge.hpp"
#include "verilator_tb/waves.hpp"

namespace mixcmp::tb {

namespace {

struct Trial {
  SetRange set;
  std::uint64_t reset_after = 0;
  PairwiseJudge::Use use = PairwiseJudge::Use::check;
};

model::Result<model::Done> check_request(const System& system,
                                         const model::Comparisons& comparisons,
                                         const VerifyOptions& options) {
  if (options.simulator == SimulatorKind::icarus) {
    return model::Error{.field = "--simulator",
                        .message = "engines are simulated with Verilator alone",
                        .received = "icarus",
                        .accepted = "verilator, or --set engine.kind=none for the system inside"};
  }
  if (options.selection.limit != 0 || options.selection.only) {
    return model::Error{.field = "--first, --sample, --only",
                        .message = "an engine compares every pair of its items",
                        .received = "a selection of comparisons",
                        .accepted = "none; or --set engine.kind=none for the system inside"};
  }
  const auto capacity = static_cast<std::uint64_t>(system.signature.engine->capacity);
  const std::uint64_t items = comparisons.table().rows();
  if (items <= capacity) return model::Done{};
  return model::Error{.field = "engine.capacity",
                      .message = "the data have more items than the engine holds",
                      .received = fmt::format("{} items, a capacity of {}", items, capacity),
                      .accepted = fmt::format("a capacity of at least {}, at most {}", items,
                                              model::EngineSpec::max_capacity)};
}

/// Words that pass the first lane.
std::uint64_t words_of(std::uint64_t items, std::uint64_t lanes) {
  std::uint64_t words = 0;
  for (std::uint64_t base = 0; base < items; base += lanes) words += items - base;
  return words;
}

std::vector<Trial> plan_trials(const System& system, std::uint64_t items,
                               const VerifyOptions& options) {
  const auto lanes = static_cast<std::uint64_t>(system.signature.lanes);
  std::vector<Trial> trials;
  const std::uint64_t words = words_of(items, lanes);
  for (int k = 0; k < options.resets; ++k) {
    const std::uint64_t after = 1 + counter_random(options.traffic_seed, trials.size()) % words;
    trials.push_back({.set = {0, items}, .reset_after = after});
  }
  for (const std::uint64_t count : std::set<std::uint64_t>{1, 2, 3, lanes, lanes + 1}) {
    if (count >= items) continue;
    const std::uint64_t places = items - count + 1;
    trials.push_back(
        {.set = {counter_random(options.traffic_seed, trials.size()) % places, count}});
  }
  trials.push_back({.set = {0, items}, .use = PairwiseJudge::Use::figures});
  trials.push_back({.set = {items - 2, 2}});
  return trials;
}

/// The items as they stand on s_axis_tdata.
std::vector<std::uint8_t> item_bytes(const gen::Signature& signature, const model::Table& table,
                                     const SetRange& set) {
  const gen::SignatureEngine& engine = *signature.engine;
  std::vector<std::size_t> columns;
  for (const std::string& name : engine.columns) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), name);
    columns.push_back(static_cast<std::size_t>(found - table.columns.begin()));
  }
  const auto size = static_cast<std::size_t>(engine.item_bytes);
  std::vector<std::uint8_t> bytes(size * set.count);
  std::vector<model::Bits> values(columns.size());
  for (std::uint64_t k = 0; k < set.count; ++k) {
    for (std::size_t c = 0; c < columns.size(); ++c)
      values[c] = table.at(set.first + k, columns[c]);
    pack_operands(values, table.format.width(), k % 2 != 0,
                  std::span(bytes).subspan(size * k, size));
  }
  return bytes;
}

void tell(const VerifyOptions& options, const System& system, const Trial& trial) {
  if (!options.progress) return;
  options.progress(
      fmt::format("{}: a set of {} items", system.signature.engine->top, trial.set.count));
}

model::Result<model::Done> run_trials(const System& system, const model::Comparisons& comparisons,
                                      const VerifyOptions& options, const Executable& executable,
                                      PairwiseJudge& judge) {
  MIXCMP_TRY(simulation, PairwiseSimulation::start(executable, simulation_options(options)));
  const std::vector<Trial> trials = plan_trials(system, comparisons.table().rows(), options);
  for (std::size_t k = 0; k < trials.size(); ++k) {
    const Trial& trial = trials[k];
    tell(options, system, trial);
    MIXCMP_TRY(answer, simulation.exchange(
                           {.items = trial.set.count,
                            .bytes = item_bytes(system.signature, comparisons.table(), trial.set),
                            .reset_after = trial.reset_after,
                            .last = k + 1 == trials.size()},
                           system.signature.lanes));
    judge.take(trial.set, answer, trial.use);
    if (answer.response.state == wire::SetState::stopped) break;
  }
  return model::Done{};
}

model::Result<model::Done> save_waves(const gen::SignatureEngine& engine,
                                      const VerifyOptions& options) {
  if (options.waves.empty()) return model::Done{};
  return write_save_file(options.waves, gtkwave_save_file(engine, {.waves = options.waves,
                                                                   .scope = "TOP." + engine.top,
                                                                   .time_per_cycle = 2,
                                                                   .marked = {}}));
}

}  // namespace

model::Result<VerifyReport> verify_pairwise(const System& system, const model::Design& design,
                                            const model::Comparisons& comparisons,
                                            const VerifyOptions& options) {
  MIXCMP_TRY(checked, check_request(system, comparisons, options));
  const Waves waves = options.waves.empty() ? Waves::off : Waves::on;
  MIXCMP_TRY(executable, build_simulator(system, {.work_dir = options.work_dir,
                                                  .waves = waves,
                                                  .progress = options.progress}));
  PairwiseJudge judge(system.signature, design, comparisons, options);
  judge.report().build_seconds = executable.build_seconds;
  judge.report().simulator = "Verilator";
  const auto start = std::chrono::steady_clock::now();
  MIXCMP_TRY(run, run_trials(system, comparisons, options, executable, judge));
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  judge.report().run_seconds = taken.count();
  MIXCMP_TRY(saved, save_waves(*system.signature.engine, options));
  return std::move(judge.report());
}

}  // namespace mixcmp::tb
