#pragma once

#include <optional>
#include <string>

#include "model/judge/proof/lane_proof.hpp"
#include "model/lane/error/error_analysis.hpp"
#include "model/lane/error/lane.hpp"

namespace mixcmp::proof {

/// A script that bounds |(true f - true g) - (computed f - computed g)| if every operand passes its
/// check. It treats the whole expression at once, and starts from the ranges that the checks
/// enforce.
/// If there is no script, `obstacle` says why. The `bound` of `range_script` is a dyadic rational.
struct RangeScript {
  std::optional<std::string> script;
  std::string obstacle;
};
RangeScript range_script(const error::Lane& lane, NodeId f, NodeId g, const mpq_class& bound);

/// Proves a running or a constant bound; `analysis` is that of the lane's graph. For a constant
/// bound, Effort::whole first tries one script for the whole expression, then one for each
/// operation.
LaneProof prove_absolute(const error::Lane& lane, const error::ErrorAnalysis& analysis,
                         const Prove& prove, Effort effort);

}  // namespace mixcmp::proof
