#include "model/plan/optimise/feasibility.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "model/cost/performance/performance.hpp"

namespace mixcmp::optimise {
namespace {

int total(const std::vector<int>& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0);
}

/// The lowest clock of the kinds that are used; any_clock if each kind has its own clock.
double clock_limit(const AllocationProblem& problem, const Counts& counts) {
  double limit = any_clock;
  if (problem.clocks == ClockDomains::separate) return limit;
  for (std::size_t k = 0; k < counts.lanes.size(); ++k) {
    if (counts.lanes[k] > 0) limit = std::min(limit, problem.lanes[k].clock_hz);
  }
  for (std::size_t k = 0; k < counts.references.size(); ++k) {
    if (counts.references[k] > 0) limit = std::min(limit, problem.references[k].clock_hz);
  }
  return limit;
}

/// A clock that every kind reaches, for a system with one clock. The order of throughputs is the
/// same at each such clock.
double common_clock(const AllocationProblem& problem) {
  double clock = any_clock;
  if (problem.clocks == ClockDomains::separate) return clock;
  for (const LaneKind& kind : problem.lanes) clock = std::min(clock, kind.clock_hz);
  for (const ReferenceKind& kind : problem.references) clock = std::min(clock, kind.clock_hz);
  return clock;
}

/// The groups of lanes of a plan, in the order in which they are dealt to references.
std::vector<performance::Datapaths> lanes_of(const AllocationProblem& problem, const Counts& counts,
                                             double limit) {
  std::vector<performance::Datapaths> lanes;
  for (const int k : lane_order(problem)) {
    const LaneKind& kind = problem.lanes[k];
    lanes.push_back({counts.lanes[k] / kind.group, kind.group * throughput_per_s(kind, limit),
                     kind.recomputation_rate});
  }
  return lanes;
}

std::vector<performance::Datapaths> references_of(const AllocationProblem& problem,
                                                  const Counts& counts, double limit) {
  std::vector<performance::Datapaths> references;
  for (const int k : reference_order(problem)) {
    references.push_back({counts.references[k], throughput_per_s(problem.references[k], limit), 0});
  }
  return references;
}

/// Equation 12. If all lanes have one clock and one interval, two mixes of the same number of lanes
/// have the same throughput to the last bit.
double total_throughput(const AllocationProblem& problem, const Counts& counts, double limit) {
  if (problem.clocks == ClockDomains::separate) {
    return performance::aggregated_throughput(lanes_of(problem, counts, limit));
  }
  std::map<double, int> lanes_of_interval;  // all of an interval are equally fast
  for (std::size_t k = 0; k < counts.lanes.size(); ++k) {
    lanes_of_interval[problem.lanes[k].initiation_interval] += counts.lanes[k];
  }
  double comparisons_per_cycle = 0;
  for (const auto& [interval, lanes] : lanes_of_interval) comparisons_per_cycle += lanes / interval;
  return comparisons_per_cycle * limit;
}

bool keeps_equation_10(const AllocationProblem& problem,
                       const std::vector<performance::Datapaths>& lanes,
                       const std::vector<performance::Datapaths>& references) {
  switch (problem.sharing) {
    case ReferenceSharing::round_robin:
      return performance::each_reference_suffices(lanes, references);
    case ReferenceSharing::pooled: return performance::references_suffice(lanes, references);
  }
  return false;
}

bool starts_all_recomputations(const AllocationProblem& problem, const Counts& counts) {
  double asked = 0;
  for (std::size_t k = 0; k < counts.lanes.size(); ++k) {
    asked += counts.lanes[k] * asked_per_cycle(problem.lanes[k]);
  }
  return performance::is_within(asked, problem.recomputations_per_cycle);
}

/// The number of crossbar ports for lanes.
int port_count(const AllocationProblem& problem, const Counts& counts) {
  return total(counts.lanes) / lanes_per_port(problem);
}

bool fits(const AllocationProblem& problem, const Amounts& demand) {
  const Amounts room = amounts_of(performance::usable(problem.available, problem.slack));
  return std::equal(demand.begin(), demand.end(), room.begin(), std::less_equal<>());
}

devices::Area area_used(const AllocationProblem& problem, const Counts& counts) {
  devices::Area used = problem.communication.fixed;
  for (std::size_t k = 0; k < counts.lanes.size(); ++k) {
    used += area_of(problem.lanes[k], counts.lanes[k]);
  }
  for (std::size_t k = 0; k < counts.references.size(); ++k) {
    used += counts.references[k] * problem.references[k].area;
  }
  if (problem.communication.crossbar.empty()) return used;
  for (const int served :
       performance::lanes_of_references(port_count(problem, counts), total(counts.references))) {
    used += problem.communication.crossbar[served];
  }
  return used;
}

}  // namespace

