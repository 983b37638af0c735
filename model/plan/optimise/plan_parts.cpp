#include "model/plan/optimise/plan_parts.hpp"

#include <algorithm>

#include "model/cost/performance/performance.hpp"
#include "model/design/slots.hpp"

namespace mixcmp::optimise {
namespace {

using measured::ComponentKey;
using Keys = std::set<ComponentKey>;

/// Adds the keys of all sizes that the table has.
template <measured::Counted Component>
void add_sizes(Keys& keys, const measured::Characterisation& table, const Component& like) {
  for (const auto& [count, row] : sizes_of(table, like)) keys.insert(row->key);
}

void add_crossbars(Keys& keys, int asking, int asked) {
  if (asked == 0) return;
  for (const int served : performance::lanes_of_references(asking, asked)) {
    if (served > 0) keys.insert(measured::Crossbar{served});
  }
}

/// The crossbars between groups of lanes, second lanes and references.
void add_crossbars(Keys& keys, const PrecisionPlan& plan) {
  const Allocation& chosen = *plan.allocation();
  const int groups = chosen.lane_count() / lanes_per_port(plan.problem);
  const int references = chosen.reference_count();
  if (!plan.second_lanes) return add_crossbars(keys, groups, references);
  add_crossbars(keys, groups, plan.second_lanes->count);
  add_crossbars(keys, plan.second_lanes->count, references);
}

void add_engine(Keys& keys, const measured::Characterisation& table, const measured::Lane& lane) {
  add_sizes(keys, table, measured::Engine{lane});
  const measured::Measurement* conversion = table.find(measured::Conversion{lane});
  if (conversion != nullptr) keys.insert(conversion->key);
}

}  // namespace

Keys components_of(const PrecisionPlan& plan, const Optimisation& found, const scene::Scene& scene,
                   const measured::Characterisation& table) {
  const Allocation& chosen = *plan.allocation();
  const scene::EngineKind engine = scene.system.engine.kind;
  Keys keys;
  for (std::size_t k = 0; k < found.references.size(); ++k) {
    if (chosen.references[k] == 0) continue;
    keys.insert(found.references[k].measured.key);
    keys.insert(measured::ReferencePort{found.references[k].reference()});
  }
  int slowest = 0;
  for (std::size_t k = 0; k < plan.lanes.size(); ++k) {
    if (chosen.lanes[k] == 0) continue;
    const measured::Measurement& row = plan.lanes[k].measured;
    slowest = std::max(slowest, row.latency_cycles);
    keys.insert(row.key);
    if (engine != scene::EngineKind::none) add_engine(keys, table, plan.lanes[k].lane());
  }
  if (plan.second_lanes) keys.insert(plan.second_lanes->measured.key);
  if (engine == scene::EngineKind::none) {
    keys.insert(measured::Fifo{design::slots_for(slowest + scene.system.input_registers,
                                                 scene.system.references.value_or(1) > 0)});
  }
  if (engine == scene::EngineKind::arg_min) add_sizes(keys, table, measured::OperandMemory{});
  if (engine != scene::EngineKind::pairwise) add_crossbars(keys, plan);
  return keys;
}

}  // namespace mixcmp::optimise
