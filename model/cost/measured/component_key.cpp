#include "model/cost/measured/component_key.hpp"

#include <tuple>
#include <utility>

#include "model/base/common/check.hpp"

namespace mixcmp::measured {

std::string_view to_string(ComponentKind kind) {
  switch (kind) {
    case ComponentKind::unit: return "unit";
    case ComponentKind::lane: return "lane";
    case ComponentKind::reference: return "reference";
    case ComponentKind::fifo: return "fifo";
    case ComponentKind::crossbar: return "crossbar";
    case ComponentKind::reference_port: return "reference_port";
    case ComponentKind::second_lane: return "second_lane";
    case ComponentKind::segment: return "segment";
    case ComponentKind::conversion: return "conversion";
    case ComponentKind::engine: return "engine";
    case ComponentKind::operand_memory: return "operand_memory";
  }
  MIXCMP_CHECK(false);
}

std::strong_ordering operator<=>(const Lane& a, const Lane& b) {
  return std::tuple(a.format.name(), a.inputs, a.bound, a.multipliers) <=>
         std::tuple(b.format.name(), b.inputs, b.bound, b.multipliers);
}

std::strong_ordering operator<=>(const Reference& a, const Reference& b) {
  return std::tuple(a.format.name(), a.multipliers, a.sums, a.initiation_interval, a.target_mhz) <=>
         std::tuple(b.format.name(), b.multipliers, b.sums, b.initiation_interval, b.target_mhz);
}

ComponentKind kind_of(const ComponentKey& key) {
  return std::visit([](const auto& component) { return component.kind; }, key);
}

const Lane* lane_of(const ComponentKey& key) {
  if (const auto* lane = std::get_if<Lane>(&key)) return lane;
  return std::visit(
      [](const auto& component) -> const Lane* {
        if constexpr (requires { component.lane; }) return &component.lane;
        return nullptr;
      },
      key);
}

const Reference* reference_of(const ComponentKey& key) {
  if (const auto* reference = std::get_if<Reference>(&key)) return reference;
  return std::visit(
      [](const auto& component) -> const Reference* {
        if constexpr (requires { component.reference; }) return &component.reference;
        return nullptr;
      },
      key);
}

Lane* lane_of(ComponentKey& key) {
  return const_cast<Lane*>(lane_of(std::as_const(key)));
}

Reference* reference_of(ComponentKey& key) {
  return const_cast<Reference*>(reference_of(std::as_const(key)));
}

ComponentKey without_multipliers(ComponentKey key) {
  if (Lane* lane = lane_of(key)) lane->multipliers.reset();
  if (Reference* reference = reference_of(key)) reference->multipliers.reset();
  return key;
}

std::optional<int> count_of(const ComponentKey& key) {
  return std::visit(
      []<class Component>(const Component& component) -> std::optional<int> {
        if constexpr (Counted<Component>) return component.*Component::count;
        return std::nullopt;
      },
      key);
}

}  // namespace mixcmp::measured
