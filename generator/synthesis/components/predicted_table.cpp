#include "generator/synthesis/components/predicted_table.hpp"

#include <algorithm>

#include "generator/synthesis/components/synthesis_jobs.hpp"

namespace mixcmp::components {

using measured::Measurement;

namespace {

/// So many tables of four inputs do the work of so many of six (docs/theory.md: lanes of the
/// paper's benchmark).
constexpr int of_four = 3, of_six = 2;

}  // namespace

AreaPredictor::AreaPredictor(UnitLibrary library, const devices::Device& device)
    : library_(std::move(library)),
      device_(device),
      packs_(device.synthesis.starts_with("synth_xilinx")),
      used_(std::make_unique<Used>()) {}

Result<AreaPredictor> AreaPredictor::make(const devices::Device& device) {
  MIXCMP_TRY(library, unit_library(device));
  return AreaPredictor(std::move(library), device);
}

std::optional<devices::Area> AreaPredictor::of(const Component& component) const {
  const ComponentParts parts = component.parts();
  devices::Area sum = parts.statements;
  for (const Part& part : parts.instances) {
    const std::optional<devices::Area> area = of(part);
    if (!area) return std::nullopt;
    sum += *area;
  }
  return library_.stands_in ? as_on_device(sum) : sum;
}

/// Only Xilinx makes shift registers of tables.
devices::Area AreaPredictor::as_on_device(devices::Area area) const {
  if (!device_.delays.has_wide_tables()) area.luts = area.luts * of_four / of_six;
  if (!packs_) area.registers += 4 * area.shift_luts;
  return area;
}

std::optional<devices::Area> AreaPredictor::of(const Part& part) const {
  if (packs_ && part.is_absorbed) return devices::Area{.registers = part.kept_registers};
  std::optional<devices::Area> area = of(part.instance);
  if (area) area->registers += part.passing_registers;
  if (area && packs_) area->registers -= std::min(part.absorbed_registers, area->registers);
  return area;
}

std::optional<devices::Area> AreaPredictor::of(const rtl::TemplateInstance& instance) const {
  return *used_->areas.of(instance_name(instance), [&] {
    const std::optional<devices::Area> area = library_.areas.of(unit_of(instance));
    note(instance.module, area.has_value());
    return area;
  });
}

void AreaPredictor::note(const std::string& module, bool is_known) const {
  const std::lock_guard lock(used_->mutex);
  if (!is_known) used_->unknown.insert(module);
  if (!is_known || !used_->seen.insert(module).second) return;
  const units::TemplateAreas* const measured = library_.areas.find(module);
  if (measured == nullptr) return;  // a table, whose area is known without
  if (measured->rtl != template_hash(module)) used_->outdated.insert(module);
}

double six_input_luts(const devices::Device& device) {
  const double luts = device.available.luts;
  return device.delays.has_wide_tables() ? luts : luts * of_six / of_four;
}

Result<measured::Characterisation> predict_table(const PredictedArea& area_of,
                                                 ComponentMaker& maker,
                                                 const ComponentQuery& query) {
  const scene::Scene& scene = maker.scene();
  measured::Characterisation table{
      .device = scene.system.device, .scene = scene.name, .command = {}, .spec = {}, .rows = {}};
  const auto use = [&](const Component& component) {
    const std::optional<devices::Area> area = area_of(component, scene);
    if (!area) return;
    table.rows.push_back({.key = component.key,
                          .latency_cycles = component.latency_cycles,
                          .area = *area,
                          .clock = {},
                          .hash = {},
                          .tools = {},
                          .stage = measured::AreaStage::predicted});
  };
  MIXCMP_TRY(missing, for_each_component(maker, query, use));  // lanes that do not exist
  std::sort(table.rows.begin(), table.rows.end(),
            [](const Measurement& a, const Measurement& b) { return a.key < b.key; });
  return table;
}

std::vector<std::optional<devices::Area>> predicted_areas(AreaPredictor& predictor,
                                                          const measured::Characterisation& table,
                                                          const scene::Scene& scene,
                                                          const data::Comparisons* data) {
  ComponentMaker maker(scene, data);
  std::vector<std::optional<devices::Area>> areas;
  for (const Measurement& row : table.rows) {
    const Result<Component> component = maker.make(row.key);
    const bool is_comparable = component.ok() && !row.is_imported();
    areas.push_back(is_comparable ? predictor.of(*component) : std::nullopt);
  }
  return areas;
}

}  // namespace mixcmp::components
