#pragma once

#include <vector>

#include "model/judge/proof/lane_proof.hpp"

namespace mixcmp::proof {

/// Proves that the hazards for which the lane's operations have no hardware cannot occur if every
/// operand passes its check and no earlier operation was exceptional. Gappa proves the ranges,
/// operation by operation; conclusions compare the ends of ranges. A lane with hardware for all
/// hazards has no findings.
std::vector<Finding> prove_hazards(const error::Lane& lane, const Prove& prove);

}  // namespace mixcmp::proof
