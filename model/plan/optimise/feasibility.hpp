#pragma once

#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <vector>

#include "model/plan/optimise/allocation.hpp"

/// Decides whether a plan is feasible, and which of two plans is better. Areas are exact integers.
namespace mixcmp::optimise {

/// One point of the search: how many of each kind.
struct Counts {
  std::vector<int> lanes;
  std::vector<int> references;
};

/// An amount of each of `bounded_resources`, in their order; sums of Areas may exceed an int.
using Amounts = std::array<std::int64_t, std::size(devices::bounded_resources)>;
Amounts amounts_of(const devices::Area& area);
/// Adds `count` times an area.
void add(Amounts& sum, int count, const devices::Area& area);

/// Left side of equation 11: lanes, references, the crossbar's shares and the fixed part. None if a
/// reference serves more lanes than `Communication::crossbar` has shares for.
std::optional<Amounts> demand_of(const AllocationProblem& problem, const Counts& counts);

/// Indices of the values, the largest first; equal values keep their order.
std::vector<int> falling_order(const std::vector<double>& values);

/// The plan with these counts, if it is feasible: it has a lane, exceeds no maximum count, and
/// satisfies equations 10 (at each reference, unless references are pooled) and 11.
std::optional<Allocation> plan_of(const AllocationProblem& problem, const Counts& counts);

/// Whether a is better than b. The first difference decides: higher throughput, fewer references,
/// fewer lanes, fewer LUTs, registers, DSPs and memories, more of the kinds listed first.
bool is_better(const Allocation& a, const Allocation& b);

}  // namespace mixcmp::optimise
