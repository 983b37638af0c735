#pragma once

#include <vector>

#include "model/judge/proof/lane_proof.hpp"
#include "model/lane/error/error_analysis.hpp"

namespace mixcmp::proof {

/// The error analysis of a lane, assuming only the input signs that the lane checks.
error::ErrorAnalysis analysis_of(const error::Lane& lane);

/// Proves the rules of theorem 7. A node has a finding for its factor, one for its absolute part as
/// a sum of terms if it has that part, and one for each condition that its rules need. `analysis`
/// is that of the lane's graph.
std::vector<Finding> prove_rules(const error::Lane& lane, const error::ErrorAnalysis& analysis,
                                 const Prove& prove);

/// Checks that a lane with a running bound computes the analysis' bound of f - g, that its guard
/// covers the inflation, and that it tests every condition.
std::vector<Finding> check_running_decision(const error::Lane& lane,
                                            const error::ErrorAnalysis& analysis);

}  // namespace mixcmp::proof
