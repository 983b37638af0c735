#pragma once

#include <optional>
#include <vector>

#include "model/optimise/allocation.hpp"
#include "model/optimise/feasibility.hpp"
#include "model/optimise/integer_program.hpp"

/// Equations 10 to 12 as integer programs. The clock of the system is fixed in each: kinds that do
/// not reach it are out, all others run at it, so that every throughput is a constant.
namespace mixcmp::model {

/// What is not a variable.
struct FixedCounts {
  double clock_per_s = 0;  ///< 0: each kind has its own
  std::optional<int> references;
  std::optional<int> lanes;
};

/// A program whose first columns are p_L of each kind of lane, then p_H of each kind of reference.
struct AllocationProgram {
  IntegerProgram program;
  /// What `is_better` has least of beside references and lanes, in its order: each bounded
  /// resource, then kinds listed late.
  std::vector<IntegerProgram::Sum> costs;
  double objective_per_s = 1;  ///< comparisons a second that a unit of the objective stands for

  Counts counts(const AllocationProblem& problem, const std::vector<int>& columns) const;
};

/// A relaxation: linear lower bounds stand for the crossbar's cost and, unless p_H is fixed,
/// equation 10 holds in total only. It contains every plan that has a reference, with the plan's
/// throughput.
AllocationProgram relaxed_program(const AllocationProblem& problem, const FixedCounts& fixed);

/// p_H is fixed. The crossbar costs what n references that serve k + 1 lanes and p_H - n that serve
/// k do; equation 10 holds at each reference where they are dealt.
AllocationProgram exact_program(const AllocationProblem& problem, const FixedCounts& fixed);

}  // namespace mixcmp::model
