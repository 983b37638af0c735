#pragma once

#include <string>
#include <variant>
#include <vector>

#include "model/error/combined_lane.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::gen {

/// What the operands of software are: the scene's numbers as doubles, exactly.
model::FloatFormat software_format();

/// The least normal binary32 that is not below `value` >= 0; infinite where there is none.
float float_at_least(const mpq_class& value);

/// f and g are never negative: less iff f * ratio < g, greater iff g * ratio < f. `ratio` is at
/// least that of the errors of f and g (docs/error_bounds.md, theorem 3).
struct RatioDecision {
  float ratio;
};

/// A bound holds only where factor * bound node `bound` <= |value|.
struct FloatCondition {
  int bound;
  model::NodeId value;
  float factor;
};

/// less iff difference < -threshold, greater iff difference > threshold, where every condition
/// holds; threshold = factor * the last bound node. The factors make up for the roundings to
/// nearest of the bound itself, and for the guard of theorem 8.
struct ThresholdDecision {
  model::NodeId difference;
  model::BoundGraph bound;  ///< its format means nothing here: nodes are binary32
  float factor;
  std::vector<FloatCondition> conditions;
};

/// A certified decision in binary32 as a CPU computes it, operands rounded first. It holds where no
/// operation is exceptional (model/golden/arithmetic.hpp) and every operand passes its check;
/// docs/baseline.md proves it.
struct PartFilter {
  model::TypedGraph graph;
  std::variant<RatioDecision, ThresholdDecision> decision;
  std::vector<model::RangeCheck> checks;  ///< on operands in software_format()
};

/// All parts of a comparison, with bounds of one kind.
struct FloatFilter {
  model::ErrorBoundKind kind;
  std::vector<PartFilter> parts;
};

/// Why a scene has no filter of some kind.
struct MissingFilter {
  model::ErrorBoundKind kind;
  std::string reason;
};

struct FloatFilters {
  std::vector<FloatFilter> filters;
  std::vector<MissingFilter> missing;
};

/// Every certified filter of the scene's comparison, of each kind at most one; whatever the scene's
/// own lanes are.
FloatFilters float_filters(const model::Scene& scene);

}  // namespace mixcmp::gen
