#pragma once

#include <optional>
#include <string>

#include "model/error/error_analysis.hpp"
#include "model/error/lane.hpp"
#include "model/proof/lane_proof.hpp"

namespace mixcmp::model::proof {

/// A script that says that (true f - true g) - (computed f - computed g) is at most `bound`, a
/// dyadic rational, in magnitude wherever every operand passes its check: the whole expression,
/// from the ranges that the checks enforce. `obstacle` says why there is none.
struct RangeScript {
  std::optional<std::string> script;
  std::string obstacle;
};
RangeScript range_script(const Lane& lane, NodeId f, NodeId g, const mpq_class& bound);

/// Proves a running or a constant bound; `analysis` is that of the lane's graph. Effort::whole
/// first tries one script for the whole expression of a constant, then one for each operation.
LaneProof prove_absolute(const Lane& lane, const ErrorAnalysis& analysis, const Prove& prove,
                         Effort effort);

}  // namespace mixcmp::model::proof
