#pragma once

#include "model/optimise/integer_program.hpp"
#include "model/optimise/kinds_at_clock.hpp"

namespace mixcmp::model {

/// Equation 10 at each of `references` references. The columns p_L of each kind of lane start at 0,
/// those p_H of each kind of reference at `first_reference`. Lanes are dealt in the order of
/// falling load: reference r gets (n - r) / p_H, rounded up, of the first n. Where loads are w_1 >=
/// w_2 >= ..., and c_k counts the lanes of the first k kinds that it gets, it is asked for the sum
/// of (w_k - w_k+1) c_k: no term of it is negative, so that "c_k is at least (n - r) / p_H" rounds
/// up by itself.
void add_dealt_rows(IntegerProgram& program, const KindsAtClock& kinds, int references,
                    int first_reference, int max_lanes);

}  // namespace mixcmp::model
