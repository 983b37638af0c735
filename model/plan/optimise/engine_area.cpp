#include "model/plan/optimise/engine_area.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/base/number/lane_format.hpp"

namespace mixcmp::optimise {
namespace {

using measured::ComponentKey;
using measured::ComponentKind;
using measured::Measurement;

/// `area` with each resource replaced by the result of `change`.
template <class Change>
devices::Area changed(const devices::Area& area, Change change) {
  devices::Area result;
  for (const devices::Resource& resource : devices::bounded_resources) {
    result.*resource.amount = change(area.*resource.amount, resource.amount);
  }
  return result;
}

/// The smallest and the largest measured component among those that differ only in their number of
/// ports.
struct MeasuredSizes {
  const Measurement* smallest = nullptr;
  const Measurement* largest = nullptr;

  bool are_two() const { return smallest != largest; }
};

MeasuredSizes sizes_of(const measured::Characterisation& table, ComponentKey key) {
  MeasuredSizes found;
  for (const Measurement& row : table.rows) {
    key.ports = row.key.ports;
    if (row.key != key) continue;
    if (found.smallest == nullptr || row.key.ports < found.smallest->key.ports) {
      found.smallest = &row;
    }
    if (found.largest == nullptr || row.key.ports > found.largest->key.ports) found.largest = &row;
  }
  return found;
}

/// An area that grows with a number of ports: own + ports x each.
struct Line {
  devices::Area own;
  devices::Area each;
};

/// The line through two sizes, rounded up to whole numbers.
Line line_through(const MeasuredSizes& sizes) {
  const int fewest = sizes.smallest->key.ports;
  const int more = sizes.largest->key.ports - fewest;
  const devices::Area& small = sizes.smallest->area;
  const devices::Area each = changed(sizes.largest->area, [&](int amount, auto resource) {
    return std::max(0, (amount - small.*resource + more - 1) / more);
  });
  return {.own = changed(small,
                         [&](int amount, auto resource) {
                           return std::max(0, amount - fewest * (each.*resource));
                         }),
          .each = each};
}

/// A line through the larger size that is nowhere below zero.
Line line_to_the_larger(const MeasuredSizes& sizes) {
  const int most = sizes.largest->key.ports;
  const int more = most - sizes.smallest->key.ports;
  const devices::Area& small = sizes.smallest->area;
  const devices::Area each = changed(sizes.largest->area, [&](int amount, auto resource) {
    return std::min(std::max(0, amount - small.*resource) / more, amount / most);
  });
  return {
      .own = changed(sizes.largest->area,
                     [&](int amount, auto resource) { return amount - most * (each.*resource); }),
      .each = each};
}

void limit(std::optional<double>& mhz, const Measurement& row) {
  if (row.clock) mhz = std::min(mhz.value_or(row.clock->mhz), row.clock->mhz);
}

bool is_converted(const ComponentKey& key) {
  const LaneFormat format = LaneFormat::parse(key.format).value();
  return format.fixed_point && !format.fixed_point->is_block;
}

/// The area of a whole without a part of it, at least zero.
devices::Area without(const devices::Area& whole, const devices::Area& part) {
  return changed(whole,
                 [&](int amount, auto resource) { return std::max(0, amount - part.*resource); });
}

}  // namespace

std::optional<EngineArea> engine_area(const measured::Characterisation& table,
                                      const Measurement& segment, scene::EngineKind kind,
                                      std::set<std::string>& missing) {
  ComponentKey key = segment.key;
  key.kind = ComponentKind::engine;
  const MeasuredSizes engines = sizes_of(table, key);
  if (!engines.are_two()) {
    missing.insert(fmt::format("engines of two sizes around segments in {}", segment.key.format));
    return std::nullopt;
  }
  // A chain's line is exact at the lanes of the larger engine, with which chains are planned.
  const Line line =
      kind == scene::EngineKind::arg_min ? line_to_the_larger(engines) : line_through(engines);
  EngineArea area{.own = without(line.own, memory_share(table, kind, missing)),
                  .group = segment.area + line.each,
                  .lane = {},
                  .mhz = {}};
  area.lane = share(area.group, segment.key.ports);
  limit(area.mhz, *engines.largest);
  if (!is_converted(segment.key)) return area;
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

devices::Area memory_share(const measured::Characterisation& table, scene::EngineKind kind,
                           std::set<std::string>& missing) {
  if (kind != scene::EngineKind::arg_min) return {};
  const MeasuredSizes memories = sizes_of(table, {.kind = ComponentKind::operand_memory});
  if (memories.are_two()) return line_through(memories).each;
  missing.insert("operand memories of two sizes");
  return {};
}

devices::Area share(const devices::Area& area, int parts) {
  return changed(area, [&](int amount, auto) { return (amount + parts - 1) / parts; });
}

}  // namespace mixcmp::optimise
