#include "generator/emit/system_plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <map>

#include "generator/datapath/delays.hpp"
#include "generator/rtl/datapath_builder.hpp"
#include "generator/rtl/net_names.hpp"
#include "model/design/slots.hpp"

namespace mixcmp::emit {
namespace {

/// Gives each group the name of its module. Groups of equal lanes share one module; another lane
/// that asks for the same name gets a number appended.
class ModuleNames {
public:
  std::string unique(const std::string& wanted, const design::LaneGroup& group) {
    std::string name = wanted;
    for (int number = 2;; ++number) {
      const design::LaneGroup& known = *groups_.emplace(name, &group).first->second;
      if (known.lane == group.lane && known.multipliers == group.multipliers) return name;
      name = fmt::format("{}_{}", wanted, number);
    }
  }

private:
  std::map<std::string, const design::LaneGroup*> groups_;
};

void add_group(std::vector<rtl::DatapathGroup>& groups, rtl::DatapathGroup group) {
  group.channel = group.datapath + "_channel";
  if (!groups.empty()) group.first = groups.back().first + groups.back().count;
  groups.push_back(std::move(group));
}

void add_lane_groups(const design::Design& design, SystemPlan& plan) {
  const std::vector<std::string> names = lane_group_names(design);
  ModuleNames modules;
  rtl::NamePool labels({});
  for (std::size_t k = 0; k < names.size(); ++k) {
    const int cycles = plan.lanes[k].latency_cycles;
    const std::string name =
        fmt::format("{}{}_lane_{}_l{}", design.system.prefix, design.name, names[k], cycles);
    add_group(plan.shape.lane_groups,
              {.datapath = modules.unique(name, design.lanes[k]),
               .channel = {},
               .label = names.size() == 1 ? "lanes" : labels.unique("lanes_" + names[k]),
               .latency_cycles = cycles,
               .count = design.lanes[k].count});
  }
}

void add_reference_groups(const design::Design& design, SystemPlan& plan) {
  const std::vector<std::string> names = reference_group_names(design);
  rtl::NamePool labels({});
  for (std::size_t k = 0; k < names.size(); ++k) {
    const int cycles = plan.references[k].latency_cycles;
    add_group(plan.shape.reference_groups,
              {.datapath = fmt::format("{}{}_reference_{}_l{}", design.system.prefix, design.name,
                                       names[k], cycles),
               .channel = {},
               .label = names.size() == 1 ? "references" : labels.unique("references_" + names[k]),
               .latency_cycles = cycles,
               .count = design.references[k].count});
  }
}

/// The scene's name, the lanes of each format, p_H: sphere_s8e8_6_s12e8_2x1.
std::string top_name(const design::Design& design) {
  std::vector<std::pair<std::string, int>> formats;
  for (const design::LaneGroup& group : design.lanes) {
    const std::string format = group.lane.graph.arithmetic.format.name();
    const auto known = std::find_if(formats.begin(), formats.end(),
                                    [&](const auto& entry) { return entry.first == format; });
    if (known == formats.end()) {
      formats.emplace_back(format, group.count);
    } else {
      known->second += group.count;
    }
  }
  std::string name = design.name;
  for (const auto& [format, count] : formats) name += fmt::format("_{}_{}", format, count);
  return name + fmt::format("x{}", design.reference_count());
}

void add_counts(const design::Design& design, SystemPlan& plan) {
  rtl::SystemShape& shape = plan.shape;
  shape.lanes = design.lane_count();
  shape.references = design.reference_count();
  int slots = 0;
  for (const datapath::Schedule& lane : plan.lanes) {
    slots = std::max(slots, design::slots_for(lane.latency_cycles, shape.recomputes()));
  }
  shape.slot_bits = std::countr_zero(static_cast<unsigned>(slots));
}

}  // namespace

rtl::SystemShape stream_shape(const std::vector<std::string>& inputs, FloatFormat format,
                              const scene::SystemSpec& system) {
  rtl::SystemShape shape;
  shape.input_ports = rtl::input_ports(inputs);
  shape.input_width = format.width();
  shape.tag_bits = system.tag_bits;
  shape.counter_bits = system.counter_bits;
  shape.order = system.order;
  shape.operands = system.operands;
  return shape;
}

Result<SystemPlan> plan_system(const design::Design& design) {
  MIXCMP_TRY(delays, datapath::delays_of(design.system.device));
  const double target_mhz = design.system.target_mhz;
  SystemPlan plan{
      .lanes = {},
      .references = {},
      .shape = stream_shape(design.inputs, design.reference.input_format, design.system),
      .engine = {}};
  for (const design::LaneGroup& group : design.lanes) {
    plan.lanes.push_back(
        datapath::schedule_lane(group.lane, group.multipliers, delays, target_mhz));
  }
  for (const design::ReferenceGroup& group : design.references) {
    plan.references.push_back(
        datapath::schedule_reference(design.reference, group.multipliers, delays, target_mhz));
  }
  plan.shape.top = top_name(design);
  add_counts(design, plan);
  add_lane_groups(design, plan);
  add_reference_groups(design, plan);
  plan.engine = rtl::engine_shape(plan.shape, design.inputs, design.system.engine);
  return plan;
}

}  // namespace mixcmp::emit
