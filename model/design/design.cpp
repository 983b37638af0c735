#include "model/design/design.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

#include "model/error/certified_lane.hpp"
#include "model/error/hazards.hpp"
#include "model/error/profiled_error.hpp"
#include "model/error/range_analysis.hpp"

namespace mixcmp::model {
namespace {

/// Comparisons measured for the paper's constants.
constexpr std::uint64_t profile_samples = 100'000;

Error unresolved(const std::string& field, const std::string& option, const std::string& accepted) {
  return {.field = field,
          .message = fmt::format("is not chosen yet; give it in the scene or by {}", option),
          .received = "\"auto\"",
          .accepted = accepted};
}

Result<Lane> design_profiled_lane(const Scene& scene, TypedGraph graph, const Comparisons* data) {
  const ReducedSpec& reduced = scene.reduced;
  if (reduced.relative_error_f && reduced.relative_error_g) {
    return profiled_lane(std::move(graph), *reduced.relative_error_f, *reduced.relative_error_g);
  }
  if (data == nullptr) {
    return Error{.field = "reduced.relative_error_f, reduced.relative_error_g",
                 .message = "a profiled bound needs its constants, or data to measure them on",
                 .received = "neither",
                 .accepted = "both constants, or a [data] section"};
  }
  const std::uint64_t seed = scene.data ? scene.data->seed : 1;
  const ProfiledError profiled = profile_error(scene.graph, graph, *data, profile_samples, seed);
  if (profiled.comparisons == 0) {
    return Error{.field = "reduced.bound",
                 .message = "no comparison of the data could be measured for the profile",
                 .received = fmt::format("{} comparisons, none with finite f and g", data->size()),
                 .accepted = "other data, or reduced.relative_error_f and relative_error_g"};
  }
  return profiled_lane(std::move(graph), reduced.relative_error_f.value_or(profiled.f),
                       reduced.relative_error_g.value_or(profiled.g));
}

bool can_decide(const UlpDistanceDecision& decision, const Lane& lane) {
  const Bits largest = lane.graph.arithmetic.format.largest_finite(false);
  return decision.guard_ulp <= (decision.nonnegative ? largest : 2 * largest);
}

/// A constant bound can exceed every difference that the checked operands give.
bool can_decide(const AbsoluteBoundDecision& decision, const Lane& lane) {
  const BoundNode& bound = decision.bound.nodes.back();
  if (bound.operation != BoundOperation::constant) return true;
  const auto ranges = analyse_ranges(lane.graph, checked_ranges(lane.graph, lane.checks));
  const Range& difference = ranges[static_cast<std::size_t>(decision.difference)].value;
  return bound.constant < std::max<mpq_class>(abs(difference.low), abs(difference.high));
}

bool can_decide(const IntervalDecision&, const Lane&) {
  return true;
}

/// Whether any two results lie far enough apart for the lane to decide.
bool can_decide(const Lane& lane) {
  return std::visit([&](const auto& decision) { return can_decide(decision, lane); },
                    lane.decision);
}

Result<Lane> design_certified_lane(const Scene& scene, TypedGraph graph) {
  const CertifiedOptions options{.kind = scene.reduced.error_bound,
                                 .bound_digits = scene.reduced.bound_digits,
                                 .ranges = scene.ranges};
  MIXCMP_TRY(lane, certified_lane(std::move(graph), options));
  if (can_decide(lane)) return lane;
  return Error{.field = "reduced.format",
               .message =
                   "too many roundings for so few digits: no two results are far enough "
                   "apart to be decided",
               .received = lane.graph.arithmetic.format.name(),
               .accepted = "more precision"};
}

Result<Lane> design_lane(const Scene& scene, const Comparisons* data) {
  const ReducedSpec& reduced = scene.reduced;
  if (!reduced.format) return unresolved("reduced.format", "--format s17e8", "sPeE, such as s17e8");
  const Arithmetic arithmetic{*reduced.format, reduced.rounding, reduced.subnormals};
  TypedGraph graph = lane_graph(scene.graph, scene.reference.format, arithmetic, reduced.inputs);
  switch (reduced.bound) {
    case BoundKind::certified: return design_certified_lane(scene, std::move(graph));
    case BoundKind::profiled: return design_profiled_lane(scene, std::move(graph), data);
  }
  MIXCMP_CHECK(false);
}

Result<Design> choose(const Scene& scene, const Comparisons* data) {
  MIXCMP_TRY(lane, design_lane(scene, data));
  if (!scene.system.lanes) return unresolved("system.lanes", "--lanes 8", "1..128");
  if (!scene.system.references) return unresolved("system.references", "--references 1", "0..16");
  return Design{.name = scene.name,
                .inputs = scene.graph.inputs(),
                .lane = std::move(lane),
                .lane_multipliers = scene.reduced.multipliers,
                .reference = reference_graph(scene.graph, scene.reference),
                .reference_multipliers = scene.reference_multipliers,
                .lanes = *scene.system.lanes,
                .references = *scene.system.references,
                .system = scene.system};
}

}  // namespace

Result<Design> make_design(const Scene& scene, const Comparisons* data) {
  Result<Design> design = choose(scene, data);
  if (design.ok()) return design;
  Error error = design.error();
  if (error.file.empty()) error.file = scene.path.string();
  return error;
}

}  // namespace mixcmp::model
