#pragma once

#include <nlohmann/json_fwd.hpp>

#include "generator/cli/options.hpp"
#include "model/devices/area.hpp"

namespace mixcmp::cli {

/// One way to bound the errors of the scene's lane: what it costs.
struct BoundCost {
  std::string name;
  bool chosen = false;                       ///< what `generate` takes
  std::string decision;                      ///< or why it does not exist
  std::optional<double> recomputation_rate;  ///< on the scene's data
  std::optional<model::Area> area;
  std::optional<model::Area> all_built;  ///< nothing left out for the ranges' sake
};

struct BoundCosts {
  std::vector<BoundCost> bounds;
  std::optional<model::Error> why_no_area;  ///< why there are no areas, if there are none
  std::string why_no_rate;
};

/// Every certified bound of the scene's lane, and the profiled one where its constants are known or
/// can be measured. Takes seconds a lane: Yosys maps each.
/// An error where the scene leaves the lane's format open.
model::Result<BoundCosts> measure_costs(const LoadedScene& loaded);

std::string to_text(const BoundCosts& costs);
nlohmann::json to_json(const BoundCosts& costs);

}  // namespace mixcmp::cli
