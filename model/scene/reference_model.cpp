#include "model/scene/reference_model.hpp"

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

}  // namespace mixcmp::scene