std::vector<int> falling_order(const std::vector<double>& values) {
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return values[a] > values[b]; });
  return order;
}

std::vector<int> lane_order(const AllocationProblem& problem) {
  const double clock = common_clock(problem);
  std::vector<double> asked;
  for (const LaneKind& kind : problem.lanes) {
    asked.push_back(throughput_per_s(kind, clock) * kind.recomputation_rate);
  }
  return falling_order(asked);
}

std::vector<int> reference_order(const AllocationProblem& problem) {
  const double clock = common_clock(problem);
  std::vector<double> served;
  for (const ReferenceKind& kind : problem.references) {
    served.push_back(throughput_per_s(kind, clock));
  }
  return falling_order(served);
}

Amounts amounts_of(const devices::Area& area) {
  Amounts amounts{};
  for (std::size_t r = 0; r < amounts.size(); ++r)
    amounts[r] = area.*devices::bounded_resources[r].amount;
  return amounts;
}

void add(Amounts& sum, int count, const devices::Area& area) {
  const Amounts one = amounts_of(area);
  for (std::size_t r = 0; r < sum.size(); ++r) sum[r] += count * one[r];
}

std::optional<Amounts> demand_of(const AllocationProblem& problem, const Counts& counts) {
  Amounts demand = amounts_of(problem.communication.fixed);
  for (std::size_t k = 0; k < counts.lanes.size(); ++k) {
    add(demand, counts.lanes[k] / problem.lanes[k].group, problem.lanes[k].area);
  }
  for (std::size_t k = 0; k < counts.references.size(); ++k) {
    add(demand, counts.references[k], problem.references[k].area);
  }
  const std::vector<devices::Area>& crossbar = problem.communication.crossbar;
  if (crossbar.empty()) return demand;
  for (const int served :
       performance::lanes_of_references(port_count(problem, counts), total(counts.references))) {
    if (served >= static_cast<int>(crossbar.size())) return std::nullopt;
    add(demand, 1, crossbar[served]);
  }
  return demand;
}

std::optional<Allocation> plan_of(const AllocationProblem& problem, const Counts& counts) {
  const int lane_count = total(counts.lanes);
  if (lane_count < problem.min_lanes || lane_count > problem.max_lanes) return std::nullopt;
  if (total(counts.references) > problem.max_references) return std::nullopt;
  const std::optional<Amounts> demand = demand_of(problem, counts);
  if (!demand || !fits(problem, *demand)) return std::nullopt;
  if (!starts_all_recomputations(problem, counts)) return std::nullopt;
  const double limit = clock_limit(problem, counts);
  const std::vector<performance::Datapaths> lanes = lanes_of(problem, counts, limit);
  if (!keeps_equation_10(problem, lanes, references_of(problem, counts, limit))) {
    return std::nullopt;
  }
  return Allocation{.lanes = counts.lanes,
                    .references = counts.references,
                    .throughput_per_s = total_throughput(problem, counts, limit),
                    .used = area_used(problem, counts)};
}

bool is_better(const Allocation& a, const Allocation& b) {
  if (a.throughput_per_s != b.throughput_per_s) return a.throughput_per_s > b.throughput_per_s;
  const auto cost = [](const Allocation& plan) {
    return std::tuple(plan.reference_count(), plan.lane_count(), amounts_of(plan.used));
  };
  if (cost(a) != cost(b)) return cost(a) < cost(b);
  return std::tie(a.lanes, a.references) > std::tie(b.lanes, b.references);
}

}  // namespace mixcmp::optimise
