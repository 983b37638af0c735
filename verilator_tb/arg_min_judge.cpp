#include "verilator_tb/arg_min_judge.hpp"

#include <fmt/core.h>

#include "model/base/number/verdict.hpp"
#include "verilator_tb/judgement.hpp"

namespace mixcmp::verilator_tb {

ArgMinJudge::ArgMinJudge(const emit::Signature& signature, const design::Design& design,
                         const data::Comparisons& comparisons, const VerifyOptions& options)
    : EngineJudge(signature, design, comparisons, options), chain_(design, comparisons) {
  report_.arg_min = ArgMinFigures{.top = signature.engine->top,
                                  .candidates = comparisons.tables()[1].rows(),
                                  .rows = comparisons.table().rows()};
}

std::uint64_t ArgMinJudge::choose(const LoadRange& load, std::uint64_t row, Use use) {
  return chain_.choose(row, load.candidates, [&](const ChainComparison& made) {
    ++lanes_[made.lane].observed[0];
    if (made.word.is_recomputed()) ++lanes_[made.lane].observed[1];
    if (use == Use::figures && made.lane + 1 < load.candidates) count(made);
  });
}

void ArgMinJudge::count(const ChainComparison& made) {
  GroupReport& group = report_.groups[group_of_lane_[made.lane]];
  ++report_.comparisons;
  ++group.comparisons;
  if (made.word.is_recomputed()) ++report_.recomputations, ++group.recomputations;
  ++report_.verdicts[static_cast<std::size_t>(made.word.verdict())];
  if (options_.truth) {
    check_against_truth(*options_.truth, design_, made.operands, made.word, *report_.truth, group);
  }
  if (!options_.on_result) return;
  const std::uint64_t index =
      made.items.row * (report_.arg_min->candidates - 1) + made.items.second - 1;
  options_.on_result({index, made.items, made.word});
}

void ArgMinJudge::take(const LoadRange& load, const LoadAnswer& answer, Use use) {
  for (const harness::wire::Violation& violation : answer.violations) {
    add_violation(to_text(violation.fault), violation.cycle,
                  fmt::format("tag 0x{:x}", violation.tag));
  }
  ++report_.arg_min->loads;
  if (answer.rows.size() > load.rows) return add_violation("rows too many", 0, "");
  for (std::uint64_t k = 0; k < answer.rows.size(); ++k) {
    judge_row(load, load.first + k, answer.rows[k], use);
  }
  switch (answer.response.state) {
    case harness::wire::LoadState::complete: return judge_end(load, answer, use);
    case harness::wire::LoadState::interrupted:
      lanes_.assign(lanes_.size(), {});
      stalled_before_ = 0;
      return;
    case harness::wire::LoadState::stopped: return;
  }
}

void ArgMinJudge::judge_row(const LoadRange& load, std::uint64_t row,
                            const harness::wire::RowResult& got, Use use) {
  const std::uint64_t expected = choose(load, row, use);
  if (got.index != expected) add_mismatch(row, expected, got);
  if (use == Use::check) return;
  if (expected != comparisons_.arg_min(row)) ++report_.arg_min->rows_unlike_reference;
  report_.arg_min->latency.add(got.cycle_left - got.cycle_accepted);
}

void ArgMinJudge::judge_end(const LoadRange& load, const LoadAnswer& answer, Use use) {
  if (answer.rows.size() != load.rows) {
    add_violation("rows lost", 0, fmt::format("{} of {}", answer.rows.size(), load.rows));
  }
  const bool too_many = load.candidates > lanes_.size() + 1;
  if ((answer.response.overrun != 0) != too_many) {
    add_violation("overrun is wrong", 0, fmt::format("{} candidates", load.candidates));
  }
  judge_counters(answer, use);
  if (use == Use::check) return;
  report_.cycles = answer.response.cycles;
  report_.arg_min->loading_cycles = answer.response.loading_cycles;
}

/// Judges, after each load, the counters, which run since reset. The report keeps the last totals.
void ArgMinJudge::judge_counters(const LoadAnswer& answer, Use use) {
  if (signature_.counter_bits == 0) return;
  const harness::wire::CounterValues& counters = answer.response.counters;
  const std::uint64_t stalled = stalls_gained(counters.counted[1]);
  if (use == Use::figures) report_.arg_min->stalled_cycles = stalled;
  std::vector<CounterTotal> totals = check_lanes(answer.lanes);
  totals.push_back({"rows"});
  check_counter("rows", counters.counted[0], counters.observed[0], totals[2]);
  check_answers(answer.answers, totals);
  report_.counters = std::move(totals);
}

void ArgMinJudge::add_mismatch(std::uint64_t row, std::uint64_t expected,
                               const harness::wire::RowResult& got) {
  ++report_.mismatch_count;
  if (report_.mismatches.size() >= VerifyReport::kept) return;
  Mismatch mismatch =
      describe_comparison(design_, comparisons_, row * (report_.arg_min->candidates - 1));
  mismatch.expected = fmt::format("candidate {}", expected);
  mismatch.got = fmt::format("candidate {}", got.index);
  mismatch.cycle = got.cycle_left;
  report_.mismatches.push_back(std::move(mismatch));
}

}  // namespace mixcmp::verilator_tb
