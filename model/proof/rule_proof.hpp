#pragma once

#include <vector>

#include "model/error/error_analysis.hpp"
#include "model/proof/lane_proof.hpp"

namespace mixcmp::model::proof {

/// The analysis of a lane with no more signs than it checks.
ErrorAnalysis analysis_of(const Lane& lane);

/// One finding or two a node: its factor, and its absolute part as a sum of terms; then the
/// conditions that the rules need. `analysis`: of the lane's graph.
std::vector<Finding> prove_rules(const Lane& lane, const ErrorAnalysis& analysis,
                                 const Prove& prove);

/// Checks that a lane with a running bound computes the analysis' bound of f - g, guards the
/// slack_factor, and asks for every condition.
std::vector<Finding> check_running_decision(const Lane& lane, const ErrorAnalysis& analysis);

}  // namespace mixcmp::model::proof
