#include "model/plan/optimise/plan_at_rates.hpp"

#include <algorithm>
#include <vector>

#include "model/base/common/check.hpp"
#include "model/cost/performance/pairwise.hpp"
#include "model/cost/performance/performance.hpp"
#include "model/cost/performance/streams.hpp"
#include "model/plan/optimise/pairwise_busy.hpp"
#include "model/plan/optimise/problems.hpp"
#include "model/plan/optimise/second_tier.hpp"

namespace mixcmp::optimise {
namespace {

using performance::Datapaths;
using scene::EngineKind;

/// The lanes and references of a plan at some rates.
struct Loaded {
  std::vector<Datapaths> groups;      ///< of lanes, in the order in which references serve them
  std::vector<Datapaths> references;  ///< in the order in which they serve
  double lanes_hz = any_clock;        ///< the lowest clock of the lanes
  double comparisons = 0;             ///< per second, if nothing waits
  double first_undecided = 0;         ///< those of them that the lanes leave undecided

  double undecided_rate() const { return first_undecided / comparisons; }
};

/// The lowest clock of the kinds that are used.
template <class Kinds>
double lowest_hz(const Kinds& kinds, const std::vector<int>& counts) {
  double lowest = any_clock;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts[k] > 0) lowest = std::min(lowest, kinds[k].clock_hz);
  }
  return lowest;
}

/// The clock of the system; any_clock if each kind has its own.
double clock_of(const AllocationProblem& problem, const Allocation& chosen) {
  if (problem.clocks == ClockDomains::separate) return any_clock;
  return std::min(lowest_hz(problem.lanes, chosen.lanes),
                  lowest_hz(problem.references, chosen.references));
}

/// Adds the lanes of one kind. `first`: the rate of the lanes; `again`: the rate at which they need
/// a reference.
void add_lanes(Loaded& loaded, const scene::Scene& scene, LaneKind kind, int lanes, double first,
               double again) {
  const bool has_engine = scene.system.engine.kind != EngineKind::none;
  const double asked = scene.system.lanes_per_group * (has_engine ? again : first);
  const double most_words = std::min(
      1.0, performance::highest_lane_throughput(asked, scene.system.request_beats.value_or(1)));
  kind.initiation_interval = std::max(cycles_per_word(scene, first), 1 / most_words);
  const double of_group = kind.group * throughput_per_s(kind);
  const int groups = lanes / kind.group;
  loaded.groups.push_back({groups, of_group, again});
  loaded.comparisons += groups * of_group;
  loaded.first_undecided += groups * of_group * first;
}

std::optional<Loaded> load_of(const PrecisionPlan& plan, const scene::Scene& scene,
                              const Rates& rates) {
  const Allocation& chosen = *plan.allocation();
  const double clock = clock_of(plan.problem, chosen);
  Loaded loaded{.groups = {},
                .references = {},
                .lanes_hz = std::min(clock, lowest_hz(plan.problem.lanes, chosen.lanes))};
  std::optional<Rate> behind_tier;
  if (scene.second_tier) {
    const auto tier = second_tier_lane(scene);
    MIXCMP_CHECK(tier.ok() && *tier);
    behind_tier = rates.find(rate_key(**tier));
    if (!behind_tier) return std::nullopt;
  }
  for (const int k : lane_order(plan.problem)) {
    if (chosen.lanes[k] == 0) continue;
    std::optional<Rate> first = rates.find(rate_key(plan.lanes[k].lane()));
    if (!first) return std::nullopt;
    first->is_exact = plan.lanes[k].rate.is_exact;
    LaneKind kind = plan.problem.lanes[k];
    kind.clock_hz = std::min(kind.clock_hz, clock);
    add_lanes(loaded, scene, std::move(kind), chosen.lanes[k], first->value(),
              behind_tier.value_or(*first).value());
  }
  for (const int k : reference_order(plan.problem)) {
    const ReferenceKind& kind = plan.problem.references[k];
    if (chosen.references[k] == 0) continue;
    loaded.references.push_back({chosen.references[k], throughput_per_s(kind, clock), 0});
  }
  return loaded;
}

