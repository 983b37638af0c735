#include "model/profile/systems.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "model/error/certified_lane.hpp"
#include "model/error/profiled_error.hpp"

namespace mixcmp::model {
namespace {

std::string name_of(const CandidateLane& candidate) {
  if (candidate.kind != ErrorBoundKind::running) return std::string(to_string(candidate.kind));
  return fmt::format("running_{}", candidate.bound_digits);
}

SystemLanes& system_named(std::vector<SystemLanes>& systems, const std::string& name,
                          SystemKind kind) {
  const auto found = std::find_if(systems.begin(), systems.end(),
                                  [&](const SystemLanes& system) { return system.name == name; });
  if (found != systems.end()) return *found;
  return systems.emplace_back(SystemLanes{name, kind, {}, ""});
}

void add(std::vector<SystemLanes>& systems, const std::string& name, SystemKind kind,
         Result<Lane> lane) {
  SystemLanes& system = system_named(systems, name, kind);
  if (lane.ok()) {
    system.lanes.emplace_back(std::move(lane).value());
  } else {
    system.lanes.emplace_back(std::nullopt);
    system.reason = lane.error().message;
  }
}

}  // namespace

bool SystemLanes::exists() const {
  return std::any_of(lanes.begin(), lanes.end(), [](const auto& lane) { return lane.has_value(); });
}

int profiled_exponent_bits(const Scene& scene) {
  return scene.reduced.format.value_or(scene.reference.format).exponent_bits();
}

TypedGraph graph_at(const Scene& scene, int precision, LaneInputs inputs) {
  const ReducedSpec& reduced = scene.reduced;
  const FloatFormat format = FloatFormat::make(precision, profiled_exponent_bits(scene)).value();
  return lane_graph(scene.graph, scene.reference.format,
                    {format, reduced.rounding, reduced.subnormals}, inputs);
}

std::vector<SystemLanes> make_systems(const Scene& scene, const ErrorProfile& errors) {
  std::vector<SystemLanes> systems;
  for (const ErrorAtPrecision& error : errors.precisions) {
    const TypedGraph graph = graph_at(scene, error.precision, errors.inputs);
    const UlpDistanceDecision order{.guard_ulp = 0, .nonnegative = false};
    add(systems, "lanes_alone", SystemKind::lanes_alone, Lane{graph, order});
    add(systems, "profiled", SystemKind::profiled, profiled_lane(graph, error.f, error.g));
    for (CandidateLane& candidate : candidate_lanes(graph, scene.ranges)) {
      add(systems, name_of(candidate), SystemKind::certified, std::move(candidate.lane));
    }
  }
  return systems;
}

}  // namespace mixcmp::model
