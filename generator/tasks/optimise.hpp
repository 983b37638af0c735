#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/synthesis/components/characterise.hpp"
#include "generator/synthesis/components/predicted_table.hpp"
#include "generator/tasks/planning.hpp"
#include "model/plan/optimise/front.hpp"
#include "model/plan/optimise/optimise.hpp"

namespace mixcmp::tasks {

struct OptimiseRequest {
  /// With a table, a file or a folder of default tables, plans are made of its rows and of no
  /// others. Without one areas are predicted, and the components of the best plan are synthesised.
  PlanningRequest planning;
  optimise::OptimiseOptions choice;
  std::optional<optimise::Rates> rates = {};  ///< in place of those of the scene's data
  bool predict_only = false;                  ///< nothing is synthesised
  /// The smallest system with so many comparisons per second is wanted. 0: the fastest. Not by a
  /// table.
  double at_least_per_s = 0;
  std::string at_least_option = "at_least";  ///< the name of `at_least_per_s` in errors
  /// How components are synthesised; the query in it is not used.
  components::CharacteriseOptions synthesis = {};
  /// Predicts areas; empty: components::AreaPredictor.
  components::PredictedArea area_of = {};
  StepProgress progress = {};
  /// Called with the plan on predicted areas before components are synthesised: their number.
  std::function<void(double per_s, int components)> confirming = {};
};

/// The best plans of one formulation of the comparison in one interface.
struct PlannedSystem {
  std::string formulation;            ///< "[comparison]", "variant root, one tier"
  std::string interface;              ///< see optimise::interface_of
  std::vector<std::string> settings;  ///< those that make its scene, beyond the request's
  std::size_t number = 0;             ///< in the search that found it
  components::Planning known;
  optimise::Optimisation found;

  double throughput_per_s() const;
};

/// The index of the fastest system; of equally fast ones with the same counters, the smallest.
std::size_t best_of(const std::vector<PlannedSystem>& systems);

/// How far a plan relies on predicted areas.
struct Confirmation {
  double predicted_per_s = 0;  ///< of the first plan, on predicted areas only
  bool is_measured = false;    ///< all components of the chosen plan have measured areas
  int rounds = 0;              ///< of synthesis
  std::string not_done;        ///< why nothing was synthesised, if it was to be
  std::vector<characterise::FailedJob> failed;
  int interrupted_by = 0;  ///< number of the signal that interrupted the synthesis; 0: none
};

using optimise::FrontPoint;

struct OptimiseResult {
  std::vector<PlannedSystem> systems;
  std::size_t chosen = 0;                               ///< the fastest
  std::vector<std::pair<std::string, Error>> left_out;  ///< formulations without a plan
  std::optional<Confirmation> confirmation;             ///< none: planned by a table
  std::vector<FrontPoint> front;                        ///< by share; none: planned by a table
  std::vector<std::string> notes;                       ///< for the user

  const PlannedSystem& best() const { return systems[chosen]; }
};

/// Finds the system with the most comparisons per second: its formulation, its architecture, and
/// its numbers and kinds of lanes and references. It is an error if no formulation has a plan.
Result<OptimiseResult> optimise(const OptimiseRequest& request, const LoadedScene& loaded);

/// The settings of each variant of the comparison that the request leaves open, beyond the
/// request's. A table file, or rates given by hand, belong to one formulation and leave none open.
std::vector<std::vector<std::string>> settings_of_variants(const OptimiseRequest& request,
                                                           const scene::Scene& scene);

/// The rates of the lanes of a table: those of the request, or counted.
Result<optimise::Rates> rates_by_table(const OptimiseRequest& request, const LoadedScene& loaded,
                                       const measured::Characterisation& table);

/// The best systems of the scene itself, not of its variants, in parts of the device, on predicted
/// areas: those of the interface in which the fastest one is. By share; empty if nothing fits.
Result<std::vector<FrontPoint>> front_of(const OptimiseRequest& request, const LoadedScene& loaded);

class ArchitectureSearch;
/// Confirms the best system of a search by synthesis, unless the request only predicts, and finds
/// the systems in parts of its room.
Result<OptimiseResult> completed(const OptimiseRequest& request, const LoadedScene& loaded,
                                 ArchitectureSearch& search, OptimiseResult predicted);

/// The request's settings with those of a system: `generate` makes it of these.
std::vector<std::string> settings_of(const OptimiseRequest& request, const PlannedSystem& system);

/// Notes in the report of a plan what its use asks for: how many operands have to arrive or, in a
/// pairwise engine, how long lanes wait for items. `data` may be null.
void note_use(const scene::Scene& scene, const data::Comparisons* data,
              optimise::Optimisation& found);

/// One formulation: the comparison or a variant, with or without its second tier.
struct Formulation {
  LoadedScene loaded;
  std::vector<std::string> settings;  ///< those that make it, beyond the request's
  std::string name;
  bool is_engine_added = false;  ///< the request has no engine, but its data permit this one
};

/// The formulations that the request leaves open.
Result<std::vector<Formulation>> formulations_of(const OptimiseRequest& request,
                                                 const LoadedScene& loaded);

}  // namespace mixcmp::tasks
