#include "model/plan/profile/rate_worker.hpp"

#include <algorithm>

#include "model/base/common/counter_random.hpp"
#include "model/judge/golden/evaluate.hpp"

namespace mixcmp::profile {

namespace {

/// No verdict is wrong if the truth is undetermined. With &, since && would branch.
bool is_wrong(Decision verdict, Decision truth) {
  return (verdict != truth) & (truth != Decision::undecided);
}

/// Batch size: byte counters overflow at 255 and fill a vector best.
constexpr std::size_t countable = 255;

}  // namespace

std::uint64_t RateJob::comparison(std::uint64_t k) const {
  if (stretch == 1) return k;
  const std::uint64_t first = k * stretch;
  return first + counter_random(0, k) % std::min(stretch, source.data().size() - first);
}

RateTally::RateTally(const RateJob& job) {
  for (const SchemeLanes& scheme : job.schemes) {
    std::vector<SchemeCounts>& row = counts.emplace_back();
    for (const auto& lane : scheme.lanes) row.push_back({.exists = lane.has_value()});
  }
}

void RateTally::add(const RateTally& other) {
  for (std::size_t scheme = 0; scheme < counts.size(); ++scheme) {
    for (std::size_t k = 0; k < counts[scheme].size(); ++k) {
      counts[scheme][k].undecided += other.counts[scheme][k].undecided;
      counts[scheme][k].wrong += other.counts[scheme][k].wrong;
      counts[scheme][k].wrong_by_lane += other.counts[scheme][k].wrong_by_lane;
    }
  }
  reference_wrong += other.reference_wrong;
  true_verdicts += other.true_verdicts;
  undetermined += other.undetermined;
  emulated += other.emulated;
}

RateWorker::RateWorker(const RateJob& job)
    : job_(job),
      tally_(job),
      pending_(job.bands.size(), UnsettledComparisons(job.source.data().input_count(), capacity)),
      last_(job.schemes.size() * capacity),
      doubtful_(capacity),
      left_(capacity),
      order_(capacity),
      picked_(job.source.data().input_count(), capacity),
      decisions_(capacity) {}

void RateWorker::run(const BlockSource& next) {
  std::uint64_t first = 0, count = 0;
  while (next(first, count)) start(first, count);
  for (std::size_t band = 1; band < pending_.size(); ++band) process(band);
}

/// Takes new comparisons through the first band: range checks, envelopes, true verdicts and lanes.
void RateWorker::start(std::uint64_t first, std::size_t count) {
  UnsettledComparisons& unsettled = pending_.front();
  fetch(first, count, unsettled.operands());
  const auto all = static_cast<std::uint32_t>((std::uint64_t{1} << job_.schemes.size()) - 1);
  std::fill_n(unsettled.schemes.begin(), count, all);
  for (std::size_t k = 0; k < count; ++k) {
    if (job_.failing.empty()) break;
    const data::Items items = job_.source.data().items(fetched_[k]);
    unsettled.failing[k] = 0;
    for (const RateJob::Failing& failing : job_.failing) {
      unsettled.failing[k] |= failing.of_row[items.of(failing.item)];
    }
  }
  classify(job_.bands.front(), unsettled, true);
  find_true_verdicts(unsettled);
  process(0);
}

/// Consecutive comparisons are fetched together, which is faster.
void RateWorker::fetch(std::uint64_t first, std::size_t count, data::OperandBlock& operands) {
  fetched_.resize(count);
  for (std::size_t k = 0; k < count; ++k) fetched_[k] = job_.comparison(first + k);
  if (job_.stretch == 1) {
    job_.source.fetch(first, count, operands);
  } else {
    job_.source.fetch(fetched_, operands);
  }
}

/// Evaluates the band's envelopes on all unsettled comparisons; for new ones it also finds the
/// verdicts.
void RateWorker::classify(const PrecisionBand& band, UnsettledComparisons& unsettled,
                          bool is_first) {
  for (std::size_t at = 0; at < unsettled.size(); at += envelope_width) {
    const BlockFindings findings{last_.data() + at, capacity, doubtful_.data() + at,
                                 (is_first ? unsettled.truth : decisions_).data() + at};
    band.classify(unsettled.operands().columns(at), envelope_, findings);
  }
  if (job_.method == ProfileMethod::brute_force) {
    std::fill(last_.begin(), last_.end(), static_cast<LastOpen>(band.next()));
    std::fill(doubtful_.begin(), doubtful_.end(), 1);
  }
}

void RateWorker::find_true_verdicts(UnsettledComparisons& unsettled) {
  unsettled.reference = unsettled.truth;
  std::vector<std::size_t> rows;
  std::vector<std::uint64_t> indices;
  for (std::size_t k = 0; k < unsettled.size(); ++k) {
    if (doubtful_[k] == 0) continue;
    rows.push_back(k);
    indices.push_back(fetched_[k]);
  }
  job_.source.fetch(indices, picked_.operands());
  job_.reference.decide(picked_.operands().columns(), indices.size(), decisions_);
  const std::vector<Decision> certified = certified_verdicts(indices.size());
  std::vector<Bits> operands(job_.source.data().input_count());
  for (std::size_t n = 0; n < indices.size(); ++n) {
    const std::size_t k = rows[n];
    unsettled.reference[k] = decisions_[n];
    unsettled.truth[k] = certified[n];
    if (certified[n] == Decision::undecided) {
      job_.source.data().fetch(indices[n], operands);
      const auto truth =
          golden::true_verdict(job_.scene.graph, job_.scene.reference.format, operands);
      unsettled.truth[k] = decision_of(truth);
      if (!truth) ++tally_.undetermined;
      ++tally_.true_verdicts;
    }
    if (is_wrong(unsettled.reference[k], unsettled.truth[k])) ++tally_.reference_wrong;
  }
  if (job_.pairs != nullptr) mark_reported(unsettled);
}

/// The verdicts on the picked operands that a reference as a lane decides; the others undecided.
std::vector<Decision> RateWorker::certified_verdicts(std::size_t count) {
  std::vector<Decision> verdicts(capacity, Decision::undecided);
  const bool may_rely = job_.certified_reference && job_.method != ProfileMethod::brute_force;
  if (may_rely) job_.certified_reference->decide(picked_.operands().columns(), count, verdicts);
  return verdicts;
}

void RateWorker::mark_reported(const UnsettledComparisons& unsettled) {
  static_assert(block % 64 == 0, "blocks share no element");
  const VerdictSet& report = job_.scene.system.engine.report;
  for (std::size_t k = 0; k < unsettled.size(); ++k) {
    const Decision truth = unsettled.truth[k];
    const bool is_reported =
        truth != Decision::undecided && report.contains(static_cast<Verdict>(truth));
    job_.pairs->reported[fetched_[k] / 64] |= std::uint64_t{is_reported} << fetched_[k] % 64;
  }
}

void RateWorker::process(std::size_t index) {
  const PrecisionBand& band = job_.bands[index];
  UnsettledComparisons& unsettled = pending_[index];
  make_room(index + 1, unsettled.size());
  if (index > 0) classify(band, unsettled, false);
  settle_finished(band, unsettled);
  for (std::size_t scheme = 0; scheme < band.scheme_count(); ++scheme) {
    run_scheme(band, scheme, unsettled);
  }
  if (index + 1 < pending_.size()) pass_on(band, unsettled, pending_[index + 1]);
  unsettled.operands().resize(0);
  if (index + 1 < pending_.size() && pending_[index + 1].size() >= block) process(index + 1);
}

/// Empties a band's queue if it has no room for `count` more. The bands share their working memory,
/// so this happens before another band begins. The first band never needs it: its queue holds one
/// block, and that of the second band less than one.
void RateWorker::make_room(std::size_t index, std::size_t count) {
  if (index < pending_.size() && pending_[index].size() + count > capacity) process(index);
}

/// Corrects the findings on comparisons that this band's envelope cannot judge. A failing range
/// check leaves a lane undecided at every precision, and a scheme that an earlier band settled
/// stays settled.
void RateWorker::settle_finished(const PrecisionBand& band, const UnsettledComparisons& unsettled) {
  const auto next = static_cast<LastOpen>(band.next());
  const auto before = static_cast<LastOpen>(band.anchor() - 1);
  const std::uint32_t* const failing = unsettled.failing.data();
  const std::uint32_t* const schemes = unsettled.schemes.data();
  const std::size_t count = unsettled.size();
  for (std::size_t scheme = 0; scheme < band.scheme_count(); ++scheme) {
    LastOpen* const last = last_.data() + scheme * capacity;
    const std::uint32_t bit = std::uint32_t{1} << scheme;
    for (std::size_t k = 0; k < count; ++k) {
      const LastOpen open = (failing[k] & bit) != 0 ? next : last[k];
      last[k] = (schemes[k] & bit) == 0 ? before : open;
    }
  }
}

/// Runs the lanes of one scheme. A comparison that is not open is decided rightly, so counting it
/// changes nothing. If more than a quarter are open, all are run, which is cheaper than picking.
void RateWorker::run_scheme(const PrecisionBand& band, std::size_t scheme,
                            const UnsettledComparisons& unsettled) {
  count_open(band, scheme, unsettled.size());
  bool picked = false;
  for (int precision = band.anchor(); precision < band.next(); ++precision) {
    const std::size_t open = open_at_[precision - band.anchor()];
    if (open == 0) break;
    const LaneRunner& runner = band.runner(scheme, precision);
    if (!runner.exists()) continue;
    const bool most = open > unsettled.size() / 4;
    if (!most && !picked) pick(band, scheme, precision, unsettled);
    picked = picked || !most;
    run_lane(runner, scheme, precision, most ? unsettled : picked_, most ? unsettled.size() : open);
  }
}

void RateWorker::count_open(const PrecisionBand& band, std::size_t scheme, std::size_t count) {
  const LastOpen* const last = last_.data() + scheme * capacity;
  const int before = band.anchor() - 1, steps = band.next() - before;
  std::vector<std::size_t>& with = open_at_;
  with.assign(steps + 2, 0);
  for (std::size_t k = 0; k < count; ++k) ++with[last[k] - before];
  with.erase(with.begin());
  for (int step = steps; step-- > 0;) with[step] += with[step + 1];
}

/// Picks the comparisons that are open at this precision or a later one of the band, longest open
/// first. So the comparisons that are open at L stand at the beginning of the list.
void RateWorker::pick(const PrecisionBand& band, std::size_t scheme, int precision,
                      const UnsettledComparisons& unsettled) {
  const LastOpen* const last = last_.data() + scheme * capacity;
  const int anchor = band.anchor();
  std::vector<std::size_t> place(open_at_.begin() + 1, open_at_.end());
  for (std::size_t k = 0; k < unsettled.size(); ++k) {
    if (last[k] >= precision) order_[place[last[k] - anchor]++] = static_cast<std::uint32_t>(k);
  }
  const std::size_t count = open_at_[precision - anchor];
  picked_.operands().resize(count);
  for (std::size_t input = 0; input < job_.source.data().input_count(); ++input) {
    const double* const from = unsettled.operands().column(input);
    double* const to = picked_.operands().column(input);
    for (std::size_t n = 0; n < count; ++n) to[n] = from[order_[n]];
  }
  for (std::size_t n = 0; n < count; ++n) {
    picked_.truth[n] = unsettled.truth[order_[n]];
    picked_.reference[n] = unsettled.reference[order_[n]];
  }
}

void RateWorker::run_lane(const LaneRunner& runner, std::size_t scheme, int precision,
                          const UnsettledComparisons& unsettled, std::size_t count) {
  runner.decide(unsettled.operands().columns(), count, decisions_);
  tally_.emulated += count;
  SchemeCounts& counts = tally_.counts[scheme][precision - job_.bands.front().anchor()];
  for (std::size_t first = 0; first < count; first += countable) {
    const std::size_t end = std::min(count, first + countable);
    std::uint8_t undecided = 0, wrong = 0, wrong_by_lane = 0;
    for (std::size_t n = first; n < end; ++n) {
      const bool open = decisions_[n] == Decision::undecided;
      const bool by_lane = is_wrong(decisions_[n], unsettled.truth[n]) & !open;
      const bool by_reference = is_wrong(unsettled.reference[n], unsettled.truth[n]) & open;
      undecided = static_cast<std::uint8_t>(undecided + open);
      wrong = static_cast<std::uint8_t>(wrong + (by_lane | by_reference));
      wrong_by_lane = static_cast<std::uint8_t>(wrong_by_lane + by_lane);
    }
    counts.undecided += undecided;
    counts.wrong += wrong;
    counts.wrong_by_lane += wrong_by_lane;
  }
}

void RateWorker::pass_on(const PrecisionBand& band, const UnsettledComparisons& from,
                         UnsettledComparisons& to) {
  const std::size_t count = from.size();
  std::fill_n(left_.begin(), count, 0);
  for (std::size_t scheme = 0; scheme < band.scheme_count(); ++scheme) {
    const LastOpen* const last = last_.data() + scheme * capacity;
    for (std::size_t k = 0; k < count; ++k) {
      left_[k] |= std::uint32_t{last[k] >= band.next()} << scheme;
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (left_[k] != 0) to.append(from, k, left_[k]);
  }
}

}  // namespace mixcmp::profile
