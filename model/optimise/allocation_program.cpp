#include "model/optimise/allocation_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/optimise/tangents.hpp"
#include "model/performance/performance.hpp"

namespace mixcmp::model {
namespace {

using Sum = IntegerProgram::Sum;
using Relation = IntegerProgram::Relation;

/// A lane that asks for less of a reference counts as 0: CBC's tolerances are not far below. The
/// point is checked afterwards.
constexpr double least_load = 1e-9;
/// The fastest lane's part in the objective: differences of 1e-8 of it are still above CBC's
/// tolerance.
constexpr double objective_scale = 1000;

class ProgramBuilder {
public:
  ProgramBuilder(const AllocationProblem& problem, double clock_per_s)
      : problem_(problem), clock_(clock_per_s) {
    for (const ReferenceKind& kind : problem.references) {
      if (in_reach(kind.throughput_per_s)) {
        capacity_ = std::max(capacity_, throughput(kind.throughput_per_s));
      }
    }
  }

  AllocationProgram relaxed() {
    add_kinds(1, problem_.max_references);
    add_objective();
    add_total_load();
    add_lanes_per_reference();
    for (std::size_t r = 0; r < std::size(bounded_resources); ++r) add_relaxed_resource(r);
    return std::move(result_);
  }

  AllocationProgram exact(int references) {
    references_ = references;
    add_kinds(references, references);
    add_objective();
    add_total_load();
    if (references > 0) add_lanes_per_reference();
    for (const Resource& resource : bounded_resources)
      used_.push_back(used_by_kinds(resource.amount));
    if (references > 0 && !problem_.communication.crossbar.empty()) add_crossbar();
    const Amounts room = room_beside_fixed();
    for (std::size_t r = 0; r < used_.size(); ++r) {
      program().add_row(bounded_resources[r].name, used_[r], Relation::at_most,
                        static_cast<double>(room[r]));
    }
    add_costs();
    if (references > 1 && problem_.sharing == ReferenceSharing::dealt) add_dealt_loads();
    return std::move(result_);
  }

private:
  IntegerProgram& program() { return result_.program; }
  int lane_kinds() const { return static_cast<int>(problem_.lanes.size()); }
  int reference_kinds() const { return static_cast<int>(problem_.references.size()); }
  int lane_column(int kind) const { return kind; }
  int reference_column(int kind) const { return lane_kinds() + kind; }

  bool in_reach(double throughput_per_s) const { return throughput_per_s >= clock_; }
  double throughput(double own_per_s) const { return clock_ > 0 ? clock_ : own_per_s; }

  /// Of the fastest reference: T(L) R_R / T(H).
  double load(int kind) const {
    const LaneKind& lane = problem_.lanes[kind];
    const double part = throughput(lane.throughput_per_s) * lane.recomputation_rate / capacity_;
    return part < least_load ? 0 : part;
  }
  /// Of the fastest reference: T(H).
  double capacity(int kind) const {
    return throughput(problem_.references[kind].throughput_per_s) / capacity_;
  }

  Sum all_lanes() const {
    Sum sum;
    for (int k = 0; k < lane_kinds(); ++k) sum.push_back({lane_column(k), 1});
    return sum;
  }
  Sum all_references(double coefficient) const {
    Sum sum;
    for (int k = 0; k < reference_kinds(); ++k) sum.push_back({reference_column(k), coefficient});
    return sum;
  }

  /// Lanes of a kind that one reference, the fastest, can serve.
  int lanes_served(int kind) const {
    const LaneKind& lane = problem_.lanes[kind];
    const double asked = throughput(lane.throughput_per_s) * lane.recomputation_rate;
    int served = 0;
    while (served < problem_.max_lanes && is_within((served + 1) * asked, capacity_)) ++served;
    return served;
  }

  void add_kinds(int least_references, int most_references) {
    const bool none = most_references == 0;
    for (int k = 0; k < lane_kinds(); ++k) {
      const LaneKind& lane = problem_.lanes[k];
      const bool usable =
          in_reach(lane.throughput_per_s) && (!none || lane.recomputation_rate == 0);
      program().comments.push_back(fmt::format("lanes_{}: {}", k, lane.name));
      program().add_column(fmt::format("lanes_{}", k), 0, usable ? problem_.max_lanes : 0);
    }
    for (int k = 0; k < reference_kinds(); ++k) {
      const ReferenceKind& reference = problem_.references[k];
      const bool usable = in_reach(reference.throughput_per_s);
      program().comments.push_back(fmt::format("references_{}: {}", k, reference.name));
      program().add_column(fmt::format("references_{}", k), 0, usable ? most_references : 0);
    }
    program().add_row("some_lane", all_lanes(), Relation::at_least, 1);
    program().add_row("most_lanes", all_lanes(), Relation::at_most, problem_.max_lanes);
    program().add_row("least_references", all_references(1), Relation::at_least, least_references);
    program().add_row("most_references", all_references(1), Relation::at_most, most_references);
  }

