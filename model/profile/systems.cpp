#include "model/profile/systems.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace mixcmp::model {
namespace {

SystemLanes& system_with(std::vector<SystemLanes>& systems, const std::optional<BoundChoice>& bound,
                         SystemKind kind) {
  const auto found = std::find_if(systems.begin(), systems.end(),
                                  [&](const SystemLanes& system) { return system.bound == bound; });
  if (found != systems.end()) return *found;
  const std::string name = bound ? to_string(*bound) : "lanes_alone";
  return systems.emplace_back(SystemLanes{name, bound, kind, {}, ""});
}

/// `bound`: none for lanes alone.
void add(std::vector<SystemLanes>& systems, const std::optional<BoundChoice>& bound,
         SystemKind kind, Result<CombinedLane> lane) {
  SystemLanes& system = system_with(systems, bound, kind);
  if (lane.ok()) {
    system.lanes.emplace_back(std::move(lane).value());
  } else {
    system.lanes.emplace_back(std::nullopt);
    system.reason = lane.error().message;
  }
}

CombinedLane lanes_alone(const CombinedGraph& graph) {
  std::vector<Lane> parts;
  for (const TypedGraph& part : graph.parts) {
    parts.push_back(Lane{part, UlpDistanceDecision{.guard_ulp = 0, .nonnegative = false}});
  }
  return {graph.combination, std::move(parts)};
}

}  // namespace

bool SystemLanes::exists() const {
  return std::any_of(lanes.begin(), lanes.end(), [](const auto& lane) { return lane.has_value(); });
}

int profiled_exponent_bits(const Scene& scene) {
  return scene.reduced.format.value_or(scene.reference.format).exponent_bits();
}

CombinedGraph graphs_at(const Scene& scene, int precision, LaneInputs inputs) {
  const ReducedSpec& reduced = scene.reduced;
  const FloatFormat format = FloatFormat::make(precision, profiled_exponent_bits(scene)).value();
  return lane_graphs(scene.graph, scene.reference.format,
                     {format, reduced.rounding, reduced.subnormals}, inputs);
}

namespace {

Result<CombinedLane> profiled_at(const CombinedGraph& graph, const ErrorAtPrecision& error) {
  if (error.f && error.g) return profiled_lanes(graph, *error.f, *error.g);
  return Error{.message = "no comparison has a relative error of f and of g"};
}

}  // namespace

std::vector<SystemLanes> make_systems(const Scene& scene, const ErrorProfile& errors) {
  std::vector<SystemLanes> systems;
  for (const ErrorAtPrecision& error : errors.precisions) {
    const CombinedGraph graph = graphs_at(scene, error.precision, errors.inputs);
    add(systems, std::nullopt, SystemKind::lanes_alone, lanes_alone(graph));
    add(systems, BoundChoice{BoundChoice::Kind::profiled}, SystemKind::profiled,
        profiled_at(graph, error));
    for (CandidateLanes& candidate : candidate_lanes(graph, scene.ranges)) {
      add(systems, bound_choice(candidate), SystemKind::certified, std::move(candidate.lane));
    }
  }
  return systems;
}

}  // namespace mixcmp::model
