#include "generator/synthesis/components/predicted_table.hpp"

#include <algorithm>
#include <cmath>

#include "model/base/common/cases.hpp"
#include "model/cost/estimated/cost_model.hpp"

namespace mixcmp::components {
namespace {

using measured::Measurement;

/// STAND-IN until the library of unit areas is here: the rough model of shortlist.cpp.
class AreaPredictor {
public:
  AreaPredictor(ComponentMaker& maker, const devices::Device& device)
      : maker_(maker), device_(device) {}

  devices::Area of(const Component& component) {
    return std::visit([this](const auto& key) { return area(key); }, component.key);
  }

private:
  using Multipliers = scene::Multipliers;
  static estimated::Products products(Multipliers multipliers) {
    if (multipliers == Multipliers::embedded) return estimated::Products::left_out;
    if (multipliers == Multipliers::logic) return estimated::Products::in_luts;
    return estimated::Products::squares_in_memory;
  }
  static devices::Area logic(double luts, int dsps = 0) {
    const int count = static_cast<int>(std::lround(luts));
    return {.luts = count, .registers = count, .dsps = dsps};
  }

  devices::Area area(const measured::Unit&) { return logic(100); }
  devices::Area area(const measured::Lane& key) {
    const auto lane = maker_.lane(key).value();
    const Multipliers multipliers = key.multipliers.value_or(Multipliers::embedded);
    const auto& size = device_.delays.multiplier_size;
    return std::visit(
        [&](const auto& made) {
          const bool embedded = multipliers == Multipliers::embedded;
          devices::Area found = logic(estimated::lane_luts(made, products(multipliers)),
                                      embedded ? estimated::embedded_multipliers(made, size) : 0);
          return found;
        },
        lane);
  }
  devices::Area area(const measured::Reference& key) {
    const TypedGraph graph = reference_graph(maker_.scene().graph, maker_.scene().reference);
    const Multipliers multipliers = key.multipliers.value_or(Multipliers::embedded);
    const bool embedded = multipliers == Multipliers::embedded;
    devices::Area all = logic(
        estimated::reference_luts(graph, products(multipliers)),
        embedded ? estimated::embedded_multipliers(graph, device_.delays.multiplier_size) : 0);
    if (key.initiation_interval > 1) all.luts = all.luts * 2 / 3;
    return all;
  }
  int request_bits() const {
    const scene::Scene& scene = maker_.scene();
    const bool carried = scene.system.operands == scene::OperandStore::carried;
    const int operands = static_cast<int>(scene.graph.inputs().size());
    return (carried ? operands * scene.reference.format.width() : 0) + scene.system.tag_bits;
  }
  int beat_bits() const {
    const auto& beats = maker_.scene().system.request_beats;
    return request_bits() / std::max(1, beats.value_or(1));
  }
  devices::Area area(const measured::Fifo& key) {
    const bool block = maker_.scene().system.operand_memory == scene::OperandMemory::block;
    const int group = maker_.scene().system.lanes_per_group;
    const int bits = block ? maker_.scene().system.tag_bits * group : request_bits();
    devices::Area all = logic(100 + 10 * group + bits * std::max(key.slots, 64) / 64);
    if (block) all.memories = (beat_bits() + 35) / 36;
    return all;
  }
  devices::Area area(const measured::Crossbar& key) {
    return logic(100 + beat_bits() * key.lanes / 2);
  }
  devices::Area area(const measured::ReferencePort&) { return logic(200 + beat_bits()); }
  devices::Area area(const measured::SecondLane& key) { return area(key.lane) + logic(200); }
  devices::Area area(const measured::Segment& key) {
    return key.lanes * (area(key.lane) + logic(30));
  }
  devices::Area area(const measured::Conversion&) { return logic(300); }
  devices::Area area(const measured::Engine& key) { return logic(600 + 20 * key.segments); }
  devices::Area area(const measured::OperandMemory& key) { return logic(300 * key.references); }

  ComponentMaker& maker_;
  const devices::Device& device_;
};

}  // namespace

Result<PredictedTable> predict_table(const scene::Scene& scene, const data::Comparisons* data,
                                     const devices::Device& device, const ComponentQuery& query) {
  ComponentMaker maker(scene, data);
  AreaPredictor predictor(maker, device);
  PredictedTable predicted;
  predicted.table.device = device.name;
  predicted.table.scene = scene.name;
  const auto use = [&](const Component& component) {
    predicted.table.rows.push_back({.key = component.key,
                                    .latency_cycles = component.latency_cycles,
                                    .area = predictor.of(component),
                                    .clock = {},
                                    .hash = {},
                                    .tools = {},
                                    .stage = measured::AreaStage::predicted});
  };
  MIXCMP_TRY(missing, for_each_component(maker, query, use));
  predicted.missing = std::move(missing);
  std::sort(predicted.table.rows.begin(), predicted.table.rows.end(),
            [](const Measurement& a, const Measurement& b) { return a.key < b.key; });
  return predicted;
}

}  // namespace mixcmp::components
