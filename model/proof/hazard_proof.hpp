#pragma once

#include <vector>

#include "model/proof/lane_proof.hpp"

namespace mixcmp::model::proof {

/// That what the lane's operations leave unbuilt cannot occur where every operand passes its check
/// and nothing before was exceptional: the ranges by Gappa, operation by operation, what follows
/// from them by comparing their ends. Nothing for a lane that leaves nothing unbuilt.
std::vector<Finding> prove_hazards(const Lane& lane, const Prove& prove);

}  // namespace mixcmp::model::proof
