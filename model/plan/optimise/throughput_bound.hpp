#pragma once

#include "model/plan/optimise/allocation.hpp"

namespace mixcmp::optimise {

/// Comparisons per second that no plan of this problem exceeds, found without an integer program.
///
/// A resource r gets a price w_r >= 0 for each unit. A plan pays at most w . (A - fixed), where A
/// is what R_S leaves. One comparison per second by lanes of kind k costs at least
///
///     w . (C(L_k) + port) / T(L_k) + R_R min_j w . C(H_j) / T(H_j),
///
/// since a lane makes at most T(L_k), references together serve all that lanes ask for (equation
/// 10), and each port of a crossbar takes at least the smallest share per port. So the plan makes
/// at most w . (A - fixed) divided by the least of these costs. If each lane may ask, a plan also
/// has a reference: w . (A - fixed) without the cheapest one, divided by the least cost of a lane,
/// is a second bound. Both hold for any prices; the result is the least of them on a grid of
/// prices and near its best point, and of the limits on lanes and references.
double throughput_bound(const AllocationProblem& problem);

}  // namespace mixcmp::optimise
