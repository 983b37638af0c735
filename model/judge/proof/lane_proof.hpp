#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/judge/proof/claims.hpp"
#include "model/lane/error/lane.hpp"
#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::proof {

enum class Outcome {
  proven,      ///< by Gappa, or by exact arithmetic if the finding says so
  not_proven,  ///< within Gappa's theory, but without a proof: the bound is refused
  out_of_time,
  not_expressible,  ///< outside Gappa's theory; the proof by hand stands
  unchecked,        ///< there is no Gappa, or it gave no verdict
};
std::string_view to_string(Outcome outcome);

struct ScriptResult {
  Outcome outcome;
  std::string detail;  ///< Gappa's words if it is not proven
  std::string file;    ///< the kept script, if any
};
/// Has Gappa prove one script, or returns the result that is known from before.
using Prove = std::function<ScriptResult(const std::string& script)>;

/// A statement and the outcome of its proof.
struct Finding {
  std::string what;
  Outcome outcome;
  std::string detail;
  std::vector<std::string> files = {};  ///< kept scripts
  /// Nothing depends on this finding: it is not proven, and another way to prove the bound has been
  /// taken. The verdict leaves it out.
  bool optional = false;
};

enum class Effort {
  operations,  ///< a lemma per operation
  whole,       ///< a script per combination of zeros for the whole expression, else `operations`
};

/// A step of the proof that no machine has checked. `statement` describes it and, in fixed point,
/// names the page that proves it. In floating point that is docs/error_bounds.md.
struct ByHand {
  std::string theorem;    ///< in the verdict: "8", "2 to 4"
  std::string statement;  ///< for the report

  friend bool operator==(const ByHand&, const ByHand&) = default;
};

struct LaneProof {
  std::string lane;  ///< "s17e8, nearest_even"
  std::string kind;  ///< the kind of error bound
  std::vector<Finding> findings;
  std::vector<ByHand> by_hand;

  /// Whether every finding but the optional ones is proven; the steps `by_hand` do not count.
  bool machine_checked() const;
  /// Something within Gappa's theory is not proven: the bound must not be called certified.
  bool refused() const;
  /// "machine-checked but for theorems 7 and 8, by hand", which names all steps by hand; "refused:
  /// ..."; or "not machine-checked: ...".
  std::string verdict() const;
};

/// The steps of theorem 1 that are proven by hand, for every kind of bound.
ByHand scaling_by_hand();

/// Proves the statements on which the lane's decision rests, and that hazards without hardware
/// cannot occur; see docs/error_bounds.md. A lane of several parts is proven part by part. Theorem
/// 11, by hand, says that the parts' decisions give the lane's.
LaneProof prove_lane(const error::Lane& lane, const Prove& prove, Effort effort);

/// Proves a lane in fixed point, operation by operation; docs/fixed_point.md has the theorems.
LaneProof prove_lane(const fixed::FixedLane& lane, const Prove& prove, Effort effort);

/// Proves a lane with a relative bound from the claims of the analysis, one for each node.
LaneProof prove_relative(const error::Lane& lane, const std::vector<NodeClaim>& claims,
                         const Prove& prove, Effort effort);

}  // namespace mixcmp::proof
