#include "model/plan/optimise/plan_summary.hpp"

#include <fmt/core.h>

namespace mixcmp::optimise {
namespace {

/// Whether the plan has references that are folded, or placed for their own target.
bool any_unusual(const PrecisionPlan& plan, const Allocation& chosen) {
  const std::vector<ReferenceKind>& references = plan.problem.references;
  for (std::size_t k = 0; k < references.size(); ++k) {
    const bool unusual = references[k].initiation_interval > 1 || references[k].has_own_target;
    if (chosen.references[k] > 0 && unusual) return true;
  }
  return false;
}

std::string kinds_of(const PrecisionPlan& plan, const Allocation& chosen) {
  std::string text;
  const auto add = [&text](int count, const std::string& name) {
    if (count > 0) text += fmt::format("{}{} x {}", text.empty() ? "" : ", ", count, name);
  };
  for (std::size_t k = 0; k < plan.lanes.size(); ++k) add(chosen.lanes[k], plan.lanes[k].kind.name);
  if (plan.second_lanes) add(plan.second_lanes->count, name_of(*plan.second_lanes));
  if (!any_unusual(plan, chosen)) return text;
  const std::vector<ReferenceKind>& references = plan.problem.references;
  for (std::size_t k = 0; k < references.size(); ++k) add(chosen.references[k], references[k].name);
  return text;
}

}  // namespace

PlanSummary summary_of(const PrecisionPlan& plan) {
  const Allocation* chosen = plan.allocation();
  if (chosen == nullptr) return {};
  return {.precision = plan.precision,
          .lanes = chosen->lane_count(),
          .references = chosen->reference_count(),
          .clock_mhz = plan.clock_mhz(),
          .recomputation_rate = plan.recomputation_rate(),
          .throughput_per_s = plan.throughput_per_s(),
          .used = chosen->used,
          .kinds = kinds_of(plan, *chosen)};
}

PlanSummary summary_of(const Optimisation& optimisation) {
  const PrecisionPlan* best = optimisation.best();
  return best == nullptr ? PlanSummary{} : summary_of(*best);
}

double baseline_per_s(const Optimisation& optimisation) {
  const auto* alone = std::get_if<Allocation>(&optimisation.reference_only);
  return alone == nullptr ? 0 : alone->throughput_per_s;
}

}  // namespace mixcmp::optimise
