#include "generator/tasks/optimise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "generator/tasks/architecture_search.hpp"
#include "generator/tasks/candidate_lanes.hpp"
#include "generator/tasks/remedies.hpp"
#include "model/base/common/file.hpp"
#include "model/plan/optimise/pairwise_busy.hpp"
#include "model/scene/expression_notes.hpp"
#include "model/scene/plan.hpp"

namespace mixcmp::tasks {
namespace {

namespace fs = std::filesystem;

constexpr int most_rounds = 5;

using Words = std::vector<std::string>;

bool is_set(const Words& settings, const std::string& key) {
  return std::any_of(settings.begin(), settings.end(),
                     [&](const std::string& each) { return each.starts_with(key + "="); });
}

/// The name that distinguishes this formulation from the scene's others.
std::string name_of(const scene::Scene& scene) {
  std::string name = scene.variant.empty() ? "[comparison]" : "variant " + scene.variant;
  if (scene.second_tier) name += ", second tier " + scene.second_tier->format_name();
  return scene.leaves_out_second_tier ? name + ", one tier" : name;
}

bool is_one_table(const OptimiseRequest& request) {
  std::error_code failed;
  return !request.planning.table.empty() && !fs::is_directory(request.planning.table, failed);
}

/// The scene as it is, and its variants. Moves that other keys of the scene rule out are left out.
Result<std::vector<Formulation>> variants_of(const OptimiseRequest& request,
                                             const LoadedScene& loaded) {
  std::vector<Formulation> formulations = {{loaded, {}, name_of(loaded.scene)}};
  for (const Words& own : settings_of_variants(request, loaded.scene)) {
    const SceneRequest& scene = request.planning.scene;
    auto read = scene::load_scene(scene.source, joined(scene.settings, own));
    if (!read.ok() && loaded.scene.variants_are_moves) continue;
    if (!read.ok()) return read.error();
    const std::string name = name_of(*read);
    formulations.push_back({{std::move(read).value(), loaded.data}, own, name});
  }
  return formulations;
}

/// The settings of the engines that a scene without [engine] could have on these data.
std::vector<Words> engines_for(const data::Comparisons* data) {
  if (data == nullptr) return {};
  std::uint64_t items = 2;
  switch (data->pairing()) {
    case data::Pairing::rows: return {};
    case data::Pairing::arg_min: return {{"engine.kind=arg_min", "system.lanes=auto"}};
    case data::Pairing::all:
    case data::Pairing::cross: break;
  }
  items = 0;
  for (const data::Table& table : data->tables()) items += table.rows();
  const std::uint64_t capacity = std::bit_ceil(std::max<std::uint64_t>(items, 2));
  if (capacity > scene::EngineSpec::max_capacity) return {};
  return {{"engine.kind=pairwise", fmt::format("engine.capacity={}", capacity)}};
}

/// Adds the formulations with an engine that the scene permits: keys that contradict one rule it
/// out.
void add_engines(const OptimiseRequest& request, std::vector<Formulation>& formulations) {
  const SceneRequest& scene = request.planning.scene;
  for (std::size_t k = 0, given = formulations.size(); k < given; ++k) {
    for (const Words& engine : engines_for(formulations[k].loaded.data_if_any())) {
      const Words own = joined(formulations[k].settings, engine);
      auto read = scene::load_scene(scene.source, joined(scene.settings, own));
      if (!read.ok()) continue;
      formulations.push_back({.loaded = {std::move(read).value(), formulations[k].loaded.data},
                              .settings = own,
                              .name = formulations[k].name,
                              .is_engine_added = true});
    }
  }
}

/// Plans by tables: one system for each formulation that has one.
Result<OptimiseResult> plan_by_tables(const OptimiseRequest& request,
                                      const std::vector<Formulation>& formulations) {
  OptimiseResult result;
  for (const Formulation& formulation : formulations) {
    const LoadedScene& loaded = formulation.loaded;
    auto planned = [&]() -> Result<PlannedSystem> {
      MIXCMP_TRY(known, load_planning(request.planning, loaded.scene, loaded.data_if_any()));
      MIXCMP_TRY(rates, rates_by_table(request, loaded, known.table));
      MIXCMP_TRY(found,
                 optimise::optimise(known.scene, known.device, known.table, rates, request.choice));
      return PlannedSystem{.formulation = formulation.name,
                           .interface = optimise::interface_of(loaded.scene),
                           .settings = formulation.settings,
                           .known = std::move(known),
                           .found = std::move(found)};
    }();
    if (planned.ok()) {
      result.systems.push_back(std::move(planned).value());
    } else {
      result.left_out.emplace_back(formulation.name, planned.error());
    }
  }
  if (result.systems.empty()) return result.left_out.front().second;
  result.chosen = best_of(result.systems);
  return result;
}

/// Adds a note to the chosen plan: its report has it, in text, in JSON and on a page.
void note_in_plan(OptimiseResult& result, std::string note) {
  result.systems[result.chosen].found.notes.push_back(std::move(note));
}

/// Tells in which part of their cycles the lanes of a pairwise engine compare.
void note_idle_lanes(const scene::Scene& scene, const data::Comparisons* data,
                     optimise::Optimisation& found) {
  const optimise::PrecisionPlan* plan = found.best();
  const bool is_pairwise = scene.system.engine.kind == scene::EngineKind::pairwise;
  if (plan == nullptr || !is_pairwise || data == nullptr) return;
  const auto set = profile::set_of(*data);
  if (!set) return;
  optimise::Rates unhindered;
  unhindered.assume_nothing_reported(*set);
  auto engine = optimise::engine_of(*plan, scene.system, *plan->allocation());
  engine.undecided = 0;
  const double busy = *optimise::busy_share(engine, unhindered, true);
  const std::string sizes = set->others > 0 ? fmt::format("{} and {}", set->items, set->others)
                                            : std::to_string(set->items);
  found.notes.push_back(
      plan->counts_idle_lanes
          ? fmt::format(
                "on sets of {} items lanes compare in {:.3g} % of their cycles ({:.3g} % if "
                "nothing were reported), since items are loaded one by one; G/s count this",
                sizes, 100 * plan->busy, 100 * busy)
          : fmt::format("on sets of {} items lanes compare in at most {:.3g} % of their cycles, "
                        "since items are loaded one by one; T(equ) does not count this",
                        sizes, 100 * busy));
}

/// Tells what must reach a system of streams: each comparison brings all of its operands.
void note_traffic(const scene::Scene& scene, optimise::Optimisation& found) {
  const optimise::PrecisionPlan* plan = found.best();
  if (plan == nullptr || scene.system.engine.kind != scene::EngineKind::none) return;
  const int bits = total_width(scene.operand_formats);
  found.notes.push_back(
      fmt::format("all operands of each comparison arrive at its ports, {} bits: {:.3g} GB/s", bits,
                  plan->throughput_per_s() / 1e9 * bits / 8));
}

/// Synthesises the components of the best plan and plans again, until the best plan has measured
/// areas only. Their results stay in the store, so that an interrupted run can be continued.
Result<OptimiseResult> confirm(const OptimiseRequest& request, const LoadedScene& loaded,
                               ArchitectureSearch& search, OptimiseResult predicted) {
  Confirmation confirmation{.predicted_per_s = predicted.best().throughput_per_s()};
  OptimiseResult result = std::move(predicted);
  while (result.best().found.best() != nullptr) {
    const PlannedSystem& best = result.best();
    const auto parts = search.predicted_parts(best);
    confirmation.is_measured = parts.empty();
    if (parts.empty() || request.predict_only || confirmation.rounds == most_rounds) break;
    if (confirmation.rounds == 0 && request.confirming) {
      request.confirming(best.throughput_per_s(), static_cast<int>(parts.size()));
    }
    components::CharacteriseOptions options = request.synthesis;
    MIXCMP_TRY(query, search.query_of(best));
    options.query = std::move(query);
    auto report = components::characterise(best.known.scene, loaded.data_if_any(),
                                           best.known.device, options, nullptr);
    if (!report.ok() && report.error().kind == ErrorKind::missing_tool) {
      confirmation.not_done = report.error().to_string();
      break;
    }
    if (!report.ok()) return report.error();
    ++confirmation.rounds;
    confirmation.failed = report->failed;
    confirmation.interrupted_by = report->interrupted_by;
    if (report->interrupted_by != 0 || !report->failed.empty()) break;
    search.replace(best, report->table.rows);
    MIXCMP_TRY(again, search.best());
    result = std::move(again);
  }
  result.confirmation = std::move(confirmation);
  return result;
}

/// Notes that the plan has no second tier although the scene has one.
void note_left_out_tier(const scene::Scene& given, OptimiseResult& result) {
  if (!given.second_tier || !result.best().known.scene.leaves_out_second_tier) return;
  const std::string tier = given.second_tier->format_name();
  const bool is_any = std::any_of(
      result.systems.begin(), result.systems.end(),
      [](const PlannedSystem& each) { return each.known.scene.second_tier.has_value(); });
  const std::string why =
      is_any ? "the fastest system has none; --set second_tier.format=" + tier + " plans with it"
             : "no system with it has a plan";
  note_in_plan(result,
               fmt::format("the plan is without the scene's second tier ({}): {}", tier, why));
}

/// Tells which operation keeps lanes in fixed point out of the plan.
void note_fixed_point(const OptimiseRequest& request, OptimiseResult& result) {
  const scene::Scene& scene = result.best().known.scene;
  const std::vector<Bound> bounds = bounds_for(request.choice, scene);
  const bool is_choice = std::any_of(bounds.begin(), bounds.end(),
                                     [](const Bound& bound) { return bound.is_fixed_point(); });
  if (!is_choice || scene.has_fixed_operands()) return;
  if (auto note = scene::fixed_point_note(scene.graph, scene.reference.format, scene.ranges)) {
    note_in_plan(result, *std::move(note));
  }
}

/// Whether some precision has no plan for want of room only, and none has a plan.
bool lacks_room(const optimise::Optimisation& found) {
  const auto is_short = [](const optimise::PrecisionPlan& plan) {
    const auto* none = std::get_if<optimise::Infeasible>(&plan.result);
    return none != nullptr && !none->shortages.empty();
  };
  const auto& plans = found.plans;
  return std::all_of(plans.begin(), plans.end(),
                     [](const auto& plan) { return plan.allocation() == nullptr; }) &&
         std::any_of(plans.begin(), plans.end(), is_short);
}

/// What the user should know of the system that was chosen.
void note_system(const OptimiseRequest& request, const LoadedScene& loaded,
                 OptimiseResult& result) {
  note_fixed_point(request, result);
  note_left_out_tier(loaded.scene, result);
  PlannedSystem& best = result.systems[result.chosen];
  note_use(best.known.scene, loaded.data_if_any(), best.found);
}

}  // namespace

void note_use(const scene::Scene& scene, const data::Comparisons* data,
              optimise::Optimisation& found) {
  note_idle_lanes(scene, data, found);
  note_traffic(scene, found);
}

double PlannedSystem::throughput_per_s() const {
  return found.best() == nullptr ? 0 : found.best()->throughput_per_s();
}

std::size_t best_of(const std::vector<PlannedSystem>& systems) {
  const auto fastest = std::max_element(systems.begin(), systems.end(), [](auto& a, auto& b) {
    return a.throughput_per_s() < b.throughput_per_s();
  });
  const PlannedSystem* best = &*fastest;
  for (const PlannedSystem& other : systems) {
    const bool is_alike = other.throughput_per_s() == best->throughput_per_s() &&
                          other.known.scene.system.counters == best->known.scene.system.counters;
    if (!is_alike || other.found.best() == nullptr) continue;
    if (is_better(*other.found.best(), *best->found.best(), other.found.device)) best = &other;
  }
  return static_cast<std::size_t>(best - systems.data());
}

std::vector<Words> settings_of_variants(const OptimiseRequest& request, const scene::Scene& scene) {
  std::vector<Words> variants;
  if (is_one_table(request) || request.rates || !scene.variant.empty()) return variants;
  for (const std::string& name : scene.variants) variants.push_back({"comparison.variant=" + name});
  return variants;
}

Result<optimise::Rates> rates_by_table(const OptimiseRequest& request, const LoadedScene& loaded,
                                       const measured::Characterisation& table) {
  if (request.rates) return *request.rates;
  MIXCMP_TRY(counted, measure_rates(loaded, optimise::inputs_of_lanes(table), request.choice,
                                    request.progress));
  return optimise::Rates::of(counted);
}

std::vector<std::string> settings_of(const OptimiseRequest& request, const PlannedSystem& system) {
  Words given = request.planning.scene.settings;
  const std::string device = "system.device";  // that of --on takes the place of the request's
  if (is_set(system.settings, device)) {
    std::erase_if(given, [&](const auto& each) { return each.starts_with(device + "="); });
  }
  return joined(given, system.settings);
}

Result<std::vector<Formulation>> formulations_of(const OptimiseRequest& request,
                                                 const LoadedScene& loaded) {
  MIXCMP_TRY(formulations, variants_of(request, loaded));
  const SceneRequest& scene = request.planning.scene;
  const bool tier_is_given = is_one_table(request) || is_set(scene.settings, "second_tier.format");
  for (std::size_t k = 0, given = formulations.size(); k < given && !tier_is_given; ++k) {
    if (!formulations[k].loaded.scene.second_tier) continue;
    const Words own = joined(formulations[k].settings, {"second_tier.format=none"});
    MIXCMP_TRY(read, scene::load_scene(scene.source, joined(scene.settings, own)));
    const std::string name = name_of(read);
    formulations.push_back({{std::move(read), loaded.data}, own, name});
  }
  if (!request.planning.table.empty()) return formulations;
  MIXCMP_TRY(read, scene::read_scene_settings(scene.source, scene.settings));
  if (optimise::open_keys(read.settings).engine) add_engines(request, formulations);
  return formulations;
}

Result<OptimiseResult> completed(const OptimiseRequest& request, const LoadedScene& loaded,
                                 ArchitectureSearch& search, OptimiseResult predicted) {
  MIXCMP_TRY(result, confirm(request, loaded, search, std::move(predicted)));
  result.notes = search.notes();
  if (result.best().found.best() == nullptr) return result;
  MIXCMP_TRY(front, search.front(result.best()));
  result.front = std::move(front);
  note_system(request, loaded, result);
  return result;
}

Result<std::vector<FrontPoint>> front_of(const OptimiseRequest& request,
                                         const LoadedScene& loaded) {
  MIXCMP_TRY(search, ArchitectureSearch::make(request, {{loaded, {}, name_of(loaded.scene)}}));
  MIXCMP_TRY(fastest, search.fastest());
  if (fastest.best().found.best() == nullptr) return std::vector<FrontPoint>();
  return search.front(fastest.best());
}

Result<OptimiseResult> optimise(const OptimiseRequest& request, const LoadedScene& loaded) {
  MIXCMP_DO(check_options(request.choice));
  MIXCMP_TRY(formulations, formulations_of(request, loaded));
  const bool by_table = !request.planning.table.empty();
  if (by_table && request.at_least_per_s > 0) {
    return Error{.file = loaded.scene.path.string(),
                 .field = request.at_least_option,
                 .message = "a plan by a table is the fastest one",
                 .received = request.planning.table.string(),
                 .accepted = "no table, so that the smallest system is searched for"};
  }
  if (by_table) {
    MIXCMP_TRY(result, plan_by_tables(request, formulations));
    note_system(request, loaded, result);
    return result;
  }
  MIXCMP_TRY(search, ArchitectureSearch::make(request, formulations));
  MIXCMP_TRY(predicted, search.best());
  MIXCMP_TRY(result, completed(request, loaded, search, std::move(predicted)));
  if (search.is_rough()) result.notes.push_back(rough_note(search.device().name));
  if (lacks_room(result.best().found)) {
    note_in_plan(result, note_on_room(search, loaded.scene.system.slack));
  }
  return result;
}

}  // namespace mixcmp::tasks
