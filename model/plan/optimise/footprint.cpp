#include "model/plan/optimise/footprint.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "model/base/common/check.hpp"
#include "model/cost/estimated/cost_model.hpp"
#include "model/cost/performance/performance.hpp"
#include "model/design/slots.hpp"
#include "model/plan/optimise/engine_area.hpp"
#include "model/scene/lane_bound.hpp"

namespace mixcmp::optimise {
namespace {

/// A design may fit if its rough estimate is at most this multiple of the device.
constexpr double rough_margin = 1.5;

std::optional<Bound> bound_of(const design::Lane& lane) {
  return std::visit([](const auto& made) -> std::optional<Bound> { return scene::bound_of(made); },
                    lane);
}

/// The lanes of a group, as a table names them; none if their parts have several bounds.
std::optional<measured::Lane> lane_of(const design::LaneGroup& group) {
  const std::optional<Bound> bound = bound_of(group.lane);
  if (!bound) return std::nullopt;
  const bool floating = std::holds_alternative<error::Lane>(group.lane);
  return measured::Lane{.format = LaneFormat::parse(design::format_name(group.lane)).value(),
                        .inputs = floating ? std::optional(group.inputs) : std::nullopt,
                        .bound = *bound,
                        .multipliers = group.multipliers};
}

bool has_engine(const design::Design& design) {
  return design.system.engine.kind != scene::EngineKind::none;
}

/// The row of a lane, or in an engine of the segment that contains it.
const measured::Measurement* row_of(const measured::Characterisation& table,
                                    const design::Design& design, const design::LaneGroup& group) {
  const std::optional<measured::Lane> lane = lane_of(group);
  if (!lane) return nullptr;
  if (!has_engine(design)) return table.find_datapath(*lane);
  return table.find_datapath(measured::Segment{*lane, design.system.engine.lanes_per_segment()});
}

const measured::Measurement* row_of(const measured::Characterisation& table,
                                    const design::Design& design,
                                    const design::ReferenceGroup& group) {
  return table.find_datapath(
      measured::Reference{.format = design::datapath_format(design.reference_datapath()),
                          .multipliers = group.structure.multipliers,
                          .sums = design.reference.arithmetic.sums,
                          .initiation_interval = group.structure.initiation_interval,
                          .target_mhz = group.structure.own_target_mhz(design.system.target_mhz)});
}

/// The row with the largest count, but at most `most`; null if there is none.
const measured::Measurement* largest(const std::map<int, const measured::Measurement*>& sizes,
                                     int most) {
  const auto above = sizes.upper_bound(most);
  return above == sizes.begin() ? nullptr : std::prev(above)->second;
}

/// Adds the references with all that the table has of their own parts; false if it lacks a
/// reference.
bool add_references(Amounts& sum, const design::Design& design,
                    const measured::Characterisation& table) {
  std::set<std::string> missing;
  for (const design::ReferenceGroup& group : design.references) {
    const measured::Measurement* row = row_of(table, design, group);
    if (row == nullptr) return false;
    add(sum, group.count, area_with_port(table, *row, design.system.engine.kind, missing));
  }
  return true;
}

/// Adds the crossbar between `asking` and `asked` ports; nothing if the table has none.
void add_crossbar(Amounts& sum, int asking, int asked, const measured::Characterisation& table) {
  const auto sizes = sizes_of(table, measured::Crossbar{});
  for (const int served : performance::lanes_of_references(asking, asked)) {
    const measured::Measurement* share = largest(sizes, served);
    if (share != nullptr) add(sum, 1, share->area);
  }
}

/// Adds the lanes of a second tier, with the most slots of any such lane in the table; false if it
/// has none.
bool add_second_lanes(Amounts& sum, const design::LaneGroup& tier,
                      const measured::Characterisation& table) {
  const std::optional<measured::Lane> lane = lane_of(tier);
  const auto sizes = lane ? sizes_of(table, measured::SecondLane{*lane})
                          : std::map<int, const measured::Measurement*>();
  if (sizes.empty()) return false;
  add(sum, tier.count, sizes.rbegin()->second->area);
  return true;
}

/// Adds all crossbars of a system, and the second lanes between them; false if a second lane has no
/// row.
bool add_recomputation(Amounts& sum, const design::Design& design,
                       const measured::Characterisation& table) {
  const int groups = design.lane_count() / design.system.lanes_per_group;
  if (!design.has_second_lanes()) {
    add_crossbar(sum, groups, design.reference_count(), table);
    return true;
  }
  add_crossbar(sum, groups, design.second_tier->count, table);
  add_crossbar(sum, design.second_tier->count, design.reference_count(), table);
  return add_second_lanes(sum, *design.second_tier, table);
}

std::optional<Amounts> measured_engine(const design::Design& design,
                                       const measured::Characterisation& table) {
  Amounts lanes{}, own{};
  for (const design::LaneGroup& group : design.lanes) {
    const measured::Measurement* segment = row_of(table, design, group);
    if (segment == nullptr) return std::nullopt;
    std::set<std::string> missing;
    const std::optional<EngineArea> engine =
        engine_area(table, *segment,
                    {.kind = design.system.engine.kind,
                     .recomputes = design.reference_count() > 0,
                     .arrives_in_fixed_point = design.has_fixed_operands()},
                    missing);
    if (!engine) return std::nullopt;
    const int lanes_each = design.system.engine.lanes_per_segment();
    const int groups = (group.count + lanes_each - 1) / lanes_each;
    add(lanes, groups, engine->group);
    const Amounts needed = amounts_of(engine->own);
    for (std::size_t r = 0; r < own.size(); ++r) own[r] = std::max(own[r], needed[r]);
  }
  for (std::size_t r = 0; r < own.size(); ++r) lanes[r] += own[r];
  if (!add_references(lanes, design, table)) return std::nullopt;
  add_crossbar(lanes, design.lane_count() / design.system.lanes_per_group, design.reference_count(),
               table);
  return lanes;
}

std::optional<Amounts> measured_system(const design::Design& design,
                                       const measured::Characterisation& table) {
  Amounts sum{};
  int slowest = 0;
  for (const design::LaneGroup& group : design.lanes) {
    const measured::Measurement* row = row_of(table, design, group);
    if (row == nullptr) return std::nullopt;
    add(sum, group.count, row->area);
    slowest = std::max(slowest, row->latency_cycles);
  }
  if (!add_references(sum, design, table)) return std::nullopt;
  const int slots =
      design::slots_for(slowest + design.system.input_registers, design.reference_count() > 0);
  const measured::Measurement* fifo = largest(sizes_of(table, measured::Fifo{}), slots);
  if (fifo != nullptr) {
    add(sum, design.lane_count() / design.system.lanes_per_group, fifo->area);
  }
  if (!add_recomputation(sum, design, table)) return std::nullopt;
  return sum;
}

std::optional<Amounts> measured_amounts(const design::Design& design,
                                        const measured::Characterisation& table) {
  return has_engine(design) ? measured_engine(design, table) : measured_system(design, table);
}

/// Products cost no LUTs if embedded multipliers may compute them.
estimated::Products products_of(scene::Multipliers multipliers, const devices::Device& device) {
  switch (multipliers) {
    case scene::Multipliers::embedded:
      return device.available.dsps > 0 ? estimated::Products::left_out
                                       : estimated::Products::in_luts;
    case scene::Multipliers::logic: return estimated::Products::in_luts;
    case scene::Multipliers::memory: return estimated::Products::squares_in_memory;
  }
  MIXCMP_CHECK(false);
}

double rough_luts(const design::Design& design, const devices::Device& device) {
  double luts = 0;
  for (const design::LaneGroup& group : design.lanes) {
    const estimated::Products products = products_of(group.multipliers, device);
    luts += group.count *
            std::visit([&](const auto& lane) { return estimated::lane_luts(lane, products); },
                       group.lane);
  }
  // An upper bound: a folded reference costs less.
  for (const design::ReferenceGroup& group : design.references) {
    const estimated::Products products = products_of(group.structure.multipliers, device);
    luts += group.count * estimated::reference_luts(design.reference_datapath(), products);
  }
  return luts;
}

std::string counted(int count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

Footprint footprint_of(const design::Design& design, const measured::Characterisation* table,
                       const devices::Device& device) {
  const auto measured = table == nullptr ? std::nullopt : measured_amounts(design, *table);
  if (measured) return {.amounts = *measured, .measured = true};
  return {.amounts = {std::llround(rough_luts(design, device))}, .measured = false};
}

std::optional<std::string> excess_of(const Footprint& footprint, const design::Design& design,
                                     const devices::Device& device, const std::string& source) {
  const Amounts room = amounts_of(device.available);
  const double margin = footprint.measured ? 1 : rough_margin;
  std::string excess;
  for (std::size_t r = 0; r < room.size(); ++r) {
    const auto needed = footprint.amounts[r];
    if (static_cast<double>(needed) <= margin * static_cast<double>(room[r])) continue;
    excess += fmt::format("{}{} {} of {}", excess.empty() ? "" : ", ", needed,
                          devices::bounded_resources[r].name, room[r]);
  }
  if (excess.empty()) return std::nullopt;
  return fmt::format(
      "{} and {} do not fit {}: {} {}; {}", counted(design.lane_count(), "lane"),
      counted(design.reference_count(), "reference"), device.name,
      footprint.measured ? "at least" : "about", excess,
      footprint.measured ? "areas measured, " + source : "a rough estimate before synthesis");
}

}  // namespace mixcmp::optimise
