#include "model/plan/optimise/allocation_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/cost/performance/performance.hpp"
#include "model/plan/optimise/kinds_at_clock.hpp"
#include "model/plan/optimise/round_robin_rows.hpp"
#include "model/plan/optimise/tangents.hpp"

namespace mixcmp::optimise {
namespace {

using Sum = IntegerProgram::Sum;
using Relation = IntegerProgram::Relation;

/// The fastest lane's coefficient in the objective. With it a relative difference of 1e-8 is still
/// above CBC's tolerance.
constexpr double objective_scale = 1000;

class ProgramBuilder {
public:
  ProgramBuilder(const AllocationProblem& problem, const FixedCounts& fixed)
      : problem_(problem), fixed_(fixed), kinds_(problem, fixed.clock_per_s) {
    for (const devices::Resource& resource : devices::bounded_resources) {
      used_.push_back(used_by_kinds(resource.amount));
    }
    room_ = amounts_of(performance::usable(problem.available, problem.slack));
    const Amounts taken = amounts_of(problem.communication.fixed);
    for (std::size_t r = 0; r < room_.size(); ++r) room_[r] -= taken[r];
  }

  AllocationProgram relaxed() {
    add_kinds(fixed_.references.value_or(1), fixed_.references.value_or(problem_.max_references));
    add_equation_10();
    add_objective();
    for (std::size_t r = 0; r < used_.size(); ++r) add_relaxed_resource(r);
    return std::move(result_);
  }

  AllocationProgram exact() {
    add_kinds(*fixed_.references, *fixed_.references);
    add_equation_10();
    add_objective();
    if (fixed_.references > 0 && !problem_.communication.crossbar.empty()) {
      fixed_.lanes ? subtract_crossbar() : add_crossbar();
    }
    for (std::size_t r = 0; r < used_.size(); ++r) {
      program().add_row(devices::bounded_resources[r].name, used_[r], Relation::at_most,
                        static_cast<double>(room_[r]));
    }
    add_costs();
    return std::move(result_);
  }

private:
  IntegerProgram& program() { return result_.program; }
  int lane_kinds() const { return static_cast<int>(problem_.lanes.size()); }
  int reference_kinds() const { return static_cast<int>(problem_.references.size()); }
  int lane_column(int kind) const { return kind; }
  int reference_column(int kind) const { return lane_kinds() + kind; }

  Sum all_lanes() const {
    Sum sum;
    for (int k = 0; k < lane_kinds(); ++k) sum.push_back(of_group(k, 1));
    return sum;
  }
  /// The number of crossbar ports for lanes.
  Sum all_ports() const {
    Sum sum;
    for (int k = 0; k < lane_kinds(); ++k)
      sum.push_back({lane_column(k), static_cast<double>(ports_of_group(k))});
    return sum;
  }
  int ports_of_group(int kind) const {
    return problem_.lanes[kind].group / lanes_per_port(problem_);
  }
  int max_ports() const { return problem_.max_lanes / lanes_per_port(problem_); }
  /// The term of a kind if each of its lanes counts `one`. A column of lanes counts whole groups.
  IntegerProgram::Term of_group(int kind, double one) const {
    return {lane_column(kind), problem_.lanes[kind].group * one};
  }
  Sum all_references(double coefficient) const {
    Sum sum;
    for (int k = 0; k < reference_kinds(); ++k) sum.push_back({reference_column(k), coefficient});
    return sum;
  }

  void add_kinds(int least_references, int most_references) {
    for (int k = 0; k < lane_kinds(); ++k) {
      const LaneKind& lane = problem_.lanes[k];
      const bool usable =
          kinds_.has_lane(k) && (most_references > 0 || lane.recomputation_rate == 0);
      program().comments.push_back(fmt::format("lanes_{}: {}", k, lane.name));
      program().add_column(fmt::format("lanes_{}", k), 0,
                           usable ? problem_.max_lanes / lane.group : 0);
    }
    for (int k = 0; k < reference_kinds(); ++k) {
      program().comments.push_back(
          fmt::format("references_{}: {}", k, problem_.references[k].name));
      program().add_column(fmt::format("references_{}", k), 0,
                           kinds_.has_reference(k) ? most_references : 0);
    }
    program().add_row("least_lanes", all_lanes(), Relation::at_least,
                      fixed_.lanes.value_or(problem_.min_lanes));
    program().add_row("most_lanes", all_lanes(), Relation::at_most,
                      fixed_.lanes.value_or(problem_.max_lanes));
    program().add_row("least_references", all_references(1), Relation::at_least, least_references);
    program().add_row("most_references", all_references(1), Relation::at_most, most_references);
  }

