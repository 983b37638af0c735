#include <fmt/core.h>

#include <utility>

#include "generator/faces/api/state.hpp"
#include "generator/present/report/plan_report.hpp"
#include "generator/tasks/optimise.hpp"
#include "generator/tasks/planning.hpp"
#include "model/plan/optimise/plan_summary.hpp"

namespace mixcmp::api {
namespace {

namespace fs = std::filesystem;

/// Refuses clocks and precisions that no plan can have. The members of both options have the same
/// names.
optimise::OptimiseOptions internal_options(const PlanOptions& options) {
  optimise::OptimiseOptions choice;
  if (options.first_precision) choice.first_precision = *options.first_precision;
  if (options.last_precision) choice.last_precision = *options.last_precision;
  choice.clocks.lane_mhz = options.lane_mhz;
  choice.clocks.reference_mhz = options.reference_mhz;
  value_or_throw(optimise::check_options(choice));
  return choice;
}

PlanPoint public_point(const optimise::PrecisionPlan& plan) {
  const optimise::PlanSummary summary = optimise::summary_of(plan);
  return {.precision = plan.precision,
          .lanes = summary.lanes,
          .references = summary.references,
          .clock_mhz = summary.clock_mhz,
          .recomputation_rate = summary.recomputation_rate,
          .throughput_per_s = summary.throughput_per_s,
          .kinds = summary.kinds};
}

/// The origin that the plan states: the command that makes it again or, if the caller gave the
/// operands, the library.
std::string origin_of_plan(const SceneState& state) {
  if (state.loaded.scene.data) return tasks::origin("optimise", state.request);
  return fmt::format("the library of mixcmp, on {} comparisons that its caller gave",
                     state.loaded.data->size());
}

/// The text of a plan file; empty for a scene that no file could name.
std::string plan_file_text(const optimise::Optimisation& found, const SceneState& state,
                           const PlanOptions& options) {
  if (state.request.source.text) return "";
  const fs::path place = options.plan_file.empty()
                             ? state.request.source.path.parent_path() / "plan.toml"
                             : options.plan_file;
  const optimise::PlanSource source = value_or_throw(
      optimise::make_plan_source(state.request.source.path, state.request.settings,
                                 state.loaded.scene.system.device, place, origin_of_plan(state)));
  return optimise::plan_toml(found, *found.best(), source);
}

}  // namespace

Plan plan(const Scene& scene, const PlanOptions& options) {
  const SceneState& state = Access::state(scene);
  const optimise::OptimiseOptions choice = internal_options(options);
  const tasks::PlanningRequest request{
      .scene = state.request, .table = options.table, .table_option = "table"};
  const components::Planning planning = value_or_throw(
      tasks::load_planning(request, state.loaded.scene, state.loaded.data_if_any()), state);
  data_of(state, "recomputation rates are measured on data");
  const auto rates =
      value_or_throw(tasks::measure_rates(state.loaded, optimise::inputs_of_lanes(planning.table),
                                          choice, options.progress),
                     state);
  optimise::Optimisation found =
      value_or_throw(optimise::optimise(planning.scene, planning.device, planning.table,
                                        optimise::Rates::of(rates), choice),
                     state);
  tasks::note_use(planning.scene, state.loaded.data_if_any(), found);
  Plan result{.baseline_per_s = optimise::baseline_per_s(found),
              .notes = planning.notes,
              .text = report::to_text(found)};
  result.notes.insert(result.notes.end(), found.notes.begin(), found.notes.end());
  for (const auto& each : found.plans) result.points.push_back(public_point(each));
  if (found.best() != nullptr) {
    result.best = public_point(*found.best());
    result.toml = plan_file_text(found, state, options);
  }
  return result;
}

}  // namespace mixcmp::api
