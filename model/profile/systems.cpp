#include "model/profile/systems.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "model/design/design.hpp"
#include "model/error/certified_lane.hpp"
#include "model/error/profiled_lane.hpp"

namespace mixcmp::profile {
namespace {

SystemLanes& system_with(std::vector<SystemLanes>& systems,
                         const std::optional<scene::BoundChoice>& bound, SystemKind kind) {
  const auto found = std::find_if(systems.begin(), systems.end(),
                                  [&](const SystemLanes& system) { return system.bound == bound; });
  if (found != systems.end()) return *found;
  const std::string name = bound ? to_string(*bound) : "lanes_alone";
  return systems.emplace_back(SystemLanes{name, bound, kind, {}, ""});
}

/// `bound`: none for lanes alone.
void add(std::vector<SystemLanes>& systems, const std::optional<scene::BoundChoice>& bound,
         SystemKind kind, Result<design::Lane> lane) {
  SystemLanes& system = system_with(systems, bound, kind);
  if (lane.ok()) {
    system.lanes.emplace_back(std::move(lane).value());
  } else {
    system.lanes.emplace_back(std::nullopt);
    system.reason = lane.error().message;
  }
}

error::Lane lanes_alone(const TypedGraph& graph) {
  const error::UlpDistanceCriterion by_order{.guard_ulp = 0, .nonnegative = false};
  return {graph, std::vector<error::LanePart>(graph.parts.size(), {by_order})};
}

}  // namespace

bool SystemLanes::exists() const {
  return std::any_of(lanes.begin(), lanes.end(), [](const auto& lane) { return lane.has_value(); });
}

int profiled_exponent_bits(const scene::Scene& scene) {
  return scene.reduced.format.value_or(scene.reference.format).exponent_bits();
}

TypedGraph graph_at(const scene::Scene& scene, int precision, LaneInputs inputs) {
  const scene::ReducedSpec& reduced = scene.reduced;
  const FloatFormat format = FloatFormat::make(precision, profiled_exponent_bits(scene)).value();
  return lane_graph(scene.graph, scene.reference.format,
                    {format, reduced.rounding, reduced.subnormals}, inputs);
}

namespace {

Result<design::Lane> profiled_at(const TypedGraph& graph, const ErrorAtPrecision& error) {
  if (error.f && error.g) return design::Lane(error::profiled_lane(graph, *error.f, *error.g));
  return Error{.message = "no comparison has a relative error of f and of g"};
}

void add_fixed_lanes(const scene::Scene& scene, int bits, std::vector<SystemLanes>& systems) {
  for (const scene::BoundChoice::Kind kind :
       {scene::BoundChoice::Kind::fixed_norm, scene::BoundChoice::Kind::fixed_constant}) {
    const scene::BoundChoice choice{kind};
    scene::ReducedSpec reduced = with_bound(scene.reduced, choice);
    reduced.fixed_bits = bits;
    SystemLanes& system = system_with(systems, choice, SystemKind::certified);
    if (settings::lane_fixed_bits(scene.reference.format).allow(bits)) {
      add(systems, choice, SystemKind::certified, design::design_lane(scene, reduced, nullptr));
    } else {
      system.lanes.emplace_back(std::nullopt);
    }
  }
}

}  // namespace

std::vector<SystemLanes> make_systems(const scene::Scene& scene, const ErrorProfile& errors,
                                      std::span<const scene::BoundChoice> bounds) {
  std::vector<SystemLanes> systems;
  for (const ErrorAtPrecision& error : errors.precisions) {
    const TypedGraph graph = graph_at(scene, error.precision, errors.inputs);
    add(systems, std::nullopt, SystemKind::lanes_alone, design::Lane(lanes_alone(graph)));
    add(systems, scene::BoundChoice{scene::BoundChoice::Kind::profiled}, SystemKind::profiled,
        profiled_at(graph, error));
    for (error::CandidateLane& candidate : error::candidate_lanes(graph, scene.ranges)) {
      add(systems, scene::bound_choice(candidate), SystemKind::certified,
          design::as_lane(std::move(candidate.lane)));
    }
    add_fixed_lanes(scene, error.precision, systems);
  }
  const auto is_unwanted = [&](const SystemLanes& system) {
    return std::find(bounds.begin(), bounds.end(), system.bound) == bounds.end();
  };
  if (!bounds.empty()) std::erase_if(systems, is_unwanted);
  return systems;
}

}  // namespace mixcmp::profile
