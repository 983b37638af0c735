#pragma once

#include "model/plan/optimise/allocation.hpp"

namespace mixcmp::optimise {

/// Whether the fixed part of C(com) fits the usable area by itself.
bool fixed_fits(const AllocationProblem& problem);

/// Explains why no plan is feasible, by the smallest systems: one lane of one kind with the
/// references that it needs. Reports each resource for which even the smallest demand of all these
/// systems is too large. If there is none, reports the shortages of the system that comes closest
/// to fitting.
Infeasible explain_infeasible(const AllocationProblem& problem);

}  // namespace mixcmp::optimise
