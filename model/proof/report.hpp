#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "model/proof/lane_proof.hpp"

namespace mixcmp::model::proof {

/// A line per finding, then the verdict and what remains by hand. `gappa`: its version; empty:
/// there is none.
std::string to_text(const LaneProof& proof, const std::string& gappa);
nlohmann::ordered_json to_json(const LaneProof& proof, const std::string& gappa);

}  // namespace mixcmp::model::proof
