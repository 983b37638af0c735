#include "verilator_tb/pairwise_verify.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "model/base/common/counter_random.hpp"
#include "model/cost/performance/pairwise.hpp"
#include "verilator_tb/engine_model.hpp"
#include "verilator_tb/engine_verify.hpp"
#include "verilator_tb/pairwise_judge.hpp"

namespace mixcmp::verilator_tb {

namespace {

struct Trial {
  SetRange set;
  std::uint64_t reset_after = 0;
  PairwiseJudge::Use use = PairwiseJudge::Use::check;
};

/// Plans sets, with the seeds of their places.
class TrialPlan {
public:
  TrialPlan(const data::Comparisons& comparisons, std::uint64_t seed)
      : rows_(comparisons.table().rows()),
        other_rows_(comparisons.tables().size() > 1 ? comparisons.tables()[1].rows() : 0),
        seed_(seed) {}

  SetRange whole() const { return {.items = {0, rows_}, .others = {0, other_rows_}}; }
  std::uint64_t draw() const { return counter_random(seed_, trials_.size()); }
  void add(Trial trial) { trials_.push_back(trial); }

  /// A set of `count` items at a random place; with two tables also the last three items of the
  /// second.
  void add_small(std::uint64_t count) {
    if (count >= rows_) return;
    const std::uint64_t others = std::min<std::uint64_t>(other_rows_, 3);
    const std::uint64_t place = draw() % (rows_ - count + 1);
    add({.set = {.items = {place, count}, .others = {other_rows_ - others, others}}});
  }
  std::vector<Trial> take() { return std::move(trials_); }

private:
  std::uint64_t rows_, other_rows_;
  std::uint64_t seed_;
  std::vector<Trial> trials_;
};

std::vector<Trial> plan_trials(const System& system, const data::Comparisons& comparisons,
                               const VerifyOptions& options) {
  const auto lanes = static_cast<std::uint64_t>(system.signature.lanes);
  TrialPlan plan(comparisons, options.traffic_seed);
  const SetRange whole = plan.whole();
  const std::uint64_t words = performance::pairwise_word_cycles(
      whole.items.count, whole.others.count, system.signature.lanes);
  for (int k = 0; k < options.resets; ++k) {
    plan.add({.set = whole, .reset_after = 1 + plan.draw() % words});
  }
  for (const std::uint64_t count : std::set<std::uint64_t>{1, 2, 3, lanes, lanes + 1}) {
    plan.add_small(count);
  }
  plan.add({.set = whole, .use = PairwiseJudge::Use::figures});
  plan.add_small(2);
  return plan.take();
}

void tell(const VerifyOptions& options, const System& system, const Trial& trial) {
  if (!options.progress) return;
  options.progress(
      fmt::format("{}: a set of {} items", system.signature.engine->top, trial.set.size()));
}

std::vector<std::uint8_t> bytes_of(const SetRange& set, const emit::SignatureEngine& engine,
                                   const data::Comparisons& comparisons) {
  std::vector<std::uint8_t> bytes =
      row_bytes(comparisons.table(), engine.columns, engine.column_formats, engine.item_bytes,
                set.items.first, set.items.count);
  if (set.others.count == 0) return bytes;
  const std::vector<std::uint8_t> others =
      row_bytes(comparisons.tables()[1], engine.columns, engine.column_formats, engine.item_bytes,
                set.others.first, set.others.count);
  bytes.insert(bytes.end(), others.begin(), others.end());
  return bytes;
}

Result<Done> run_trials(const System& system, const data::Comparisons& comparisons,
                        const VerifyOptions& options, const Executable& executable,
                        PairwiseJudge& judge) {
  MIXCMP_TRY(simulation, PairwiseSimulation::start(executable, simulation_options(options)));
  const emit::SignatureEngine& engine = *system.signature.engine;
  const std::vector<Trial> trials = plan_trials(system, comparisons, options);
  for (std::size_t k = 0; k < trials.size(); ++k) {
    const Trial& trial = trials[k];
    tell(options, system, trial);
    MIXCMP_TRY(answer,
               simulation.exchange({.items = trial.set.size(),
                                    .targets = trial.set.targets(),
                                    .bytes = bytes_of(trial.set, engine, comparisons),
                                    .reset_after = trial.reset_after,
                                    .last = k + 1 == trials.size()},
                                   engine.report_streams, emit::counted_answers(system.signature)));
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
  MIXCMP_TRY(report, run_engine(system, options, judge, [&](const Executable& executable) {
               return run_trials(system, comparisons, options, executable, judge);
             }));
  const bool is_whole = report.cycles > 0;
  if (is_whole && options.traffic == TrafficKind::full_rate) {
    report.engine->expected_cycles = expected_pairwise_cycles(design, report, judge.data());
  }
  return report;
}

}  // namespace mixcmp::verilator_tb
