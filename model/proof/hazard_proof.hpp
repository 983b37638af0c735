#pragma once

#include <vector>

#include "model/proof/lane_proof.hpp"

namespace mixcmp::model::proof {

/// Proves that what the lane's operations leave unbuilt cannot occur where every operand passes its
/// check and nothing before was exceptional. Gappa proves the ranges, operation by operation; what
/// follows from them is found by comparing their ends. A lane that leaves nothing unbuilt has no
/// findings.
std::vector<Finding> prove_hazards(const Lane& lane, const Prove& prove);

}  // namespace mixcmp::model::proof
