#include "generator/faces/cli/report_maker.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/lane_traffic.hpp"
#include "generator/faces/cli/profiling.hpp"
#include "generator/faces/cli/prove.hpp"
#include "generator/hardware/emit/system.hpp"
#include "generator/hardware/emit/version.hpp"
#include "generator/tasks/optimise.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/quote.hpp"
#include "model/scene/plan.hpp"

namespace mixcmp::cli {

using report::IfThere;
using report::Missing;

namespace {

/// An error as a page states it, without paths and options: the field, the message, and the file's
/// name. The full error goes to standard error.
std::string on_page(const Error& error) {
  return Error{.file = std::filesystem::path(error.file).filename().string(),
               .line = error.line,
               .field = error.field,
               .message = error.message}
      .to_string();
}

/// The name of the scene's device, also where that is a file.
std::string device_name(const scene::Scene& scene) {
  const auto device = devices::find_device(scene.system.device);
  return device.ok() ? device->name : scene.system.device;
}

}  // namespace

ReportMaker::ReportMaker(const PlanningOptions& planning, const LoadedScene& loaded,
                         ReportChoice choice)
    : planning_options_(planning),
      loaded_(loaded),
      choice_(std::move(choice)),
      system_(build_system()) {}

page::Page ReportMaker::make() {
  const scene::Summary summary = summarise(loaded_.scene, data());
  page::Page page{.title = loaded_.scene.name,
                  .subtitle = subtitle(),
                  .sections = {report::request_section(summary, made_by())},
                  .footer = fmt::format("mixcmp {}: {}", emit::version, choice_.command)};
  page.sections.push_back(report::proof_section(proofs()));
  add_measurements(page);
  page.sections.push_back(report::system_section(system_));
  if (shows("waves")) page.sections.push_back(report::wave_section(traffic()));
  return page;
}

/// Adds the measurements and the conclusions from them: the profile, the trade, the plan.
void ReportMaker::add_measurements(page::Page& page) {
  if (shows("profile")) {
    profile_ = measure();
    page.sections.push_back(report::profile_section(profile_, choice_.beside_paper));
  }
  std::optional<IfThere<optimise::Optimisation>> plans;
  if (shows("plan")) plans = find_plans();
  const auto* found = plans ? std::get_if<optimise::Optimisation>(&*plans) : nullptr;
  if (const auto* measured = std::get_if<report::ProfileReport>(&profile_)) {
    page.sections.push_back(report::trade_section(weigh(loaded_, *measured, {}, {}).trades, found));
  }
  if (plans) {
    page.sections.push_back(report::plan_section(loaded_.scene, *plans, front(), published()));
  }
}

std::string ReportMaker::subtitle() const {
  const std::string format = loaded_.scene.reduced.format_name();
  const std::string rest = loaded_.scene.reference_count() == 0
                               ? "and leave the rest undecided"
                               : fmt::format("references in {} decide the rest",
                                             design::datapath_format(loaded_.scene).name());
  return fmt::format(
      "A mixed-precision comparison: lanes decide in {} where that is certainly right, {}.",
      format == "auto" ? "a reduced precision" : format, rest);
}

table::Lines ReportMaker::made_by() const {
  return {{"command", choice_.command}, {"version", fmt::format("mixcmp {}", emit::version)}};
}

Missing ReportMaker::not_made(const std::string& section, const std::string& why,
                              const std::string& makes_it) {
  not_done_.push_back(section + ": " + why);
  return {why, makes_it};
}

Missing ReportMaker::not_made(const std::string& section, const Error& error,
                              const std::string& makes_it) {
  return {on_page(error), not_made(section, error.to_string(), makes_it).command};
}

IfThere<report::BuiltSystem> ReportMaker::build_system() {
  const auto design = design_of(planning_options_.scene, loaded_);
  if (!design.ok()) return no_system(design.error());
  auto system = emit::generate_system(*design, "");
  if (!system.ok()) return no_system(system.error());
  auto scheduled = emit::schedule_system(*design);
  if (!scheduled.ok()) return no_system(scheduled.error());
  return report::BuiltSystem{*design, system->signature, std::move(scheduled).value(),
                             system->notes};
}

Missing ReportMaker::no_system(const Error& error) {
  const std::string plan = loaded_.scene.name + "_plan.toml";
  return not_made("system", error,
                  fmt::format("{} -o {}\nmixcmp report {}", command("optimise"), plan, plan));
}

IfThere<std::vector<report::ProvenLanes>> ReportMaker::proofs() const {
  const auto* system = std::get_if<report::BuiltSystem>(&system_);
  if (system == nullptr) return std::get<Missing>(system_);
  std::vector<report::ProvenLanes> proven;
  for (const design::NamedLane& named : named_lanes(system->design)) {
    const design::Lane& lane = named.lane;
    report::ProvenLanes& each = proven.emplace_back();
    each.name = named.name;
    each.decision = design::describe_criterion(lane);
    each.certified = design::is_certified(lane);
    if (!each.certified) continue;
    QuickProof quick = prove_quickly(planning_options_.scene.scene, lane);
    each.proof = std::move(quick.proof);
    each.gappa = std::move(quick.gappa);
  }
  return proven;
}

/// Measures errors and rates, those of the plan's lanes among them.
IfThere<report::ProfileReport> ReportMaker::measure() {
  const scene::Scene& scene = loaded_.scene;
  if (!loaded_.data) {
    return not_made("profile", "The scene has no data: nothing can be counted or simulated.",
                    "# in the scene\n[data]\nfile = \"...\"");
  }
  profile::ProfileOptions options;
  options.last_precision = settings::lane_precisions(scene.reference.format).most;
  if (const auto possible = check_profile(scene, options); !possible.ok()) {
    return not_made("profile", possible.error(), "");
  }
  std::set<LaneInputs> counted = {scene.reduced.inputs};
  if (shows("plan") && shows("front")) counted.insert({LaneInputs::exact, LaneInputs::rounded});
  if (const Planning* planning = plannable())
    counted.merge(optimise::inputs_of_lanes(planning->table));
  report::ProfileReport measured = measure_profile(loaded_, counted, options);
  all_rates_ = measured.rates;
  std::erase_if(measured.rates, [&](const profile::RateProfile& rates) {
    return rates.inputs != scene.reduced.inputs;
  });
  return measured;
}

/// The table of areas that plans are made from; null where there is none.
const Planning* ReportMaker::plannable() {
  if (!shows("plan")) return nullptr;
  if (!planning_) {
    PlanningOptions options = planning_options_;
    if (options.table.empty()) options.table = table_beside_a_layer();
    planning_.emplace(load_planning(options, loaded_.scene, data()));
  }
  return planning_->ok() ? &planning_->value() : nullptr;
}

/// The table beside the scene, or beside a scene that this plan is laid over. If there is none, the
/// path that it would have beside the scene.
std::filesystem::path ReportMaker::table_beside_a_layer() const {
  const SceneOptions& options = planning_options_.scene;
  const scene::Scene& scene = loaded_.scene;
  const std::string name = device_name(scene);
  const auto read = scene::read_scene_settings(options.scene, options.settings);
  for (const std::filesystem::path& layer : value_or_exit(read).files) {
    const std::filesystem::path table = optimise::default_table(layer, scene, name);
    if (path_exists(table)) return table;
  }
  return optimise::default_table(options.scene, scene, name);
}

/// Whether the file is a plan whose areas are measured: `optimise` has left them in the store.
bool ReportMaker::is_measured_plan() const {
  if (!loaded_.scene.plan) return false;
  const auto& values = loaded_.scene.plan->values;
  return std::any_of(values.begin(), values.end(), [](const auto& value) {
    return value.first == "areas" && value.second != in_quotes("predicted");
  });
}

/// Plans without a table. The areas of a measured plan's components are those of the store; others
/// are predicted, so that nothing is synthesised.
IfThere<optimise::Optimisation> ReportMaker::search_plans() {
  auto result = tasks::optimise(search_request(planning_options_, !is_measured_plan()), loaded_);
  show_progress("");
  if (!result.ok()) return not_made("plan", result.error(), command("optimise"));
  const tasks::Confirmation& confirmation = *result->confirmation;
  const auto& failed = confirmation.failed;
  if (!failed.empty() && confirmation.interrupted_by == 0) {
    return not_made("plan", failed.front().label + ": " + failed.front().message,
                    command("optimise"));
  }
  end_if_not_confirmed(*result);
  const tasks::PlannedSystem& best = result->best();
  optimise::Optimisation plans = best.found;
  if (!result->confirmation->is_measured) {
    plans.notes.emplace_back("areas are predicted; mixcmp optimise measures those of its plan");
  }
  plans.notes.push_back("the system around the lanes: " + best.interface);
  return plans;
}

IfThere<optimise::Optimisation> ReportMaker::find_plans() {
  if (!loaded_.data) {
    return not_made("plan", "A plan needs recomputation rates, and the scene has no data.", "");
  }
  const Planning* planning = plannable();
  if (planning == nullptr) {
    if (!planning_options_.table.empty()) fail(planning_->error());
    if (!path_exists(table_beside_a_layer())) return search_plans();
    return not_made("plan", planning_->error(), command("characterise"));
  }
  show_progress("finding plans");
  auto found = optimise::optimise(planning->scene, planning->device, planning->table, rates(),
                                  planning_options_.choice);
  show_progress("");
  if (!found.ok()) return not_made("plan", found.error(), command("optimise"));
  optimise::Optimisation plans = std::move(found).value();
  plans.notes.insert(plans.notes.begin(), planning->notes.begin(), planning->notes.end());
  return plans;
}

/// Whether the rates that were measured are those of plans: the scene gives none of its constants.
bool ReportMaker::has_rates() const {
  const scene::ReducedSpec& reduced = loaded_.scene.reduced;
  return !all_rates_.empty() && !reduced.relative_error_f && !reduced.relative_error_g;
}

optimise::Rates ReportMaker::rates() {
  if (has_rates()) return optimise::Rates::of(all_rates_);
  return optimise::Rates::of(value_or_exit(measure_rates(
      loaded_, optimise::inputs_of_lanes(plannable()->table), planning_options_.choice)));
}

/// The front of the scene's own formulation; none where it is left out, or has no rates.
std::optional<IfThere<report::Front>> ReportMaker::front() {
  if (!shows("front") || !loaded_.data) return std::nullopt;
  tasks::OptimiseRequest request{.planning = planning_options_.request(),
                                 .choice = planning_options_.choice,
                                 .predict_only = true,
                                 .progress = show_share};
  if (has_rates()) request.rates = optimise::Rates::of(all_rates_);
  auto front = tasks::front_of(request, loaded_);
  show_progress("");
  if (!front.ok()) return not_made("front", front.error(), "");
  return std::move(front).value();
}

std::optional<optimise::PublishedFigures> ReportMaker::published() const {
  if (!choice_.beside_paper) return std::nullopt;
  const auto device = devices::find_device(loaded_.scene.system.device);
  return device.ok() ? optimise::published(device->name) : std::nullopt;
}

IfThere<report::LaneTraffic> ReportMaker::traffic() {
  const auto* system = std::get_if<report::BuiltSystem>(&system_);
  if (system == nullptr) return std::get<Missing>(system_);
  if (!loaded_.data) return not_made("waves", "The scene has no data to simulate.", "");
  show_progress("simulating a lane");
  auto traffic = lane_traffic(system->design, *loaded_.data);
  if (traffic.ok()) return std::move(traffic).value();
  if (traffic.error().kind != ErrorKind::missing_tool) fail(traffic.error());
  return not_made("waves", traffic.error(), command("verify") + " --trace waves.fst");
}

}  // namespace mixcmp::cli
