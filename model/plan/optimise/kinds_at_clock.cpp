#include "model/plan/optimise/kinds_at_clock.hpp"

#include <algorithm>

#include "model/cost/performance/performance.hpp"
#include "model/plan/optimise/feasibility.hpp"

namespace mixcmp::optimise {
namespace {

/// A smaller load counts as 0, since CBC's tolerances are not far below. Plans are checked with the
/// true load.
constexpr double least_load = 1e-9;

bool takes_no_more(const devices::Area& a, const devices::Area& b) {
  const Amounts of_a = amounts_of(a);
  const Amounts of_b = amounts_of(b);
  return std::equal(of_a.begin(), of_a.end(), of_b.begin(), std::less_equal<>());
}

/// Marks dominated kinds as not useful. `replaces(a, b)` says that a can replace b in any plan. If
/// kinds replace each other, the first one stays useful.
template <class Kind, class Replaces>
void drop_replaceable(std::vector<Kind>& kinds, Replaces replaces) {
  for (std::size_t b = 0; b < kinds.size(); ++b) {
    for (std::size_t a = 0; a < kinds.size() && kinds[b].useful; ++a) {
      if (a == b || !kinds[a].useful || !replaces(a, b)) continue;
      kinds[b].useful = a > b && replaces(b, a);
    }
  }
}

}  // namespace

KindsAtClock::KindsAtClock(const AllocationProblem& problem, double clock_per_s)
    : problem_(problem) {
  const double system_hz = clock_per_s > 0 ? clock_per_s : any_clock;
  for (const LaneKind& lane : problem.lanes) {
    const double throughput = optimise::throughput_per_s(lane, system_hz);
    lanes_.push_back(
        {throughput, throughput * lane.recomputation_rate, lane.clock_hz >= clock_per_s});
  }
  for (const ReferenceKind& reference : problem.references) {
    const bool in_reach = reference.clock_hz >= clock_per_s;
    references_.push_back({optimise::throughput_per_s(reference, system_hz), 0, in_reach});
    if (in_reach) fastest_per_s_ = std::max(fastest_per_s_, references_.back().throughput_per_s);
  }
  drop_replaceable(lanes_, [&](std::size_t a, std::size_t b) {
    return lanes_[a].throughput_per_s >= lanes_[b].throughput_per_s &&
           lanes_[a].asked_per_s <= lanes_[b].asked_per_s &&
           asked_per_cycle(problem.lanes[a]) <= asked_per_cycle(problem.lanes[b]) &&
           problem.lanes[a].group == problem.lanes[b].group &&
           takes_no_more(problem.lanes[a].area, problem.lanes[b].area);
  });
  drop_replaceable(references_, [&](std::size_t a, std::size_t b) {
    return references_[a].throughput_per_s >= references_[b].throughput_per_s &&
           takes_no_more(problem.references[a].area, problem.references[b].area);
  });
  lane_order_ = useful_by_falling(&Kind::asked_per_s, lanes_);
  reference_order_ = useful_by_falling(&Kind::throughput_per_s, references_);
}

std::vector<int> KindsAtClock::useful_by_falling(double Kind::*value,
                                                 const std::vector<Kind>& kinds) {
  std::vector<double> values;
  for (const Kind& kind : kinds) values.push_back(kind.*value);
  std::vector<int> order = falling_order(values);
  std::erase_if(order, [&](int kind) { return !kinds[kind].useful; });
  return order;
}

std::optional<double> KindsAtClock::common_throughput_per_s() const {
  std::optional<double> common;
  for (const Kind& kind : lanes_) {
    if (!kind.useful) continue;
    if (common && *common != kind.throughput_per_s) return std::nullopt;
    common = kind.throughput_per_s;
  }
  return common;
}

double KindsAtClock::load(int kind) const {
  const double part = lanes_[kind].asked_per_s / fastest_per_s_;
  return part < least_load ? 0 : part;
}

double KindsAtClock::capacity(int kind) const {
  return references_[kind].throughput_per_s / fastest_per_s_;
}

int KindsAtClock::groups_served(int kind) const {
  const int lanes = problem_.lanes[kind].group;
  const double asked = lanes * lanes_[kind].asked_per_s;
  int served = 0;
  while (served < problem_.max_lanes / lanes &&
         performance::is_within((served + 1) * asked, fastest_per_s_))
    ++served;
  return served;
}

bool KindsAtClock::references_alike() const {
  return std::all_of(references_.begin(), references_.end(), [&](const Kind& kind) {
    return !kind.useful || kind.throughput_per_s == fastest_per_s_;
  });
}

}  // namespace mixcmp::optimise