  void add_objective() {
    if (clock_ > 0) {
      result_.objective_per_s = clock_;
      program().objective = all_lanes();
      return;
    }
    double fastest = 0;
    for (const LaneKind& kind : problem_.lanes) fastest = std::max(fastest, kind.throughput_per_s);
    result_.objective_per_s = fastest / objective_scale;
    for (int k = 0; k < lane_kinds(); ++k) {
      program().objective.push_back(
          {lane_column(k), problem_.lanes[k].throughput_per_s / result_.objective_per_s});
    }
  }

  void add_total_load() {
    if (capacity_ == 0) return;
    Sum sum;
    for (int k = 0; k < lane_kinds(); ++k) sum.push_back({lane_column(k), load(k)});
    for (int k = 0; k < reference_kinds(); ++k) sum.push_back({reference_column(k), -capacity(k)});
    program().add_row("equation_10", std::move(sum), Relation::at_most, 0);
  }

  /// With ports or with capacity for k lanes, a reference serves at most k.
  void add_lanes_per_reference() {
    const std::vector<Area>& crossbar = problem_.communication.crossbar;
    if (!crossbar.empty()) {
      Sum sum = all_references(1.0 - static_cast<double>(crossbar.size()));
      for (const auto& term : all_lanes()) sum.push_back(term);
      program().add_row("ports", std::move(sum), Relation::at_most, 0);
    }
    if (problem_.sharing == ReferenceSharing::pooled) return;
    for (int k = 0; k < lane_kinds(); ++k) {
      const int served = lanes_served(k);
      if (served == problem_.max_lanes) continue;
      Sum sum = all_references(-served);
      sum.push_back({lane_column(k), 1});
      program().add_row(fmt::format("served_{}", k), std::move(sum), Relation::at_most, 0);
    }
  }

  Amounts room_beside_fixed() const {
    Amounts room = amounts_of(usable(problem_.available, problem_.slack));
    const Amounts fixed = amounts_of(problem_.communication.fixed);
    for (std::size_t r = 0; r < room.size(); ++r) room[r] -= fixed[r];
    return room;
  }

  Sum used_by_kinds(int Area::*amount) const {
    Sum sum;
    for (int k = 0; k < lane_kinds(); ++k) {
      sum.push_back({lane_column(k), static_cast<double>(problem_.lanes[k].area.*amount)});
    }
    for (int k = 0; k < reference_kinds(); ++k) {
      sum.push_back(
          {reference_column(k), static_cast<double>(problem_.references[k].area.*amount)});
    }
    return sum;
  }

  /// Equation 11 with lines below the crossbar's cost in its place.
  void add_relaxed_resource(std::size_t r) {
    const auto amount = bounded_resources[r].amount;
    std::vector<double> cost;
    for (const Area& share : problem_.communication.crossbar) cost.push_back(share.*amount);
    const double room = static_cast<double>(room_beside_fixed()[r]);
    const Sum kinds = used_by_kinds(amount);
    int number = 0;
    for (const Line& line : lines_below(cost)) {
      Sum sum;
      for (const auto& [column, coefficient] : kinds) {
        const bool lane = column < lane_kinds();
        sum.push_back({column, coefficient + (lane ? line.slope : line.offset)});
      }
      program().add_row(fmt::format("{}_{}", bounded_resources[r].name, number++), std::move(sum),
                        Relation::at_most, room);
    }
  }

  void add_costs() {
    result_.costs.push_back(all_lanes());
    for (const Sum& sum : used_) {
      if (!sum.empty()) result_.costs.push_back(sum);
    }
    Sum late;
    for (int k = 0; k < lane_kinds(); ++k) late.push_back({lane_column(k), double(k)});
    for (int k = 0; k < reference_kinds(); ++k) late.push_back({reference_column(k), double(k)});
    result_.costs.push_back(std::move(late));
  }

  /// base_k = 1: references serve k lanes, and more_k of them one more.
  void add_crossbar() {
    const std::vector<Area>& shares = problem_.communication.crossbar;
    const int most = std::min(static_cast<int>(shares.size()) - 1,
                              (problem_.max_lanes + references_ - 1) / references_);
    Sum chosen;
    Sum lanes = all_lanes();
    for (int k = 0; k <= most; ++k) {
      const int base = program().add_column(fmt::format("base_{}", k), 0, 1);
      chosen.push_back({base, 1});
      lanes.push_back({base, -static_cast<double>(k) * references_});
      add_used(base, references_, shares[k], Area{});
      if (k == most || references_ == 1) continue;
      const int more = program().add_column(fmt::format("more_{}", k), 0, references_ - 1);
      lanes.push_back({more, -1});
      add_used(more, 1, shares[k + 1], shares[k]);
      program().add_row(fmt::format("more_of_{}", k),
                        {{more, 1}, {base, -static_cast<double>(references_ - 1)}},
                        Relation::at_most, 0);
    }
    program().add_row("one_base", std::move(chosen), Relation::equal, 1);
    program().add_row("lanes_served", std::move(lanes), Relation::equal, 0);
  }

