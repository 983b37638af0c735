#include "verilator_tb/pairwise_judge.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <tuple>

#include "model/base/number/verdict.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "verilator_tb/judgement.hpp"

namespace mixcmp::verilator_tb {

/// The reports of one set, sorted by pair, and how far a judge has come that visits the pairs in
/// this order.
class PairwiseJudge::Reports {
public:
  explicit Reports(std::vector<harness::wire::ReportedPair> reports)
      : reports_(std::move(reports)) {
    std::stable_sort(reports_.begin(), reports_.end(),
                     [](const harness::wire::ReportedPair& a,
                        const harness::wire::ReportedPair& b) { return key(a) < key(b); });
  }

  /// Returns the first report of this pair, or null. Skipped reports of earlier pairs, and further
  /// reports of this pair, are passed to `stray`.
  template <class Stray>
  const harness::wire::ReportedPair* find(std::uint64_t i, std::uint64_t j, const Stray& stray) {
    const harness::wire::ReportedPair* found = nullptr;
    for (; next_ < reports_.size() && key(reports_[next_]) <= std::tuple(i, j); ++next_) {
      const harness::wire::ReportedPair& report = reports_[next_];
      if (found == nullptr && key(report) == std::tuple(i, j)) {
        found = &report;
      } else {
        stray(report, found != nullptr);
      }
    }
    return found;
  }

  std::span<const harness::wire::ReportedPair> rest() const {
    return std::span(reports_).subspan(next_);
  }
  std::span<const harness::wire::ReportedPair> all() const { return reports_; }

private:
  static std::tuple<std::uint64_t, std::uint64_t> key(const harness::wire::ReportedPair& report) {
    return {report.i, report.j};
  }

