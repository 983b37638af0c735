#include "model/plan/profile/schemes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "model/design/design.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "model/lane/error/profiled_lane.hpp"
#include "model/scene/lane_bound.hpp"

namespace mixcmp::profile {
namespace {

SchemeLanes& scheme_with(std::vector<SchemeLanes>& schemes, const std::optional<Bound>& bound,
                         SchemeKind kind) {
  const auto found = std::find_if(schemes.begin(), schemes.end(),
                                  [&](const SchemeLanes& scheme) { return scheme.bound == bound; });
  if (found != schemes.end()) return *found;
  const std::string name = bound ? to_string(*bound) : "lanes_alone";
  return schemes.emplace_back(SchemeLanes{name, bound, kind, {}, ""});
}

/// `bound`: none for lanes without a bound.
void add(std::vector<SchemeLanes>& schemes, const std::optional<Bound>& bound, SchemeKind kind,
         Result<design::Lane> lane) {
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

/// `measured`: the number of comparisons on which the error was measured.
Result<design::Lane> profiled_at(const TypedGraph& graph, const ErrorAtPrecision& error,
                                 std::uint64_t measured) {
  if (error.f && error.g) return design::Lane(error::profiled_lane(graph, *error.f, *error.g));
  return Error{.message = measured == 0 ? "no relative error was measured"
                                        : "no comparison has a relative error of f and of g"};
}

/// The bounds that are always counted, those of the scene's own formats, and those asked for.
/// Running ones are counted only if a scene or a caller asks for them: they require a look at many
/// comparisons.
std::vector<Bound> bounds_in_fixed_point(const scene::Scene& scene, std::span<const Bound> asked) {
  std::vector<Bound> bounds;
  const auto add_new = [&](const Bound& bound) {
    const bool known = std::find(bounds.begin(), bounds.end(), bound) != bounds.end();
    const bool takes_operands = bound.system != NumberSystem::block || !scene.has_fixed_operands();
    if (bound.is_fixed_point() && takes_operands && !known) bounds.push_back(bound);
  };
  const auto add_format = [&](const scene::ReducedSpec& reduced) {
    if (!reduced.fixed_point) return;
    const bool runs = reduced.error_bound == BoundKind::running;
    for (const auto& bound : bounds_of(*reduced.fixed_point)) {
      if (bound == grid_bound) continue;  // counted_bounds_of adds it
      if (runs || bound.kind != BoundKind::running) add_new(bound);
    }
  };
  for (const Bound& bound : scene::counted_bounds_of(scene)) add_new(bound);
  add_format(scene.reduced);
  for (const scene::LaneGroupSpec& group : scene.lanes) add_format(group.reduced);
  for (const Bound& bound : asked) add_new(bound);
  return bounds;
}

void add_float_lanes(const scene::Scene& scene, const ErrorProfile& errors,
                     const ErrorAtPrecision& error, std::vector<SchemeLanes>& schemes) {
  const TypedGraph graph = graph_at(scene, error.precision, errors.inputs);
  add(schemes, std::nullopt, SchemeKind::lanes_alone, design::Lane(lanes_alone(graph)));
  add(schemes, Bound{.kind = BoundKind::profiled}, SchemeKind::profiled,
      profiled_at(graph, error, errors.comparisons));
  for (error::CandidateLane& candidate : error::candidate_lanes(graph, scene.ranges)) {
    add(schemes, candidate.bound, SchemeKind::certified,
        design::as_lane(std::move(candidate.lane)));
  }
}

void add_fixed_lanes(const scene::Scene& scene, int bits, std::span<const Bound> bounds,
                     std::vector<SchemeLanes>& schemes) {
  const settings::Limits limits = settings::lane_fixed_bits(scene.reference.format);
  for (const Bound& bound : bounds) {
    scene::ReducedSpec reduced = with_bound(scene.reduced, bound);
    reduced.fixed_point = bound.fixed_point(bits);
    SchemeLanes& scheme = scheme_with(schemes, bound, SchemeKind::certified);
    // The narrowest lane on grids decides as all wider ones do, so these are not made.
    const bool has_narrower = bound == grid_bound && scheme.exists();
    if (!has_narrower && allow(limits, *reduced.fixed_point)) {
      add(schemes, bound, SchemeKind::certified, design::design_lane(scene, reduced, nullptr));
    } else {
      scheme.lanes.emplace_back(std::nullopt);
    }
  }
}

}  // namespace

std::vector<SchemeLanes> make_schemes(const scene::Scene& scene, const ErrorProfile& errors,
                                      std::span<const Bound> bounds) {
  std::vector<SchemeLanes> schemes;
  const std::vector<Bound> in_fixed_point = bounds_in_fixed_point(scene, bounds);
  for (const ErrorAtPrecision& error : errors.precisions) {
    if (!scene.why_no_float_lane()) add_float_lanes(scene, errors, error, schemes);
    add_fixed_lanes(scene, error.precision, in_fixed_point, schemes);
  }
  const auto is_unwanted = [&](const SchemeLanes& scheme) {
    return std::find(bounds.begin(), bounds.end(), scheme.bound) == bounds.end();
  };
  if (!bounds.empty()) std::erase_if(schemes, is_unwanted);
  return schemes;
}

}  // namespace mixcmp::profile
