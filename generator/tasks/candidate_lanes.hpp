#pragma once

#include <set>
#include <string>
#include <vector>

#include "generator/synthesis/components/component_list.hpp"
#include "model/cost/measured/measurement.hpp"
#include "model/plan/optimise/architecture.hpp"
#include "model/plan/optimise/optimise.hpp"
#include "model/plan/optimise/rates.hpp"
#include "model/scene/scene.hpp"

/// The lanes among which a search over architectures chooses.
namespace mixcmp::tasks {

/// The bounds of lanes that a plan of the scene may use.
std::vector<Bound> bounds_for(const optimise::OptimiseOptions& choice, const scene::Scene& scene);
/// The inputs of lanes that a plan may use.
std::vector<LaneInputs> inputs_for(const optimise::OptimiseOptions& choice);

/// All lanes and references that a plan of the scene may use, and the crossbars between which plans
/// interpolate.
components::ComponentQuery query_for(const optimise::OptimiseOptions& choice,
                                     const scene::Scene& scene, const optimise::OpenKeys& open);

/// A lane without products has no multipliers in its row, and any kind of them in a query.
measured::Lane as_asked(measured::Lane lane);

/// The lanes whose rate is known and that are not plainly worse than one of fewer digits: where
/// none of the counted comparisons is undecided, more digits cost area and save nothing.
Result<std::set<measured::Lane>> useful_lanes(const scene::Scene& scene,
                                              const components::ComponentQuery& query,
                                              const optimise::Rates& rates);

/// Lanes of known rates that a search leaves out before it plans.
struct LeftOutLanes {
  std::set<int> precisions;  ///< theirs
  std::string why = {};      ///< for the user
};

/// Systems with references, or without any.
struct ReferenceChoice {
  scene::Scene scene;
  components::ComponentQuery query;        ///< for their components
  std::vector<std::string> settings = {};  ///< with which the scene's file gives this scene
};

/// The choices of a scene, one unless operands arrive in fixed point and the number of references
/// is open: then there are exact lanes without references and other lanes with them. An arg-min
/// engine always has some. It is an error if there is no choice.
Result<std::vector<ReferenceChoice>> reference_choices(const scene::Scene& scene,
                                                       components::ComponentQuery query,
                                                       const optimise::OpenKeys& open);

/// The lanes of the query that are not among `lanes` and whose rates are known.
Result<LeftOutLanes> left_out_lanes(const scene::Scene& scene,
                                    const components::ComponentQuery& query,
                                    const optimise::Rates& rates,
                                    const std::set<measured::Lane>& lanes, std::string why);

/// Says in a result, at the precisions where lanes are left out, that the plan there, or that there
/// is none, is of the others.
void tell_of(const LeftOutLanes& left_out, optimise::Optimisation& found);

/// One lane for each number of slots that lanes of these rows need.
std::set<measured::Lane> lanes_by_slots(const measured::Characterisation& table,
                                        const scene::Scene& scene);

/// Lanes with some more digits than these promising ones: the memory of an engine serves at most
/// one undecided comparison a cycle, so that large engines need more digits than few lanes do.
Result<std::set<measured::Lane>> with_longer(const std::set<measured::Lane>& promising,
                                             const scene::Scene& scene,
                                             const components::ComponentQuery& query);

}  // namespace mixcmp::tasks
