#pragma once

#include <optional>
#include <string>

#include "model/error/error_analysis.hpp"
#include "model/error/lane.hpp"
#include "model/proof/lane_proof.hpp"

namespace mixcmp::model::proof {

/// That (true f - true g) - (computed f - computed g) is at most `bound` in magnitude wherever
/// every operand passes its check: the whole expression, from the ranges. Or in words, why Gappa
/// has none.
struct RangeScript {
  std::optional<std::string> script;
  std::string obstacle;
};
RangeScript range_script(const Lane& lane, NodeId f, NodeId g, const mpq_class& bound);

/// Of a lane with a running or a constant bound; `analysis`: of its graph.
LaneProof prove_absolute(const Lane& lane, const ErrorAnalysis& analysis, const Prove& prove);

}  // namespace mixcmp::model::proof
