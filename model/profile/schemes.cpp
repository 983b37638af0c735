#include "model/profile/schemes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "model/design/design.hpp"
#include "model/error/certified_lane.hpp"
#include "model/error/profiled_lane.hpp"

namespace mixcmp::profile {
namespace {

SchemeLanes& scheme_with(std::vector<SchemeLanes>& schemes,
                         const std::optional<scene::BoundChoice>& bound, SchemeKind kind) {
  const auto found = std::find_if(schemes.begin(), schemes.end(),
                                  [&](const SchemeLanes& scheme) { return scheme.bound == bound; });
  if (found != schemes.end()) return *found;
  const std::string name = bound ? to_string(*bound) : "lanes_alone";
  return schemes.emplace_back(SchemeLanes{name, bound, kind, {}, ""});
}

/// `bound`: none for lanes alone.
void add(std::vector<SchemeLanes>& schemes, const std::optional<scene::BoundChoice>& bound,
         SchemeKind kind, Result<design::Lane> lane) {
  SchemeLanes& scheme = scheme_with(schemes, bound, kind);
  if (lane.ok()) {
    scheme.lanes.emplace_back(std::move(lane).value());
  } else {
    scheme.lanes.emplace_back(std::nullopt);
    scheme.reason = lane.error().message;
  }
}

error::Lane lanes_alone(const TypedGraph& graph) {
  const error::UlpDistanceCriterion by_order{.guard_ulp = 0, .nonnegative = false};
  return {graph, std::vector<error::LanePart>(graph.parts.size(), {by_order})};
}

}  // namespace

bool SchemeLanes::exists() const {
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

void add_fixed_lanes(const scene::Scene& scene, int bits, std::vector<SchemeLanes>& schemes) {
  using Kind = scene::BoundChoice::Kind;
  for (const Kind kind :
       {Kind::fixed_norm, Kind::fixed_constant, Kind::block_norm, Kind::block_constant}) {
    const scene::BoundChoice choice{kind};
    scene::ReducedSpec reduced = with_bound(scene.reduced, choice);
    reduced.fixed_point = FixedPoint{bits, choice.is_block()};
    SchemeLanes& scheme = scheme_with(schemes, choice, SchemeKind::certified);
    if (settings::lane_fixed_bits(scene.reference.format).allow(bits)) {
      add(schemes, choice, SchemeKind::certified, design::design_lane(scene, reduced, nullptr));
    } else {
      scheme.lanes.emplace_back(std::nullopt);
    }
  }
}

}  // namespace

std::vector<SchemeLanes> make_schemes(const scene::Scene& scene, const ErrorProfile& errors,
                                      std::span<const scene::BoundChoice> bounds) {
  std::vector<SchemeLanes> schemes;
  for (const ErrorAtPrecision& error : errors.precisions) {
    const TypedGraph graph = graph_at(scene, error.precision, errors.inputs);
    add(schemes, std::nullopt, SchemeKind::lanes_alone, design::Lane(lanes_alone(graph)));
    add(schemes, scene::BoundChoice{scene::BoundChoice::Kind::profiled}, SchemeKind::profiled,
        profiled_at(graph, error));
    for (error::CandidateLane& candidate : error::candidate_lanes(graph, scene.ranges)) {
      add(schemes, scene::bound_choice(candidate), SchemeKind::certified,
          design::as_lane(std::move(candidate.lane)));
    }
    add_fixed_lanes(scene, error.precision, schemes);
  }
  const auto is_unwanted = [&](const SchemeLanes& scheme) {
    return std::find(bounds.begin(), bounds.end(), scheme.bound) == bounds.end();
  };
  if (!bounds.empty()) std::erase_if(schemes, is_unwanted);
  return schemes;
}

}  // namespace mixcmp::profile
