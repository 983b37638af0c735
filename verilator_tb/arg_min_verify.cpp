#include "verilator_tb/arg_min_verify.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "model/base/common/counter_random.hpp"
#include "verilator_tb/arg_min_judge.hpp"
#include "verilator_tb/engine_model.hpp"
#include "verilator_tb/engine_verify.hpp"

namespace mixcmp::verilator_tb {

namespace {

struct Trial {
  LoadRange load;
  std::uint64_t reload_after = 0;
  std::uint64_t reset_after = 0;
  ArgMinJudge::Use use = ArgMinJudge::Use::check;
};

/// Plans the loads: first those that a reset breaks off; then loads of one, two, one too few and
/// one too many candidates; last, twice, all candidates and rows.
std::vector<Trial> plan_trials(const System& system, const data::Comparisons& comparisons,
                               const VerifyOptions& options) {
  const std::uint64_t rows = comparisons.table().rows();
  const std::uint64_t candidates = comparisons.tables()[1].rows();
  const auto lanes = static_cast<std::uint64_t>(system.signature.lanes);
  std::vector<Trial> trials;
  for (int k = 0; k < options.resets; ++k) {
    const std::uint64_t after =
        1 + counter_random(options.traffic_seed, trials.size()) % (candidates + rows);
    trials.push_back({.load = {candidates, 0, rows}, .reset_after = after});
  }
  for (const std::uint64_t count : std::set<std::uint64_t>{
           1, std::min<std::uint64_t>(2, candidates), candidates - 1, lanes + 2}) {
    const std::uint64_t some = std::min<std::uint64_t>(rows, 8);
    const std::uint64_t places = rows - some + 1;
    const std::uint64_t first = counter_random(options.traffic_seed, trials.size()) % places;
    trials.push_back({.load = {count, first, some}});
  }
  trials.push_back({.load = {candidates, 0, rows}, .use = ArgMinJudge::Use::figures});
  trials.push_back({.load = {candidates, 0, rows}, .reload_after = (rows + 1) / 2});
  return trials;
}

CandidateLoad load_of(const emit::SignatureEngine& engine, const data::Comparisons& comparisons,
                      const Trial& trial, bool last) {
  const LoadRange& load = trial.load;
  return {.request = {.candidates = load.candidates,
                      .rows = load.rows,
                      .reload_after = trial.reload_after,
                      .reset_after = trial.reset_after,
                      .last = last ? 1u : 0u},
          .candidates = row_bytes(comparisons.tables()[1], engine.columns, engine.column_formats,
                                  engine.item_bytes, 0, load.candidates),
          .rows = row_bytes(comparisons.table(), engine.row_columns, engine.row_column_formats,
                            engine.row_bytes, load.first, load.rows)};
}

Result<Done> run_trials(const System& system, const data::Comparisons& comparisons,
                        const VerifyOptions& options, const Executable& executable,
                        ArgMinJudge& judge) {
  MIXCMP_TRY(simulation, ArgMinSimulation::start(executable, simulation_options(options)));
  const emit::SignatureEngine& engine = *system.signature.engine;
  const std::vector<Trial> trials = plan_trials(system, comparisons, options);
  for (std::size_t k = 0; k < trials.size(); ++k) {
    const Trial& trial = trials[k];
    if (options.progress) {
      options.progress(fmt::format("{}: {} candidates, {} rows", engine.top, trial.load.candidates,
                                   trial.load.rows));
    }
    const CandidateLoad load = load_of(engine, comparisons, trial, k + 1 == trials.size());
    MIXCMP_TRY(answer, simulation.exchange(load, system.signature.lanes,
                                           emit::counted_answers(system.signature)));
    judge.take(trial.load, answer, trial.use);
    if (answer.response.state == harness::wire::LoadState::stopped) break;
  }
  return simulation.finish();
}

}  // namespace

Result<VerifyReport> verify_arg_min(const System& system, const design::Design& design,
                                    const data::Comparisons& comparisons,
                                    const VerifyOptions& options) {
  ArgMinJudge judge(system.signature, design, comparisons, options);
  MIXCMP_TRY(report, run_engine(system, options, judge, [&](const Executable& executable) {
               return run_trials(system, comparisons, options, executable, judge);
             }));
  const bool is_whole = report.cycles > 0;
  if (is_whole && options.traffic == TrafficKind::full_rate) {
    report.arg_min->expected_cycles = expected_arg_min_cycles(design, report);
  }
  return report;
}

}  // namespace mixcmp::verilator_tb
