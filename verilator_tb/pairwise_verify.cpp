#include "verilator_tb/pairwise_verify.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "verilator_tb/engine_verify.hpp"
#include "verilator_tb/pairwise_judge.hpp"

namespace mixcmp::verilator_tb {

namespace {

struct Trial {
  SetRange set;
  std::uint64_t reset_after = 0;
  PairwiseJudge::Use use = PairwiseJudge::Use::check;
};

/// How many words (items, repeated for every block) pass the first lane for a set of `items`.
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

void tell(const VerifyOptions& options, const System& system, const Trial& trial) {
  if (!options.progress) return;
  options.progress(
      fmt::format("{}: a set of {} items", system.signature.engine->top, trial.set.count));
}

Result<Done> run_trials(const System& system, const data::Comparisons& comparisons,
                        const VerifyOptions& options, const Executable& executable,
                        PairwiseJudge& judge) {
  MIXCMP_TRY(simulation, PairwiseSimulation::start(executable, simulation_options(options)));
  const emit::SignatureEngine& engine = *system.signature.engine;
  const std::vector<Trial> trials = plan_trials(system, comparisons.table().rows(), options);
  for (std::size_t k = 0; k < trials.size(); ++k) {
    const Trial& trial = trials[k];
    tell(options, system, trial);
    MIXCMP_TRY(answer, simulation.exchange(
                           {.items = trial.set.count,
                            .bytes = row_bytes(comparisons.table(), engine.columns,
                                               engine.item_bytes, trial.set.first, trial.set.count),
                            .reset_after = trial.reset_after,
                            .last = k + 1 == trials.size()},
                           system.signature.lanes));
    judge.take(trial.set, answer, trial.use);
    if (answer.response.state == harness::wire::SetState::stopped) break;
  }
  return simulation.finish();
}

}  // namespace

Result<VerifyReport> verify_pairwise(const System& system, const design::Design& design,
                                     const data::Comparisons& comparisons,
                                     const VerifyOptions& options) {
  PairwiseJudge judge(system.signature, design, comparisons, options);
  return run_engine(system, options, judge, [&](const Executable& executable) {
    return run_trials(system, comparisons, options, executable, judge);
  });
}

}  // namespace mixcmp::verilator_tb