  void add_used(int column, int count, const Area& share, const Area& instead_of) {
    for (std::size_t r = 0; r < used_.size(); ++r) {
      const auto amount = bounded_resources[r].amount;
      const double rise = static_cast<double>(share.*amount) - instead_of.*amount;
      used_[r].push_back({column, count * rise});
    }
  }

  /// How many of the first `kinds` kinds, dealt to the references one by one, reach reference r:
  /// whole + part_r, where the parts are 1 up to some reference and 0 from there on.
  struct Dealt {
    int whole;
    std::vector<int> parts;  ///< of all references but the last

    void add_to(Sum& sum, int reference, double coefficient) const {
      sum.push_back({whole, coefficient});
      if (reference < static_cast<int>(parts.size())) {
        sum.push_back({parts[reference], coefficient});
      }
    }
  };

  std::vector<int> add_falling(const std::string& name) {
    std::vector<int> columns;
    for (int r = 0; r + 1 < references_; ++r) {
      columns.push_back(program().add_column(fmt::format("{}_{}", name, r), 0, 1));
      if (r == 0) continue;
      program().add_row(fmt::format("{}_falls_{}", name, r),
                        {{columns[r], 1}, {columns[r - 1], -1}}, Relation::at_most, 0);
    }
    return columns;
  }

  Dealt add_dealt(int kinds) {
    const int whole = program().add_column(fmt::format("whole_{}", kinds), 0, problem_.max_lanes);
    Dealt dealt{whole, add_falling(fmt::format("part_{}", kinds))};
    Sum sum{{whole, -static_cast<double>(references_)}};
    for (const int part : dealt.parts) sum.push_back({part, -1});
    for (int k = 0; k < kinds; ++k) sum.push_back({lane_column(k), 1});
    program().add_row(fmt::format("dealt_{}", kinds), std::move(sum), Relation::equal, 0);
    return dealt;
  }

  /// Equation 10 at each reference.
  void add_dealt_loads() {
    std::vector<Sum> loads(static_cast<std::size_t>(references_));
    for (int k = 0; k < lane_kinds(); ++k) {
      // Lanes of kind k are the first k + 1 kinds' less the first k kinds'.
      const Dealt dealt = add_dealt(k + 1);
      const double before = k + 1 < lane_kinds() ? load(k + 1) : 0;
      for (int r = 0; r < references_; ++r) dealt.add_to(loads[r], r, load(k) - before);
    }
    add_capacities(loads);
    for (int r = 0; r < references_; ++r) {
      const double bound = references_alike() ? 1 : 0;
      program().add_row(fmt::format("equation_10_{}", r), std::move(loads[r]), Relation::at_most,
                        bound);
    }
  }

  /// At one clock all references are equally fast.
  bool references_alike() const { return clock_ > 0 || reference_kinds() == 1; }

  /// Reference r is of the first k kinds where first_k_r is 1.
  void add_capacities(std::vector<Sum>& loads) {
    if (references_alike()) return;
    for (int k = 0; k < reference_kinds(); ++k) {
      std::vector<int> first;
      Sum counted;
      for (int r = 0; r < references_; ++r) {
        first.push_back(program().add_column(fmt::format("first_{}_{}", k, r), 0, 1));
        counted.push_back({first[r], -1});
        if (r > 0) {
          program().add_row(fmt::format("first_{}_falls_{}", k, r),
                            {{first[r], 1}, {first[r - 1], -1}}, Relation::at_most, 0);
        }
        const double after = k + 1 < reference_kinds() ? capacity(k + 1) : 0;
        loads[r].push_back({first[r], after - capacity(k)});
      }
      for (int j = 0; j <= k; ++j) counted.push_back({reference_column(j), 1});
      program().add_row(fmt::format("first_{}", k), std::move(counted), Relation::equal, 0);
    }
  }

  const AllocationProblem& problem_;
  double clock_;
  double capacity_ = 0;  ///< T(H) of the fastest reference in reach; 0: there is none
  int references_ = 0;
  std::vector<Sum> used_;  ///< of each bounded resource, less what is fixed
  AllocationProgram result_;
};

}  // namespace

Counts AllocationProgram::counts(const AllocationProblem& problem,
                                 const std::vector<int>& columns) const {
  const auto lanes_end = columns.begin() + static_cast<std::ptrdiff_t>(problem.lanes.size());
  return {{columns.begin(), lanes_end},
          {lanes_end, lanes_end + static_cast<std::ptrdiff_t>(problem.references.size())}};
}

AllocationProgram relaxed_program(const AllocationProblem& problem, double clock_per_s) {
  return ProgramBuilder(problem, clock_per_s).relaxed();
}

AllocationProgram exact_program(const AllocationProblem& problem, double clock_per_s,
                                int references) {
  return ProgramBuilder(problem, clock_per_s).exact(references);
}

}  // namespace mixcmp::model
