#include "generator/synthesis/components/engine_components.hpp"

#include <algorithm>

#include "generator/hardware/rtl/channel_modules.hpp"
#include "generator/hardware/rtl/segment_module.hpp"
#include "model/base/common/check.hpp"
#include "model/scene/reference_model.hpp"

namespace mixcmp::components {
namespace {

/// Below this number a merge is one multiplexer, which says little of larger ones.
constexpr int fewest_segments = 4;

/// A design with these lanes and one reference, or none if the scene has none. The parts of an
/// engine depend on nothing else.
design::Design design_of(const scene::Scene& scene, const design::LaneGroup& lanes,
                         std::optional<design::LaneGroup> second_tier) {
  std::vector<design::ReferenceGroup> references;
  if (scene.reference_count() != 0) {
    references = {{.structure = {scene::Multipliers::embedded, 1}, .count = 1}};
  }
  design::Design design{.name = "engine",  // not the scene's: equal hardware has equal names
                        .inputs = scene.graph.inputs(),
                        .lanes = {lanes},
                        .second_tier = std::move(second_tier),
                        .reference = reference_graph(scene.graph, scene.reference),
                        .references = std::move(references),
                        .system = scene.system,
                        .operand_formats = scene.operand_formats};
  if (scene.reference_fixed_point) {
    auto reference = scene::reference_model(scene).value();  // the scene was checked
    design.fixed_reference = std::get<fixed::FixedLane>(std::move(reference));
  }
  return design;
}

}  // namespace

std::vector<int> measured_segments(const scene::Scene& scene) {
  constexpr int growth = 4;
  const scene::EngineSpec& engine = scene.system.engine;
  if (engine.kind == scene::EngineKind::pairwise) {
    const int fewest = std::max(fewest_segments, engine.report_streams);
    return {fewest, growth * fewest};
  }
  const int lanes = *scene.lane_count();
  return {std::max(1, lanes / growth), lanes == 1 ? growth : lanes};
}

Result<EngineParts> EngineParts::make(const scene::Scene& scene, const design::LaneGroup& lanes) {
  MIXCMP_CHECK(scene.system.engine.kind != scene::EngineKind::none);
  MIXCMP_TRY(second_tier, design::design_second_tier(scene));
  MIXCMP_TRY(scheduled, emit::schedule_system(design_of(scene, lanes, std::move(second_tier))));
  return EngineParts(std::move(scheduled));
}

int EngineParts::lane_latency_cycles() const {
  return scheduled_.shape.lane_groups.front().schedule.latency_cycles;
}

rtl::Module EngineParts::lane() const {
  const rtl::DatapathGroup& lanes = scheduled_.shape.lane_groups.front();
  return rtl::word_lane_module(lanes.datapath, words().lanes.front(), lanes.schedule);
}

std::vector<rtl::Module> EngineParts::segment() const {
  std::vector<rtl::Module> modules;
  modules.push_back(lane());
  if (scheduled_.arg_min) {
    const rtl::SystemShape& system = scheduled_.shape;
    modules.push_back(rtl::lane_channel_module(system, system.lane_groups.front()));
    return modules;
  }
  const rtl::PairwiseShape& shape = *scheduled_.pairwise;
  if (const auto& tier = scheduled_.shape.second_tier) {
    modules.push_back(
        rtl::word_lane_module(tier->datapath, *shape.words.second_tier, tier->schedule));
  }
  modules.push_back(
      rtl::segment_module(scheduled_.shape, shape.engine, shape.words, shape.segments.front()));
  return modules;
}

int EngineParts::conversion_latency_cycles() const {
  return words().latency_cycles();
}

std::vector<rtl::Module> EngineParts::conversion() const {
  std::vector<rtl::Module> modules = {
      rtl::item_word_module(words(), data::Item::first, *scheduled_.engine)};
  if (!scheduled_.arg_min) return modules;
  modules.push_back(rtl::item_word_module(words(), data::Item::row, *scheduled_.engine));
  modules.push_back(rtl::arg_min_conversions_module(*scheduled_.arg_min));
  return modules;
}

rtl::TemplateInstance EngineParts::engine() const {
  return scheduled_.arg_min ? rtl::arg_min_template(*scheduled_.arg_min, scheduled_.shape)
                            : rtl::pairwise_template(*scheduled_.pairwise, scheduled_.shape);
}

}  // namespace mixcmp::components
