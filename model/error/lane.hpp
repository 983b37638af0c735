#pragma once

#include <string>
#include <variant>
#include <vector>

#include "model/expression/typed_graph.hpp"

namespace mixcmp::model {

/// Certified decision on packed encodings. With key(x) = +-magnitude bits of x by its sign, the
/// lane is decided iff nothing is exceptional and |key(f) - key(g)| >= guard_ulp; the verdict is
/// then the order of the keys. guard_ulp = 0 means f and g are exact: all is decided, equality too.
struct UlpDistanceDecision {
  Bits guard_ulp;
  /// f and g are never negative: the hardware compares plain magnitudes.
  bool nonnegative;
  /// Inputs whose range the proof needs to be non-negative: a set sign bit is exceptional.
  std::vector<int> nonnegative_inputs;
};

/// The paper's decision, equations 1-3, in the lane's format: D = f - g, E = |f|*RE_f + |g|*RE_g,
/// greater iff D - E > 0, less iff D + E < 0. The nodes are part of the lane's graph.
struct IntervalDecision {
  NodeId minimum;  ///< D - E
  NodeId maximum;  ///< D + E
  mpq_class relative_error_f;
  mpq_class relative_error_g;
};

/// One reduced-precision datapath: what it computes and when it dares to decide.
struct Lane {
  TypedGraph graph;
  std::variant<UlpDistanceDecision, IntervalDecision> decision;

  bool certified() const { return std::holds_alternative<UlpDistanceDecision>(decision); }
};

/// When the lane decides, for a report: "certified: where f and g are 7 ulp apart or more".
std::string describe_decision(const Lane& lane);

}  // namespace mixcmp::model
