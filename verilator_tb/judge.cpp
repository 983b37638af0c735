#include "verilator_tb/judge.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "model/base/common/counter_random.hpp"
#include "model/base/number/verdict.hpp"
#include "verilator_tb/judgement.hpp"

namespace mixcmp::verilator_tb {

Judge::Judge(const emit::Signature& signature, const design::Design& design,
             const data::Comparisons& comparisons, const Selection& selection,
             const VerifyOptions& options, const ExpectedWords* emulator)
    : signature_(signature),
      design_(design),
      comparisons_(comparisons),
      selection_(selection),
      options_(options),
      emulator_(emulator),
      operands_(comparisons.input_count()),
      report_(empty_report(signature, design, options)) {
  report_.requested = selection.size();
  for (std::size_t k = 0; k < design.lanes.size(); ++k) {
    group_of_lane_.insert(group_of_lane_.end(), static_cast<std::size_t>(design.lanes[k].count), k);
  }
}

void Judge::announce(std::uint64_t count) {
  window_.resize(window_.size() + count);
}

void Judge::take(const Answer& answer) {
  for (const harness::wire::Result& result : answer.results) take_result(result);
  judge(answer.results);
  for (const harness::wire::Violation& violation : answer.violations) take_violation(violation);
  report_.cycles = answer.cycles;
  take_counters(answer.groups);
  take_answers(answer);
  retire();
}

void Judge::take_result(const harness::wire::Result& result) {
  MIXCMP_CHECK(result.position >= window_start_ &&
               result.position - window_start_ < window_.size());
  Fate& fate = window_[result.position - window_start_];
  MIXCMP_CHECK(!fate.has_left);  // the simulator reports duplicates as violations
  fate.has_left = true;
  fate.lane = result.lane;
  fate.word = ResultWord(result.tdata);
  fate.cycle_accepted = result.cycle_accepted;
  fate.cycle_left = result.cycle_left;
  ++report_.comparisons;
  GroupReport& group = group_of(result.lane);
  ++group.comparisons;
  const bool decided = fate.word.is_decided_by_lane();
  if (!decided && !first_undecided_) first_undecided_ = result;
  const std::uint64_t cycles = result.cycle_left - result.cycle_accepted;
  const auto latency = decided                    ? &Latencies::decided
                       : fate.word.is_undecided() ? &Latencies::undecided
                                                  : &Latencies::recomputed;
  (report_.latencies.*latency).add(cycles);
  (group.latencies.*latency).add(cycles);
}

void Judge::judge(const std::vector<harness::wire::Result>& results) {
  if (options_.truth) {
    for (const harness::wire::Result& result : results) check_truth(result);
  }
  const std::vector<std::optional<ResultWord>> emulated = emulate(results);
  for (std::size_t k = 0; k < results.size(); ++k) {
    const ResultWord word = expected(results[k], emulated[k]);
    if (ResultWord(results[k].tdata) != word) add_mismatch(results[k], word);
  }
}

/// The emulator's words, lanes of one kind after the other.
std::vector<std::optional<ResultWord>> Judge::emulate(
    const std::vector<harness::wire::Result>& results) const {
  std::vector<std::optional<ResultWord>> words(results.size());
  std::vector<std::size_t> of_group;
  std::vector<std::uint64_t> indices;
  for (std::size_t group = 0; emulator_ != nullptr && group < report_.groups.size(); ++group) {
    if (!emulator_->emulates(group)) continue;
    of_group.clear();
    indices.clear();
    for (std::size_t k = 0; k < results.size(); ++k) {
      if (group_of_lane_[results[k].lane] != group) continue;
      of_group.push_back(k);
      indices.push_back(selection_.index(results[k].position));
    }
    const std::vector<ResultWord> found = emulator_->find(group, indices);
    for (std::size_t k = 0; k < found.size(); ++k) words[of_group[k]] = found[k];
  }
  return words;
}

/// One comparison in 64 by a hash, so that no kind of lane and no item is left out; and all of a
/// short run.
bool Judge::needs_golden_model(const harness::wire::Result& result, ResultWord emulated) const {
  constexpr std::uint64_t one_in = 64, hash_seed = 1;
  const bool sampled = counter_random(hash_seed, selection_.index(result.position)) % one_in == 0 ||
                       selection_.size() <= one_in;
  return sampled || !emulated.is_decided_by_lane() || ResultWord(result.tdata) != emulated;
}

ResultWord Judge::expected(const harness::wire::Result& result,
                           std::optional<ResultWord> emulated) {
  if (emulated && !needs_golden_model(result, *emulated)) {
    ++report_.judged_by_emulator;
    return *emulated;
  }
  fetch(result);
  const ResultWord golden = expected_word(design_, group_of_lane_[result.lane], operands_);
  if (golden.is_recomputed() && reaches_reference(design_, operands_)) ++references_asked_;
  if (emulated && *emulated != golden) add_emulator_error(result, golden, *emulated);
  return golden;
}

void Judge::add_emulator_error(const harness::wire::Result& result, ResultWord golden,
                               ResultWord emulated) {
  ++report_.emulator_errors;
  if (report_.mismatches.size() >= VerifyReport::kept) return;
  Mismatch mismatch = mismatch_of(result, golden);
  mismatch.got = "by the emulator, not the hardware: " + describe(emulated);
  report_.mismatches.push_back(std::move(mismatch));
}

void Judge::fetch(const harness::wire::Result& result) {
  comparisons_.fetch(selection_.index(result.position), operands_);
}

void Judge::check_truth(const harness::wire::Result& result) {
  fetch(result);
  check_against_truth(*options_.truth, design_, operands_, ResultWord(result.tdata), *report_.truth,
                      group_of(result.lane));
}

void Judge::add_mismatch(const harness::wire::Result& result, ResultWord expected) {
  ++report_.mismatch_count;
  ++group_of(result.lane).mismatches;
  if (report_.mismatches.size() < VerifyReport::kept) {
    report_.mismatches.push_back(mismatch_of(result, expected));
  }
}

Mismatch Judge::mismatch_of(const harness::wire::Result& result, ResultWord expected) const {
  const std::uint64_t index = selection_.index(result.position);
  Mismatch mismatch = describe_comparison(design_, comparisons_, index);
  mismatch.expected = describe(expected);
  mismatch.got = describe(ResultWord(result.tdata));
  mismatch.lane = result.lane;
  mismatch.cycle = result.cycle_left;
  if (!options_.repeat_command.empty()) {
    mismatch.repeat = fmt::format("{} --only {}", options_.repeat_command, index);
  }
  return mismatch;
}

void Judge::take_violation(const harness::wire::Violation& violation) {
  if (violation.fault == harness::wire::Fault::lost) {
    window_[violation.position - window_start_].lost = true;
  }
  ++report_.violation_count;
  if (report_.violations.size() >= VerifyReport::kept) return;
  ProtocolViolation told{to_text(violation.fault), violation.lane, violation.cycle,
                         fmt::format("tag 0x{:x}", violation.tag)};
  if (violation.position != harness::wire::no_position) {
    told.details += fmt::format(", comparison {}", selection_.index(violation.position));
  }
  report_.violations.push_back(std::move(told));
}

void Judge::take_counters(const std::vector<harness::wire::CounterValues>& groups) {
  if (groups.empty() || signature_.counter_bits == 0) return;
  constexpr const char* names[] = {"comparisons", "recomputations", "stalls"};
  const auto mask = static_cast<std::uint64_t>(low_mask(signature_.counter_bits));
  for (int k = 0; k < 3; ++k) {
    CounterTotal total{names[k], 0, 0};
    for (std::size_t group = 0; group < groups.size(); ++group) {
      const std::uint64_t counted = groups[group].counted[k];
      const std::uint64_t observed = groups[group].observed[k];
      total.counted += counted;
      total.observed += observed;
      if (counted == (observed & mask)) continue;
      const auto lane = static_cast<std::uint32_t>(group) *
                        static_cast<std::uint32_t>(signature_.lanes_per_group);
      report_wrong_counter(names[k], lane, counted, observed);
    }
    report_.counters.push_back(total);
  }
}

/// Compares the references' answers only in sum, since it is not known which lane of the second
/// tier asked. After a reset they are not compared: it is not known which requests came before it.
void Judge::take_answers_behind_second_tier(const Answer& answer) {
  if (options_.resets > 0) return;
  const std::uint64_t counted =
      std::accumulate(answer.answers.begin(), answer.answers.end(), std::uint64_t{0});
  const auto mask = static_cast<std::uint64_t>(low_mask(signature_.counter_bits));
  report_.counters.push_back({"answers", counted, references_asked_});
  if ((counted & mask) == (references_asked_ & mask)) return;
  report_wrong_counter("answers", 0, counted, references_asked_);
}

/// Lane k, or group k of lanes, is served by reference k modulo their number.
void Judge::take_answers(const Answer& answer) {
  if (answer.answers.empty()) return;
  if (design_.has_second_lanes()) return take_answers_behind_second_tier(answer);
  const auto mask = static_cast<std::uint64_t>(low_mask(signature_.counter_bits));
  CounterTotal total{"answers", 0, 0};
  for (std::size_t reference = 0; reference < answer.answers.size(); ++reference) {
    const std::uint64_t counted = answer.answers[reference];
    std::uint64_t observed = 0;
    for (std::size_t group = reference; group < answer.groups.size();
         group += answer.answers.size()) {
      observed += answer.groups[group].observed[1];
    }
    total.counted += counted;
    total.observed += observed;
    if (counted == (observed & mask)) continue;
    report_wrong_counter("answers", static_cast<std::uint32_t>(reference), counted, observed);
  }
  report_.counters.push_back(total);
}

void Judge::report_wrong_counter(const char* name, std::uint32_t lane, std::uint64_t counted,
                                 std::uint64_t observed) {
  ++report_.violation_count;
  if (report_.violations.size() >= VerifyReport::kept) return;
  report_.violations.push_back({"counter is wrong", lane, report_.cycles,
                                fmt::format("{}: {} instead of {}", name, counted, observed)});
}

void Judge::retire() {
  while (!window_.empty() && (window_.front().has_left || window_.front().lost)) {
    if (window_.front().has_left) count(selection_.index(window_start_), window_.front());
    window_.pop_front();
    ++window_start_;
  }
}

void Judge::count(std::uint64_t index, const Fate& fate) {
  GroupReport& group = group_of(fate.lane);
  if (fate.word.is_recomputed()) {
    ++report_.recomputations;
    ++group.recomputations;
  }
  if (fate.word.is_undecided()) {
    ++report_.undecided;
    ++group.undecided;
  } else {
    ++report_.verdicts[static_cast<std::size_t>(fate.word.verdict())];
  }
  if (!options_.on_result) return;
  options_.on_result(
      {.index = index,
       .items = comparisons_.items(index),
       .word = fate.word,
       .transfer = VerifiedResult::Transfer{fate.lane, fate.cycle_accepted, fate.cycle_left}});
}

}  // namespace mixcmp::verilator_tb
