#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "generator/synthesis/components/shortlist.hpp"
#include "generator/tasks/architecture_search.hpp"
#include "model/base/common/file.hpp"
#include "model/scene/plan.hpp"

namespace mixcmp::tasks {
namespace {

using components::ComponentQuery;
using measured::Characterisation;
using measured::ComponentKey;
using measured::ComponentKind;
using measured::Measurement;
using scene::EngineKind;

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

/// Whether components have the same areas on both devices, as far as they are predicted.
bool has_like_areas(const devices::Device& a, const devices::Device& b) {
  return a.synthesis == b.synthesis && a.delays == b.delays;
}

/// Makes the settings name this device.
void name_device(std::vector<std::string>& settings, const std::string& device) {
  const std::string key = "system.device=";
  const auto old = std::find_if(settings.begin(), settings.end(),
                                [&](const std::string& each) { return each.starts_with(key); });
  if (old == settings.end()) {
    settings.insert(settings.begin(), key + device);
  } else {
    *old = key + device;
  }
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
  choice.samples_rates = true;
  MIXCMP_TRY(tier, optimise::second_tier_lane(loaded.scene));
  if (tier) choice.last_precision = std::max(choice.last_precision, tier->format.precision());
  const std::vector<LaneInputs> inputs = inputs_for(choice);
  MIXCMP_TRY(counted,
             measure_rates(loaded, {inputs.begin(), inputs.end()}, choice, request.progress));
  return optimise::Rates::of(counted);
}

std::optional<std::string> note_on_sample(const optimise::Rates& rates) {
  std::uint64_t all = 0, sample = 0;
  int most_digits = 0;
  const std::vector<optimise::RateKey> keys = rates.keys();
  for (const optimise::RateKey& key : keys) all = std::max(all, rates.find(key)->comparisons);
  for (const optimise::RateKey& key : keys) {
    const std::uint64_t counted = rates.find(key)->comparisons;
    if (counted == all) continue;
    sample = counted;
    most_digits = std::max(most_digits, key.precision);
  }
  if (sample == 0) return std::nullopt;
  return fmt::format(
      "recomputation rates of lanes of at most {} digits were counted on a sample of {} of {} "
      "comparisons",
      most_digits, sample, all);
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
  }
  MIXCMP_DO(search.add_all({}));
  return search;
}

Result<Done> ArchitectureSearch::move_to(const std::string& name) {
  MIXCMP_TRY(device, devices::find_device(name));
  const bool is_alike = has_like_areas(device, device_) && !has_measured_rows_;
  device_ = std::move(device);
  if (!is_alike) MIXCMP_DO(choose_areas());
  for (Formulation& each : formulations_) {
    use_device(each.loaded.scene.system, name);
    name_device(each.settings, name);
  }
  std::vector<System> known;
  if (is_alike) known = std::move(systems_);
  for (System& each : known) {
    use_device(each.scene.system, name);
    each.table.device = device_.name;
    name_device(each.settings, name);
  }
  const auto added = add_all(std::move(known));
  if (!added.ok()) systems_.clear();
  return added;
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
  if (auto note = note_on_sample(rates)) sample_notes_.insert(*std::move(note));
  rates_.push_back(std::move(rates));
  return Done{};
}

Result<Done> ArchitectureSearch::add_all(std::vector<System> known) {
  systems_.clear();
  notes_.clear();
  has_measured_rows_ = false;
  std::vector<std::vector<System>> systems(formulations_.size());
  for (System& each : known) {
    // The lanes of an engine are chosen by what they take of the device.
    const bool is_engine = each.scene.system.engine.kind != EngineKind::none;
    if (!is_engine) systems[each.formulation].push_back(std::move(each));
  }
  MIXCMP_DO(for_each_in_threads(split_of(systems.size(), areas_predicted, request_->progress),
                                [&](std::uint64_t k) -> Result<Done> {
                                  if (!systems[k].empty()) return Done{};
                                  MIXCMP_TRY(found, systems_of(k));
                                  systems[k] = std::move(found);
                                  return Done{};
                                }));
  for (std::size_t k = 0; k < systems.size(); ++k) {
    std::ranges::move(systems[k], std::back_inserter(systems_));
    use_kept_rows(k);
  }
  notes_.insert(notes_.end(), sample_notes_.begin(), sample_notes_.end());
  if (predictor_ == nullptr) return Done{};
  for (const std::string& changed : predictor_->outdated()) {
    notes_.push_back(fmt::format(
        "unit areas of {} were measured before it changed; mixcmp units measures them again",
        changed));
  }
  for (const std::string& unknown : predictor_->unknown()) {
    notes_.push_back(fmt::format(
        "components with {0} left out: the library of unit areas lacks it; mixcmp units "
        "SCENE --device {1} --template {0} measures it",
        unknown, device_.name));
  }
  return Done{};
}

Result<std::vector<ArchitectureSearch::System>> ArchitectureSearch::systems_of(
    std::size_t number) const {
  const Formulation& formulation = formulations_[number];
  std::vector<std::string> settings =
      joined(request_->planning.scene.settings, formulation.settings);
  // No key is open because of a device, and after move_to both may name one.
  std::erase_if(settings, [](const auto& each) { return each.starts_with("system.device="); });
  MIXCMP_TRY(read, scene::read_scene_settings(request_->planning.scene.source, settings));
  optimise::OpenKeys open = optimise::open_keys(read.settings);
  const LoadedScene& loaded = formulation.loaded;
  MIXCMP_TRY(given, with_chain_lanes(loaded.scene, loaded.data_if_any(), request_->planning.scene));
  if (given.has_exact_references()) open.initiation_interval = false;
  const bool streams = given.system.engine.kind == EngineKind::none;
  ComponentQuery query = query_for(request_->choice, given, open);
  MIXCMP_TRY(choices, reference_choices(given, std::move(query), open));
  std::vector<System> all;
  for (ReferenceChoice& choice : choices) {
    MIXCMP_TRY(systems, streams ? systems_of_streams(number, std::move(choice), open)
                                : systems_of_engine(number, std::move(choice), open));
    std::move(systems.begin(), systems.end(), std::back_inserter(all));
  }
  MIXCMP_CHECK(!all.empty());
  return all;
}

ArchitectureSearch::System ArchitectureSearch::system_of(std::size_t formulation,
                                                         const ReferenceChoice& choice,
                                                         const optimise::Architecture& architecture,
                                                         const optimise::OpenKeys& open,
                                                         Characterisation table) const {
  const scene::Scene& given = choice.scene;
  sort_rows(table);
  table.device = device_.name;
  System system{.formulation = formulation,
                .settings = joined(formulations_[formulation].settings, choice.settings),
                .interface = {},
                .scene = with_architecture(given, architecture, open),
                .table = std::move(table)};
  for (std::string& setting : settings_of(architecture, given, open)) {
    system.settings.push_back(std::move(setting));
  }
  system.interface = optimise::interface_of(system.scene);
  return system;
}

Result<std::vector<ArchitectureSearch::System>> ArchitectureSearch::systems_of_streams(
    std::size_t formulation, ReferenceChoice choice, const optimise::OpenKeys& open) const {
  const scene::Scene& given = choice.scene;
  ComponentQuery& query = choice.query;
  const data::Comparisons* data = formulations_[formulation].loaded.data_if_any();
  MIXCMP_TRY(useful, useful_lanes(given, query, rates_[formulation]));
  MIXCMP_TRY(left_out, left_out_lanes(given, query, rates_[formulation], useful,
                                      "fewer digits leave nothing undecided"));
  query.lanes = std::move(useful);
  components::ComponentMaker maker(given, data);
  MIXCMP_TRY(datapaths, predict_table(area_of_, maker, query));
  query.lanes = lanes_by_slots(datapaths, given);
  query.kinds = {ComponentKind::fifo, ComponentKind::crossbar, ComponentKind::reference_port};
  if (given.second_tier) query.kinds.insert(ComponentKind::second_lane);
  std::vector<System> systems;
  for (const optimise::Architecture& architecture : architectures_of(given, open)) {
    maker.use_system_of(with_architecture(given, architecture, open));
    MIXCMP_TRY(streams, predict_table(area_of_, maker, query));
    Characterisation table = datapaths;
    table.rows.insert(table.rows.end(), streams.rows.begin(), streams.rows.end());
    systems.push_back(system_of(formulation, choice, architecture, open, std::move(table)));
    systems.back().left_out = left_out;
  }
  return systems;
}

/// All components of an engine depend on its groups, and each kind of lane has its own: only
/// promising ones are predicted.
Result<std::vector<ArchitectureSearch::System>> ArchitectureSearch::systems_of_engine(
    std::size_t formulation, ReferenceChoice choice, const optimise::OpenKeys& open) const {
  const scene::Scene& given = choice.scene;
  ComponentQuery& query = choice.query;
  const data::Comparisons* data = formulations_[formulation].loaded.data_if_any();
  components::ComponentMaker maker(given, data);
  MIXCMP_TRY(promising, shortlist(maker, query, device_, rates_[formulation]));
  MIXCMP_TRY(longer, with_longer(promising.lanes, given, query));
  MIXCMP_TRY(left_out, left_out_lanes(given, query, rates_[formulation], longer,
                                      "by rough areas they are slower than others"));
  query.lanes = std::move(longer);
  const std::set<ComponentKind> of_groups = {ComponentKind::lane, ComponentKind::reference,
                                             ComponentKind::segment, ComponentKind::conversion};
  std::set<ComponentKind> of_engine = {ComponentKind::reference_port, ComponentKind::engine};
  if (given.system.engine.kind == EngineKind::arg_min) {
    of_engine.insert({ComponentKind::operand_memory, ComponentKind::crossbar});
  }
  std::vector<System> systems;
  std::map<int, Characterisation> groups;  // by their lanes: counters and streams change nothing
  for (const optimise::Architecture& architecture : architectures_of(given, open)) {
    maker.use_system_of(with_architecture(given, architecture, open));
    const auto [group, is_new] = groups.try_emplace(architecture.lanes_per_group);
    if (is_new) {
      query.kinds = of_groups;
      MIXCMP_TRY(parts, predict_table(area_of_, maker, query));
      group->second = std::move(parts);
    }
    query.kinds = of_engine;
    MIXCMP_TRY(parts, predict_table(area_of_, maker, query));
    const std::vector<Measurement>& shared = group->second.rows;
    parts.rows.insert(parts.rows.end(), shared.begin(), shared.end());
    System& system =
        systems.emplace_back(system_of(formulation, choice, architecture, open, std::move(parts)));
    system.scene.lanes = given.lanes;
    system.scene.system.lanes = given.system.lanes;
    system.left_out = left_out;
  }
  return systems;
}

void ArchitectureSearch::use_kept_rows(std::size_t number) {
  const Formulation& formulation = formulations_[number];
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
  has_measured_rows_ = true;
  const auto use = [&](System& system, const std::vector<const Measurement*>& rows) {
    for (const Measurement* row : rows) {
      if (put(system.table, *row)) used.insert(row->key);
    }
  };
  const auto current = components::current_rows(datapaths, given, data, device_);
  for (System& system : systems_) {
    if (system.formulation != number) continue;
    use(system, current);
    if (!has_streams_of(*table, system.scene.system)) continue;
    use(system, components::current_rows(others, system.scene, data, device_));
  }
  notes_.push_back(fmt::format(
      "{}: {} of {} rows take the place of predicted areas; the others are of other RTL or of "
      "lanes that no plan needs, and --table plans with them",
      path.filename().string(), used.size(), table->rows.size()));
}

void ArchitectureSearch::replace(const PlannedSystem& planned,
                                 const std::vector<Measurement>& rows) {
  const std::size_t formulation = systems_[planned.number].formulation;
  const bool streams = systems_[planned.number].scene.system.engine.kind == EngineKind::none;
  has_measured_rows_ = true;
  for (std::size_t k = 0; k < systems_.size(); ++k) {
    if (systems_[k].formulation != formulation) continue;
    for (const Measurement& row : rows) {
      const bool is_shared = streams && is_datapath(row.key);
      if (k == planned.number || is_shared) put(systems_[k].table, row);
    }
  }
}

}  // namespace mixcmp::tasks
