#pragma once

#include <string>
#include <variant>
#include <vector>

#include "model/lane/error/certified_lane.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::software {

/// The format of the software's operands, binary64: it must hold the scene's numbers exactly.
FloatFormat software_format();

/// The least normal binary32 that is not below `value` >= 0; infinite if there is none.
float float_at_least(const mpq_class& value);

/// Decides for f and g that are never negative: less iff f * ratio < g, greater iff g * ratio < f.
/// `ratio` is at least R of docs/error_bounds.md, theorem 3.
struct RatioCriterion {
  float ratio;
};

/// A condition of a bound: the bound holds only if factor * bound node `bound` <= |value|.
struct FloatCondition {
  int bound;
  NodeId value;
  float factor;
};

/// Decides if every condition holds: less iff difference < -threshold, greater iff difference >
/// threshold, where threshold = factor * the last bound node. The factors make up for the roundings
/// to nearest of the bound itself, and for the guard of theorem 8.
struct ThresholdCriterion {
  NodeId difference;
  error::BoundGraph bound;  ///< its nodes are computed in binary32; its own format is not used
  float factor;
  std::vector<FloatCondition> conditions;
};

/// A certified criterion in binary32 as a CPU computes it; operands are rounded first. It holds if
/// no operation is exceptional (model/judge/golden/arithmetic.hpp) and every operand passes its
/// check. docs/baseline.md proves it.
struct PartFilter {
  TypedGraph graph;
  std::variant<RatioCriterion, ThresholdCriterion> criterion;
  std::vector<error::RangeCheck> checks;  ///< on operands in software_format()
};

/// All parts of a comparison, with bounds of one kind.
struct FloatFilter {
  BoundKind kind;
  std::vector<PartFilter> parts;
};

/// A kind of filter that a scene cannot have, and the reason.
struct MissingFilter {
  BoundKind kind;
  std::string reason;
};

struct FloatFilters {
  std::vector<FloatFilter> filters;
  std::vector<MissingFilter> missing;
};

/// The certified filters of the scene's comparison, at most one of each kind. The scene's own lanes
/// have no influence on them.
FloatFilters float_filters(const scene::Scene& scene);

}  // namespace mixcmp::software
