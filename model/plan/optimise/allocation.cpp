#include "model/plan/optimise/allocation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "model/base/common/check.hpp"
#include "model/cost/performance/performance.hpp"
#include "model/plan/optimise/allocation_program.hpp"
#include "model/plan/optimise/feasibility.hpp"
#include "model/plan/optimise/kinds_at_clock.hpp"
#include "model/plan/optimise/shortage.hpp"
#include "model/plan/optimise/unbeaten.hpp"

namespace mixcmp::optimise {
namespace {

using Relation = IntegerProgram::Relation;

template <class Kind>
bool is_possible(const Kind& kind) {
  return kind.clock_hz > 0 && std::isfinite(kind.clock_hz) && kind.initiation_interval >= 1;
}

void check(const AllocationProblem& problem) {
  for (const LaneKind& lane : problem.lanes) {
    MIXCMP_CHECK(is_possible(lane));
    MIXCMP_CHECK(problem.min_lanes == 1 || problem.min_lanes % lane.group == 0);
    MIXCMP_CHECK(lane.recomputation_rate >= 0 && lane.recomputation_rate <= 1);
    MIXCMP_CHECK(problem.sharing == ReferenceSharing::pooled ||
                 lane.group == problem.lanes.front().group);
  }
  for (const ReferenceKind& reference : problem.references) {
    MIXCMP_CHECK(is_possible(reference));
  }
}

/// Clocks that the system may run at, the highest first; only 0 if each kind has its own clock.
std::set<double, std::greater<>> candidate_clocks(const AllocationProblem& problem) {
  if (problem.clocks == ClockDomains::separate) return {0.0};
  std::set<double, std::greater<>> clocks;
  for (const LaneKind& lane : problem.lanes) clocks.insert(lane.clock_hz);
  for (const ReferenceKind& reference : problem.references) clocks.insert(reference.clock_hz);
  return clocks;
}

/// The clock of a plan: the lowest of the kinds it uses, bit for bit one of `candidate_clocks`; 0
/// if each kind has its own clock.
double clock_of(const AllocationProblem& problem, const Allocation& plan) {
  if (problem.clocks == ClockDomains::separate) return 0;
  double clock = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < plan.lanes.size(); ++k) {
    if (plan.lanes[k] > 0) clock = std::min(clock, problem.lanes[k].clock_hz);
  }
  for (std::size_t k = 0; k < plan.references.size(); ++k) {
    if (plan.references[k] > 0) clock = std::min(clock, problem.references[k].clock_hz);
  }
  return clock;
}

/// Adds a row that excludes plans of lower throughput.
void ask_for(AllocationProgram& wanted, double throughput_per_s) {
  if (throughput_per_s <= 0) return;
  wanted.program.add_row("at_least", wanted.program.objective, Relation::at_least,
                         throughput_per_s / wanted.objective_per_s);
}

/// Splits a program into parts that together have all of its points except `point`. Each of the
/// first columns gives a part with smaller and a part with larger values than the point's. In both,
/// the previous columns have the point's values.
std::vector<IntegerProgram> around(const IntegerProgram& program, const std::vector<int>& point,
                                   std::size_t columns) {
  std::vector<IntegerProgram> parts;
  IntegerProgram held = program;
  for (std::size_t k = 0; k < columns; ++k) {
    IntegerProgram::Column& column = held.columns[k];
    const IntegerProgram::Column all = column;
    if (all.lower < point[k]) {
      column.upper = point[k] - 1;
      parts.push_back(held);
    }
    if (point[k] < all.upper) {
      column = {all.name, point[k] + 1, all.upper};
      parts.push_back(held);
    }
    column = {all.name, point[k], point[k]};
  }
  return parts;
}

double value_of(const IntegerProgram::Sum& sum, const std::vector<int>& point) {
  double value = 0;
  for (const auto& [column, coefficient] : sum) value += coefficient * point[column];
  return value;
}

IntegerProgram::Sum negated(IntegerProgram::Sum sum) {
  for (IntegerProgram::Term& term : sum) term.coefficient = -term.coefficient;
  return sum;
}

/// The search for the best plan of one problem.
class Search {
public:
  explicit Search(const AllocationProblem& problem)
      : problem_(problem), best_per_s_(problem.at_least_per_s) {}

