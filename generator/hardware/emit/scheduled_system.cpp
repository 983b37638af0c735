#include "generator/hardware/emit/scheduled_system.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <map>

#include "generator/hardware/datapath/delays.hpp"
#include "generator/hardware/datapath/schedule.hpp"
#include "generator/hardware/emit/signature.hpp"
#include "generator/hardware/rtl/arg_min_module.hpp"
#include "generator/hardware/rtl/datapath_builder.hpp"
#include "generator/hardware/rtl/net_names.hpp"
#include "model/base/common/content_hash.hpp"
#include "model/cost/devices/device.hpp"
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
  group.channel = group.datapath + std::string(channel_suffix);
  if (!groups.empty()) group.first = groups.back().first + groups.back().count;
  groups.push_back(std::move(group));
}

/// The groups of a design's lanes. With `words`, they are the lanes of an engine behind the
/// conversion.
std::vector<rtl::DatapathGroup> lane_groups(const design::Design& design,
                                            const rtl::SystemShape& shape,
                                            const std::optional<rtl::ItemWords>& words,
                                            const datapath::DelayTable& delays) {
  const std::vector<std::string> names = lane_group_names(design);
  ModuleNames modules;
  rtl::NamePool labels({});
  std::vector<rtl::DatapathGroup> groups;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const design::LaneGroup& lanes = design.lanes[k];
    datapath::Schedule schedule =
        datapath::schedule_lane(words ? words->lanes[k].lane : lanes.lane, lanes.multipliers,
                                delays, design.system.target_mhz);
    const std::string name =
        fmt::format("{}{}_{}_{}_l{}", design.system.prefix, design.name,
                    words ? "pair_lane" : "lane", names[k], schedule.latency_cycles);
    add_group(groups, {.datapath = modules.unique(name, lanes),
                       .operands = shape.operand_ports(),
                       .channel = {},
                       .label = names.size() == 1 ? "lanes" : labels.unique("lanes_" + names[k]),
                       .schedule = std::move(schedule),
                       .count = lanes.count});
  }
  return groups;
}

/// The lanes of the second tier. In an engine there is one behind each segment, and they also read
/// `words`.
std::optional<rtl::DatapathGroup> second_tier(const design::Design& design,
                                              const rtl::SystemShape& shape,
                                              const std::optional<rtl::ItemWords>& words,
                                              const datapath::DelayTable& delays) {
  if (!design.second_tier) return std::nullopt;
  const design::LaneGroup& tier = *design.second_tier;
  datapath::Schedule schedule =
      datapath::schedule_lane(words ? words->second_tier->lane : tier.lane, tier.multipliers,
                              delays, design.system.target_mhz);
  const std::string datapath =
      fmt::format("{}{}_second_lane_{}_l{}", design.system.prefix, design.name,
                  design::format_name(tier.lane), schedule.latency_cycles);
  return rtl::DatapathGroup{
      .datapath = datapath,
      .operands = words ? std::vector<rtl::OperandPort>{} : shape.operand_ports(),
      .channel = datapath + std::string(channel_suffix),
      .label = "second_tier",
      .schedule = std::move(schedule),
      .count = tier.count};
}

std::vector<rtl::DatapathGroup> reference_groups(const design::Design& design,
                                                 const rtl::SystemShape& shape,
                                                 const datapath::DelayTable& delays) {
  const std::vector<std::string> names = reference_group_names(design);
  rtl::NamePool labels({});
  std::vector<rtl::DatapathGroup> groups;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const design::ReferenceGroup& references = design.references[k];
    datapath::Schedule schedule = datapath::schedule_reference(
        design.reference_datapath(), references.structure, delays,
        references.structure.target_mhz.value_or(design.system.target_mhz));
    add_group(groups,
              {.datapath = fmt::format("{}{}_reference_{}_l{}", design.system.prefix, design.name,
                                       names[k], schedule.latency_cycles),
               .operands = shape.operand_ports(),
               .channel = {},
               .label = names.size() == 1 ? "references" : labels.unique("references_" + names[k]),
               .schedule = std::move(schedule),
               .count = references.count});
  }
  return groups;
}

/// The most characters that other modules add to the top's name: an engine adds its kind, and a
/// test bench "_tb".
std::size_t longest_suffix(scene::EngineKind kind) {
  const bool is_engine = kind != scene::EngineKind::none;
  return bench_suffix.size() + (is_engine ? 1 + to_string(kind).size() : 0);
}

/// A short form of a list of formats that is too long for a name: their number and a hash of the
/// list, "_24kinds_0d1f65c8".
std::string hashed_list(const std::string& list, std::size_t formats) {
  return fmt::format("_{}kinds_{}", formats, ContentHash().add(list).hex().substr(0, 8));
}

/// The name of the top: the scene's name, each format of lanes with their number, the same for a
/// second tier, and p_H. Examples are sphere_s8e8_6_s12e8_2x1 and sphere_q8_64xq13_2x1. The names
/// of modules around the top are this name with a suffix.
std::string top_name(const design::Design& design) {
  std::vector<std::pair<std::string, int>> formats;
  for (const design::LaneGroup& group : design.lanes) {
    const std::string format = design::format_name(group.lane);
    const auto known = std::find_if(formats.begin(), formats.end(),
                                    [&](const auto& entry) { return entry.first == format; });
    if (known == formats.end()) {
      formats.emplace_back(format, group.count);
    } else {
      known->second += group.count;
    }
  }
  std::string list;
  for (const auto& [format, count] : formats) list += fmt::format("_{}_{}", format, count);
  std::string end;
  if (design.has_second_lanes()) {
    const design::LaneGroup& tier = *design.second_tier;
    end += fmt::format("x{}_{}", design::format_name(tier.lane), tier.count);
  }
  end += fmt::format("x{}", design.reference_count());
  const std::size_t length =
      design.name.size() + list.size() + end.size() + longest_suffix(design.system.engine.kind);
  if (length > longest_module_name) list = hashed_list(list, formats.size());
  return design.name + list + end;
}

