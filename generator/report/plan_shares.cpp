#include "generator/report/plan_shares.hpp"

#include <fmt/format.h>

#include "model/common/check.hpp"

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

}  // namespace

std::vector<PartShare> shares_of(const optimise::PrecisionPlan& plan) {
  const optimise::Allocation* chosen = plan.allocation();
  MIXCMP_CHECK(chosen != nullptr);
  const bool in_engine =
      plan.lanes.front().measured.key.kind == characterise::ComponentKind::segment;
  std::vector<PartShare> parts;
  Area streams, sum;
  for (std::size_t k = 0; k < plan.lanes.size(); ++k) {
    const optimise::LaneImplementation& lane = plan.lanes[k];
    const int count = chosen->lanes[k];
    if (count == 0) continue;
    const Area datapaths = in_engine ? area_of(lane.kind, count) : count * lane.measured.area;
    parts.push_back({fmt::format("{} x {}", count, lane.kind.name), datapaths});
    streams += difference(area_of(lane.kind, count), datapaths);
  }
  if (!in_engine) parts.push_back({"scoreboards of the lanes", streams});
  for (std::size_t k = 0; k < chosen->references.size(); ++k) {
    const int count = chosen->references[k];
    if (count == 0) continue;
    const optimise::ReferenceKind& reference = plan.problem.references[k];
    parts.push_back(
        {fmt::format("{} x reference {}", count, reference.name), count * reference.area});
  }
  for (const PartShare& part : parts) sum += part.area;
  parts.push_back({in_engine ? "engine" : "crossbar", difference(chosen->used, sum)});
  return parts;
}

}  // namespace mixcmp::report
