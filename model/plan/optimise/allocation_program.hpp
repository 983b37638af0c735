#pragma once

#include <optional>
#include <vector>

#include "model/plan/optimise/allocation.hpp"
#include "model/plan/optimise/feasibility.hpp"
#include "model/plan/optimise/integer_program.hpp"

/// Equations 10 to 12 as integer programs. Each program has a fixed clock of the system: kinds that
/// do not reach it are excluded, all others run at it. So every throughput is a constant.
namespace mixcmp::optimise {

/// Quantities that a program takes as constants. A count that is not set stays a variable.
struct FixedCounts {
  double clock_per_s = 0;  ///< 0: each kind has its own
  std::optional<int> references;
  std::optional<int> lanes;
};

/// A program whose first columns are p_L of each kind of lane, then p_H of each kind of reference.
struct AllocationProgram {
  IntegerProgram program;
  /// Sums for minimising, one after the other, among plans with the same throughput, references and
  /// lanes. Their order is that of `is_better`: each bounded resource, then a sum that prefers
  /// kinds listed first.
  std::vector<IntegerProgram::Sum> costs;
  double objective_per_s = 1;  ///< comparisons per second in one unit of the objective

  Counts counts(const AllocationProblem& problem, const std::vector<int>& columns) const;
};

/// A relaxation. Linear lower bounds replace the crossbar's cost and, unless p_H is fixed, equation
/// 10 holds only in total. It contains every plan that has a reference, with the plan's throughput.
AllocationProgram relaxed_program(const AllocationProblem& problem, const FixedCounts& fixed);

/// The exact program; `fixed` must set p_H. In the crossbar's cost, n references serve k + 1 groups
/// of lanes each, and p_H - n references serve k. With ReferenceSharing::round_robin, equation 10
/// holds at each reference.
AllocationProgram exact_program(const AllocationProblem& problem, const FixedCounts& fixed);

}  // namespace mixcmp::optimise
