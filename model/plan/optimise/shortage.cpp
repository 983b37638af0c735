#include "model/plan/optimise/shortage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "model/cost/performance/performance.hpp"
#include "model/plan/optimise/feasibility.hpp"

namespace mixcmp::optimise {
namespace {

/// The fewest lanes of a kind that a system may have.
int fewest(const LaneKind& lane, const AllocationProblem& problem) {
  return std::max(lane.group, problem.min_lanes);
}

/// Whether `count` references of a capacity serve `lanes` lanes that ask `asked` times each.
bool serve(int count, double capacity, int lanes, double asked, const AllocationProblem& problem) {
  const int group = lanes_per_port(problem);
  const int most = performance::lanes_of_references(lanes / group, count).front();
  const std::size_t ports = problem.communication.crossbar.size();
  if (ports > 0 && static_cast<std::size_t>(most) >= ports) return false;
  return problem.sharing == ReferenceSharing::pooled
             ? performance::is_within(lanes * asked, count * capacity)
             : performance::is_within(most * group * asked, capacity);
}

/// The number of references that the fewest lanes need. If they recompute nothing, it is 0, without
/// a kind of reference. None if no number suffices.
std::optional<int> references_needed(const LaneKind& lane, const ReferenceKind* reference,
                                     const AllocationProblem& problem) {
  if (lane.recomputation_rate == 0) return reference == nullptr ? std::optional(0) : std::nullopt;
  if (reference == nullptr) return std::nullopt;
  const int lanes = fewest(lane, problem);
  const double started = problem.recomputations_per_cycle;
  if (!performance::is_within(lanes * asked_per_cycle(lane), started)) return std::nullopt;
  const bool one_clock = problem.clocks == ClockDomains::single;
  const double clock = one_clock ? std::min(lane.clock_hz, reference->clock_hz) : any_clock;
  const double asked = throughput_per_s(lane, clock) * lane.recomputation_rate;
  const double capacity = throughput_per_s(*reference, clock);
  // More references than lanes help only if they are pooled.
  const int most = problem.sharing == ReferenceSharing::pooled
                       ? problem.max_references
                       : std::min(lanes / lanes_per_port(problem), problem.max_references);
  for (int count = 1; count <= most; ++count) {
    if (serve(count, capacity, lanes, asked, problem)) return count;
  }
  return std::nullopt;
}

Counts smallest_system(const AllocationProblem& problem, std::size_t lane,
                       const ReferenceKind* reference, int references) {
  Counts counts{std::vector<int>(problem.lanes.size(), 0),
                std::vector<int>(problem.references.size(), 0)};
  counts.lanes[lane] = fewest(problem.lanes[lane], problem);
  if (reference != nullptr) counts.references[reference - problem.references.data()] = references;
  return counts;
}

/// The demands of the smallest systems that satisfy equation 10.
std::vector<Amounts> smallest_demands(const AllocationProblem& problem) {
  std::vector<const ReferenceKind*> references{nullptr};
  for (const ReferenceKind& reference : problem.references) references.push_back(&reference);
  std::vector<Amounts> demands;
  for (std::size_t lane = 0; lane < problem.lanes.size(); ++lane) {
    for (const ReferenceKind* reference : references) {
      const auto needed = references_needed(problem.lanes[lane], reference, problem);
      if (!needed) continue;
      const auto demand = demand_of(problem, smallest_system(problem, lane, reference, *needed));
      if (demand) demands.push_back(*demand);
    }
  }
  return demands;
}

std::vector<Infeasible::Shortage> shortages_of(const Amounts& demand, const Amounts& room) {
  std::vector<Infeasible::Shortage> shortages;
  for (std::size_t r = 0; r < demand.size(); ++r) {
    if (demand[r] <= room[r]) continue;
    const auto needed = std::min<std::int64_t>(demand[r], std::numeric_limits<int>::max());
    shortages.push_back(
        {devices::bounded_resources[r].name, static_cast<int>(room[r]), static_cast<int>(needed)});
  }
  return shortages;
}

/// The least demand for each resource over all these systems.
Amounts least_of_each(const std::vector<Amounts>& demands) {
  Amounts least = demands.front();
  for (const Amounts& demand : demands) {
    for (std::size_t r = 0; r < least.size(); ++r) least[r] = std::min(least[r], demand[r]);
  }
  return least;
}

/// The largest ratio of demand to room over all resources.
double worst_ratio(const Amounts& demand, const Amounts& room) {
  double worst = 0;
  for (std::size_t r = 0; r < demand.size(); ++r) {
    if (demand[r] == 0) continue;
    worst = std::max(worst, static_cast<double>(demand[r]) / static_cast<double>(room[r]));
  }
  return worst;
}

std::string sentence(const std::vector<Infeasible::Shortage>& shortages) {
  std::vector<std::string> parts;
  for (const auto& [resource, room, needed] : shortages) {
    parts.push_back(fmt::format("{}: {} needed, {} usable, {} short", resource, needed, room,
                                static_cast<std::int64_t>(needed) - room));
  }
  return fmt::format("the smallest system does not fit ({})", fmt::join(parts, "; "));
}

Infeasible short_of(const std::vector<Infeasible::Shortage>& shortages) {
  return {shortages, sentence(shortages)};
}

}  // namespace

bool fixed_fits(const AllocationProblem& problem) {
  const Amounts room = amounts_of(performance::usable(problem.available, problem.slack));
  return shortages_of(amounts_of(problem.communication.fixed), room).empty();
}

Infeasible explain_infeasible(const AllocationProblem& problem) {
  const Amounts room = amounts_of(performance::usable(problem.available, problem.slack));
  if (problem.lanes.empty() || problem.max_lanes < 1) return {{}, "there is no lane to build"};
  const std::vector<Amounts> demands = smallest_demands(problem);
  if (demands.empty()) {
    return {{},
            problem.references.empty() || problem.max_references < 1
                ? "every lane needs a reference, and there is none to build"
            : problem.min_lanes > 1
                ? fmt::format("no number of references serves {} lanes", problem.min_lanes)
                : "no reference is fast enough for a single lane, or none has a port for it"};
  }
  const auto always = shortages_of(least_of_each(demands), room);
  if (!always.empty()) return short_of(always);
  const Amounts& closest =
      *std::min_element(demands.begin(), demands.end(), [&](const Amounts& a, const Amounts& b) {
        return worst_ratio(a, room) < worst_ratio(b, room);
      });
  return short_of(shortages_of(closest, room));
}

}  // namespace mixcmp::optimise
