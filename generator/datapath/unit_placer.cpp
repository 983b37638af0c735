#include "generator/datapath/unit_placer.hpp"

#include <fmt/core.h>

#include "model/common/check.hpp"

namespace mixcmp::datapath {

Step UnitPlacer::place(Unit unit, int start) {
  std::vector<bool> cuts = choose_cuts(unit);
  const int latency = static_cast<int>(std::count(cuts.begin(), cuts.end(), true));
  return {std::move(unit), std::move(cuts), start, start + latency};
}

std::vector<bool> UnitPlacer::choose_cuts(const Unit& unit) {
  for (const Stage& stage : unit.stages) {
    if (stage.delay_ns > logic_ns_) note_slow(unit, stage);
  }
  const std::vector<Stage> stages = with_whole_sums(unit.stages);
  const std::vector<bool> cuts = greedy_cuts(stages, -1);
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    const int needed = stages[k].cut_needs;
    if (cuts[k] && needed >= 0 && !cuts[needed]) return greedy_cuts(stages, needed);
  }
  return cuts;
}

/// Leaves nothing to do for the upper half of a sum that fits into one period.
std::vector<Stage> UnitPlacer::with_whole_sums(std::vector<Stage> stages) const {
  for (std::size_t k = 1; k < stages.size(); ++k) {
    Stage& upper = stages[k];
    const double whole_ns = stages[k - 1].delay_ns + upper.delay_ns - upper.overlap_ns;
    if (!upper.is_upper_half || whole_ns > logic_ns_) continue;
    stages[k - 1].delay_ns = whole_ns;
    upper.delay_ns = upper.overlap_ns = 0;
  }
  return stages;
}

/// Places registers from the operands on: one behind the stage `forced` (-1: none), and one in
/// front of each stage that would not fit into the period, besides those that a unit has anyway.
/// For a chain of stages this needs the fewest registers.
std::vector<bool> UnitPlacer::greedy_cuts(const std::vector<Stage>& stages, int forced) const {
  MIXCMP_CHECK(!stages.empty());
  std::vector<bool> cuts(stages.size(), false);
  double path_ns = 0;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const double stage_ns = stages[k].delay_ns;
    path_ns += stage_ns - stages[k].overlap_ns;
    if (k > 0 && (path_ns > logic_ns_ || static_cast<int>(k) - 1 == forced)) {
      cuts[k - 1] = true;
      path_ns = stage_ns;
    }
    if (stages[k].registered) {
      cuts[k] = true;
      path_ns = 0;
    }
  }
  cuts.back() = true;
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
