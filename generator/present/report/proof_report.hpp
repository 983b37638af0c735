#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "generator/present/table/table.hpp"
#include "model/judge/proof/lane_proof.hpp"

namespace mixcmp::report {

/// A row per finding, then one per step that is proven only by hand.
table::Table findings_of(const proof::LaneProof& proof);
/// The findings as text, and the verdict on the whole proof. `gappa`: its version; empty if it is
/// not installed.
std::string to_text(const proof::LaneProof& proof, const std::string& gappa);
nlohmann::ordered_json to_json(const proof::LaneProof& proof, const std::string& gappa);

}  // namespace mixcmp::report
