#include "model/plan/optimise/round_robin_rows.hpp"

#include <fmt/format.h>

namespace mixcmp::optimise {
namespace {

using Sum = IntegerProgram::Sum;
using Relation = IntegerProgram::Relation;

/// Adds to loads[r] the load that the lanes cause at reference r.
void add_loads(IntegerProgram& program, const KindsAtClock& kinds, int references, int max_groups,
               int lanes_per_group, std::vector<Sum>& loads) {
  Sum first_lanes;
  const std::vector<int>& order = kinds.lane_order();
  for (std::size_t k = 0; k < order.size(); ++k) {
    first_lanes.push_back({order[k], 1});
    const double next = k + 1 < order.size() ? kinds.load(order[k + 1]) : 0;
    const double fall = lanes_per_group * (kinds.load(order[k]) - next);
    if (fall == 0) continue;
    for (std::size_t r = 0; r < loads.size(); ++r) {
      const int count = program.add_column(fmt::format("count_{}_{}", k, r), 0, max_groups);
      Sum row = first_lanes;
      row.push_back({count, -static_cast<double>(references)});
      program.add_row(fmt::format("dealt_{}_{}", k, r), std::move(row), Relation::at_most,
                      static_cast<double>(r));
      loads[r].push_back({count, fall});
    }
  }
}

/// Subtracts from loads[r] the capacity T(H) of reference r. References are numbered by falling
/// T(H). Column first_k_r is 1 if reference r has one of the kinds 0 to k in that order.
void subtract_capacities(IntegerProgram& program, const KindsAtClock& kinds, int first_reference,
                         std::vector<Sum>& loads) {
  Sum first_references;
  const std::vector<int>& order = kinds.reference_order();
  for (std::size_t k = 0; k < order.size(); ++k) {
    first_references.push_back({first_reference + order[k], 1});
    const double next = k + 1 < order.size() ? kinds.capacity(order[k + 1]) : 0;
    Sum counted = first_references;
    int before = -1;
    for (std::size_t r = 0; r < loads.size(); ++r) {
      const int first = program.add_column(fmt::format("first_{}_{}", k, r), 0, 1);
      counted.push_back({first, -1});
      if (r > 0) {
        program.add_row(fmt::format("first_{}_falls_{}", k, r), {{first, 1}, {before, -1}},
                        Relation::at_most, 0);
      }
      loads[r].push_back({first, next - kinds.capacity(order[k])});
      before = first;
    }
    program.add_row(fmt::format("first_{}", k), std::move(counted), Relation::equal, 0);
  }
}

}  // namespace

void add_round_robin_rows(IntegerProgram& program, const KindsAtClock& kinds, int references,
                          int first_reference, int max_groups, int lanes_per_group) {
  // If references are alike, the first has the greatest load, and its row implies the others.
  const bool alike = kinds.references_alike();
  std::vector<Sum> loads(alike ? 1 : static_cast<std::size_t>(references));
  add_loads(program, kinds, references, max_groups, lanes_per_group, loads);
  if (!alike) subtract_capacities(program, kinds, first_reference, loads);
  for (std::size_t r = 0; r < loads.size(); ++r) {
    program.add_row(fmt::format("equation_10_{}", r), std::move(loads[r]), Relation::at_most,
                    alike ? 1 : 0);
  }
}

}  // namespace mixcmp::optimise
