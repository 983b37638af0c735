#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "generator/faces/cli/options.hpp"
#include "generator/synthesis/components/shortlist.hpp"
#include "model/plan/profile/profile.hpp"

namespace mixcmp::cli {

/// The kinds of lanes that take least of the scene's device for a comparison, by recomputation
/// rates counted on data and by rough areas.
struct Advice {
  std::vector<components::LaneEstimate> best;  ///< of each kind, the cheapest first; may be empty
  double reference_share = 0;                  ///< of the device, for one reference
  std::string device;
  std::string try_first;  ///< a command that measures the advised lanes
  std::string try_now;    ///< a command that verifies a system of such lanes; may be empty
};

/// Weighs every kind of lane that a plan of the scene may use and that `rates` counts. It runs no
/// tool.
Result<Advice> advise(const SceneOptions& options, const LoadedScene& loaded,
                      const std::vector<profile::RateProfile>& rates);

std::string to_text(const Advice& advice);
nlohmann::ordered_json to_json(const Advice& advice);

}  // namespace mixcmp::cli
