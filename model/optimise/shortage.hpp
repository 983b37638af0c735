#pragma once

#include "model/optimise/allocation.hpp"

namespace mixcmp::model {

/// Whether C(com) alone leaves room.
bool fixed_fits(const AllocationProblem& problem);

/// Why a problem without a plan has none, from its smallest systems: one lane of each kind with
/// the reference it needs.
Infeasible explain_infeasible(const AllocationProblem& problem);

}  // namespace mixcmp::model