/// The part of the lanes' throughput that a resource allows which starts `capacity` of the `asked`
/// recomputations per second.
double allowed(double asked, double capacity) {
  return performance::is_within(asked, capacity) ? 1 : capacity / asked;
}

/// The part that a second tier allows. Behind streams its lanes share the load.
double allowed_by_tier(const PrecisionPlan& plan, const scene::Scene& scene, const Loaded& loaded) {
  if (plan.second_lanes) {
    return allowed(loaded.first_undecided,
                   plan.second_lanes->count * most_undecided_per_cycle * loaded.lanes_hz);
  }
  if (!scene.second_tier) return 1;
  return allowed(loaded.undecided_rate() * scene.system.engine.lanes_per_group,
                 most_undecided_per_cycle);
}

/// The part that the reference with the highest load allows.
double allowed_by_slowest(const Loaded& loaded) {
  std::vector<double> capacities;
  for (const Datapaths& kind : loaded.references) {
    capacities.insert(capacities.end(), kind.count, kind.throughput_per_s);
  }
  const std::vector<double> asked =
      performance::recomputations_of_references(loaded.groups, static_cast<int>(capacities.size()));
  double part = 1;
  for (std::size_t r = 0; r < capacities.size(); ++r) {
    part = std::min(part, allowed(asked[r], capacities[r]));
  }
  return part;
}

/// The part of their cycles in which the lanes of a plan's pairwise engine compare.
double busy_at(const PrecisionPlan& plan, const scene::Scene& scene, const Loaded& loaded,
               const Rates& rates) {
  performance::PairwiseEngine engine = engine_of(plan, scene.system, *plan.allocation());
  engine.undecided = 0;
  for (const Datapaths& kind : loaded.groups) {
    engine.undecided = std::max(engine.undecided, kind.recomputation_rate);
  }
  return busy_share(engine, rates, plan.counts_idle_lanes).value_or(plan.busy);
}

double throughput_of(const PrecisionPlan& plan, const scene::Scene& scene, const Loaded& loaded) {
  const double asked = performance::recomputations_per_s(loaded.groups);
  double part = allowed(asked, plan.problem.recomputations_per_cycle * loaded.lanes_hz);
  part = std::min(part, allowed_by_tier(plan, scene, loaded));
  const bool is_chain = scene.system.engine.kind == EngineKind::arg_min;
  if (is_chain && asked > 0) part = std::min(part, allowed_by_slowest(loaded));
  if (is_chain) return part * loaded.comparisons;
  const bool is_pooled = plan.problem.sharing == ReferenceSharing::pooled || plan.second_lanes;
  const double served = is_pooled
                            ? performance::equivalent_throughput(loaded.groups, loaded.references)
                            : performance::round_robin_throughput(loaded.groups, loaded.references);
  return std::min(served, part * loaded.comparisons);
}

}  // namespace

std::optional<PlanAtRates> at_rates(const PrecisionPlan& plan, const scene::Scene& scene,
                                    const Rates& rates) {
  MIXCMP_CHECK(plan.allocation() != nullptr);
  const std::optional<Loaded> loaded = load_of(plan, scene, rates);
  if (!loaded) return std::nullopt;
  const double again = performance::recomputations_per_s(loaded->groups) / loaded->comparisons;
  const bool is_pairwise = scene.system.engine.kind == EngineKind::pairwise;
  double throughput = throughput_of(plan, scene, *loaded);
  if (is_pairwise) {
    const double busy = busy_at(plan, scene, *loaded, rates);
    throughput = std::min(throughput, busy * loaded->comparisons);
  }
  return PlanAtRates{.throughput_per_s = throughput,
                     .counted_rate = is_pairwise ? again : loaded->undecided_rate()};
}

}  // namespace mixcmp::optimise