  std::vector<harness::wire::ReportedPair> reports_;
  std::size_t next_ = 0;
};

namespace {

constexpr std::uint64_t closing_tuser = 0x80;

ResultWord word_of(const harness::wire::ReportedPair& report) {
  return ResultWord(static_cast<std::uint32_t>(report.tuser));
}

std::string pair_text(const harness::wire::ReportedPair& report) {
  return fmt::format("items {} and {}, tuser 0x{:02x}", report.i, report.j, report.tuser);
}

}  // namespace

PairwiseJudge::PairwiseJudge(const emit::Signature& signature, const design::Design& design,
                             const data::Comparisons& comparisons, const VerifyOptions& options)
    : EngineJudge(signature, design, comparisons, options) {
  const std::uint64_t others = comparisons.tables().size() > 1 ? comparisons.tables()[1].rows() : 0;
  report_.engine =
      PairwiseFigures{.top = signature.engine->top,
                      .items = comparisons.table().rows() + others,
                      .others = others,
                      .item_bytes = static_cast<std::uint64_t>(signature.engine->item_bytes),
                      .pair_bytes = static_cast<std::uint64_t>(signature.tdata_bytes)};
  data_ = std::make_shared<performance::PairwiseData>(
      performance::PairwiseData{.set = {comparisons.table().rows(), others}});
  data_->reported.resize((data_->pairs() + 63) / 64);
}

data::Items PairwiseJudge::rows_of(const SetRange& set, std::uint64_t i, std::uint64_t j) const {
  const std::uint64_t second =
      set.others.count > 0 ? set.others.first + j - set.items.count : set.items.first + j;
  return {.row = 0, .first = set.items.first + i, .second = second};
}

bool PairwiseJudge::is_pair(const SetRange& set, std::uint64_t i, std::uint64_t j) const {
  return i < set.items.count && j >= set.first_partner(i) && j < set.size();
}

std::uint64_t PairwiseJudge::pair_of(const SetRange& set, std::uint64_t i, std::uint64_t j) const {
  const data::Items rows = rows_of(set, i, j);
  if (comparisons_.pairing() == data::Pairing::cross) {
    return rows.first * comparisons_.tables()[1].rows() + rows.second;
  }
  return data::pair_index(rows.first, rows.second, comparisons_.table().rows());
}

ResultWord PairwiseJudge::expected(const SetRange& set, std::uint64_t i, std::uint64_t j) {
  comparisons_.fetch(rows_of(set, i, j), operands_);
  return expected_word(design_, group_of_lane_[lane_of(i)], operands_);
}

bool PairwiseJudge::is_reported(ResultWord word) const {
  return word.is_undecided() || design_.system.engine.report.contains(word.verdict());
}

void PairwiseJudge::take(const SetRange& set, const SetAnswer& answer, Use use) {
  for (const harness::wire::Violation& violation : answer.violations) {
    add_violation(to_text(violation.fault), violation.cycle,
                  fmt::format("tdata 0x{:x}", violation.tag));
  }
  ++report_.engine->sets;
  switch (answer.response.state) {
    case harness::wire::SetState::closed: return judge_closed(set, answer, use);
    case harness::wire::SetState::interrupted: return judge_interrupted(set, answer);
    case harness::wire::SetState::stopped: return;
  }
}

void PairwiseJudge::judge_closed(const SetRange& set, const SetAnswer& answer, Use use) {
  Reports reports(answer.reports);
  due_ = 0;
  for (std::uint64_t i = 0; i < set.items.count; ++i) {
    for (std::uint64_t j = set.first_partner(i); j < set.size(); ++j) {
      judge_pair(set, i, j, reports, use);
    }
  }
  for (const harness::wire::ReportedPair& report : reports.rest()) {
    add_violation("report of no pair", report.cycle, pair_text(report));
  }
  judge_closing_beats(answer, due_);
  judge_counters(answer, use);
  if (use == Use::figures) {
    report_.cycles = answer.response.cycles;
    report_.engine->reported = due_;
  }
}

void PairwiseJudge::judge_pair(const SetRange& set, std::uint64_t i, std::uint64_t j,
                               Reports& reports, Use use) {
  const ResultWord word = expected(set, i, j);
  const harness::wire::ReportedPair* got =
      reports.find(i, j, [this](const harness::wire::ReportedPair& report, bool again) {
        add_violation(again ? "pair reported twice" : "report of no pair", report.cycle,
                      pair_text(report));
      });
  if (word.is_recomputed()) ++recomputations_;
  const bool due = is_reported(word);
  if (due) ++due_;
  const bool as_due =
      got == nullptr ? !due || counts_only() : due && !counts_only() && word_of(*got) == word;
  if (!as_due) return add_mismatch(set, i, j, word, got);
  if (use == Use::figures) count(set, i, j, word);
}

/// Judges a set that a reset broke off: reports may be missing, but those that left must be right.
void PairwiseJudge::judge_interrupted(const SetRange& set, const SetAnswer& answer) {
  const Reports reports(answer.reports);
  const harness::wire::ReportedPair* before = nullptr;
  for (const harness::wire::ReportedPair& report : reports.all()) {
    if (!is_pair(set, report.i, report.j)) {
      add_violation("report of no pair", report.cycle, pair_text(report));
      continue;
    }
    if (before != nullptr && before->i == report.i && before->j == report.j) {
      add_violation("pair reported twice", report.cycle, pair_text(report));
    }
    before = &report;
    const ResultWord word = expected(set, report.i, report.j);
    if (!is_reported(word) || word_of(report) != word) {
      add_mismatch(set, report.i, report.j, word, &report);
    }
  }
  recomputations_ = 0;
  stalled_before_ = 0;
}

/// Judges the closing beat of each stream: it counts the reports of its stream, or, where none
/// leave, its share of those that are due.
void PairwiseJudge::judge_closing_beats(const SetAnswer& answer, std::uint64_t due) {
  std::uint64_t counted = 0;
  for (const harness::wire::StreamEnd& end : answer.streams) {
    counted += end.closing_tdata;
    const bool right_count = counts_only() || end.closing_tdata == end.beats;
    if (right_count && end.closing_tuser == closing_tuser) continue;
    add_violation("closing beat is wrong", 0,
                  fmt::format("{} reports, tuser 0x{:02x} instead of {}, 0x{:02x}",
                              end.closing_tdata, end.closing_tuser, end.beats, closing_tuser));
  }
  if (!counts_only() || counted == due) return;
  add_violation("count is wrong", 0, fmt::format("{} reports instead of {}", counted, due));
}

/// Judges, after each set, the counters, which run since reset. The report keeps the last totals.
void PairwiseJudge::judge_counters(const SetAnswer& answer, Use use) {
  if (signature_.counter_bits == 0) return;
  const harness::wire::CounterValues& counters = answer.response.counters;
  const std::uint64_t stalled = stalls_gained(counters.counted[2]);
  if (use == Use::figures) report_.engine->stalled_cycles = stalled;
  std::vector<CounterTotal> totals = {{"reports"}, {"recomputations"}, {"busy_cycles"}};
  for (const harness::wire::StreamEnd& end : answer.streams) {
    check_counter("reports", end.counted_beats, end.observed_beats, totals[0]);
  }
  check_counter("recomputations", counters.counted[0], recomputations_, totals[1]);
  check_counter("busy_cycles", counters.counted[1], counters.observed[1], totals[2]);
  if (!answer.answers.empty()) {
    totals.push_back({"answers"});
    // Any reference takes any pair, so only the sum of their answers is known.
    std::uint64_t answers = 0;
    for (const std::uint64_t counted : answer.answers) answers += counted;
    const auto mask = static_cast<std::uint64_t>(low_mask(signature_.counter_bits));
    check_counter("answers", answers & mask, recomputations_, totals.back());
  }
  report_.counters = std::move(totals);
}

void PairwiseJudge::count(const SetRange& set, std::uint64_t i, std::uint64_t j, ResultWord word) {
  GroupReport& group = report_.groups[group_of_lane_[lane_of(i)]];
  ++report_.comparisons;
  ++group.comparisons;
  if (word.is_recomputed()) ++report_.recomputations, ++group.recomputations;
  if (word.is_undecided()) {
    ++report_.undecided;
    ++group.undecided;
  } else {
    ++report_.verdicts[static_cast<std::size_t>(word.verdict())];
  }
  mark_if_reported(pair_of(set, i, j), word);
  if (options_.truth) {
    check_against_truth(*options_.truth, design_, operands_, word, *report_.truth, group);
  }
  if (options_.on_result && is_reported(word)) {
    options_.on_result({pair_of(set, i, j), rows_of(set, i, j), word});
  }
}

void PairwiseJudge::mark_if_reported(std::uint64_t pair, ResultWord word) {
  const Verdict verdict =
      word.is_undecided() ? reference_verdict(design_, operands_) : word.verdict();
  const bool is_marked = design_.system.engine.report.contains(verdict);
  data_->reported[pair / 64] |= std::uint64_t{is_marked} << pair % 64;
}

void PairwiseJudge::add_mismatch(const SetRange& set, std::uint64_t i, std::uint64_t j,
                                 ResultWord expected, const harness::wire::ReportedPair* got) {
  ++report_.mismatch_count;
  ++report_.groups[group_of_lane_[lane_of(i)]].mismatches;
  if (report_.mismatches.size() >= VerifyReport::kept) return;
  Mismatch mismatch = describe_comparison(design_, comparisons_, pair_of(set, i, j));
  mismatch.expected = describe(expected) + (is_reported(expected) ? "" : ", not reported");
  mismatch.got = got == nullptr ? std::string("not reported") : describe(word_of(*got));
  mismatch.lane = static_cast<std::uint32_t>(lane_of(i));
  mismatch.cycle = got == nullptr ? 0 : got->cycle;
  report_.mismatches.push_back(std::move(mismatch));
}

}  // namespace mixcmp::verilator_tb
