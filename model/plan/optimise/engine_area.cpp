#include "model/plan/optimise/engine_area.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

namespace mixcmp::optimise {
namespace {

using measured::Measurement;
using Sizes = std::map<int, const Measurement*>;

/// `area` with each resource replaced by the result of `change`.
template <class Change>
devices::Area changed(const devices::Area& area, Change change) {
  devices::Area result;
  for (const devices::Resource& resource : devices::bounded_resources) {
    result.*resource.amount = change(area.*resource.amount, resource.amount);
  }
  return result;
}

/// An area that grows with a number of ports: own + ports x each.
struct Line {
  devices::Area own;
  devices::Area each;
};

/// The line through the smallest and the largest size, rounded up to whole numbers.
Line line_through(const Sizes& sizes) {
  const auto& [fewest, smallest] = *sizes.begin();
  const auto& [most, largest] = *sizes.rbegin();
  const devices::Area& small = smallest->area;
  const devices::Area each =
      changed(largest->area, [&small, more = most - fewest](int amount, auto resource) {
        return std::max(0, (amount - small.*resource + more - 1) / more);
      });
  return {.own = changed(small,
                         [&each, fewest = fewest](int amount, auto resource) {
                           return std::max(0, amount - fewest * (each.*resource));
                         }),
          .each = each};
}

/// A line through the larger size that is nowhere below zero.
Line line_to_the_larger(const Sizes& sizes) {
  const devices::Area& small = sizes.begin()->second->area;
  const devices::Area& large = sizes.rbegin()->second->area;
  const int most = sizes.rbegin()->first;
  const int more = most - sizes.begin()->first;
  const devices::Area each = changed(large, [&](int amount, auto resource) {
    return std::min(std::max(0, amount - small.*resource) / more, amount / most);
  });
  return {.own = changed(
              large, [&](int amount, auto resource) { return amount - most * (each.*resource); }),
          .each = each};
}

void limit(std::optional<double>& mhz, const Measurement& row) {
  if (row.clock) mhz = std::min(mhz.value_or(row.clock->mhz), row.clock->mhz);
}

bool is_converted(const LaneFormat& format) {
  return format.fixed_point && !format.fixed_point->is_block;
}

/// The area of a whole without a part of it, at least zero.
devices::Area without(const devices::Area& whole, const devices::Area& part) {
  return changed(whole,
                 [&](int amount, auto resource) { return std::max(0, amount - part.*resource); });
}

}  // namespace

std::optional<EngineArea> engine_area(const measured::Characterisation& table,
                                      const Measurement& row, EngineUse use,
                                      std::set<std::string>& missing) {
  const auto& segment = std::get<measured::Segment>(row.key);
  const Sizes engines = sizes_of(table, measured::Engine{segment.lane});
  if (engines.size() < 2) {
    missing.insert(
        fmt::format("engines of two sizes around segments in {}", segment.lane.format.name()));
    return std::nullopt;
  }
  // A chain's line is exact at the lanes of the larger engine, with which chains are planned.
  const bool is_chain = use.kind == scene::EngineKind::arg_min;
  const Line line = is_chain ? line_to_the_larger(engines) : line_through(engines);
  const devices::Area memory =
      use.recomputes ? memory_share(table, use.kind, missing) : devices::Area{};
  EngineArea area{
      .own = without(line.own, memory), .group = row.area + line.each, .lane = {}, .mhz = {}};
  area.lane = share(area.group, segment.lanes);
  limit(area.mhz, *engines.rbegin()->second);
  if (!is_converted(segment.lane.format)) return area;
  const Measurement* conversion = table.find(measured::Conversion{segment.lane});
  if (conversion == nullptr) {
    if (use.arrives_in_fixed_point) return area;
    missing.insert(fmt::format("a conversion to {}", segment.lane.format.name()));
    return area;
  }
  area.own += conversion->area;
  limit(area.mhz, *conversion);
  return area;
}

devices::Area memory_share(const measured::Characterisation& table, scene::EngineKind kind,
                           std::set<std::string>& missing) {
  if (kind != scene::EngineKind::arg_min) return {};
  const Sizes memories = sizes_of(table, measured::OperandMemory{});
  if (memories.size() >= 2) return line_through(memories).each;
  missing.insert("operand memories of two sizes");
  return {};
}

devices::Area area_with_port(const measured::Characterisation& table, const Measurement& reference,
                             scene::EngineKind kind, std::set<std::string>& missing) {
  const Measurement* port =
      table.find(measured::ReferencePort{std::get<measured::Reference>(reference.key)});
  const devices::Area area = reference.area + memory_share(table, kind, missing);
  if (port != nullptr) return area + port->area;
  if (kind != scene::EngineKind::none) missing.insert("the port of a reference");
  return area;
}

devices::Area share(const devices::Area& area, int parts) {
  return changed(area, [&](int amount, auto) { return (amount + parts - 1) / parts; });
}

}  // namespace mixcmp::optimise
