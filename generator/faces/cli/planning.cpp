#include "generator/faces/cli/planning.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <thread>

#include "generator/faces/cli/characterise_table.hpp"
#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/output.hpp"
#include "model/base/settings/bound_name.hpp"
#include "model/scene/plan.hpp"

namespace mixcmp::cli {
namespace {

/// Tells of a target_mhz that is set and is not the one for which the table was measured.
void tell_of_other_target(const scene::Scene& given, const Planning& planning,
                          const SceneOptions& options) {
  const double measured = planning.scene.system.target_mhz;
  if (given.system.target_mhz == measured || !is_set(options, "system.target_mhz")) return;
  tell_note(fmt::format("registers are placed for {} MHz, which {} was measured for", measured,
                        planning.table_path.filename().string()));
}

}  // namespace

bool is_set(const SceneOptions& options, const std::string& key) {
  return std::any_of(options.settings.begin(), options.settings.end(),
                     [&](const std::string& setting) { return setting.starts_with(key + "="); });
}

void add_planning_options(const Verb& verb, PlanningOptions& options) {
  add_scene_options(verb, options.scene, {"--format", "--inputs", "--lanes", "--references"});
  optimise::OptimiseOptions& choice = options.choice;
  verb.option("--table", options.table,
              "areas and clocks, made by mixcmp characterise (default: "
              "characterisation/SCENE-DEVICE.csv beside the scene)");
  verb.option("--first", choice.first_precision, "the lowest L (default: the lowest there is)")
      .check(within(settings::limits::lane_precision));
  verb.option("--last", choice.last_precision, "the highest L (default: the highest there is)")
      .check(within(settings::limits::lane_precision));
  verb.list_option(
          "--use-inputs",
          [&choice](const std::vector<std::string>& words) {
            choice.inputs = value_or_exit(
                parse_inputs("--use-inputs", words, settings::limits::reference_precision.most));
          },
          "lanes to choose from: exact,rounded,20 (default: all that the table has)")
      .separated_by(',');
  verb.list_option(
          "--use-bounds",
          [&choice](const std::vector<std::string>& names) {
            choice.bounds = value_or_exit(parse_bounds("--use-bounds", names));
          },
          fmt::format("error bounds to choose from: {} (default: all)", settings::bound_names()))
      .separated_by(',');
  verb.list_option(
          "--use-multipliers",
          [&choice](const std::vector<std::string>& names) {
            for (const std::string& name : names) {
              for (const scene::Multipliers each : scene::all_multipliers) {
                if (name == to_string(each)) choice.multipliers.push_back(each);
              }
            }
          },
          "multipliers to choose from: embedded,logic,memory (default: all)")
      .separated_by(',')
      .one_of({"embedded", "logic", "memory"});
  verb.option("--lane-mhz", choice.clocks.lane_mhz, "clock of the lanes, in place of the table's")
      .check(between(optimise::least_mhz, optimise::most_mhz, "MHZ"));
  verb.option("--reference-mhz", choice.clocks.reference_mhz,
              "clock of the references, in place of the table's")
      .check(between(optimise::least_mhz, optimise::most_mhz, "MHZ"));
  verb.flag(
      "--separate-clocks", [&choice] { choice.clocks.domains = optimise::ClockDomains::separate; },
      "count lanes and references at clocks of their own, as the paper does; what generate "
      "writes has one clock");
}

CommandLine planning_command_line(const std::string& verb, const PlanningOptions& options) {
  const optimise::OptimiseOptions usual;
  const optimise::OptimiseOptions& choice = options.choice;
  return command_line(verb, options.scene)
      .add("--table", options.table.string())
      .add("--first", std::to_string(choice.first_precision), std::to_string(usual.first_precision))
      .add("--last", std::to_string(choice.last_precision), std::to_string(usual.last_precision))
      .add("--use-inputs", text_of(choice.inputs))
      .add("--use-bounds", text_of(choice.bounds))
      .add("--use-multipliers", text_of(choice.multipliers))
      .add("--lane-mhz", text_of(choice.clocks.lane_mhz))
      .add("--reference-mhz", text_of(choice.clocks.reference_mhz))
      .add_flag("--separate-clocks", choice.clocks.domains == optimise::ClockDomains::separate);
}

optimise::PlanSource plan_source(const PlanningOptions& options, const std::string& device,
                                 const std::filesystem::path& plan, std::string command) {
  return value_or_exit(optimise::make_plan_source(options.scene.scene, options.scene.settings,
                                                  device, plan, std::move(command)));
}

std::filesystem::path table_of(const PlanningOptions& options, const scene::Scene& scene) {
  return tasks::table_of(options.request(), scene);
}

Result<Done> check_options_of(const PlanningOptions& options) {
  return check_options(options.choice, {.first_precision = "--first",
                                        .last_precision = "--last",
                                        .lane_mhz = "--lane-mhz",
                                        .reference_mhz = "--reference-mhz"});
}

void tell_notes_of(const Planning& planning, const scene::Scene& given,
                   const PlanningOptions& options) {
  tell_of_other_target(given, planning, options.scene);
  for (const std::string& note : planning.notes) tell_note(note);
}

Result<Planning> load_planning(const PlanningOptions& options, const scene::Scene& scene,
                               const data::Comparisons* data) {
  MIXCMP_DO(check_options_of(options));
  MIXCMP_TRY(planning,
             with_shortcuts(tasks::load_planning(options.request(), scene, data), options.scene));
  tell_notes_of(planning, scene, options);
  return planning;
}

Result<std::vector<profile::RateProfile>> measure_rates(const LoadedScene& loaded,
                                                        const std::set<LaneInputs>& inputs,
                                                        const optimise::OptimiseOptions& choice) {
  auto rates = tasks::measure_rates(loaded, inputs, choice, show_share);
  show_progress("");
  return rates;
}

tasks::OptimiseRequest search_request(const PlanningOptions& options, bool predict_only) {
  tasks::OptimiseRequest request{.planning = options.request(),
                                 .choice = options.choice,
                                 .predict_only = predict_only,
                                 .progress = show_share};
  request.synthesis.synthesis.effort = characterise::TimingEffort::area_only;
  request.synthesis.workers = std::max(1u, std::thread::hardware_concurrency());
  request.synthesis.progress = tell_progress;
  if (!predict_only && options.table.empty()) {
    request.synthesis.store = value_or_exit(characterise::default_store_path());
  }
  return request;
}

void end_if_not_confirmed(const tasks::OptimiseResult& result) {
  if (!result.confirmation) return;
  components::CharacteriseReport report;
  report.failed = result.confirmation->failed;
  report.interrupted_by = result.confirmation->interrupted_by;
  end_if_unfinished(report);
  if (result.confirmation->not_done.empty()) return;
  tell_note("areas are predicted, not measured: " + result.confirmation->not_done);
}

}  // namespace mixcmp::cli
