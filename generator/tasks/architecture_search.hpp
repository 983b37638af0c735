#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "generator/synthesis/components/predicted_table.hpp"
#include "generator/tasks/candidate_lanes.hpp"
#include "generator/tasks/optimise.hpp"
#include "model/plan/optimise/architecture.hpp"

namespace mixcmp::tasks {

/// What a pairwise engine compares on these data; none without pairs.
std::optional<performance::ItemSet> set_of(const data::Comparisons* data);

/// Counts the rates of all lanes that a plan of the request may have.
Result<optimise::Rates> count_rates(const OptimiseRequest& request, const LoadedScene& loaded);

/// The systems of all architectures of a scene's formulations, with predicted areas. Lanes and
/// references do not depend on the streams around them, so they are predicted once for each
/// formulation.
class ArchitectureSearch {
public:
  /// Counts rates and predicts areas. Rows of the tables beside the scene replace predicted ones if
  /// they describe today's RTL.
  static Result<ArchitectureSearch> make(const OptimiseRequest& request,
                                         const std::vector<Formulation>& formulations);

  /// The best system of each formulation in each interface, by the areas that are known. A
  /// precision of a system is solved only if its bound (optimise::throughput_bound) is half a
  /// percent above the best plan found before: a better plan that is lost is no faster than that.
  /// If the request has a least throughput, the systems have the smallest share of the device, in
  /// steps of 1/64, in which one of them reaches it; it is an error if none does.
  Result<OptimiseResult> best() const;

  /// The best system of this interface and formulation in parts of the room that `system` has.
  Result<std::vector<FrontPoint>> front(const PlannedSystem& system) const;

  /// The components on which the plan of a system depends and whose areas are predicted.
  std::set<measured::ComponentKey> predicted_parts(const PlannedSystem& system) const;

  /// Asks for these parts.
  Result<components::ComponentQuery> query_of(const PlannedSystem& system) const;

  /// Puts measured rows in the place of a system's predicted ones; those of lanes and references
  /// also in the other architectures of its formulation.
  void replace(const PlannedSystem& system, const std::vector<measured::Measurement>& rows);

  const std::vector<std::string>& notes() const { return notes_; }

private:
  struct System {
    std::size_t formulation;
    std::vector<std::string> settings;
    std::string interface;
    scene::Scene scene;
    measured::Characterisation table;
    LeftOutLanes left_out = {};
  };
  /// A precision of a system, which may be solved.
  struct Choice {
    std::size_t system;
    int precision;
    double bound_per_s;
  };

  explicit ArchitectureSearch(const OptimiseRequest& request) : request_(&request) {}
  Result<Done> choose_areas();
  Result<Done> count_rates(const Formulation& formulation);
  Result<Done> add(const Formulation& formulation);
  Result<Done> add_streams(const Formulation& formulation, const optimise::OpenKeys& open);
  Result<Done> add_engine(const Formulation& formulation, const optimise::OpenKeys& open);
  void add_system(const Formulation& formulation, const optimise::Architecture& architecture,
                  const optimise::OpenKeys& open, measured::Characterisation table);
  void use_kept_rows(const Formulation& formulation);
  /// A share of the room that the scene's slack leaves, above 0 and at most 1.
  using Share = double;
  Result<OptimiseResult> best_in(Share share) const;
  std::string name_of(std::size_t formulation) const;
  /// Adds the formulations that have no plan in this share, with a reason, unless none has one.
  Result<Done> tell_of_others(const std::map<std::size_t, std::size_t>& possible, Share share,
                              OptimiseResult& result) const;
  void tell_progress(const char* step, std::size_t done, std::size_t of) const;
  /// Why no system has lanes and references: names the templates that the library of unit areas
  /// lacks, or is the error unchanged.
  Error explained(const Error& error) const;
  Result<std::vector<Choice>> choices_of(std::size_t system, Share share) const;
  Result<PlannedSystem> planned(std::size_t system, Share share,
                                optimise::OptimiseOptions options) const;
  Result<std::vector<PlannedSystem>> fastest_of(std::vector<Choice> choices, Share share) const;

  const OptimiseRequest* request_;
  devices::Device device_;
  components::PredictedArea area_of_;
  std::shared_ptr<components::AreaPredictor> predictor_;  ///< null if the request has its own
  std::vector<Formulation> formulations_;
  std::vector<optimise::Rates> rates_;  ///< of each formulation
  std::vector<System> systems_;
  std::vector<std::string> notes_;
};

}  // namespace mixcmp::tasks
