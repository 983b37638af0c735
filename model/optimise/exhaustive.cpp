#include "model/optimise/allocation.hpp"
#include "model/optimise/feasibility.hpp"
#include "model/optimise/shortage.hpp"

namespace mixcmp::optimise {
namespace {

/// The next vector of counts whose sum is at most `most`, in the order of an odometer; false after
/// the last.
bool advance(std::vector<int>& counts, int& sum, int most) {
  for (int& count : counts) {
    if (sum < most) {
      ++count;
      ++sum;
      return true;
    }
    sum -= count;
    count = 0;
  }
  return false;
}

}  // namespace

AllocationResult allocate_exhaustively(const AllocationProblem& problem) {
  std::optional<Allocation> best;
  Counts counts{std::vector<int>(problem.lanes.size(), 0), {}};
  int lanes = 0;
  do {
    counts.references.assign(problem.references.size(), 0);
    int references = 0;
    do {
      const std::optional<Allocation> plan = plan_of(problem, counts);
      if (plan && (!best || is_better(*plan, *best))) best = plan;
    } while (advance(counts.references, references, problem.max_references));
  } while (advance(counts.lanes, lanes, problem.max_lanes));
  if (!best) return explain_infeasible(problem);
  return *best;
}

}  // namespace mixcmp::optimise
