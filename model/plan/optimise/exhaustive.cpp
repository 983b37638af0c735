#include "model/plan/optimise/allocation.hpp"
#include "model/plan/optimise/feasibility.hpp"
#include "model/plan/optimise/shortage.hpp"

namespace mixcmp::optimise {
namespace {

/// The next vector of counts in the order of an odometer, each a multiple of its step, with a sum
/// of at most `most`; false after the last.
bool advance(std::vector<int>& counts, const std::vector<int>& steps, int& sum, int most) {
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (sum + steps[k] <= most) {
      counts[k] += steps[k];
      sum += steps[k];
      return true;
    }
    sum -= counts[k];
    counts[k] = 0;
  }
  return false;
}

}  // namespace

AllocationResult allocate_exhaustively(const AllocationProblem& problem) {
  std::optional<Allocation> best;
  std::vector<int> groups;
  for (const LaneKind& kind : problem.lanes) groups.push_back(kind.group);
  const std::vector<int> ones(problem.references.size(), 1);
  Counts counts{std::vector<int>(problem.lanes.size(), 0), {}};
  int lanes = 0;
  do {
    counts.references.assign(problem.references.size(), 0);
    int references = 0;
    do {
      const std::optional<Allocation> plan = plan_of(problem, counts);
      if (plan && (!best || is_better(*plan, *best))) best = plan;
    } while (advance(counts.references, ones, references, problem.max_references));
  } while (advance(counts.lanes, groups, lanes, problem.max_lanes));
  if (!best) return explain_infeasible(problem);
  return *best;
}

}  // namespace mixcmp::optimise