int slowest_cycles(const std::vector<rtl::DatapathGroup>& groups) {
  int slowest = 0;
  for (const rtl::DatapathGroup& group : groups) {
    slowest = std::max(slowest, group.schedule.latency_cycles);
  }
  return slowest;
}

int second_tier_slot_bits(const design::Design& design, const rtl::SystemShape& shape) {
  const int slots =
      design::second_tier_slots_for(design.system, shape.second_tier->schedule.latency_cycles,
                                    slowest_cycles(shape.reference_groups));
  return std::countr_zero(static_cast<unsigned>(slots));
}

/// The slots that the slowest lane needs.
int slots_of(const rtl::SystemShape& shape, const scene::EngineSpec& engine) {
  const int slowest = slowest_cycles(shape.lane_groups);
  return engine.kind == scene::EngineKind::arg_min
             ? design::chain_slots_for(slowest, shape.recomputes())
             : design::slots_for(slowest + shape.input_registers, shape.recomputes());
}

/// Makes the counters in the modules narrow: the port on which they are read widens them.
void narrow_counters(ScheduledSystem& scheduled) {
  rtl::SystemShape& shape = scheduled.shape;
  if (shape.counter_bits == 0) return;
  shape.read_counter_bits = shape.counter_bits;
  // Without references a group may report several undecided comparisons in a cycle.
  const int events = shape.recomputes() ? 1 : shape.lanes_per_group;
  shape.counter_bits = rtl::narrow_counter_bits(scheduled.counters(), events);
}

}  // namespace

const rtl::ItemWords* ScheduledSystem::words() const {
  if (pairwise) return &pairwise->words;
  return arg_min ? &arg_min->words : nullptr;
}

std::vector<rtl::Counters> ScheduledSystem::counters() const {
  if (pairwise) return rtl::pairwise_counters(*pairwise, shape);
  return arg_min ? rtl::arg_min_counters(shape) : rtl::system_counters(shape);
}

namespace {

/// Whether the device's synthesis builds a memory whose write port is wider than its read port.
/// Quartus makes registers of this memory if it is written in Verilog-2001.
bool has_ports_of_two_widths(const scene::SystemSpec& system) {
  const auto device = devices::find_device(system.device);
  return device.ok() && device->quartus_part.empty();
}

/// Adds the other parts of the engine around a system whose lanes are scheduled.
void add_engine(std::optional<rtl::ItemWords> words, rtl::SystemShape& shape,
                ScheduledSystem& scheduled) {
  if (!scheduled.engine) return;
  const rtl::EngineShape& engine = *scheduled.engine;
  switch (engine.spec.kind) {
    case scene::EngineKind::none: return;
    case scene::EngineKind::pairwise:
      scheduled.pairwise =
          rtl::PairwiseShape{.engine = engine,
                             .words = std::move(*words),
                             .segments = rtl::segment_groups(shape, engine.spec.lanes_per_group)};
      return;
    case scene::EngineKind::arg_min:
      scheduled.arg_min = rtl::arg_min_shape(engine, std::move(*words), shape);
      return;
  }
}

}  // namespace

rtl::SystemShape stream_shape(const std::vector<std::string>& inputs,
                              const std::vector<OperandFormat>& formats,
                              const scene::SystemSpec& system) {
  rtl::SystemShape shape;
  shape.input_ports = rtl::input_ports(inputs);
  shape.input_formats = formats;
  shape.tag_bits = system.tag_bits;
  shape.counter_bits = system.counter_bits;
  shape.input_registers = system.input_registers;
  shape.lanes_per_group = system.lanes_per_group;
  shape.order = system.order;
  shape.operands = system.operands;
  if (system.operands == scene::OperandStore::carried) {
    shape.beat_bits = std::countr_zero(static_cast<unsigned>(system.request_beats.value_or(1)));
    shape.block_memory =
        system.operand_memory == scene::OperandMemory::block && has_ports_of_two_widths(system);
  }
  return shape;
}

Result<ScheduledSystem> schedule_system(const design::Design& design) {
  MIXCMP_TRY(delays, datapath::delays_of(design.system.device));
  rtl::SystemShape shape = stream_shape(design.inputs, design.formats_of_inputs(), design.system);
  shape.top = top_name(design);
  shape.lanes = design.lane_count();
  shape.references = design.reference_count();
  ScheduledSystem scheduled;
  scheduled.engine = rtl::engine_shape(shape, design.inputs, design.system.engine);
  std::optional<rtl::ItemWords> words;
  if (scheduled.engine) words = rtl::item_words(design, *scheduled.engine, delays);
  shape.lane_groups = lane_groups(design, shape, words, delays);
  shape.second_tier = second_tier(design, shape, words, delays);
  shape.reference_groups = reference_groups(design, shape, delays);
  if (shape.second_tier) shape.second_tier_slot_bits = second_tier_slot_bits(design, shape);
  shape.slot_bits = std::countr_zero(static_cast<unsigned>(slots_of(shape, design.system.engine)));
  add_engine(std::move(words), shape, scheduled);
  scheduled.shape = std::move(shape);
  if (design.system.counters == scene::CounterAccess::axi_lite) narrow_counters(scheduled);
  return scheduled;
}

}  // namespace mixcmp::emit
