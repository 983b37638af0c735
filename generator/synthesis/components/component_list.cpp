#include "generator/synthesis/components/component_list.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "generator/synthesis/components/engine_components.hpp"
#include "generator/synthesis/components/synthesis_jobs.hpp"
#include "model/base/number/bound.hpp"
#include "model/design/slots.hpp"
#include "model/lane/error/exponent_range.hpp"
#include "model/plan/optimise/second_tier.hpp"

namespace mixcmp::components {
namespace {

using measured::ComponentKey;
using measured::ComponentKind;
using scene::Multipliers;
using scene::Scene;

int exponent_bits(const Scene& scene, const ComponentQuery& query, int precision, LaneInputs inputs,
                  const Bound& bound) {
  const scene::ReducedSpec& reduced = scene.reduced;
  const int widest = scene.reference.format.exponent_bits();
  const bool fixed = reduced.format && !reduced.exponent_bits_from_ranges;
  if (!query.exponents && fixed) return reduced.format->exponent_bits();
  const bool from_ranges = query.exponents ? *query.exponents == LaneExponents::ranges
                                           : reduced.exponent_bits_from_ranges;
  // A profiled lane checks no range: its exponents reach as far as the reference's.
  if (!from_ranges || bound.is_profiled()) return widest;
  const FloatFormat format = FloatFormat::make(precision, widest).value();
  return error::lane_exponent_bits(scene.graph, scene.reference.format,
                                   {format, reduced.rounding, reduced.subnormals}, inputs,
                                   scene.ranges);
}

/// The kinds of multipliers that floating point can have.
std::vector<Multipliers> float_multipliers(const ComponentQuery& query) {
  std::vector<Multipliers> kinds = query.multipliers;
  std::erase(kinds, Multipliers::memory);
  return kinds;
}

/// Lanes in fixed point take operands as they arrive: there is no choice of inputs.
void add_fixed_lanes(std::vector<measured::Lane>& lanes, const Scene& scene,
                     const ComponentQuery& query, const Bound& bound) {
  for (const int bits : query.precisions) {
    const FixedPoint format = bound.fixed_point(bits);
    if (!allow(settings::lane_fixed_bits(scene.reference.format), format)) continue;
    for (const Multipliers multipliers : query.multipliers) {
      lanes.push_back(
          {.format = {{}, format}, .inputs = {}, .bound = bound, .multipliers = multipliers});
    }
  }
}

/// Visits the components of one query.
class Walk {
public:
  Walk(ComponentMaker& maker, const ComponentQuery& query,
       const std::function<void(const Component&)>& use)
      : maker_(maker), query_(query), use_(use) {}

  Result<std::vector<MissingLane>> run() {
    if (needs_lanes()) {
      MIXCMP_TRY(lanes, visit_lanes());
      MIXCMP_DO(visit_second_tier());
    }
    if (asked(ComponentKind::second_lane)) {
      MIXCMP_DO(visit_second_lanes());
    }
    MIXCMP_TRY(references, visit_references());
    MIXCMP_DO(visit_sizes(measured::Fifo{}, slots_));
    if (recomputes() && maker_.has_crossbar()) {
      MIXCMP_DO(visit_sizes(measured::Crossbar{}, query_.crossbars));
    }
    if (recomputes() && maker_.engine().kind == scene::EngineKind::arg_min) {
      MIXCMP_DO(visit_sizes(measured::OperandMemory{}, measured_memory_references));
    }
    if (asked(ComponentKind::unit)) {
      for (const ComponentKey& unit : units_) {
        MIXCMP_TRY(visited, visit(unit));
      }
    }
    return std::move(missing_);
  }

private:
  bool asked(ComponentKind kind) const { return query_.kinds.contains(kind); }
  bool needs_lanes() const {
    constexpr std::array kinds = {ComponentKind::lane,       ComponentKind::fifo,
                                  ComponentKind::unit,       ComponentKind::segment,
                                  ComponentKind::conversion, ComponentKind::engine};
    return std::any_of(kinds.begin(), kinds.end(), [this](auto kind) { return asked(kind); });
  }
  bool recomputes() const { return maker_.scene().system.references.value_or(1) > 0; }

  Result<Done> visit(const ComponentKey& key) {
    MIXCMP_TRY(component, maker_.make(key));
    take(component);
    return Done{};
  }

  /// Visits a component unless one with the same key was visited before.
  void take(const Component& component) {
    if (asked(ComponentKind::unit)) {
      for (const ComponentParts parts = component.parts(); const Part& part : parts.instances) {
        if (part.instance.module == "delay_line") continue;
        units_.insert(measured::Unit{instance_name(part.instance)});
      }
    }
    const bool named = !query_.only || query_.only->contains(component.key);
    if (!asked(kind_of(component.key)) || !named) return;
    if (seen_.insert(component.key).second) use_(component);
  }

  Result<Done> visit_lanes() {
    MIXCMP_TRY(lanes, lanes_of(maker_.scene(), query_));
    for (const measured::Lane& wanted : lanes) {
      const Result<design::Lane> designed = maker_.lane(wanted);
      if (!designed.ok()) {
        missing_.push_back({wanted, designed.error()});
        continue;
      }
      // Further bits change nothing in a lane on grids.
      if (wanted.bound == grid_bound && !grid_lanes_.insert(wanted.multipliers).second) continue;
      if (!maker_.has_engine()) {
        MIXCMP_DO(visit_stream_lane(wanted));
        continue;
      }
      if (asked(ComponentKind::lane) || asked(ComponentKind::unit)) MIXCMP_DO(visit(wanted));
      MIXCMP_DO(visit_engine_parts(wanted));
    }
    return Done{};
  }

