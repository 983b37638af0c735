#include "model/cost/performance/performance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/base/common/check.hpp"

namespace mixcmp::performance {
namespace {

constexpr double rounding_allowance = 1e-12;

int total_count(const std::vector<Datapaths>& kinds) {
  int count = 0;
  for (const Datapaths& kind : kinds) count += kind.count;
  return count;
}

double rate_of(const Datapaths& lane) {
  return lane.throughput_per_s * lane.recomputation_rate;
}

/// The throughput of each datapath, one entry per datapath, in the order of the kinds.
std::vector<double> capacities_of(const std::vector<Datapaths>& references) {
  std::vector<double> capacities;
  for (const Datapaths& kind : references) {
    capacities.insert(capacities.end(), static_cast<std::size_t>(kind.count),
                      kind.throughput_per_s);
  }
  return capacities;
}

/// The kinds of the lanes at each reference, one entry per lane.
std::vector<std::vector<Datapaths>> assign_round_robin(const std::vector<Datapaths>& lanes,
                                                       int references) {
  std::vector<std::vector<Datapaths>> lanes_of_reference(static_cast<std::size_t>(references));
  std::size_t lane = 0;
  for (const Datapaths& kind : lanes) {
    for (int k = 0; k < kind.count; ++k)
      lanes_of_reference[lane++ % lanes_of_reference.size()].push_back(kind);
  }
  return lanes_of_reference;
}

/// The total throughput of lanes that take turns at one reference.
double shared_throughput(std::vector<Datapaths> lanes, double capacity) {
  std::sort(lanes.begin(), lanes.end(),
            [](const Datapaths& a, const Datapaths& b) { return rate_of(a) < rate_of(b); });
  double throughput = 0;
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    const double turn = capacity / static_cast<double>(lanes.size() - k);
    const double asked = rate_of(lanes[k]);
    const double granted = std::min(asked, turn);
    throughput +=
        granted < asked ? granted / lanes[k].recomputation_rate : lanes[k].throughput_per_s;
    capacity -= granted;
  }
  return throughput;
}

}  // namespace

double aggregated_throughput(const std::vector<Datapaths>& kinds) {
  double sum = 0;
  for (const Datapaths& kind : kinds) sum += kind.count * kind.throughput_per_s;
  return sum;
}

double recomputations_per_s(const std::vector<Datapaths>& lanes) {
  double sum = 0;
  for (const Datapaths& kind : lanes) sum += kind.count * rate_of(kind);
  return sum;
}

double equivalent_throughput(const std::vector<Datapaths>& lanes,
                             const std::vector<Datapaths>& references) {
  const double reduced = aggregated_throughput(lanes);
  const double recomputed = recomputations_per_s(lanes);
  const double capacity = aggregated_throughput(references);
  return recomputed <= capacity ? reduced : reduced * (capacity / recomputed);
}

double optimal_ratio(double lane_throughput_per_s, double reference_throughput_per_s,
                     double recomputation_rate) {
  MIXCMP_CHECK(lane_throughput_per_s > 0);
  if (recomputation_rate == 0) return std::numeric_limits<double>::infinity();
  return reference_throughput_per_s / (lane_throughput_per_s * recomputation_rate);
}

bool is_within(double demand, double capacity) {
  return demand <= capacity * (1 + rounding_allowance);
}

bool references_suffice(const std::vector<Datapaths>& lanes,
                        const std::vector<Datapaths>& references) {
  return is_within(recomputations_per_s(lanes), aggregated_throughput(references));
}

devices::Area usable(const devices::Area& available, double slack) {
  MIXCMP_CHECK(slack >= 0 && slack <= 1);
  // 1 - R_S is rounded: without the allowance 10 (1 - 0.9) would be 0.
  const auto part = [&](int amount) {
    return static_cast<int>(std::floor(amount * (1 - slack) * (1 + rounding_allowance)));
  };
  return {.luts = part(available.luts),
          .registers = part(available.registers),
          .dsps = part(available.dsps),
          .memories = part(available.memories),
          .carries = part(available.carries),
          .shift_luts = part(available.shift_luts)};
}

std::vector<int> lanes_of_references(int lanes, int references) {
  std::vector<int> served;
  for (int r = 0; r < references; ++r) served.push_back((lanes - r + references - 1) / references);
  return served;
}

std::vector<double> recomputations_of_references(const std::vector<Datapaths>& lanes,
                                                 int references) {
  std::vector<double> loads(static_cast<std::size_t>(references), 0.0);
  int before = 0;
  for (const Datapaths& kind : lanes) {
    const std::vector<int> without = lanes_of_references(before, references);
    before += kind.count;
    const std::vector<int> with = lanes_of_references(before, references);
    for (std::size_t r = 0; r < loads.size(); ++r)
      loads[r] += (with[r] - without[r]) * rate_of(kind);
  }
  return loads;
}

bool each_reference_suffices(const std::vector<Datapaths>& lanes,
                             const std::vector<Datapaths>& references) {
  const std::vector<double> capacities = capacities_of(references);
  if (capacities.empty()) return recomputations_per_s(lanes) == 0;
  const std::vector<double> loads =
      recomputations_of_references(lanes, static_cast<int>(capacities.size()));
  for (std::size_t r = 0; r < loads.size(); ++r) {
    if (!is_within(loads[r], capacities[r])) return false;
  }
  return true;
}

double round_robin_throughput(const std::vector<Datapaths>& lanes,
                              const std::vector<Datapaths>& references) {
  const std::vector<double> capacities = capacities_of(references);
  if (capacities.empty())
    return recomputations_per_s(lanes) == 0 ? aggregated_throughput(lanes) : 0;
  const auto lanes_of_reference = assign_round_robin(lanes, total_count(references));
  double throughput = 0;
  for (std::size_t r = 0; r < lanes_of_reference.size(); ++r) {
    throughput += shared_throughput(lanes_of_reference[r], capacities[r]);
  }
  return throughput;
}

}  // namespace mixcmp::performance
