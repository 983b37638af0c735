#pragma once

#include "generator/synthesis/components/component_list.hpp"
#include "model/cost/devices/device.hpp"
#include "model/cost/measured/measurement.hpp"

namespace mixcmp::components {

/// A table of all components that a query asks for, whose areas are predicted: no tool runs.
struct PredictedTable {
  measured::Characterisation table;  ///< rows of AreaStage::predicted, without clocks
  std::vector<MissingLane> missing;
};

/// Predicts the areas that `characterise` would measure. `data` may be null, as there.
Result<PredictedTable> predict_table(const scene::Scene& scene, const data::Comparisons* data,
                                     const devices::Device& device, const ComponentQuery& query);

}  // namespace mixcmp::components
