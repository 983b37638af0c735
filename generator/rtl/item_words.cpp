#include "generator/rtl/item_words.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "generator/datapath/fixed_schedule.hpp"
#include "generator/rtl/datapath_builder.hpp"
#include "generator/rtl/fixed_lane_module.hpp"
#include "generator/rtl/fixed_nodes.hpp"
#include "generator/rtl/float_lane_module.hpp"
#include "generator/rtl/net_names.hpp"

namespace mixcmp::rtl {
namespace {

/// The lane, if its operands can be converted without knowing those of the other item.
const fixed::FixedLane* splittable(const design::Lane& lane) {
  const auto* made = std::get_if<fixed::FixedLane>(&lane);
  return made != nullptr && !made->format.is_block ? made : nullptr;
}

class WordMaker {
public:
  WordMaker(const design::Design& design, const EngineShape& engine)
      : design_(design), engine_(engine), names_({}) {}

  ItemWords run() {
    split_lanes();
    if (words_.converts()) add_converted_fields();
    for (const design::LaneGroup& group : design_.lanes) {
      words_.lanes.push_back(word_lane(group.lane));
    }
    if (design_.second_tier) words_.second_tier = word_lane(design_.second_tier->lane);
    return std::move(words_);
  }

private:
  void split_lanes() {
    std::vector<const fixed::FixedLane*> lanes;
    for (const design::LaneGroup& group : design_.lanes) {
      if (const auto* lane = splittable(group.lane)) lanes.push_back(lane);
    }
    if (design_.second_tier) lanes.push_back(splittable(design_.second_tier->lane));
    if (lanes.empty()) return;
    std::vector<fixed::ItemInput> inputs;
    for (const EngineShape::Source& source : engine_.sources) {
      inputs.push_back(
          {.column = static_cast<int>(source.column), .second = source.item == data::Item::second});
    }
    words_.split = fixed::split_by_item(lanes, inputs, engine_.columns);
  }

  void add_converted_fields() {
    const fixed::FixedLane& loader = words_.split->loader;
    NamePool pool({});
    const std::vector<std::string> names = name_nodes(loader, engine_.columns, pool);
    for (const NodeId id : loader.outputs) {
      const fixed::FixedNode& node = loader.nodes[id];
      const bool is_input = node.operation == Operation::input;
      add_field(is_input ? engine_.columns[node.input] : names[id], node.format.width);
    }
    for (std::size_t flag = 0; flag < words_.split->flags.size(); ++flag) {
      add_field("out_of_range", 1);
    }
  }

  std::size_t add_field(const std::string& name, int width) {
    const int low = words_.fields.empty() ? 0 : words_.bits();
    words_.fields.push_back({names_.unique(name), width, low});
    return words_.fields.size() - 1;
  }

  LanePort port_of(std::size_t field, bool second, int dropped_bits = 0) const {
    const ItemWords::Field& bits = words_.fields[field];
    return {bits.name + (second ? "_j" : "_i"), second, bits.low + dropped_bits,
            bits.width - dropped_bits};
  }

  /// The lanes come in the order in which they were split.
  WordLane word_lane(const design::Lane& lane) {
    return splittable(lane) != nullptr ? lane_of_fields(words_.split->lanes[next_split_++])
                                       : lane_of_columns(lane);
  }

  WordLane lane_of_fields(const fixed::FixedLane& lane) const {
    WordLane made{lane, {}};
    for (const fixed::LoadedInput& loaded : lane.loaded_inputs) {
      made.ports.push_back(port_of(loaded.field, loaded.second, loaded.dropped_bits));
    }
    const std::size_t first_flag = words_.split->loader.outputs.size();
    for (const fixed::LoadedFlag& flag : fixed::flags_read(lane)) {
      made.ports.push_back(port_of(first_flag + flag.flag, flag.second));
    }
    return made;
  }

  WordLane lane_of_columns(const design::Lane& lane) {
    WordLane made{lane, {}};
    const std::vector<std::string> names = input_ports(design_.inputs);
    for (std::size_t k = 0; k < engine_.sources.size(); ++k) {
      const EngineShape::Source& source = engine_.sources[k];
      const ItemWords::Field& bits = words_.fields[column_field(source.column)];
      made.ports.push_back({names[k], source.item == data::Item::second, bits.low, bits.width});
    }
    return made;
  }

  /// The field that holds a column as it arrives.
  std::size_t column_field(std::size_t column) {
    const auto known = std::find(words_.columns.begin(), words_.columns.end(), column);
    if (known == words_.columns.end()) {
      words_.columns.push_back(column);
      return add_field(engine_.columns[column], engine_.column_width);
    }
    const auto behind = static_cast<std::size_t>(words_.columns.end() - known);
    return words_.fields.size() - behind;
  }

  const design::Design& design_;
  const EngineShape& engine_;
  NamePool names_;
  ItemWords words_;
  std::size_t next_split_ = 0;
};

/// The multipliers of the conversion: those of the first lanes that are split. It has one datapath
/// for the whole engine, so that memories are left to the lanes.
scene::Multipliers multipliers_of(const design::Design& design) {
  for (const design::LaneGroup& group : design.lanes) {
    if (splittable(group.lane) == nullptr) continue;
    const bool memory = group.multipliers == scene::Multipliers::memory;
    return memory ? scene::Multipliers::logic : group.multipliers;
  }
  return scene::Multipliers::logic;
}

void build_word(DatapathBuilder& datapath, const ItemWords& words) {
  const fixed::FixedLane& loader = words.split->loader;
  FixedNodes nodes(datapath, loader, words.schedule);
  nodes.build();
  const int cycle = words.schedule.latency_cycles;
  std::vector<Operand> fields;
  for (const NodeId id : loader.outputs) fields.push_back(datapath.at(nodes.value(id), cycle));
  for (const std::vector<NodeId>& inputs : words.split->flags) {
    std::vector<Signal> misfits;
    for (const NodeId id : inputs) misfits.push_back(nodes.out_of_range(id));
    fields.push_back(datapath.any_at(misfits, cycle));
  }
  for (const std::size_t column : words.columns) {
    const std::string& port = datapath.port(static_cast<int>(column));
    const int width = loader.input_format.width();
    fields.push_back(datapath.at({net(port), port, width, 0}, cycle));
  }
  std::reverse(fields.begin(), fields.end());
  datapath.add(Comment{"The word, its first field lowest."});
  datapath.add(Assignment{net("word"), concatenation(std::move(fields))});
}

}  // namespace

ItemWords item_words(const design::Design& design, const EngineShape& engine,
                     const datapath::DelayTable& delays) {
  ItemWords words = WordMaker(design, engine).run();
  if (words.converts()) {
    words.schedule = datapath::schedule_lane(words.split->loader, multipliers_of(design), delays,
                                             design.system.target_mhz);
  }
  return words;
}

Module item_word_module(const std::string& name, const ItemWords& words,
                        const EngineShape& engine) {
  return datapath_module(name, operands_of_width(engine.columns, engine.column_width),
                         {{Direction::output, words.bits(), "word"}},
                         [&](DatapathBuilder& datapath) { build_word(datapath, words); });
}

Module word_lane_module(const std::string& name, const WordLane& lane,
                        const datapath::Schedule& schedule) {
  std::vector<InputPort> ports;
  for (const LanePort& port : lane.ports) ports.push_back({port.name, port.width});
  return std::visit([&](const auto& made) { return lane_module(name, ports, made, schedule); },
                    lane.lane);
}

}  // namespace mixcmp::rtl