  /// Finds the highest throughput over all clocks, then the cheapest plan that reaches it.
  std::optional<Allocation> run() {
    for (const double clock : candidate_clocks(problem_)) try_clock(clock);
    const bool is_fastest = is_proven_;
    std::optional<Allocation> best;
    for (const auto& [clock, found] : best_) {
      const Allocation plan = cheapest(clock, found);
      if (!best || is_better(plan, *best)) best = plan;
    }
    if (best) best->is_proven = is_fastest;
    return best;
  }

  /// All programs so far were solved.
  bool is_proven() const { return is_proven_; }

private:
  struct Found {
    Allocation plan;
    double value;  ///< of the objective
  };

  std::optional<std::vector<int>> solved(const IntegerProgram& program) {
    Solution solution = solve(program, problem_.effort);
    is_proven_ = is_proven_ && solution.is_proven;
    return std::move(solution.point);
  }

  /// The throughput that a plan must have to be worth more than those found.
  double wanted_per_s() const {
    return best_.empty() ? best_per_s_ : (1 + problem_.effort.may_lose) * best_per_s_;
  }

  int most_references() const { return problem_.references.empty() ? 0 : problem_.max_references; }

  bool some_lane_needs_no_reference() const {
    return std::any_of(problem_.lanes.begin(), problem_.lanes.end(),
                       [](const LaneKind& lane) { return lane.recomputation_rate == 0; });
  }

  /// If the optimum of the relaxation is a feasible plan, no plan with references is better at this
  /// clock; otherwise each p_H is tried.
  void try_clock(double clock) {
    if (some_lane_needs_no_reference()) try_exactly({clock, 0, {}});
    if (most_references() == 0) return;
    if (!try_relaxed({clock, {}, {}})) return;
    for (int references = 1; references <= most_references(); ++references) {
      const FixedCounts fixed{clock, references, {}};
      if (const auto relaxed = try_relaxed(fixed)) try_below(fixed, *relaxed);
    }
  }

  /// Solves the relaxation for plans no worse than the best so far. If its optimum is a feasible
  /// plan, notes that plan and returns none; otherwise returns the optimum. Also returns none if
  /// the relaxation is infeasible.
  std::optional<Counts> try_relaxed(const FixedCounts& fixed) {
    AllocationProgram relaxed = relaxed_program(problem_, fixed);
    ask_for(relaxed, wanted_per_s());
    const auto point = solved(relaxed.program);
    if (!point) return std::nullopt;
    const Counts counts = relaxed.counts(problem_, *point);
    const auto plan = plan_of(problem_, counts);
    if (!plan) return counts;
    note(fixed.clock_per_s, *plan);
    return std::nullopt;
  }

  /// Finds the best plan for a fixed p_H. If all lanes are equally fast, throughput depends only on
  /// their number: it is tried from the relaxation's number downwards to the first with a plan.
  void try_below(FixedCounts fixed, const Counts& relaxed) {
    const auto alike = KindsAtClock(problem_, fixed.clock_per_s).common_throughput_per_s();
    if (!alike) {
      try_exactly(fixed);
      return;
    }
    fixed.lanes = std::accumulate(relaxed.lanes.begin(), relaxed.lanes.end(), 0);
    while (*fixed.lanes >= problem_.min_lanes &&
           performance::is_within(wanted_per_s(), *fixed.lanes * *alike)) {
      if (try_exactly(fixed)) return;
      --*fixed.lanes;
    }
  }

