#include "model/optimise/engine_area.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/number/lane_format.hpp"

namespace mixcmp::optimise {
namespace {

using characterise::ComponentKey;
using characterise::ComponentKind;
using characterise::Measurement;

/// Each resource of `area` as `change` makes it.
template <class Change>
devices::Area changed(const devices::Area& area, Change change) {
  devices::Area result;
  for (const devices::Resource& resource : devices::bounded_resources) {
    result.*resource.amount = change(area.*resource.amount, resource.amount);
  }
  return result;
}

/// A whole number of `parts` that together are no less than `area`.
devices::Area share(const devices::Area& area, int parts) {
  return changed(area, [&](int amount, auto) { return (amount + parts - 1) / parts; });
}

/// The smallest and the largest engine with such lanes that was measured.
struct MeasuredEngines {
  const Measurement* smallest = nullptr;
  const Measurement* largest = nullptr;
};

MeasuredEngines engines_of(const characterise::Characterisation& table, ComponentKey key) {
  MeasuredEngines found;
  for (const Measurement& row : table.rows) {
    key.kind = ComponentKind::engine;
    key.ports = row.key.ports;
    if (row.key != key) continue;
    if (found.smallest == nullptr || row.key.ports < found.smallest->key.ports) {
      found.smallest = &row;
    }
    if (found.largest == nullptr || row.key.ports > found.largest->key.ports) found.largest = &row;
  }
  return found;
}

void limit(std::optional<double>& mhz, const Measurement& row) {
  if (row.clock) mhz = std::min(mhz.value_or(row.clock->mhz), row.clock->mhz);
}

bool is_converted(const ComponentKey& key) {
  const LaneFormat format = LaneFormat::parse(key.format).value();
  return format.fixed_point && !format.fixed_point->is_block;
}

}  // namespace

std::optional<EngineArea> engine_area(const characterise::Characterisation& table,
                                      const Measurement& segment, std::set<std::string>& missing) {
  const MeasuredEngines engines = engines_of(table, segment.key);
  if (engines.smallest == engines.largest) {
    missing.insert(fmt::format("engines of two sizes around segments in {}", segment.key.format));
    return std::nullopt;
  }
  const int fewest = engines.smallest->key.ports;
  const int more = engines.largest->key.ports - fewest;
  const devices::Area& small = engines.smallest->area;
  const devices::Area each = changed(engines.largest->area, [&](int amount, auto resource) {
    return std::max(0, (amount - small.*resource + more - 1) / more);
  });
  EngineArea area;
  area.own = changed(small, [&](int amount, auto resource) {
    return std::max(0, amount - fewest * (each.*resource));
  });
  area.group = segment.area + each;
  area.lane = share(area.group, segment.key.ports);
  limit(area.mhz, *engines.largest);
  if (!is_converted(segment.key)) return area;
  ComponentKey key = segment.key;
  key.kind = ComponentKind::conversion;
  key.ports = 0;
  const Measurement* conversion = table.find(key);
  if (conversion == nullptr) {
    missing.insert(fmt::format("a conversion to {}", key.format));
    return area;
  }
  area.own += conversion->area;
  limit(area.mhz, *conversion);
  return area;
}

}  // namespace mixcmp::optimise
