#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "model/judge/proof/lane_proof.hpp"

namespace mixcmp::report {

/// A line per finding, then the verdict and the steps that are proven only by hand. `gappa`: its
/// version; empty if it is not installed.
std::string to_text(const proof::LaneProof& proof, const std::string& gappa);
nlohmann::ordered_json to_json(const proof::LaneProof& proof, const std::string& gappa);

}  // namespace mixcmp::report
