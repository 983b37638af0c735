#pragma once

#include "generator/synthesis/components/component_list.hpp"
#include "model/cost/devices/device.hpp"
#include "model/cost/measured/measurement.hpp"
#include "model/cost/units/unit_areas.hpp"

namespace mixcmp::components {

/// A table of all components that a query asks for, whose areas are predicted: no tool runs.
struct PredictedTable {
  measured::Characterisation table;  ///< rows of AreaStage::predicted, without clocks
  std::vector<MissingLane> missing;
};

/// The area of a component: the sum of its parts'. An error names a template that the library
/// lacks.
Result<devices::Area> predicted_area(const Component& component, const units::UnitAreas& library,
                                     const devices::Device& device);

/// Predicts the areas that `characterise` would measure. `data` may be null, as there.
Result<PredictedTable> predict_table(const scene::Scene& scene, const data::Comparisons* data,
                                     const devices::Device& device, const ComponentQuery& query);

}  // namespace mixcmp::components