  /// Visits a lane and notes the slots that it needs.
  Result<Done> visit_stream_lane(const measured::Lane& wanted) {
    MIXCMP_TRY(lane, maker_.make(wanted));
    const int registers = maker_.scene().system.input_registers;
    slots_.insert(design::slots_for(lane.latency_cycles + registers, recomputes()));
    take(lane);
    return Done{};
  }

  /// Visits the lane of the second tier. Such lanes are in an engine's segments or in second lanes.
  Result<Done> visit_second_tier() {
    MIXCMP_TRY(lane, optimise::second_tier_lane(maker_.scene()));
    return lane ? visit(*lane) : Done{};
  }

  /// A second lane for each number of slots that one needs before a reference that is asked for.
  Result<Done> visit_second_lanes() {
    MIXCMP_TRY(lane, optimise::second_tier_lane(maker_.scene()));
    if (!lane || maker_.has_engine()) return Done{};
    MIXCMP_TRY(made, maker_.make(*lane));
    std::set<int> slots;
    for (const design::ReferenceStructure& structure : reference_structures()) {
      MIXCMP_TRY(reference, maker_.make(reference_key(maker_.scene(), structure)));
      slots.insert(design::second_tier_slots_for(maker_.scene().system, made.latency_cycles,
                                                 reference.latency_cycles));
    }
    return visit_sizes(measured::SecondLane{*lane}, slots);
  }

  /// Visits the parts of an engine with such lanes. Lanes in floating point and in block floating
  /// point have no conversion.
  Result<Done> visit_engine_parts(const measured::Lane& lane) {
    if (asked(ComponentKind::segment)) {
      MIXCMP_DO(visit(measured::Segment{lane, maker_.engine().lanes_per_segment()}));
    }
    if (asked(ComponentKind::engine)) {
      MIXCMP_TRY(sizes, maker_.engine_sizes());
      MIXCMP_DO(visit_sizes(measured::Engine{lane}, sizes));
    }
    if (!asked(ComponentKind::conversion)) return Done{};
    MIXCMP_TRY(converts, maker_.converts(lane));
    return converts ? visit(measured::Conversion{lane}) : Done{};
  }

  Result<Done> visit_references() {
    const bool wanted = asked(ComponentKind::reference) || asked(ComponentKind::unit) ||
                        asked(ComponentKind::reference_port);
    if (!recomputes() || !wanted) return Done{};
    for (const design::ReferenceStructure& structure : reference_structures()) {
      MIXCMP_TRY(visited, visit_reference(structure));
    }
    return Done{};
  }

  std::vector<design::ReferenceStructure> reference_structures() const {
    std::vector<design::ReferenceStructure> structures;
    for (const Multipliers multipliers : reference_multipliers(query_)) {
      // References in fixed point are not folded.
      const bool is_folded = !maker_.scene().has_fixed_references();
      for (const int interval : is_folded ? query_.initiation_intervals : std::vector<int>{1}) {
        for (const std::optional<int> target : query_.reference_targets) {
          structures.push_back({multipliers, interval, target});
        }
      }
    }
    return structures;
  }

  Result<Done> visit_reference(const design::ReferenceStructure& structure) {
    const measured::Reference reference = reference_key(maker_.scene(), structure);
    if (asked(ComponentKind::reference) || asked(ComponentKind::unit)) {
      MIXCMP_DO(visit(reference));
    }
    if (!asked(ComponentKind::reference_port)) return Done{};
    return visit(measured::ReferencePort{reference});
  }

  template <measured::Counted Component, class Counts>
  Result<Done> visit_sizes(Component component, const Counts& counts) {
    if (!asked(component.kind)) return Done{};
    for (const int count : counts) {
      component.*Component::count = count;
      MIXCMP_DO(visit(component));
    }
    return Done{};
  }

  ComponentMaker& maker_;
  const ComponentQuery& query_;
  const std::function<void(const Component&)>& use_;
  std::set<ComponentKey> seen_;
  std::set<ComponentKey> units_;
  std::set<int> slots_;
  std::set<std::optional<Multipliers>> grid_lanes_;  ///< the multipliers of those visited
  std::vector<MissingLane> missing_;
};

}  // namespace

std::vector<Multipliers> reference_multipliers(const ComponentQuery& query) {
  std::vector<Multipliers> kinds = float_multipliers(query);
  if (kinds.empty()) kinds.push_back(Multipliers::embedded);
  return kinds;
}

Result<std::vector<measured::Lane>> lanes_of(const Scene& scene, const ComponentQuery& query) {
  std::vector<measured::Lane> lanes;
  for (const Bound& bound : query.bounds) {
    if (bound.is_fixed_point()) add_fixed_lanes(lanes, scene, query, bound);
    for (const int precision : query.precisions) {
      if (bound.is_fixed_point()) break;
      for (const LaneInputs inputs : query.inputs) {
        // A number of digits applies to lanes with fewer digits. With as many or more, inputs are
        // rounded.
        if (inputs.in_lane(precision, scene.reference.format.precision()) != inputs) continue;
        const int bits = exponent_bits(scene, query, precision, inputs, bound);
        MIXCMP_TRY(format, FloatFormat::make(precision, bits));
        for (const Multipliers multipliers : float_multipliers(query)) {
          lanes.push_back({.format = {format, {}},
                           .inputs = inputs,
                           .bound = bound,
                           .multipliers = multipliers});
        }
      }
    }
  }
  if (query.lanes) {
    std::erase_if(lanes, [&](const auto& lane) { return !query.lanes->contains(lane); });
  }
  return lanes;
}

Result<std::vector<MissingLane>> for_each_component(
    ComponentMaker& maker, const ComponentQuery& query,
    const std::function<void(const Component&)>& use) {
  return Walk(maker, query, use).run();
}

}  // namespace mixcmp::components
