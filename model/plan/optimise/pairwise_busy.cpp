#include "model/plan/optimise/pairwise_busy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "model/base/common/check.hpp"

namespace mixcmp::optimise {
namespace {

/// An engine has enough lanes if it makes this share of the most pairs per cycle.
constexpr double enough = 0.98;

/// A pairwise engine with the scene's groups and streams.
performance::PairwiseEngine engine_without_lanes(const scene::SystemSpec& system) {
  return {.lanes = 0,
          .lanes_per_segment = system.engine.lanes_per_segment(),
          .streams = system.engine.report_streams,
          .report_as = system.engine.report_as};
}

/// Recomputations per cycle of the lanes that the references can start, at most 1.
double recomputations_per_cycle(const PrecisionPlan& plan, const Allocation& chosen) {
  double system_hz = any_clock;
  for (std::size_t k = 0; k < chosen.lanes.size(); ++k) {
    if (chosen.lanes[k] > 0) system_hz = std::min(system_hz, plan.problem.lanes[k].clock_hz);
  }
  double started = 0;
  for (std::size_t k = 0; k < chosen.references.size(); ++k) {
    const ReferenceKind& kind = plan.problem.references[k];
    const bool has_own_clock = plan.problem.clocks == ClockDomains::separate;
    const double cycles_per_cycle = has_own_clock ? kind.clock_hz / system_hz : 1;
    started += chosen.references[k] * cycles_per_cycle / kind.initiation_interval;
  }
  return std::min(1.0, started);
}

/// The engine with so many of the plan's lanes if all were of the kind that leaves least undecided,
/// and references kept up: no mix of its lanes is faster.
performance::PairwiseEngine fastest_engine(const PrecisionPlan& plan,
                                           const scene::SystemSpec& system, int lanes) {
  performance::PairwiseEngine engine = engine_without_lanes(system);
  engine.lanes = lanes;
  engine.undecided = 1;
  engine.lane_latency_cycles = std::numeric_limits<int>::max();
  for (const LaneImplementation& lane : plan.lanes) {
    engine.undecided = std::min(engine.undecided, lane.kind.recomputation_rate);
    engine.lane_latency_cycles = std::min(engine.lane_latency_cycles, lane.measured.latency_cycles);
  }
  return engine;
}

/// Pairs per cycle of a pairwise engine of so many of the plan's lanes, at most. None if the rates
/// do not know the pairs.
std::optional<double> most_pairs_per_cycle(const PrecisionPlan& plan, const PlanningInputs& inputs,
                                           int lanes) {
  const performance::PairwiseEngine engine = fastest_engine(plan, inputs.scene.system, lanes);
  const auto busy = busy_share(engine, inputs.rates, inputs.options.set.has_value());
  return busy ? std::optional(*busy * lanes) : std::nullopt;
}

}  // namespace

performance::PairwiseEngine engine_of(const PrecisionPlan& plan, const scene::SystemSpec& system,
                                      const Allocation& chosen) {
  performance::PairwiseEngine engine = engine_without_lanes(system);
  engine.lanes = chosen.lane_count();
  for (std::size_t k = 0; k < plan.lanes.size(); ++k) {
    if (chosen.lanes[k] == 0) continue;
    const LaneImplementation& lane = plan.lanes[k];
    engine.undecided = std::max(engine.undecided, lane.kind.recomputation_rate);
    engine.lane_latency_cycles = std::max(engine.lane_latency_cycles, lane.measured.latency_cycles);
  }
  engine.recomputations_per_cycle = recomputations_per_cycle(plan, chosen);
  for (std::size_t k = 0; k < chosen.references.size(); ++k) {
    if (chosen.references[k] == 0) continue;
    engine.reference_latency_cycles =
        std::max(engine.reference_latency_cycles, plan.problem.references[k].latency_cycles);
  }
  return engine;
}

std::optional<double> busy_share(const performance::PairwiseEngine& engine, const Rates& rates,
                                 bool counts_idle_lanes) {
  const std::optional<double> cycles = rates.cycles_per_pair(engine);
  if (!cycles) return std::nullopt;
  if (counts_idle_lanes) return 1 / (engine.lanes * *cycles);
  performance::PairwiseEngine unhindered = engine;
  unhindered.report_as = scene::ReportForm::count;
  unhindered.undecided = 0;
  const double flowing = *rates.cycles_per_pair(unhindered) / *cycles;
  if (engine.report_as != scene::ReportForm::pairs) return flowing;
  // The simulation also has cycles in which few lanes have items and few pairs are reported. T(equ)
  // has all lanes compare, so that the streams' mean load limits it as well.
  const double reported = engine.lanes * rates.reported_share().value();
  return reported > engine.streams ? std::min(flowing, engine.streams / reported) : flowing;
}

int most_useful_groups(const PrecisionPlan& plan, const PlanningInputs& inputs) {
  const int group = inputs.scene.system.engine.lanes_per_segment();
  const int least = inputs.scene.system.engine.report_streams;  // each stream has one
  int most = settings::limits::engine_lanes.most / group;
  if (inputs.options.set) {
    const auto lanes = static_cast<std::uint64_t>(group);
    const std::uint64_t for_items = (inputs.options.set->items + lanes - 1) / lanes;
    most = std::max(least, static_cast<int>(std::min<std::uint64_t>(most, for_items)));
  }
  if (!inputs.rates.reported_share()) return most;
  // A lane compares at most one pair per cycle, so that an engine of fewer lanes than `wanted`
  // needs no simulation.
  const auto pairs = [&](int groups, double wanted) {
    return groups * group < wanted ? 0 : *most_pairs_per_cycle(plan, inputs, groups * group);
  };
  std::vector<int> tried;  // up to a factor of two from any number
  for (int groups = least; groups < most; groups *= 2) tried.push_back(groups);
  tried.push_back(most);
  double best = 0;
  for (auto groups = tried.rbegin(); groups != tried.rend(); ++groups) {
    best = std::max(best, pairs(*groups, best));
  }
  const double wanted = enough * best;
  const auto first = std::find_if(tried.begin(), tried.end(),
                                  [&](int groups) { return pairs(groups, wanted) >= wanted; });
  MIXCMP_CHECK(first != tried.end());
  int too_few = first == tried.begin() ? least - 1 : *(first - 1);
  int many = *first;
  while (many - too_few > 1) {
    const int middle = (too_few + many) / 2;
    (pairs(middle, wanted) >= wanted ? many : too_few) = middle;
  }
  return many;
}

void count_idle_cycles(PrecisionPlan& plan, const PlanningInputs& inputs) {
  const Rates& rates = inputs.rates;
  plan.counts_idle_lanes = inputs.options.set.has_value();
  if (const Allocation* chosen = plan.allocation()) {
    performance::PairwiseEngine engine = engine_of(plan, inputs.scene.system, *chosen);
    plan.busy = busy_share(engine, rates, plan.counts_idle_lanes).value_or(1);
    engine.undecided = 0;
    plan.fills_streams = chosen->lane_count() == plan.problem.max_lanes &&
                         busy_share(engine, rates, false).value_or(1) < enough;
  }
  if (plan.bound_per_s == 0) return;
  double least_interval_s = std::numeric_limits<double>::infinity();
  for (const LaneKind& kind : plan.problem.lanes) {
    least_interval_s = std::min(least_interval_s, 1 / throughput_per_s(kind));
  }
  const int lanes = std::min(plan.problem.max_lanes,
                             static_cast<int>(std::ceil(plan.bound_per_s * least_interval_s)));
  const auto pairs = lanes > 0 ? most_pairs_per_cycle(plan, inputs, lanes) : std::nullopt;
  constexpr double margin = 1.02;  // fewer lanes may be that much faster
  if (pairs) plan.bound_per_s = std::min(plan.bound_per_s, margin * *pairs / least_interval_s);
}

}  // namespace mixcmp::optimise
