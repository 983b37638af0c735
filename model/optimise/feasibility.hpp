#pragma once

#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <vector>

#include "model/optimise/allocation.hpp"

/// What it means for a plan to be feasible, and which of two is better. Exact: integers for areas.
namespace mixcmp::model {

/// One point of the search: how many of each kind.
struct Counts {
  std::vector<int> lanes;
  std::vector<int> references;
};

/// An amount of each of `bounded_resources`, in their order; sums of Areas may exceed an int.
using Amounts = std::array<std::int64_t, std::size(bounded_resources)>;
Amounts amounts_of(const Area& area);

/// Left side of equation 11: lanes, references, the crossbar's shares and what is fixed. A share
/// that the table does not know makes it none.
std::optional<Amounts> demand_of(const AllocationProblem& problem, const Counts& counts);

/// Indices of the values, the largest first, equal ones in the order given.
std::vector<int> falling_order(const std::vector<double>& values);

/// The plan, where it has a lane and keeps equations 10 (at each reference, unless references are
/// pooled) and 11.
std::optional<Allocation> plan_of(const AllocationProblem& problem, const Counts& counts);

/// Higher throughput; then fewer references, fewer lanes, fewer LUTs, registers, DSPs and memories,
/// more of the kinds listed first.
bool is_better(const Allocation& a, const Allocation& b);

}  // namespace mixcmp::model
