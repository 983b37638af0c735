#include "generator/datapath/unit_placer.hpp"

#include <fmt/core.h>

#include <tuple>

#include "model/common/check.hpp"

namespace mixcmp::datapath {
namespace {

/// When the chains of logic behind a register have ended.
class Path {
public:
  explicit Path(const Stage& first) {
    for (const ChainDelay& chain : chains_of(first)) ends_.push_back(chain.ns);
  }

  void add(const Stage& stage) {
    const std::vector<ChainDelay> chains = chains_of(stage);
    if (stage.forks || chains.size() != ends_.size()) ends_.assign(chains.size(), end_ns());
    for (std::size_t k = 0; k < chains.size(); ++k) {
      ends_[k] += chains[k].ns - chains[k].overlap_ns;
    }
  }

  double end_ns() const { return *std::max_element(ends_.begin(), ends_.end()); }

private:
  static std::vector<ChainDelay> chains_of(const Stage& stage) {
    if (!stage.chains.empty()) return stage.chains;
    return {{stage.delay_ns, stage.overlap_ns}};
  }

  std::vector<double> ends_;
};

/// Finds the fewest cuts, the last included, between which every path fits into `logic_ns`, a stage
/// that does not fit by itself aside. Of equal numbers it takes that with the fewest sums in
/// halves, then that whose cuts are latest. By dynamic programming: the best cuts of stages 0 to k
/// begin with the best of some stages 0 to j.
class CutSearch {
public:
  /// forced: a stage that ends in a cut, or -1.
  CutSearch(const std::vector<Stage>& stages, double logic_ns, int forced)
      : stages_(stages), logic_ns_(logic_ns), forced_(forced), best_(stages.size() + 1) {
    MIXCMP_CHECK(!stages.empty());
    for (int end = 1; end <= count(); ++end) best_[end] = best_before(end);
  }

  std::vector<bool> cuts() const {
    std::vector<bool> cuts(stages_.size(), false);
    for (int end = count(); end > 0; end = best_[end].start) cuts[end - 1] = true;
    return cuts;
  }

private:
  /// The best cuts of the stages before some `end`.
  struct Cuts {
    int number = 0;
    int halved_sums = 0;
    int start = 0;  ///< the first stage behind the last cut but one
  };

  int count() const { return static_cast<int>(stages_.size()); }

  bool must_cut(int stage) const { return stage == forced_ || stages_[stage].registered; }

  bool halves_a_sum(int end) const { return end < count() && stages_[end].is_upper_half; }

  /// Tries all places for the last cut but one, the latest first.
  Cuts best_before(int end) const {
    Cuts best = extended(end - 1, end);
    for (int start = end - 2; start >= 0 && !must_cut(start) && fits(start, end); --start) {
      const Cuts cuts = extended(start, end);
      if (std::tie(cuts.number, cuts.halved_sums) < std::tie(best.number, best.halved_sums)) {
        best = cuts;
      }
    }
    return best;
  }

  Cuts extended(int start, int end) const {
    const Cuts& before = best_[start];
    return {before.number + 1, before.halved_sums + (halves_a_sum(end) ? 1 : 0), start};
  }

  bool fits(int start, int end) const {
    Path path(stages_[start]);
    for (int k = start + 1; k < end; ++k) path.add(stages_[k]);
    return path.end_ns() <= logic_ns_;
  }

  const std::vector<Stage>& stages_;
  double logic_ns_;
  int forced_;
  std::vector<Cuts> best_;
};

}  // namespace

Step UnitPlacer::place(Unit unit, int start) {
  std::vector<bool> cuts = choose_cuts(unit);
  const int latency = static_cast<int>(std::count(cuts.begin(), cuts.end(), true));
  return {std::move(unit), std::move(cuts), start, start + latency};
}

std::vector<bool> UnitPlacer::choose_cuts(const Unit& unit) {
  for (const Stage& stage : unit.stages) {
    if (stage.delay_ns > logic_ns_) note_slow(unit, stage);
  }
  const std::vector<bool> cuts = CutSearch(unit.stages, logic_ns_, -1).cuts();
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    const int needed = unit.stages[k].cut_needs;
    if (cuts[k] && needed >= 0 && !cuts[needed]) {
      return CutSearch(unit.stages, logic_ns_, needed).cuts();
    }
  }
  return cuts;
}

void UnitPlacer::note_slow(const Unit& unit, const Stage& stage) {
  const std::string note =
      fmt::format("{}, stage \"{}\": about {:.1f} ns of logic, the target leaves {:.1f} ns",
                  unit.module, stage.name, stage.delay_ns, logic_ns_);
  auto& notes = slow_stages_;
  if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
}

Schedule UnitPlacer::finish(Schedule schedule) {
  int ready = 0;
  for (const PartSchedule& part : schedule.parts) {
    ready = std::max(ready, part.decision.ready_cycle);
  }
  if (schedule.parts.size() > 1) {
    schedule.combination = place(combination_unit(schedule.parts.size(), delays_), ready);
    ready = schedule.combination.ready_cycle;
  }
  schedule.latency_cycles = ready;
  schedule.slow_stages = slow_stages_;
  return schedule;
}

}  // namespace mixcmp::datapath