  bool try_exactly(const FixedCounts& fixed) {
    AllocationProgram wanted = exact_program(problem_, fixed);
    ask_for(wanted, wanted_per_s());
    const auto found = best_of(wanted, 0);
    if (found) note(fixed.clock_per_s, found->plan);
    return found.has_value();
  }

  void note(double clock, const Allocation& plan) {
    if (plan.throughput_per_s < best_per_s_) return;
    if (plan.throughput_per_s > best_per_s_) best_.clear();
    best_per_s_ = plan.throughput_per_s;
    const auto [place, added] = best_.emplace(clock, plan);
    if (!added && is_better(plan, place->second)) place->second = plan;
  }

  /// The best point that is a feasible plan without CBC's tolerances and has at least this
  /// throughput. If CBC's optimum is no such point, the program is split around it.
  std::optional<Found> best_of(const AllocationProgram& wanted, double least_per_s) {
    const std::size_t kinds = problem_.lanes.size() + problem_.references.size();
    std::vector<IntegerProgram> parts{wanted.program};
    std::optional<Found> best;
    while (!parts.empty()) {
      const IntegerProgram part = std::move(parts.back());
      parts.pop_back();
      const auto point = solved(part);
      if (!point) continue;
      const double value = value_of(part.objective, *point);
      if (best && value <= best->value) continue;
      const auto plan = plan_of(problem_, wanted.counts(problem_, *point));
      if (plan && performance::is_within(least_per_s, plan->throughput_per_s)) {
        best = Found{*plan, value};
        continue;
      }
      for (IntegerProgram& rest : around(part, *point, kinds)) parts.push_back(std::move(rest));
    }
    return best;
  }

  /// The best plan, by `is_better`, of those with the best throughput at this clock. If lanes are
  /// not equally fast, two mixes hardly ever have the same throughput. The lanes of `found` are
  /// then kept, and only its references are chosen anew.
  Allocation cheapest(double clock, const Allocation& found) {
    const auto alike = KindsAtClock(problem_, clock).common_throughput_per_s();
    const int lanes =
        alike ? static_cast<int>(std::lround(best_per_s_ / *alike)) : found.lane_count();
    for (int references = 0; references <= found.reference_count(); ++references) {
      AllocationProgram wanted = exact_program(problem_, {clock, references, lanes});
      for (std::size_t k = 0; !alike && k < found.lanes.size(); ++k) {
        const int groups = found.lanes[k] / problem_.lanes[k].group;
        wanted.program.columns[k].lower = wanted.program.columns[k].upper = groups;
      }
      if (const auto plan = cheapest(wanted)) return *plan;
    }
    return found;
  }

  std::optional<Allocation> cheapest(AllocationProgram wanted) {
    std::optional<Found> found;
    for (const IntegerProgram::Sum& cost : wanted.costs) {
      wanted.program.objective = negated(cost);
      found = best_of(wanted, best_per_s_);
      if (!found) return std::nullopt;
      wanted.program.add_row("cheapest", cost, Relation::at_most, -found->value);
    }
    return found->plan;
  }

  const AllocationProblem& problem_;
  double best_per_s_ = 0;
  bool is_proven_ = true;
  /// by clock, for clocks that reach best_per_s_
  std::map<double, Allocation, std::greater<>> best_;
};

}  // namespace

devices::Area area_of(const LaneKind& kind, int lanes) {
  return lanes / kind.group * kind.area;
}

double asked_per_cycle(const LaneKind& lane) {
  return lane.recomputation_rate / lane.initiation_interval;
}

int lanes_per_port(const AllocationProblem& problem) {
  const bool has_ports = problem.sharing == ReferenceSharing::round_robin;
  return has_ports && !problem.lanes.empty() ? problem.lanes.front().group : 1;
}

int Allocation::lane_count() const {
  return std::accumulate(lanes.begin(), lanes.end(), 0);
}

int Allocation::reference_count() const {
  return std::accumulate(references.begin(), references.end(), 0);
}

