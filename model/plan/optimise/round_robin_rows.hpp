#pragma once

#include "model/plan/optimise/integer_program.hpp"
#include "model/plan/optimise/kinds_at_clock.hpp"

namespace mixcmp::optimise {

/// Adds equation 10 for each of `references` references. The columns p_L of the kinds of lanes
/// start at 0, the columns p_H of the kinds of references at `first_reference`.
///
/// Lanes are dealt round robin in the order of falling load, so reference r gets ceil((n - r) /
/// p_H) of the first n lanes. Let kinds have loads w_1 >= w_2 >= ... (0 after the last), and let
/// c_k be the number of lanes of the first k kinds that reference r gets. Its load is then the sum
/// of (w_k - w_k+1) c_k. No coefficient is negative, so the row c_k >= (n - r) / p_H suffices: c_k
/// is an integer, and the smallest one is the rounded-up quotient.
///
/// With groups of `lanes_per_group` lanes, all this holds for groups instead of lanes: the columns,
/// the c_k and `max_groups` count groups.
void add_round_robin_rows(IntegerProgram& program, const KindsAtClock& kinds, int references,
                          int first_reference, int max_groups, int lanes_per_group);

}  // namespace mixcmp::optimise
