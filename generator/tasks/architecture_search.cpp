#include "generator/tasks/architecture_search.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "generator/synthesis/components/shortlist.hpp"
#include "model/base/common/file.hpp"
#include "model/plan/optimise/plan_parts.hpp"
#include "model/plan/optimise/plan_summary.hpp"
#include "model/scene/plan.hpp"

namespace mixcmp::tasks {
namespace {

using components::ComponentQuery;
using measured::Characterisation;
using measured::ComponentKey;
using measured::ComponentKind;
using measured::Measurement;
using scene::EngineKind;
using scene::Multipliers;

/// The intervals of references where the scene leaves them open: one that is not folded, those with
/// few units, and about the smallest one.
constexpr std::array usual_intervals = {1, 2, 4, 8, 16};
/// Plans interpolate between these crossbars.
const std::vector<int> usual_ports = {1, 4, 8, 16, 32, 64, 128};

/// The scene's limit of system.slack.
constexpr double most_slack = 0.95;

/// The search may lose half a percent of the highest throughput. A program of this many nodes takes
/// about a second; only precisions far from the best have needed more.
constexpr optimise::Effort effort{.may_lose = 0.005, .nodes = 300};

/// The bounds of lanes that a plan of the scene may use.
std::vector<Bound> bounds_for(const optimise::OptimiseOptions& choice, const scene::Scene& scene) {
  std::vector<Bound> bounds = choice.bounds;
  if (bounds.empty()) {
    for (const Bound& bound : counted_bounds()) bounds.push_back(bound);
    bounds.push_back({.kind = BoundKind::profiled});
  }
  std::erase_if(
      bounds, [&](const Bound& bound) { return bound.is_profiled() != scene.reduced.is_profiled; });
  return bounds;
}

std::vector<LaneInputs> inputs_for(const optimise::OptimiseOptions& choice) {
  if (!choice.inputs.empty()) return choice.inputs;
  return {LaneInputs::exact, LaneInputs::rounded};
}

/// All lanes and references that the request admits.
ComponentQuery query_for(const optimise::OptimiseOptions& choice, const scene::Scene& scene,
                         const optimise::OpenKeys& open) {
  const settings::Limits allowed = settings::lane_precisions(scene.reference.format);
  const auto& [multipliers, interval, target] = scene.reference_structure;
  ComponentQuery query{.kinds = {ComponentKind::lane, ComponentKind::reference},
                       .precisions = {},
                       .bounds = bounds_for(choice, scene),
                       .inputs = inputs_for(choice),
                       .multipliers = choice.multipliers,
                       .reference_targets = {target},
                       .crossbars = usual_ports,
                       .exponents = {}};
  const int last = std::min(choice.last_precision, allowed.most);
  for (int k = std::max(choice.first_precision, allowed.least); k <= last; ++k) {
    query.precisions.push_back(k);
  }
  if (query.multipliers.empty()) {
    query.multipliers = {Multipliers::embedded, Multipliers::logic, Multipliers::memory};
  }
  if (open.initiation_interval || !interval) {
    query.initiation_intervals.assign(usual_intervals.begin(), usual_intervals.end());
  } else {
    query.initiation_intervals = {*interval};
  }
  return query;
}

void sort_rows(Characterisation& table) {
  std::sort(table.rows.begin(), table.rows.end(),
            [](const Measurement& a, const Measurement& b) { return a.key < b.key; });
}

bool is_datapath(const ComponentKey& key) {
  return std::holds_alternative<measured::Lane>(key) ||
         std::holds_alternative<measured::Reference>(key);
}

/// Puts a row into the table. Its clock is left out: architectures are compared at one clock. Only
/// sizes of crossbars are added; other rows replace one with the same key.
bool put(Characterisation& table, Measurement row) {
  row.clock.reset();
  const auto place = std::lower_bound(
      table.rows.begin(), table.rows.end(), row.key,
      [](const Measurement& each, const ComponentKey& key) { return each.key < key; });
  if (place != table.rows.end() && place->key == row.key) {
    *place = std::move(row);
    return true;
  }
  if (!std::holds_alternative<measured::Crossbar>(row.key)) return false;
  table.rows.insert(place, std::move(row));
  return true;
}

/// Whether the streams of a table are those of the scene, by what the table says of itself.
bool has_streams_of(const Characterisation& table, const scene::SystemSpec& system) {
  std::map<std::string, std::string> spec(table.spec.begin(), table.spec.end());
  const std::string groups = spec.contains("lanes_per_group") ? spec["lanes_per_group"] : "1";
  return spec["operands"] == to_string(system.operands) &&
         groups == std::to_string(system.lanes_per_group) &&
         spec["counter_bits"] == std::to_string(system.counter_bits);
}

/// The scene with a share of the room that its slack leaves.
scene::Scene scene_in(scene::Scene scene, double share) {
  if (share == 1) return scene;
  constexpr double digits = 1e6;  // of what plans show
  scene.system.slack = std::round(digits * (1 - share * (1 - scene.system.slack))) / digits;
  return scene;
}

/// Why a system has no plan: one of its precisions, preferably one that only lacks room.
std::string why_none(const optimise::Optimisation& found) {
  const auto reason = [](const optimise::PrecisionPlan& plan) {
    return std::get_if<optimise::Infeasible>(&plan.result);
  };
  auto plan = std::find_if(found.plans.begin(), found.plans.end(), [&](const auto& each) {
    return reason(each) != nullptr && !reason(each)->shortages.empty();
  });
  if (plan == found.plans.end()) plan = found.plans.begin();
  const std::string why =
      reason(*plan) == nullptr ? "a lane costs more than a reference" : reason(*plan)->message;
  return fmt::format("no plan at any precision; L = {}: {}", plan->precision, why);
}

Characterisation part_of(const Characterisation& table, bool datapaths) {
  Characterisation part{
      .device = table.device, .scene = table.scene, .command = {}, .spec = table.spec, .rows = {}};
  for (const Measurement& row : table.rows) {
    if (is_datapath(row.key) == datapaths) part.rows.push_back(row);
  }
  return part;
}

}  // namespace

Result<optimise::Rates> count_rates(const OptimiseRequest& request, const LoadedScene& loaded) {
  optimise::OptimiseOptions choice = request.choice;
  choice.bounds = bounds_for(choice, loaded.scene);
  MIXCMP_TRY(tier, optimise::second_tier_lane(loaded.scene));
  if (tier) choice.last_precision = std::max(choice.last_precision, tier->format.precision());
  const std::vector<LaneInputs> inputs = inputs_for(choice);
  MIXCMP_TRY(counted,
             measure_rates(loaded, {inputs.begin(), inputs.end()}, choice, request.progress));
  return optimise::Rates::of(counted);
}

Result<ArchitectureSearch> ArchitectureSearch::make(const OptimiseRequest& request,
                                                    const std::vector<Formulation>& formulations) {
  ArchitectureSearch search(request);
  search.formulations_ = formulations;
  const scene::Scene& scene = formulations.front().loaded.scene;
  MIXCMP_TRY(device, devices::find_device(scene.system.device));
  search.device_ = std::move(device);
  MIXCMP_DO(search.choose_areas());
  for (const Formulation& formulation : search.formulations_) {
    MIXCMP_DO(search.count_rates(formulation));
    search.tell_progress("areas predicted", search.rates_.size() - 1, formulations.size());
    MIXCMP_DO(search.add(formulation));
  }
  if (search.predictor_ == nullptr) return search;
  if (search.predictor_->is_rough()) {
    search.notes_.push_back(fmt::format(
        "no library of unit areas for {}: those of Xilinx' 7 series stand in, and predictions are "
        "rough; mixcmp units makes one",
        search.device_.name));
  }
  for (const std::string& changed : search.predictor_->outdated()) {
    search.notes_.push_back(fmt::format(
        "unit areas of {} were measured before it changed; mixcmp units measures them again",
        changed));
  }
  for (const std::string& unknown : search.predictor_->unknown()) {
    search.notes_.push_back(
        fmt::format("components with {} left out: the library of unit areas lacks it", unknown));
  }
  return search;
}

void ArchitectureSearch::tell_progress(const char* step, std::size_t done, std::size_t of) const {
  if (request_->progress) request_->progress(step, double(done) / double(of));
}

Result<Done> ArchitectureSearch::choose_areas() {
  area_of_ = request_->area_of;
  if (area_of_) return Done{};
  MIXCMP_TRY(predictor, components::AreaPredictor::make(device_));
  predictor_ = std::make_shared<components::AreaPredictor>(std::move(predictor));
  area_of_ = [predictor = predictor_](const components::Component& component, const scene::Scene&) {
    return predictor->of(component);
  };
  return Done{};
}

Result<Done> ArchitectureSearch::count_rates(const Formulation& formulation) {
  if (request_->rates) {
    rates_.push_back(*request_->rates);
    return Done{};
  }
  const LoadedScene& loaded = formulation.loaded;
  for (std::size_t k = 0; k < rates_.size(); ++k) {
    if (formulations_[k].loaded.scene.variant != loaded.scene.variant) continue;
    rates_.push_back(rates_[k]);  // rates do not depend on the system around a lane
    return Done{};
  }
  MIXCMP_TRY(rates, tasks::count_rates(*request_, loaded));
  rates_.push_back(std::move(rates));
  return Done{};
}

Result<Done> ArchitectureSearch::add(const Formulation& formulation) {
  std::vector<std::string> settings = request_->planning.scene.settings;
  settings.insert(settings.end(), formulation.settings.begin(), formulation.settings.end());
  MIXCMP_TRY(read, scene::read_scene_settings(request_->planning.scene.source, settings));
  const optimise::OpenKeys open = optimise::open_keys(read.settings);
  const std::size_t before = systems_.size();
  const bool streams = formulation.loaded.scene.system.engine.kind == EngineKind::none;
  MIXCMP_DO(streams ? add_streams(formulation, open) : add_engine(formulation, open));
  MIXCMP_CHECK(systems_.size() > before);
  use_kept_rows(formulation);
  return Done{};
}

void ArchitectureSearch::add_system(const Formulation& formulation,
                                    const optimise::Architecture& architecture,
                                    const optimise::OpenKeys& open, Characterisation table) {
  const scene::Scene& given = formulation.loaded.scene;
  sort_rows(table);
  table.device = device_.name;
  System system{.formulation = rates_.size() - 1,
                .settings = formulation.settings,
                .interface = {},
                .scene = with_architecture(given, architecture, open),
                .table = std::move(table)};
  for (std::string& setting : settings_of(architecture, given, open)) {
    system.settings.push_back(std::move(setting));
  }
  system.interface = optimise::interface_of(system.scene);
  systems_.push_back(std::move(system));
}

Result<Done> ArchitectureSearch::add_streams(const Formulation& formulation,
                                             const optimise::OpenKeys& open) {
  const scene::Scene& given = formulation.loaded.scene;
  const data::Comparisons* data = formulation.loaded.data_if_any();
  ComponentQuery query = query_for(request_->choice, given, open);
  MIXCMP_TRY(useful, useful_lanes(given, query, rates_.back()));
  MIXCMP_TRY(left_out, left_out_lanes(given, query, rates_.back(), useful,
                                      "fewer digits leave nothing undecided"));
  query.lanes = std::move(useful);
  MIXCMP_TRY(datapaths, predict_table(area_of_, given, data, query));
  query.lanes = lanes_by_slots(datapaths, given);
  query.kinds = {ComponentKind::fifo, ComponentKind::crossbar, ComponentKind::reference_port};
  if (given.second_tier) query.kinds.insert(ComponentKind::second_lane);
  for (const optimise::Architecture& architecture : architectures_of(given, open)) {
    const scene::Scene scene = with_architecture(given, architecture, open);
    MIXCMP_TRY(streams, predict_table(area_of_, scene, data, query));
    Characterisation table = datapaths;
    table.rows.insert(table.rows.end(), streams.rows.begin(), streams.rows.end());
    add_system(formulation, architecture, open, std::move(table));
    systems_.back().left_out = left_out;
  }
  return Done{};
}

/// All components of an engine depend on its groups, and each kind of lane has its own: only
/// promising ones are predicted.
Result<Done> ArchitectureSearch::add_engine(const Formulation& formulation,
                                            const optimise::OpenKeys& open) {
  const data::Comparisons* data = formulation.loaded.data_if_any();
  MIXCMP_TRY(given, with_chain_lanes(formulation.loaded.scene, data, request_->planning.scene));
  ComponentQuery query = query_for(request_->choice, given, open);
  components::ComponentMaker maker(given, data);
  MIXCMP_TRY(promising, shortlist(maker, query, device_, rates_.back()));
  MIXCMP_TRY(longer, with_longer(promising.lanes, given, query));
  MIXCMP_TRY(left_out, left_out_lanes(given, query, rates_.back(), longer,
                                      "rough areas rank them behind those that are predicted"));
  query.lanes = std::move(longer);
  query.kinds = {ComponentKind::lane,    ComponentKind::reference,  ComponentKind::reference_port,
                 ComponentKind::segment, ComponentKind::conversion, ComponentKind::engine};
  if (given.system.engine.kind == EngineKind::arg_min) {
    query.kinds.insert({ComponentKind::operand_memory, ComponentKind::crossbar});
  }
  for (const optimise::Architecture& architecture : architectures_of(given, open)) {
    const scene::Scene scene = with_architecture(given, architecture, open);
    MIXCMP_TRY(parts, predict_table(area_of_, scene, data, query));
    add_system(formulation, architecture, open, std::move(parts));
    systems_.back().scene.lanes = given.lanes;
    systems_.back().scene.system.lanes = given.system.lanes;
    systems_.back().left_out = left_out;
  }
  return Done{};
}

void ArchitectureSearch::use_kept_rows(const Formulation& formulation) {
  const scene::Scene& given = formulation.loaded.scene;
  if (formulation.is_engine_added || request_->planning.scene.source.text) return;
  const std::filesystem::path path = table_of(request_->planning, given);
  if (!path_exists(path)) return;
  const Result<Characterisation> table = optimise::read_table(path, given, device_);
  if (!table.ok()) {
    notes_.push_back("not used: " + table.error().to_string());
    return;
  }
  const data::Comparisons* data = formulation.loaded.data_if_any();
  const Characterisation datapaths = part_of(*table, true);
  const Characterisation others = part_of(*table, false);
  std::set<ComponentKey> used;
  const auto use = [&](System& system, const std::vector<const Measurement*>& rows) {
    for (const Measurement* row : rows) {
      if (put(system.table, *row)) used.insert(row->key);
    }
  };
  const auto current = components::current_rows(datapaths, given, data, device_);
  for (System& system : systems_) {
    if (system.formulation != rates_.size() - 1) continue;
    use(system, current);
    if (!has_streams_of(*table, system.scene.system)) continue;
    use(system, components::current_rows(others, system.scene, data, device_));
  }
  notes_.push_back(fmt::format(
      "{}: {} of {} rows take the place of predicted areas; the others are of other RTL or of "
      "lanes that no plan needs, and --table plans with them",
      path.filename().string(), used.size(), table->rows.size()));
}

Result<std::vector<ArchitectureSearch::Choice>> ArchitectureSearch::choices_of(std::size_t system,
                                                                               Share share) const {
  optimise::OptimiseOptions options = request_->choice;
  options.at_least_per_s = std::numeric_limits<double>::infinity();  // bounds, and no plans
  const System& each = systems_[system];
  MIXCMP_TRY(found, optimise::optimise(scene_in(each.scene, share), device_, each.table,
                                       rates_[each.formulation], options));
  std::vector<Choice> choices;
  for (const optimise::PrecisionPlan& plan : found.plans) {
    if (plan.bound_per_s == 0 || (found.crossover && plan.precision >= *found.crossover)) continue;
    choices.push_back({system, plan.precision, plan.bound_per_s});
  }
  return choices;
}

Result<PlannedSystem> ArchitectureSearch::planned(std::size_t number, Share share,
                                                  optimise::OptimiseOptions options) const {
  options.effort = effort;
  const System& system = systems_[number];
  scene::Scene scene = scene_in(system.scene, share);
  MIXCMP_TRY(found,
             optimise::optimise(scene, device_, system.table, rates_[system.formulation], options));
  tell_of(system.left_out, found);
  std::vector<std::string> settings = system.settings;
  if (share < 1) settings.push_back(fmt::format("system.slack={}", scene.system.slack));
  return PlannedSystem{.formulation = formulations_[system.formulation].name,
                       .interface = system.interface,
                       .settings = std::move(settings),
                       .number = number,
                       .known = {std::move(scene), device_, system.table, {}, {}},
                       .found = std::move(found)};
}

Result<OptimiseResult> ArchitectureSearch::best() const {
  constexpr int steps = 64;
  const double least_per_s = request_->at_least_per_s;
  MIXCMP_TRY(best, best_in(1));
  if (least_per_s == 0 || best.best().found.best() == nullptr) return best;
  if (best.best().throughput_per_s() < least_per_s) {
    return Error{.file = formulations_.front().loaded.scene.path.string(),
                 .field = request_->at_least_option,
                 .message = "no system on " + device_.name + " is so fast",
                 .received = fmt::format("{:.4g} G comparisons/s", least_per_s / 1e9),
                 .accepted = fmt::format("less than {:.4g} G comparisons/s",
                                         best.best().throughput_per_s() / 1e9)};
  }
  const double usable = 1 - systems_[best.best().number].scene.system.slack;
  int too_small = static_cast<int>(std::ceil(steps * (1 - most_slack) / usable));
  for (int enough = steps; enough - too_small > 1;) {
    const int middle = (too_small + enough) / 2;
    auto found = best_in(static_cast<double>(middle) / steps);
    const bool is_enough = found.ok() && found->best().throughput_per_s() >= least_per_s;
    (is_enough ? enough : too_small) = middle;
    if (is_enough) best = std::move(found).value();
  }
  return best;
}

Result<std::vector<FrontPoint>> ArchitectureSearch::front(const PlannedSystem& system) const {
  std::vector<FrontPoint> points;
  for (const double part : {1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0}) {
    const Share share = part * (1 - system.known.scene.system.slack) /
                        (1 - systems_[system.number].scene.system.slack);
    std::vector<Choice> choices;
    for (std::size_t k = 0; k < systems_.size(); ++k) {
      const bool is_alike = systems_[k].formulation == systems_[system.number].formulation &&
                            systems_[k].interface == system.interface;
      if (!is_alike) continue;
      if (const auto found = choices_of(k, share); found.ok()) {
        choices.insert(choices.end(), found->begin(), found->end());
      }
    }
    MIXCMP_TRY(fastest, fastest_of(std::move(choices), share));
    if (fastest.empty()) continue;  // nothing fits
    points.push_back({part, summary_of(fastest.front().found), fastest.front().settings});
  }
  return points;
}

Error ArchitectureSearch::explained(const Error& error) const {
  if (predictor_ == nullptr || predictor_->unknown().empty()) return error;
  std::string command = fmt::format("mixcmp units SCENE --device {}", device_.name);
  for (const std::string& unknown : predictor_->unknown()) command += " --template " + unknown;
  return {.field = "system.device",
          .message = "areas cannot be predicted, since the library of unit areas lacks templates",
          .received = fmt::format("{}", fmt::join(predictor_->unknown(), ", ")),
          .accepted = "what this measures: " + command};
}

Result<OptimiseResult> ArchitectureSearch::best_in(Share share) const {
  OptimiseResult result;
  std::vector<Choice> choices;
  std::map<std::size_t, std::size_t> possible;  // by formulation: a system with lanes
  std::map<std::size_t, Error> errors;
  for (std::size_t k = 0; k < systems_.size(); ++k) {
    tell_progress("systems bounded", k, systems_.size());
    const auto found = choices_of(k, share);
    const std::size_t formulation = systems_[k].formulation;
    if (!found.ok()) {
      errors.emplace(formulation, found.error());
      continue;
    }
    possible.emplace(formulation, k);
    choices.insert(choices.end(), found->begin(), found->end());
  }
  MIXCMP_TRY(fastest, fastest_of(std::move(choices), share));
  for (std::size_t k = 0; k < formulations_.size(); ++k) {
    if (possible.contains(k)) continue;
    result.left_out.emplace_back(name_of(k), errors.at(k));
  }
  if (possible.empty()) return explained(result.left_out.front().second);
  result.systems = std::move(fastest);
  MIXCMP_DO(tell_of_others(possible, share, result));
  if (result.systems.empty()) {  // what is short is said for one of them
    MIXCMP_TRY(none, planned(possible.begin()->second, share, request_->choice));
    result.systems.push_back(std::move(none));
    return result;
  }
  const auto most = std::max_element(result.systems.begin(), result.systems.end(),
                                     [](const PlannedSystem& a, const PlannedSystem& b) {
                                       return a.throughput_per_s() < b.throughput_per_s();
                                     });
  result.chosen = static_cast<std::size_t>(most - result.systems.begin());
  MIXCMP_TRY(whole, planned(most->number, share, request_->choice));
  for (optimise::PrecisionPlan& plan : whole.found.plans) {
    const optimise::PrecisionPlan& known = *most->found.best();
    if (plan.precision == known.precision && is_better(known, plan, device_)) plan = known;
  }
  *most = std::move(whole);
  return result;
}

std::string ArchitectureSearch::name_of(std::size_t formulation) const {
  const Formulation& of = formulations_[formulation];
  return of.is_engine_added ? of.name + " in an engine" : of.name;
}

Result<Done> ArchitectureSearch::tell_of_others(const std::map<std::size_t, std::size_t>& possible,
                                                Share share, OptimiseResult& result) const {
  if (result.systems.empty()) return Done{};
  std::set<std::size_t> planned_ones;
  for (const PlannedSystem& each : result.systems) {
    planned_ones.insert(systems_[each.number].formulation);
  }
  for (const auto& [formulation, number] : possible) {
    if (planned_ones.contains(formulation)) continue;
    MIXCMP_TRY(none, planned(number, share, request_->choice));
    result.left_out.emplace_back(name_of(formulation), Error{.message = why_none(none.found)});
  }
  return Done{};
}

Result<std::vector<PlannedSystem>> ArchitectureSearch::fastest_of(std::vector<Choice> choices,
                                                                  Share share) const {
  std::stable_sort(choices.begin(), choices.end(),
                   [](const Choice& a, const Choice& b) { return a.bound_per_s > b.bound_per_s; });
  std::map<std::pair<std::size_t, std::string>, PlannedSystem> best;
  const char* const step = share == 1 ? "plans searched" : "plans of smaller systems searched";
  for (std::size_t k = 0; k < choices.size(); ++k) {
    tell_progress(step, k, choices.size());
    const Choice& choice = choices[k];
    const System& system = systems_[choice.system];
    const std::pair key{system.formulation, system.interface};
    const auto known = best.find(key);
    const bool any = known != best.end();
    const double known_per_s = any ? known->second.throughput_per_s() : 0;
    if (choice.bound_per_s < (1 + effort.may_lose) * known_per_s) continue;
    optimise::OptimiseOptions options = request_->choice;
    options.first_precision = options.last_precision = choice.precision;
    options.at_least_per_s = std::max(known_per_s, std::numeric_limits<double>::min());
    MIXCMP_TRY(found, planned(choice.system, share, options));
    const optimise::PrecisionPlan* plan = found.found.best();
    if (plan == nullptr) continue;
    if (any && !is_better(*plan, *known->second.found.best(), device_)) continue;
    best.insert_or_assign(key, std::move(found));
  }
  std::vector<PlannedSystem> systems;
  for (auto& [key, system] : best) systems.push_back(std::move(system));
  return systems;
}

std::set<ComponentKey> ArchitectureSearch::predicted_parts(const PlannedSystem& planned) const {
  const System& system = systems_[planned.number];
  const optimise::PrecisionPlan* plan = planned.found.best();
  if (plan == nullptr) return {};
  std::set<ComponentKey> parts = components_of(*plan, planned.found, system.scene, system.table);
  std::erase_if(parts, [&](const ComponentKey& key) {
    const auto* crossbar = std::get_if<measured::Crossbar>(&key);
    if (crossbar != nullptr && !components::measured_ports.allow(crossbar->lanes)) return true;
    const Measurement* row = system.table.find(key);
    return row != nullptr && row->stage != measured::AreaStage::predicted;
  });
  return parts;
}

Result<components::ComponentQuery> ArchitectureSearch::query_of(
    const PlannedSystem& planned) const {
  const System& system = systems_[planned.number];
  ComponentQuery query{.kinds = {},
                       .precisions = {},
                       .bounds = {},
                       .inputs = {},
                       .multipliers = {},
                       .initiation_intervals = {},
                       .reference_targets = {},
                       .crossbars = {},
                       .lanes = std::set<measured::Lane>(),
                       .only = predicted_parts(planned),
                       .exponents = {}};
  std::set<std::optional<int>> targets = {system.scene.reference_structure.target_mhz};
  std::set<Multipliers> multipliers = {Multipliers::embedded};
  std::set<int> intervals, precisions;
  std::set<Bound> bounds;
  std::set<LaneInputs> inputs = {LaneInputs::exact};
  const optimise::PrecisionPlan& plan = *planned.found.best();
  for (std::size_t k = 0; k < plan.lanes.size(); ++k) {
    if (plan.allocation()->lanes[k] == 0) continue;
    const measured::Lane lane = as_asked(plan.lanes[k].lane());
    query.lanes->insert(lane);
    precisions.insert(lane.format.precision());
    bounds.insert(lane.bound);
    if (lane.inputs) inputs.insert(*lane.inputs);
    multipliers.insert(*lane.multipliers);
  }
  for (const ComponentKey& key : *query.only) {
    query.kinds.insert(kind_of(key));
    if (const auto* crossbar = std::get_if<measured::Crossbar>(&key)) {
      query.crossbars.push_back(crossbar->lanes);
    }
  }
  for (const optimise::ReferenceImplementation& each : planned.found.references) {
    intervals.insert(each.reference().initiation_interval);
    multipliers.insert(each.reference().multipliers.value_or(Multipliers::embedded));
  }
  query.precisions.assign(precisions.begin(), precisions.end());
  query.bounds.assign(bounds.begin(), bounds.end());
  query.inputs.assign(inputs.begin(), inputs.end());
  query.multipliers.assign(multipliers.begin(), multipliers.end());
  query.initiation_intervals.assign(intervals.begin(), intervals.end());
  query.reference_targets.assign(targets.begin(), targets.end());
  return query;
}

void ArchitectureSearch::replace(const PlannedSystem& planned,
                                 const std::vector<Measurement>& rows) {
  const std::size_t formulation = systems_[planned.number].formulation;
  const bool streams = systems_[planned.number].scene.system.engine.kind == EngineKind::none;
  for (std::size_t k = 0; k < systems_.size(); ++k) {
    if (systems_[k].formulation != formulation) continue;
    for (const Measurement& row : rows) {
      const bool is_shared = streams && is_datapath(row.key);
      if (k == planned.number || is_shared) put(systems_[k].table, row);
    }
  }
}

}  // namespace mixcmp::tasks
