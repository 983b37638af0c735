#pragma once

#include <vector>

#include "model/optimise/allocation.hpp"
#include "model/optimise/feasibility.hpp"
#include "model/optimise/integer_program.hpp"

/// Equations 10 to 12 as integer programs. The clock of the system is fixed in each: kinds that do
/// not reach it are out, all others run at it, so that every throughput is a constant. With several
/// clock domains (`clock_per_s` = 0) each kind has its own.
namespace mixcmp::model {

/// A program whose first columns are p_L of each kind of lane, then p_H of each kind of reference.
struct AllocationProgram {
  IntegerProgram program;
  /// What `is_better` has least of, in its order: lanes, each bounded resource, kinds listed late.
  /// Only where p_H is fixed.
  std::vector<IntegerProgram::Sum> costs;
  double objective_per_s = 1;  ///< comparisons a second that a unit of the objective stands for

  Counts counts(const AllocationProblem& problem, const std::vector<int>& columns) const;
};

/// For any p_H of 1 or more. A relaxation: every plan is in it with its own throughput; of the
/// crossbar it knows lower bounds of the cost, of equation 10 the total, and that p_L of a kind is
/// at most p_H times what one reference serves.
AllocationProgram relaxed_program(const AllocationProblem& problem, double clock_per_s);

/// Exact for this p_H, 0 or more: the crossbar's cost as n references that serve k + 1 lanes and
/// p_H - n that serve k, equation 10 at each reference where they are dealt.
AllocationProgram exact_program(const AllocationProblem& problem, double clock_per_s,
                                int references);

}  // namespace mixcmp::model
