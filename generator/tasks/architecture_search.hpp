#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "generator/synthesis/components/predicted_table.hpp"
#include "generator/tasks/candidate_lanes.hpp"
#include "generator/tasks/optimise.hpp"
#include "model/base/common/workers.hpp"
#include "model/plan/optimise/architecture.hpp"

namespace mixcmp::tasks {

/// Counts the rates of all lanes that a plan of the request may have.
Result<optimise::Rates> count_rates(const OptimiseRequest& request, const LoadedScene& loaded);

/// A note that names the lanes that were counted on a sample of the scene's data; none if all were
/// counted on all data. `rates` are those of count_rates.
std::optional<std::string> note_on_sample(const optimise::Rates& rates);

/// Says that the areas of these devices or families are rough predictions.
std::string rough_note(const std::string& names);

/// The steps of a search on one device, in their order, as its progress names them.
inline constexpr auto areas_predicted = "areas predicted", systems_bounded = "systems bounded",
                      plans_searched = "plans searched";

/// The share of a search that is done when this share of one of its steps is done.
double progress_of_search(const std::string& step, double share);

/// The systems of all architectures of a scene's formulations, with predicted areas. Lanes and
/// references do not depend on the streams around them, so they are predicted once for each
/// formulation.
class ArchitectureSearch {
public:
  /// Counts rates and predicts areas. Rows of the tables beside the scene replace predicted ones if
  /// they describe today's RTL.
  static Result<ArchitectureSearch> make(const OptimiseRequest& request,
                                         const std::vector<Formulation>& formulations);

  /// Goes on with another device, by a name that find_device knows: the settings of its systems
  /// name it. Rates stay, and so do predicted areas if they are those of the device before.
  Result<Done> move_to(const std::string& device);
  const devices::Device& device() const { return device_; }

  /// The best system of each formulation in each interface, by the areas that are known. A
  /// precision of a system is solved only if its bound (optimise::throughput_bound) is half a
  /// percent above the best plan found before: a better plan that is lost is no faster than that.
  /// If the request has a least throughput, the systems have the smallest share of the device, in
  /// steps of 1/64, in which one of them reaches it; it is an error if none does.
  Result<OptimiseResult> best() const;

  /// The same on the whole device, whatever the least throughput: the systems have no plans of
  /// other precisions, and are at most half a percent slower.
  Result<OptimiseResult> fastest() const { return fastest_in(1, request_->progress); }

  /// The same without slack: a system may fill the whole device.
  Result<OptimiseResult> fastest_without_slack() const;

  /// The best system of this interface and formulation in parts of the room that `system` has.
  Result<std::vector<FrontPoint>> front(const PlannedSystem& system) const;

  /// The components on which the plan of a system depends and whose areas are predicted.
  std::set<measured::ComponentKey> predicted_parts(const PlannedSystem& system) const;

  /// Asks for these parts.
  Result<components::ComponentQuery> query_of(const PlannedSystem& system) const;

  /// Puts measured rows in the place of a system's predicted ones; those of lanes and references
  /// also in the other architectures of its formulation.
  void replace(const PlannedSystem& system, const std::vector<measured::Measurement>& rows);

  /// Whether another family's library of unit areas stands in for the device's.
  bool is_rough() const { return predictor_ != nullptr && predictor_->is_rough(); }
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
  /// Adds the systems of all formulations on the device. `known`: those on another one, with the
  /// areas that are predicted for this one.
  Result<Done> add_all(std::vector<System> known);
  Result<std::vector<System>> systems_of(std::size_t formulation) const;
  Result<std::vector<System>> systems_of_streams(std::size_t formulation, ReferenceChoice choice,
                                                 const optimise::OpenKeys& open) const;
  Result<std::vector<System>> systems_of_engine(std::size_t formulation, ReferenceChoice choice,
                                                const optimise::OpenKeys& open) const;
  System system_of(std::size_t formulation, const ReferenceChoice& choice,
                   const optimise::Architecture& architecture, const optimise::OpenKeys& open,
                   measured::Characterisation table) const;
  void use_kept_rows(std::size_t formulation);
  /// A share of the room that the scene's slack leaves, above 0 and at most 1.
  using Share = double;
  Result<OptimiseResult> fastest_in(Share share, const StepProgress& progress) const;
  Result<OptimiseResult> best_in(Share share, const StepProgress& progress) const;
  /// The smallest share in which a system is fast enough, if `best` is the fastest one.
  Result<OptimiseResult> smallest(OptimiseResult best) const;
  std::string name_of(std::size_t formulation) const;
  std::optional<performance::ItemSet> set_of(std::size_t formulation) const;
  /// Adds the formulations that have no plan in this share, with a reason, unless none has one.
  Result<Done> tell_of_others(const std::map<std::size_t, std::size_t>& possible, Share share,
                              OptimiseResult& result) const;
  void tell_progress(const char* step, double done, double of) const;
  /// Work on so many items in threads, which tells its progress if it can.
  static WorkSplit split_of(std::size_t size, const char* step, const StepProgress& progress);
  /// Why no system has lanes and references: names the templates that the library of unit areas
  /// lacks, or is the error unchanged.
  Error explained(const Error& error) const;
  Result<std::vector<Choice>> choices_of(std::size_t system, Share share) const;
  /// The choices of each of these systems, found in threads.
  std::vector<Result<std::vector<Choice>>> choices_of(const std::vector<std::size_t>& systems,
                                                      Share share,
                                                      const StepProgress& progress) const;
  Result<PlannedSystem> planned(std::size_t system, Share share,
                                optimise::OptimiseOptions options) const;
  Result<std::vector<PlannedSystem>> fastest_of(std::vector<Choice> choices, Share share,
                                                const StepProgress& progress) const;

  const OptimiseRequest* request_;
  devices::Device device_;
  components::PredictedArea area_of_;
  std::shared_ptr<components::AreaPredictor> predictor_;  ///< null if the request has its own
  std::vector<Formulation> formulations_;
  std::vector<optimise::Rates> rates_;  ///< of each formulation
  std::vector<System> systems_;
  bool has_measured_rows_ = false;  ///< in the systems' tables
  std::vector<std::string> notes_;
  std::set<std::string> sample_notes_;  ///< on rates, which no device changes
};

}  // namespace mixcmp::tasks
