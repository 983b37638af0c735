#pragma once

#include <optional>
#include <vector>

#include "model/judge/proof/lane_proof.hpp"
#include "model/lane/error/error_analysis.hpp"

namespace mixcmp::proof {

/// Whether the bound of a lane's criterion is a number, with neither guard nor conditions.
bool is_constant(const error::AbsoluteBoundCriterion& criterion);

/// A number that |f - g|, the unrounded difference of the computed f and g, exceeds whenever a lane
/// with a constant bound decides: the constant as the hardware holds it, times 1 + 2^-(P+2). None
/// if the constant is infinite: the lane then decides nothing.
std::optional<mpq_class> decided_beyond(const error::Lane& lane);

/// Proves that, if every operand passes its check, the lane's constant is at least the analysis'
/// bound of f - g, and every condition of the analysis holds. `analysis` is that of the lane's
/// graph. The ranges of the values in the bound are proven operation by operation.
std::vector<Finding> prove_constant(const error::Lane& lane, const error::ErrorAnalysis& analysis,
                                    const Prove& prove);

}  // namespace mixcmp::proof
