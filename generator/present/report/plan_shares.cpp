#include "generator/present/report/plan_shares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "model/base/common/check.hpp"
#include "model/cost/performance/performance.hpp"

namespace mixcmp::report {
namespace {

using devices::Area;
using devices::bounded_resources;

/// `whole` without `part`, for the resources that limit a plan.
Area difference(const Area& whole, const Area& part) {
  Area left;
  for (const devices::Resource& resource : bounded_resources) {
    left.*resource.amount = whole.*resource.amount - part.*resource.amount;
  }
  return left;
}

bool is_within(const Area& part, const Area& whole) {
  return std::all_of(std::begin(bounded_resources), std::end(bounded_resources),
                     [&](const devices::Resource& resource) {
                       return part.*resource.amount <= whole.*resource.amount;
                     });
}

/// The lanes of each kind, the second tiers behind them, and the parts around both. Lanes that were
/// not measured by themselves count together with the parts around them. So do lanes whose area is
/// predicted, beside a measured segment that is smaller.
std::vector<PartShare> shares_of_lanes(const optimise::PrecisionPlan& plan,
                                       const optimise::Allocation& chosen, bool in_engine) {
  std::vector<PartShare> parts;
  std::optional<Area> second_tier, around;
  for (std::size_t k = 0; k < plan.lanes.size(); ++k) {
    const optimise::LaneImplementation& lane = plan.lanes[k];
    const int count = chosen.lanes[k];
    if (count == 0) continue;
    Area rest = area_of(lane.kind, count);
    const bool is_apart = lane.datapath && is_within(count * *lane.datapath, rest);
    const Area lanes = is_apart ? count * *lane.datapath : rest;
    parts.push_back({fmt::format("{} x {}", count, lane.kind.name), lanes});
    if (!is_apart) continue;
    rest = difference(rest, lanes);
    if (plan.second_lanes) {
      rest = difference(rest, count / lane.kind.group * plan.second_lanes->area_per_group);
    }
    if (lane.second_tier) {
      const Area tier = count / lane.kind.group * *lane.second_tier;
      second_tier = second_tier.value_or(Area{}) + tier;
      rest = difference(rest, tier);
    }
    around = around.value_or(Area{}) + rest;
  }
  if (second_tier) parts.push_back({"second tier", *second_tier});
  if (const auto& second = plan.second_lanes) {
    parts.push_back({fmt::format("{} x {}", second->count, name_of(*second)),
                     second->count * second->measured.area});
  }
  if (around) {
    parts.push_back({in_engine ? "segments of the lanes" : "scoreboards of the lanes", *around});
  }
  return parts;
}

/// The crossbar's share of all references.
Area crossbar_of(const optimise::AllocationProblem& problem, const optimise::Allocation& chosen) {
  Area sum;
  for (const int served : performance::lanes_of_references(
           chosen.lane_count() / lanes_per_port(problem), chosen.reference_count())) {
    sum += problem.communication.crossbar[served];
  }
  return sum;
}

}  // namespace

bool is_in_engine(const optimise::PrecisionPlan& plan) {
  return std::holds_alternative<measured::Segment>(plan.lanes.front().measured.key);
}

std::vector<PartShare> shares_of(const optimise::PrecisionPlan& plan) {
  const optimise::Allocation* chosen = plan.allocation();
  MIXCMP_CHECK(chosen != nullptr);
  const bool in_engine = is_in_engine(plan);
  std::vector<PartShare> parts = shares_of_lanes(plan, *chosen, in_engine);
  Area sum;
  for (std::size_t k = 0; k < chosen->references.size(); ++k) {
    const int count = chosen->references[k];
    if (count == 0) continue;
    const optimise::ReferenceKind& reference = plan.problem.references[k];
    Area area = count * reference.area;
    if (plan.second_lanes) area = difference(area, count * plan.second_lanes->area);
    parts.push_back({fmt::format("{} x reference {}", count, reference.name), area});
  }
  if (in_engine && !plan.problem.communication.crossbar.empty()) {
    parts.push_back({"crossbar", crossbar_of(plan.problem, *chosen)});
  }
  for (const PartShare& part : parts) sum += part.area;
  parts.push_back({in_engine ? "engine" : "crossbar", difference(chosen->used, sum)});
  return parts;
}

}  // namespace mixcmp::report
