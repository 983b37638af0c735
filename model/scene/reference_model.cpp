#include "model/scene/reference_model.hpp"

#include "model/base/settings/section.hpp"

namespace mixcmp::scene {

Result<fixed::ReferenceDatapath> reference_model(const Scene& scene) {
  if (!scene.reference_fixed_point) {
    return fixed::ReferenceDatapath(reference_graph(scene.graph, scene.reference));
  }
  Result<fixed::FixedLane> lane = fixed::fixed_lane(scene.graph, scene.reference.format,
                                                    {.format = *scene.reference_fixed_point,
                                                     .bound = BoundKind::constant,
                                                     .ranges = scene.ranges,
                                                     .operand_formats = scene.operand_formats,
                                                     .is_reference = true});
  if (lane.ok()) return fixed::ReferenceDatapath(std::move(lane).value());
  Error error = lane.error();
  if (error.file.empty()) error.file = scene.path.string();
  if (error.field == "reduced.format") error.field = "reference.format";
  return error;
}

Result<Done> check_reference_model(const settings::Settings& settings, const Scene& scene) {
  const auto model = reference_model(scene);
  if (model.ok()) return Done{};
  const Error& error = model.error();
  if (error.field != "reference.format") return error;
  return settings::Section(settings, "reference")
      .mistake("format", error.message, error.received, error.accepted);
}

}  // namespace mixcmp::scene
