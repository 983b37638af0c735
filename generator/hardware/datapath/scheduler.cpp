#include "generator/hardware/datapath/scheduler.hpp"

#include <fmt/core.h>

#include <optional>
#include <tuple>

#include "model/base/common/check.hpp"

namespace mixcmp::datapath {
namespace {

/// Adds up the delays of stages behind a register, separately for each chain of logic.
class Path {
public:
  explicit Path(const Stage& first) {
    for (const ChainDelay& chain : chains_of(first)) ends_.push_back(chain.delay_ns);
  }

  void add(const Stage& stage) {
    const std::vector<ChainDelay> chains = chains_of(stage);
    // Chains that fork or join begin when the slowest chain of the stage before has ended.
    if (stage.forks || chains.size() != ends_.size()) ends_.assign(chains.size(), end_ns());
    for (std::size_t k = 0; k < chains.size(); ++k) {
      ends_[k] += chains[k].delay_ns - chains[k].overlap_ns;
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

/// Finds the fewest cuts, the output's included, with at most `logic_ns` of logic between two cuts.
/// A longer stage has a cut at either end. Among choices with equally many cuts the search prefers
/// fewer halved sums, then later cuts. It is dynamic programming: the best cuts in front of a stage
/// extend those of an earlier one.
class CutSearch {
public:
  /// `forced`: a stage that ends in a cut whatever the period is.
  CutSearch(const std::vector<Stage>& stages, double logic_ns, std::optional<int> forced = {})
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
  struct Choice {
    int number = 0;
    int halved_sums = 0;
    int start = 0;  ///< the first stage behind the last cut but one
  };

  int count() const { return static_cast<int>(stages_.size()); }

  bool must_cut(int stage) const { return stage == forced_ || stages_[stage].registered; }

  bool halves_a_sum(int end) const { return end < count() && stages_[end].is_upper_half; }

  /// Tries all places for the last cut but one, the latest first.
  Choice best_before(int end) const {
    Choice best = extended(end - 1, end);
    for (int start = end - 2; start >= 0 && !must_cut(start) && fits(start, end); --start) {
      const Choice choice = extended(start, end);
      if (std::tie(choice.number, choice.halved_sums) < std::tie(best.number, best.halved_sums)) {
        best = choice;
      }
    }
    return best;
  }

  Choice extended(int start, int end) const {
    const Choice& before = best_[start];
    return {before.number + 1, before.halved_sums + (halves_a_sum(end) ? 1 : 0), start};
  }

  bool fits(int start, int end) const {
    Path path(stages_[start]);
    for (int k = start + 1; k < end; ++k) path.add(stages_[k]);
    return path.end_ns() <= logic_ns_;
  }

  const std::vector<Stage>& stages_;
  double logic_ns_;
  std::optional<int> forced_;
  std::vector<Choice> best_;
};

/// The time by which stages exceed `logic_ns`, summed over those that do.
double excess_ns(const Unit& unit, double logic_ns) {
  double excess = 0;
  for (const Stage& stage : unit.stages) excess += std::max(0.0, stage.delay_ns - logic_ns);
  return excess;
}

/// The form of `unit` that fits `logic_ns` better.
Unit best_form(Unit unit, double logic_ns) {
  if (unit.faster_form.empty()) return unit;
  Unit faster = std::move(unit.faster_form.front());
  return excess_ns(faster, logic_ns) < excess_ns(unit, logic_ns) ? faster : unit;
}

std::vector<NodeId> each_once(const std::vector<NodeId>& nodes) {
  std::vector<NodeId> found;
  for (const NodeId id : nodes) {
    if (std::find(found.begin(), found.end(), id) == found.end()) found.push_back(id);
  }
  return found;
}

}  // namespace

Step Scheduler::place(Unit unit, const std::vector<NodeId>& reads, int earliest) {
  unit = best_form(std::move(unit), logic_ns_);
  std::vector<bool> cuts = choose_cuts(unit);
  const int latency = static_cast<int>(std::count(cuts.begin(), cuts.end(), true));
  Step step = wires(reads, earliest);
  step.unit = std::move(unit);
  step.cuts = std::move(cuts);
  step.ready_cycle += latency;
  return step;
}

Step Scheduler::wires(const std::vector<NodeId>& reads, int earliest) const {
  const int start = std::max(earliest, ready_cycle(schedule_.steps, reads));
  return {.start_cycle = start, .ready_cycle = start, .reads = each_once(reads)};
}

void Scheduler::widen(const std::vector<OperandFormat>& arriving, FloatFormat format,
                      bool is_folded) {
  const auto needs_unit = [&](const OperandFormat& from) {
    return from.floating() == nullptr || from.floating()->exponent_bits() != format.exponent_bits();
  };
  if (std::none_of(arriving.begin(), arriving.end(), needs_unit)) return;
  for (const OperandFormat& from : arriving) {
    Step& step = schedule_.widenings.emplace_back();
    if (!needs_unit(from)) continue;
    step = place(widening_unit(from, format, delays_), {});
    if (!is_folded) continue;
    step.cuts.assign(step.cuts.size(), false);
    step.ready_cycle = 0;
  }
  for (const Step& step : schedule_.widenings) {
    schedule_.entry_cycles = std::max(schedule_.entry_cycles, step.ready_cycle);
  }
}

std::vector<bool> Scheduler::choose_cuts(const Unit& unit) {
  for (const Stage& stage : unit.stages) {
    if (stage.delay_ns > logic_ns_) note_slow(unit, stage);
  }
  const std::vector<bool> cuts = CutSearch(unit.stages, logic_ns_).cuts();
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    const int needed = unit.stages[k].cut_needs;
    if (cuts[k] && needed >= 0 && !cuts[needed]) {
      return CutSearch(unit.stages, logic_ns_, needed).cuts();
    }
  }
  return cuts;
}

void Scheduler::note_slow(const Unit& unit, const Stage& stage) {
  const std::string note =
      fmt::format("{}, stage \"{}\": about {:.1f} ns of logic, the target leaves {:.1f} ns",
                  unit.module, stage.name, stage.delay_ns, logic_ns_);
  auto& notes = schedule_.slow_stages;
  if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
}

Schedule Scheduler::finish() {
  int ready = 0;
  for (const PartSchedule& part : schedule_.parts) {
    ready = std::max(ready, part.decision.ready_cycle);
  }
  if (schedule_.parts.size() > 1) {
    schedule_.combination = place(combination_unit(schedule_.parts.size(), delays_), {}, ready);
    ready = schedule_.combination.ready_cycle;
  }
  schedule_.latency_cycles = schedule_.entry_cycles + ready;
  return std::move(schedule_);
}

}  // namespace mixcmp::datapath