namespace {

/// Whether no resource has more in `a` than in `b`.
bool is_within(const devices::Area& a, const devices::Area& b) {
  return std::all_of(
      std::begin(devices::bounded_resources), std::end(devices::bounded_resources),
      [&](const devices::Resource& each) { return a.*each.amount <= b.*each.amount; });
}

double asked_per_s(const LaneKind& lane) {
  return lane.recomputation_rate * throughput_per_s(lane);
}

/// Whether a plan loses nothing where kind `a` takes the place of kind `b`. A lane whose own clock
/// is higher asks more often, which a reference may not bear.
bool is_as_good(const LaneKind& a, const LaneKind& b) {
  return a.group == b.group && a.clock_hz >= b.clock_hz &&
         a.initiation_interval <= b.initiation_interval &&
         asked_per_cycle(a) <= asked_per_cycle(b) && asked_per_s(a) <= asked_per_s(b) &&
         is_within(a.area, b.area);
}
bool is_as_good(const ReferenceKind& a, const ReferenceKind& b) {
  return a.clock_hz >= b.clock_hz && a.initiation_interval <= b.initiation_interval &&
         is_within(a.area, b.area);
}

/// The kinds that the best plan may have. One is left out if another is as good and smaller, or as
/// large and listed before it: then `allocate` prefers the other.
template <class Kind>
std::vector<int> useful_kinds(const std::vector<Kind>& kinds) {
  return unbeaten(static_cast<int>(kinds.size()), [&](int a, int b) {
    return is_as_good(kinds[a], kinds[b]) && (a < b || !is_within(kinds[b].area, kinds[a].area));
  });
}

template <class Kind>
std::vector<Kind> chosen(const std::vector<Kind>& kinds, const std::vector<int>& places) {
  std::vector<Kind> result;
  for (const int place : places) result.push_back(kinds[place]);
  return result;
}

/// Counts of all kinds from those of the chosen ones.
std::vector<int> spread(const std::vector<int>& counts, const std::vector<int>& places,
                        std::size_t kinds) {
  std::vector<int> all(kinds, 0);
  for (std::size_t k = 0; k < places.size(); ++k) all[places[k]] = counts[k];
  return all;
}

/// The best plan, by a search among the kinds that it may have.
AllocationResult best_allocation(const AllocationProblem& problem) {
  const std::vector<int> lanes = useful_kinds(problem.lanes);
  const std::vector<int> references = useful_kinds(problem.references);
  AllocationProblem smaller = problem;
  smaller.lanes = chosen(problem.lanes, lanes);
  smaller.references = chosen(problem.references, references);
  Search search(smaller);
  std::optional<Allocation> plan = search.run();
  if (plan) {
    plan->lanes = spread(plan->lanes, lanes, problem.lanes.size());
    plan->references = spread(plan->references, references, problem.references.size());
    return *std::move(plan);
  }
  if (!search.is_proven()) {
    return Infeasible{.shortages = {}, .message = "the search was cut short before it had a plan"};
  }
  if (problem.at_least_per_s == 0) return explain_infeasible(problem);
  return Infeasible{.shortages = {}, .message = "slower than a plan that is known"};
}

}  // namespace

AllocationResult allocate(const AllocationProblem& problem) {
  check(problem);
  if (problem.lanes.empty() || !fixed_fits(problem)) return explain_infeasible(problem);
  return best_allocation(problem);
}

std::string to_lp(const AllocationProblem& problem) {
  const AllocationResult result = allocate(problem);
  const auto* plan = std::get_if<Allocation>(&result);
  if (plan == nullptr) {
    const double lowest = *candidate_clocks(problem).rbegin();
    return to_lp(relaxed_program(problem, {lowest, {}, {}}).program);
  }
  return to_lp(
      exact_program(problem, {clock_of(problem, *plan), plan->reference_count(), {}}).program);
}

}  // namespace mixcmp::optimise
