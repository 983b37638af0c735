#pragma once

#include <cstddef>
#include <vector>

/// Plan sets: a few plans that together serve data sets with different recomputation rates
/// (section V of the paper, "rates that change or are not known").
namespace mixcmp::optimise {

/// Seconds per comparison of each plan on each data set, [plan][set]; infinite where a plan does
/// not serve a set. All plans have the same sets.
using PlanSeconds = std::vector<std::vector<double>>;

struct PlanChoice {
  std::vector<std::size_t> plans;  ///< the plan that is best by itself comes first
  /// Seconds per comparison, summed over the data sets, each served by its fastest plan.
  double seconds = 0;
};

/// The best choices of at most 1, 2, ... `most` plans: those of the least seconds. A choice has
/// fewer plans than allowed if more gain nothing. Exact, by branch and bound: `left` further plans
/// gain at most the sum of what the `left` best of them gain each by itself. `plans` has at least
/// one plan, and some plan serves each set.
std::vector<PlanChoice> choose_plans(const PlanSeconds& plans, int most);

/// Finds these choices by trying all, for small problems: the oracle of the tests.
std::vector<PlanChoice> choose_plans_exhaustively(const PlanSeconds& plans, int most);

}  // namespace mixcmp::optimise
