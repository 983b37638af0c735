#include "generator/synthesis/components/predicted_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "generator/synthesis/components/synthesis_jobs.hpp"
#include "generator/synthesis/components/unit_library.hpp"

namespace mixcmp::components {
namespace {

using measured::Measurement;

/// Whether Yosys packs registers and sums into the device's multipliers (component_parts.hpp).
bool packs(const devices::Device& device) {
  return device.synthesis.starts_with("synth_xilinx");
}

/// Adds up the areas of a component's parts.
class AreaPredictor {
public:
  AreaPredictor(const units::UnitAreas& library, const devices::Device& device)
      : library_(library), packs_(packs(device)) {}

  devices::Area of(const ComponentParts& parts) {
    devices::Area sum = parts.statements;
    for (const Part& part : parts.instances) sum += of(part);
    return sum;
  }

  /// Templates without a unit in the library.
  const std::set<std::string>& unknown() const { return unknown_; }

private:
  devices::Area of(const Part& part) {
    if (packs_ && part.is_absorbed) return {};
    devices::Area area = of(part.instance);
    if (packs_) area.registers -= std::min(part.absorbed_registers, area.registers);
    return area;
  }

  devices::Area of(const rtl::TemplateInstance& instance) {
    const std::string name = instance_name(instance);
    const auto known = areas_.find(name);
    if (known != areas_.end()) return known->second;
    const std::optional<devices::Area> found = area_of_unit(library_, unit_of(instance));
    if (!found) unknown_.insert(instance.module);
    return areas_[name] = found.value_or(devices::Area{});
  }

  const units::UnitAreas& library_;
  bool packs_;
  std::map<std::string, devices::Area> areas_;
  std::set<std::string> unknown_;
};

Error not_measured(const std::set<std::string>& templates, const devices::Device& device) {
  return {.field = "system.device",
          .message = "the library of unit areas of this family lacks a template",
          .received = fmt::format("{}: {}", device.name, *templates.begin()),
          .accepted = "what mixcmp units makes again"};
}

}  // namespace

Result<devices::Area> predicted_area(const Component& component, const units::UnitAreas& library,
                                     const devices::Device& device) {
  AreaPredictor predictor(library, device);
  const devices::Area area = predictor.of(component.parts());
  if (!predictor.unknown().empty()) return not_measured(predictor.unknown(), device);
  return area;
}

Result<PredictedTable> predict_table(const scene::Scene& scene, const data::Comparisons* data,
                                     const devices::Device& device, const ComponentQuery& query) {
  MIXCMP_TRY(library, unit_library(device));
  ComponentMaker maker(scene, data);
  AreaPredictor predictor(library, device);
  PredictedTable predicted;
  predicted.table.device = device.name;
  predicted.table.scene = scene.name;
  const auto use = [&](const Component& component) {
    predicted.table.rows.push_back({.key = component.key,
                                    .latency_cycles = component.latency_cycles,
                                    .area = predictor.of(component.parts()),
                                    .clock = {},
                                    .hash = {},
                                    .tools = {},
                                    .stage = measured::AreaStage::predicted});
  };
  MIXCMP_TRY(missing, for_each_component(maker, query, use));
  if (!predictor.unknown().empty()) return not_measured(predictor.unknown(), device);
  predicted.missing = std::move(missing);
  std::sort(predicted.table.rows.begin(), predicted.table.rows.end(),
            [](const Measurement& a, const Measurement& b) { return a.key < b.key; });
  return predicted;
}

}  // namespace mixcmp::components
