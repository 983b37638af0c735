#include "generator/tasks/architecture_search.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "model/plan/optimise/plan_parts.hpp"
#include "model/plan/optimise/plan_summary.hpp"
#include "model/scene/plan.hpp"

namespace mixcmp::tasks {
namespace {

using components::ComponentQuery;
using measured::ComponentKey;
using measured::Measurement;
using scene::Multipliers;

/// The scene's limit of system.slack.
constexpr double most_slack = 0.95;

/// The search may lose half a percent of the highest throughput. A program of this many nodes takes
/// about a second; only precisions far from the best have needed more.
constexpr optimise::Effort effort{.may_lose = 0.005, .nodes = 300};

/// The scene with a share of the room that its slack leaves.
scene::Scene scene_in(scene::Scene scene, double share) {
  if (share == 1) return scene;
  constexpr double digits = 1e6;  // of what plans show
  scene.system.slack = std::round(digits * (1 - share * (1 - scene.system.slack))) / digits;
  return scene;
}

/// The best systems so far, by formulation and interface.
using BestSystems = std::map<std::pair<std::size_t, std::string>, PlannedSystem>;

/// The fastest system that asks no more of its user; null without one.
const PlannedSystem* rival_of(const BestSystems::key_type& key, const scene::SystemSpec& system,
                              const BestSystems& best) {
  const PlannedSystem* rival = nullptr;
  for (const auto& [other, planned] : best) {
    const bool is_rival =
        other.first == key.first && optimise::asks_no_more(planned.known.scene.system, system);
    if (!is_rival) continue;
    if (rival == nullptr || planned.throughput_per_s() > rival->throughput_per_s()) {
      rival = &planned;
    }
  }
  return rival;
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

}  // namespace

std::string rough_note(const std::string& names) {
  return fmt::format(
      "no library of unit areas for {}: those of Xilinx' 7 series stand in, and predictions are "
      "rough; mixcmp units makes one",
      names);
}

double progress_of_search(const std::string& step, double share) {
  constexpr double areas = 0.3, bounds = 0.2;  // of the time, about
  if (step == areas_predicted) return areas * share;
  if (step == systems_bounded) return areas + bounds * share;
  return areas + bounds + (1 - areas - bounds) * share;
}

void ArchitectureSearch::tell_progress(const char* step, double done, double of) const {
  if (request_->progress) request_->progress(step, done / of);
}

WorkSplit ArchitectureSearch::split_of(std::size_t size, const char* step,
                                       const StepProgress& progress) {
  WorkSplit split{.size = size};
  if (progress) split.progress = [step, &progress](double share) { progress(step, share); };
  return split;
}

std::optional<performance::ItemSet> ArchitectureSearch::set_of(std::size_t formulation) const {
  const data::Comparisons* data = formulations_[formulation].loaded.data_if_any();
  return data == nullptr ? std::nullopt : profile::set_of(*data);
}

Result<std::vector<ArchitectureSearch::Choice>> ArchitectureSearch::choices_of(std::size_t system,
                                                                               Share share) const {
  optimise::OptimiseOptions options = request_->choice;
  options.at_least_per_s = std::numeric_limits<double>::infinity();  // bounds, and no plans
  const System& each = systems_[system];
  options.set = set_of(each.formulation);
  MIXCMP_TRY(found, optimise::optimise(scene_in(each.scene, share), device_, each.table,
                                       rates_[each.formulation], options));
  std::vector<Choice> choices;
  for (const optimise::PrecisionPlan& plan : found.plans) {
    if (plan.bound_per_s == 0 || (found.crossover && plan.precision >= *found.crossover)) continue;
    choices.push_back({system, plan.precision, plan.bound_per_s});
  }
  return choices;
}

std::vector<Result<std::vector<ArchitectureSearch::Choice>>> ArchitectureSearch::choices_of(
    const std::vector<std::size_t>& systems, Share share, const StepProgress& progress) const {
  std::vector<Result<std::vector<Choice>>> found(systems.size(), std::vector<Choice>());
  const WorkSplit split = split_of(systems.size(), systems_bounded, progress);
  const auto done = for_each_in_threads(split, [&](std::uint64_t k) {
    found[k] = choices_of(systems[k], share);
    return Result<Done>(Done{});
  });
  MIXCMP_CHECK(done.ok());
  return found;
}

Result<PlannedSystem> ArchitectureSearch::planned(std::size_t number, Share share,
                                                  optimise::OptimiseOptions options) const {
  options.effort = effort;
  const System& system = systems_[number];
  options.set = set_of(system.formulation);
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
  const double least_per_s = request_->at_least_per_s;
  MIXCMP_TRY(best, best_in(1, request_->progress));
  if (least_per_s == 0 || best.best().found.best() == nullptr) return best;
  if (best.best().throughput_per_s() < least_per_s) {
    return Error{.file = formulations_.front().loaded.scene.path.string(),
                 .field = request_->at_least_option,
                 .message = "no system on " + device_.name + " is so fast",
                 .received = fmt::format("{:.4g} G comparisons/s", least_per_s / 1e9),
                 .accepted = fmt::format("less than {:.4g} G comparisons/s",
                                         best.best().throughput_per_s() / 1e9)};
  }
  return smallest(std::move(best));
}

Result<OptimiseResult> ArchitectureSearch::smallest(OptimiseResult best) const {
  constexpr int steps = 64;
  const double least_per_s = request_->at_least_per_s;
  const double usable = 1 - systems_[best.best().number].scene.system.slack;
  int too_small = static_cast<int>(std::ceil(steps * (1 - most_slack) / usable));
  const int halvings = std::bit_width(static_cast<unsigned>(steps - too_small - 1));
  int halved = 0;
  const StepProgress progress = [&](const std::string& step, double share) {
    tell_progress("smallest system searched", halved + progress_of_search(step, share), halvings);
  };
  for (int enough = steps; enough - too_small > 1; ++halved) {
    const int middle = (too_small + enough) / 2;
    auto found = best_in(static_cast<double>(middle) / steps, progress);
    const bool is_enough = found.ok() && found->best().throughput_per_s() >= least_per_s;
    (is_enough ? enough : too_small) = middle;
    if (is_enough) best = std::move(found).value();
  }
  return best;
}

Result<OptimiseResult> ArchitectureSearch::fastest_without_slack() const {
  return fastest_in(1 / (1 - formulations_.front().loaded.scene.system.slack), {});
}

Result<std::vector<FrontPoint>> ArchitectureSearch::front(const PlannedSystem& system) const {
  constexpr std::array parts = {1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0};
  std::vector<std::size_t> alike;
  for (std::size_t k = 0; k < systems_.size(); ++k) {
    const bool is_alike = systems_[k].formulation == systems_[system.number].formulation &&
                          systems_[k].interface == system.interface;
    if (is_alike) alike.push_back(k);
  }
  std::vector<FrontPoint> points;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const double of_device = parts[part] * (1 - system.known.scene.system.slack);
    const Share share = of_device / (1 - systems_[system.number].scene.system.slack);
    std::vector<Choice> choices;
    for (const auto& found : choices_of(alike, share, {})) {
      if (found.ok()) choices.insert(choices.end(), found->begin(), found->end());
    }
    const auto progress = [&](const std::string&, double done) {
      tell_progress("plans of smaller systems searched", double(part) + done, parts.size());
    };
    MIXCMP_TRY(fastest, fastest_of(std::move(choices), share, progress));
    if (fastest.empty()) continue;  // nothing fits
    points.push_back({of_device, summary_of(fastest.front().found), fastest.front().settings});
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

Result<OptimiseResult> ArchitectureSearch::fastest_in(Share share,
                                                      const StepProgress& progress) const {
  OptimiseResult result;
  std::vector<Choice> choices;
  std::map<std::size_t, std::size_t> possible;  // by formulation: a system with lanes
  std::map<std::size_t, Error> errors;
  std::vector<std::size_t> systems(systems_.size());
  std::iota(systems.begin(), systems.end(), std::size_t{0});
  const auto bounded = choices_of(systems, share, progress);
  for (const std::size_t k : systems) {
    const std::size_t formulation = systems_[k].formulation;
    if (!bounded[k].ok()) {
      errors.emplace(formulation, bounded[k].error());
      continue;
    }
    possible.emplace(formulation, k);
    choices.insert(choices.end(), bounded[k]->begin(), bounded[k]->end());
  }
  MIXCMP_TRY(fastest, fastest_of(std::move(choices), share, progress));
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
  result.chosen = best_of(result.systems);
  return result;
}

Result<OptimiseResult> ArchitectureSearch::best_in(Share share,
                                                   const StepProgress& progress) const {
  MIXCMP_TRY(result, fastest_in(share, progress));
  PlannedSystem& most = result.systems[result.chosen];
  if (most.found.best() == nullptr) return result;
  MIXCMP_TRY(whole, planned(most.number, share, request_->choice));
  for (optimise::PrecisionPlan& plan : whole.found.plans) {
    const optimise::PrecisionPlan& known = *most.found.best();
    if (plan.precision == known.precision && is_better(known, plan, device_)) plan = known;
  }
  most = std::move(whole);
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

Result<std::vector<PlannedSystem>> ArchitectureSearch::fastest_of(
    std::vector<Choice> choices, Share share, const StepProgress& progress) const {
  // Fewer streams of reports come first: more of them must make a system faster.
  const auto order = [&](const Choice& choice) {
    const int streams = systems_[choice.system].scene.system.engine.report_streams;
    return std::pair(streams, -choice.bound_per_s);
  };
  std::stable_sort(choices.begin(), choices.end(),
                   [&](const Choice& a, const Choice& b) { return order(a) < order(b); });
  BestSystems best;
  for (std::size_t k = 0; k < choices.size(); ++k) {
    if (progress) progress(plans_searched, double(k) / double(choices.size()));
    const Choice& choice = choices[k];
    const System& system = systems_[choice.system];
    const BestSystems::key_type key{system.formulation, system.interface};
    const PlannedSystem* known = rival_of(key, system.scene.system, best);
    const double known_per_s = known == nullptr ? 0 : known->throughput_per_s();
    if (choice.bound_per_s < (1 + effort.may_lose) * known_per_s) continue;
    optimise::OptimiseOptions options = request_->choice;
    options.first_precision = options.last_precision = choice.precision;
    options.at_least_per_s = std::max(known_per_s, std::numeric_limits<double>::min());
    MIXCMP_TRY(found, planned(choice.system, share, options));
    const optimise::PrecisionPlan* plan = found.found.best();
    if (plan == nullptr) continue;
    if (known != nullptr && known->interface == system.interface) {
      if (!is_better(*plan, *known->found.best(), device_)) continue;
    } else if (plan->throughput_per_s() <= (1 + effort.may_lose) * known_per_s) {
      continue;
    }
    best.insert_or_assign(key, std::move(found));
  }
  std::vector<PlannedSystem> systems;
  for (auto& [key, system] : best) systems.push_back(std::move(system));
  const auto place = [&](const PlannedSystem& system) {
    return std::pair(systems_[system.number].formulation,
                     system.known.scene.system.engine.report_streams);
  };
  std::stable_sort(
      systems.begin(), systems.end(),
      [&](const PlannedSystem& a, const PlannedSystem& b) { return place(a) < place(b); });
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

}  // namespace mixcmp::tasks
