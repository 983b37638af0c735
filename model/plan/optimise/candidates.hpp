#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/plan/optimise/optimise.hpp"

namespace mixcmp::optimise {

/// The data from which all problems of one scene are made.
struct PlanningInputs {
  const scene::Scene& scene;
  const measured::Characterisation& table;
  const Rates& rates;
  const OptimiseOptions& options;
  std::optional<measured::Lane> second_tier;  ///< see second_tier_lane

  scene::EngineKind engine() const { return scene.system.engine.kind; }
  bool has_engine() const { return engine() != scene::EngineKind::none; }
  bool has_second_lanes() const { return second_tier && !has_engine(); }
};

/// Facts for the user that come up while problems are made.
struct Findings {
  ClockBasis basis = ClockBasis::given;  ///< the least reliable source of a clock
  std::set<std::string> notes;
  /// The parts of every system for which the table has no row, such as "a crossbar".
  std::set<std::string> missing;
};

using Rows = std::vector<const measured::Measurement*>;

/// The rows that a plan may use.
struct Candidates {
  std::map<int, Rows> lanes;  ///< by precision; lanes one by one, or in an engine segments
  Rows references;
};

/// The table's lanes and references that the scene and the options admit. If any lane has a
/// measured clock, lanes without one are left out: their clock would be the target, which would
/// beat every measurement. The same holds for references.
Candidates candidates_of(const PlanningInputs& inputs, Findings& findings);

}  // namespace mixcmp::optimise
