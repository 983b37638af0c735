#pragma once

#include <nlohmann/json_fwd.hpp>

#include "generator/faces/cli/options.hpp"
#include "model/cost/devices/area.hpp"

namespace mixcmp::cli {

/// The costs of the scene's lane with one kind of error bound.
struct BoundCost {
  std::string name;
  bool chosen = false;                       ///< `generate` takes this bound
  std::string decision;                      ///< when the lane decides, or why there is none
  std::optional<double> recomputation_rate;  ///< on the scene's data
  std::optional<devices::Area> area;
  std::optional<devices::Area> all_built;  ///< area with the hardware that ranges make unnecessary
  std::optional<Error> why_no_area;        ///< why one of the areas, or both, could not be measured
};

struct BoundCosts {
  std::vector<BoundCost> bounds;
  std::string why_no_rate;
};

/// Measures every certified bound of the scene's lane, and the profiled one where its constants are
/// known or can be measured. It takes seconds per lane, since Yosys maps each.
/// It is an error if the scene leaves the lane's format open.
Result<BoundCosts> measure_costs(const LoadedScene& loaded);

std::string to_text(const BoundCosts& costs);
nlohmann::json to_json(const BoundCosts& costs);

}  // namespace mixcmp::cli