  void add_objective() {
    if (const std::optional<double> alike = kinds_.common_throughput_per_s()) {
      result_.objective_per_s = *alike;
      program().objective = all_lanes();
      return;
    }
    double fastest = 0;
    for (const LaneKind& kind : problem_.lanes) {
      fastest = std::max(fastest, throughput_per_s(kind));
    }
    result_.objective_per_s = fastest / objective_scale;
    for (int k = 0; k < lane_kinds(); ++k) {
      program().objective.push_back(
          of_group(k, kinds_.lane_throughput_per_s(k) / result_.objective_per_s));
    }
  }

  void add_equation_10() {
    add_recomputations_per_cycle();
    add_total_load();
    if (fixed_.references == 0) return;
    add_lanes_per_reference();
    const bool round_robin = problem_.sharing == ReferenceSharing::round_robin;
    if (round_robin && fixed_.references.value_or(1) > 1) {
      add_round_robin_rows(program(), kinds_, *fixed_.references, lane_kinds(), max_ports(),
                           lanes_per_port(problem_));
    }
  }

  void add_recomputations_per_cycle() {
    const double most = problem_.recomputations_per_cycle;
    if (most == std::numeric_limits<double>::infinity()) return;
    Sum sum;
    for (int k = 0; k < lane_kinds(); ++k) {
      sum.push_back(of_group(k, asked_per_cycle(problem_.lanes[k]) / most));
    }
    program().add_row("recomputations_per_cycle", std::move(sum), Relation::at_most, 1);
  }

  void add_total_load() {
    if (!kinds_.some_reference()) return;
    Sum sum;
    for (int k = 0; k < lane_kinds(); ++k) sum.push_back(of_group(k, kinds_.load(k)));
    for (int k = 0; k < reference_kinds(); ++k)
      sum.push_back({reference_column(k), -kinds_.capacity(k)});
    program().add_row("equation_10", std::move(sum), Relation::at_most, 0);
  }

  /// Lets a reference serve at most as many groups of lanes as its ports and its capacity allow.
  void add_lanes_per_reference() {
    const std::vector<devices::Area>& crossbar = problem_.communication.crossbar;
    if (!crossbar.empty()) {
      Sum sum = all_references(1.0 - static_cast<double>(crossbar.size()));
      for (const auto& term : all_ports()) sum.push_back(term);
      program().add_row("ports", std::move(sum), Relation::at_most, 0);
    }
    if (problem_.sharing == ReferenceSharing::pooled) return;
    for (int k = 0; k < lane_kinds(); ++k) {
      const int served = kinds_.groups_served(k);
      if (served == max_ports()) continue;
      Sum sum = all_references(-served);
      sum.push_back({lane_column(k), 1});
      program().add_row(fmt::format("served_{}", k), std::move(sum), Relation::at_most, 0);
    }
  }

  Sum used_by_kinds(int devices::Area::*amount) const {
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

  /// Adds equation 11, relaxed: linear lower bounds replace the crossbar's cost.
  void add_relaxed_resource(std::size_t r) {
    const auto amount = devices::bounded_resources[r].amount;
    std::vector<double> cost;
    for (const devices::Area& share : problem_.communication.crossbar)
      cost.push_back(share.*amount);
    int number = 0;
    for (const Tangent& tangent : lower_tangents(cost)) {
      Sum sum;
      for (const auto& [column, coefficient] : used_[r]) {
        const bool lane = column < lane_kinds();
        const double more = lane ? ports_of_group(column) * tangent.slope : tangent.offset;
        sum.push_back({column, coefficient + more});
      }
      program().add_row(fmt::format("{}_{}", devices::bounded_resources[r].name, number++),
                        std::move(sum), Relation::at_most, static_cast<double>(room_[r]));
    }
  }

  void add_costs() {
    for (const Sum& sum : used_) {
      if (!sum.empty()) result_.costs.push_back(sum);
    }
    Sum late;
    for (int k = 0; k < lane_kinds(); ++k) late.push_back({lane_column(k), double(k)});
    for (int k = 0; k < reference_kinds(); ++k) late.push_back({reference_column(k), double(k)});
    result_.costs.push_back(std::move(late));
  }

  void subtract_crossbar() {
    const int ports = *fixed_.lanes / lanes_per_port(problem_);
    for (const int served : performance::lanes_of_references(ports, *fixed_.references)) {
      // The row "ports" makes such a program infeasible anyway.
      if (served >= static_cast<int>(problem_.communication.crossbar.size())) return;
      const Amounts share = amounts_of(problem_.communication.crossbar[served]);
      for (std::size_t r = 0; r < room_.size(); ++r) room_[r] -= share[r];
    }
  }

  /// Adds columns for the groups of lanes that a reference serves. If base_k is 1, every reference
  /// serves k groups, and more_k of the references serve one more.
  void add_crossbar() {
    const std::vector<devices::Area>& shares = problem_.communication.crossbar;
    const int references = *fixed_.references;
    const int most =
        std::min(static_cast<int>(shares.size()) - 1, (max_ports() + references - 1) / references);
    Sum chosen;
    Sum ports = all_ports();
    for (int k = 0; k <= most; ++k) {
      const int base = program().add_column(fmt::format("base_{}", k), 0, 1);
      chosen.push_back({base, 1});
      ports.push_back({base, -static_cast<double>(k) * references});
      add_used(base, references, shares[k], devices::Area{});
      if (k == most || references == 1) continue;
      const int more = program().add_column(fmt::format("more_{}", k), 0, references - 1);
      ports.push_back({more, -1});
      add_used(more, 1, shares[k + 1], shares[k]);
      program().add_row(fmt::format("more_of_{}", k),
                        {{more, 1}, {base, -static_cast<double>(references - 1)}},
                        Relation::at_most, 0);
    }
    program().add_row("one_base", std::move(chosen), Relation::equal, 1);
    program().add_row("lanes_served", std::move(ports), Relation::equal, 0);
  }

  void add_used(int column, int count, const devices::Area& share,
                const devices::Area& instead_of) {
    for (std::size_t r = 0; r < used_.size(); ++r) {
      const auto amount = devices::bounded_resources[r].amount;
      const double rise = static_cast<double>(share.*amount) - instead_of.*amount;
      used_[r].push_back({column, count * rise});
    }
  }

  const AllocationProblem& problem_;
  FixedCounts fixed_;
  KindsAtClock kinds_;
  std::vector<Sum> used_;  ///< left side of equation 11 for each bounded resource
  Amounts room_{};         ///< its right side: usable amounts less fixed ones
  AllocationProgram result_;
};

}  // namespace

Counts AllocationProgram::counts(const AllocationProblem& problem,
                                 const std::vector<int>& columns) const {
  const auto lanes_end = columns.begin() + static_cast<std::ptrdiff_t>(problem.lanes.size());
  std::vector<int> lanes;
  for (const LaneKind& kind : problem.lanes) lanes.push_back(kind.group * columns[lanes.size()]);
  return {std::move(lanes),
          {lanes_end, lanes_end + static_cast<std::ptrdiff_t>(problem.references.size())}};
}

AllocationProgram relaxed_program(const AllocationProblem& problem, const FixedCounts& fixed) {
  return ProgramBuilder(problem, fixed).relaxed();
}

AllocationProgram exact_program(const AllocationProblem& problem, const FixedCounts& fixed) {
  return ProgramBuilder(problem, fixed).exact();
}

}  // namespace mixcmp::optimise
