#include "generator/hardware/rtl/item_words.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "generator/hardware/datapath/schedule.hpp"
#include "generator/hardware/rtl/datapath_builder.hpp"
#include "generator/hardware/rtl/fixed_nodes.hpp"
#include "generator/hardware/rtl/lane_module.hpp"
#include "generator/hardware/rtl/net_names.hpp"
#include "model/base/common/check.hpp"
#include "model/lane/fixed/bilinear_form.hpp"

namespace mixcmp::rtl {
namespace {

/// The lane, if its operands can be converted without knowing those of the other item.
const fixed::FixedLane* splittable(const design::Lane& lane) {
  const auto* made = std::get_if<fixed::FixedLane>(&lane);
  return made != nullptr && !made->format.is_block ? made : nullptr;
}

/// Whether a loader does more than select bits of operands that arrive in fixed point.
bool computes(const fixed::FixedLane& loader) {
  return std::any_of(loader.nodes.begin(), loader.nodes.end(), [&](const fixed::FixedNode& node) {
    return !fixed::is_read_as_it_arrives(loader, node) && !fixed::is_wires(node);
  });
}

fixed::ItemRole role_of(data::Item item) {
  switch (item) {
    case data::Item::row: return fixed::ItemRole::row;
    case data::Item::first: return fixed::ItemRole::first;
    case data::Item::second: return fixed::ItemRole::second;
  }
  MIXCMP_CHECK(false);
}

data::Item item_of(fixed::ItemRole role) {
  switch (role) {
    case fixed::ItemRole::row: return data::Item::row;
    case fixed::ItemRole::first: return data::Item::first;
    case fixed::ItemRole::second: return data::Item::second;
  }
  MIXCMP_CHECK(false);
}

/// The suffix of an item's ports: "_i" or "_j"; empty for a row.
std::string port_suffix(data::Item item) {
  switch (item) {
    case data::Item::row: return "";
    case data::Item::first: return "_i";
    case data::Item::second: return "_j";
  }
  MIXCMP_CHECK(false);
}

/// The embedded multipliers of a lane's products and squares.
int multipliers_of(const fixed::FixedLane& lane, const devices::MultiplierSize& size) {
  const auto parts = [](int bits, int port) { return (bits + port - 1) / port; };
  int count = 0;
  for (const fixed::FixedNode& node : lane.nodes) {
    const bool squares = node.operation == Operation::square;
    if (!squares && node.operation != Operation::multiply) continue;
    const auto bits = [&](int k) { return lane.nodes[node.operands[k]].format.magnitude_bits(); };
    count += parts(bits(0), size.a_bits) * parts(bits(squares ? 0 : 1), size.b_bits);
  }
  return count;
}

class WordMaker {
public:
  WordMaker(const design::Design& design, const EngineShape& engine,
            const datapath::DelayTable& delays)
      : design_(design), engine_(engine), multiplier_size_(delays.multiplier_size), names_({}) {}

  ItemWords run() {
    split_lanes();
    if (words_.split) {
      add_converted_fields(data::Item::first);
      add_converted_fields(data::Item::row);
    }
    for (const design::LaneGroup& group : design_.lanes) {
      words_.lanes.push_back(word_lane(group.lane));
    }
    if (design_.second_tier) words_.second_tier = word_lane(design_.second_tier->lane);
    // A word that no lane reads still has one field.
    for (const data::Item item : {data::Item::first, data::Item::row}) {
      if (!engine_.columns_of(item).empty() && word_of(item).fields.empty()) column_field(item, 0);
    }
    return std::move(words_);
  }

private:
  Word& word_of(data::Item item) { return item == data::Item::row ? words_.rows : words_.items; }

  void split_lanes() {
    std::vector<fixed::ItemInput> inputs;
    for (const EngineShape::Source& source : engine_.sources) {
      inputs.push_back({.column = static_cast<int>(source.column), .role = role_of(source.item)});
    }
    std::vector<fixed::FixedLane> lanes;
    for (const design::LaneGroup& group : design_.lanes) {
      if (splittable(group.lane) != nullptr) lanes.push_back(best_form(group, inputs));
    }
    if (design_.second_tier) lanes.push_back(best_form(*design_.second_tier, inputs));
    if (lanes.empty()) return;
    fixed::ItemSplit split = split_of(lanes, inputs);
    if (computes(split.items.lane) || computes(split.rows.lane)) words_.split = std::move(split);
  }

  fixed::ItemSplit split_of(const std::vector<fixed::FixedLane>& lanes,
                            const std::vector<fixed::ItemInput>& inputs) const {
    std::vector<const fixed::FixedLane*> pointers;
    for (const fixed::FixedLane& lane : lanes) pointers.push_back(&lane);
    return fixed::split_by_item(pointers, inputs, engine_.columns, engine_.row_columns);
  }

  /// The lane of a group; as bilinear forms where these need fewer embedded multipliers.
  fixed::FixedLane best_form(const design::LaneGroup& group,
                             const std::vector<fixed::ItemInput>& inputs) const {
    const fixed::FixedLane& lane = *splittable(group.lane);
    if (group.multipliers != scene::Multipliers::embedded) return lane;
    std::optional<fixed::FixedLane> bilinear = fixed::in_bilinear_form(lane, inputs);
    const auto multipliers = [&](const fixed::FixedLane& form) {
      return multipliers_of(split_of({form}, inputs).lanes.front(), multiplier_size_);
    };
    const bool is_smaller = bilinear && multipliers(*bilinear) < multipliers(lane);
    return is_smaller ? std::move(*bilinear) : lane;
  }

  void add_converted_fields(data::Item item) {
    const fixed::ItemLoader& loader = words_.split->of(role_of(item));
    const std::vector<std::string>& columns = engine_.columns_of(item);
    NamePool pool({});
    const std::vector<std::string> names = name_nodes(loader.lane, columns, pool);
    for (const NodeId id : loader.lane.outputs) {
      const fixed::FixedNode& node = loader.lane.nodes[id];
      const bool is_input = node.operation == Operation::input;
      add_field(item, is_input ? columns[node.input] : names[id], node.format.width);
    }
    for (std::size_t flag = 0; flag < loader.flags.size(); ++flag) {
      add_field(item, item == data::Item::row ? "row_out_of_range" : "out_of_range", 1);
    }
  }

  std::size_t add_field(data::Item item, const std::string& name, int width) {
    Word& word = word_of(item);
    const int low = word.bits();
    word.fields.push_back({names_.unique(name), width, low});
    return word.fields.size() - 1;
  }

  LanePort port_of(data::Item item, std::size_t field, int dropped_bits = 0) {
    const Word::Field& bits = word_of(item).fields[field];
    return {bits.name + port_suffix(item), item, bits.low + dropped_bits,
            bits.width - dropped_bits};
  }

  /// Makes a lane that reads words. It must be called for the lanes in the order in which they were
  /// split.
  WordLane word_lane(const design::Lane& lane) {
    return words_.split && splittable(lane) != nullptr
               ? lane_of_fields(words_.split->lanes[next_split_++])
               : lane_of_columns(lane);
  }

  WordLane lane_of_fields(const fixed::FixedLane& lane) {
    WordLane made{lane, {}};
    NamePool pool({});  // two encodings of an operand may read one field
    for (const fixed::LoadedInput& loaded : lane.loaded_inputs) {
      made.ports.push_back(port_of(item_of(loaded.role), loaded.field, loaded.dropped_bits));
      made.ports.back().name = pool.unique(made.ports.back().name);
    }
    for (const fixed::LoadedFlag& flag : fixed::flags_read(lane)) {
      const std::size_t first_flag = words_.split->of(flag.role).lane.outputs.size();
      made.ports.push_back(port_of(item_of(flag.role), first_flag + flag.flag));
    }
    return made;
  }

  WordLane lane_of_columns(const design::Lane& lane) {
    WordLane made{lane, {}};
    const std::vector<std::string> names = input_ports(design_.inputs);
    for (std::size_t k = 0; k < engine_.sources.size(); ++k) {
      const EngineShape::Source& source = engine_.sources[k];
      const Word::Field& bits =
          word_of(source.item).fields[column_field(source.item, source.column)];
      made.ports.push_back({names[k], source.item, bits.low, bits.width});
    }
    return made;
  }

  /// The field that holds a column as it arrives; the field is added if it is new.
  std::size_t column_field(data::Item item, std::size_t column) {
    Word& word = word_of(item);
    const std::size_t converted = word.fields.size() - word.columns.size();
    const auto known = std::find(word.columns.begin(), word.columns.end(), column);
    const auto place = static_cast<std::size_t>(known - word.columns.begin());
    if (known != word.columns.end()) return converted + place;
    word.columns.push_back(column);
    return add_field(item, engine_.columns_of(item)[column],
                     engine_.formats_of(item)[column].width());
  }

  const design::Design& design_;
  const EngineShape& engine_;
  devices::MultiplierSize multiplier_size_;
  NamePool names_;
  ItemWords words_;
  std::size_t next_split_ = 0;
};

/// The multipliers of the conversion: those of the first lanes that are split. The whole engine has
/// one conversion, so it leaves memories to the lanes.
scene::Multipliers multipliers_of(const design::Design& design) {
  for (const design::LaneGroup& group : design.lanes) {
    if (splittable(group.lane) == nullptr) continue;
    const bool memory = group.multipliers == scene::Multipliers::memory;
    return memory ? scene::Multipliers::logic : group.multipliers;
  }
  return scene::Multipliers::logic;
}

void build_word(DatapathBuilder& datapath, const ItemWords& words, data::Item item) {
  const fixed::FixedLane& loader = words.loader_of(item);
  const Word& word = words.of(item);
  FixedNodes nodes(datapath, loader, word.schedule);
  nodes.build();
  const int cycle = word.schedule.latency_cycles - word.schedule.entry_cycles;
  std::vector<Operand> fields;
  for (const NodeId id : loader.outputs) fields.push_back(datapath.at(nodes.value(id), cycle));
  for (const std::vector<NodeId>& inputs : words.split->of(role_of(item)).flags) {
    std::vector<Signal> misfits;
    for (const NodeId id : inputs) misfits.push_back(nodes.out_of_range(id));
    fields.push_back(datapath.any_at(misfits, cycle));
  }
  for (const std::size_t column : word.columns) {
    const std::string& port = datapath.arrived(static_cast<int>(column));
    const int width = fixed::operand_format(loader, static_cast<int>(column)).width();
    fields.push_back(datapath.at({net(port), port, width, 0}, cycle));
  }
  std::reverse(fields.begin(), fields.end());
  datapath.add(Comment{"The word, its first field lowest."});
  datapath.add(Assignment{net("word"), concatenation(std::move(fields))});
}

/// Schedules the conversions, so that the words of items and of rows take equally many cycles, and
/// names their modules.
void schedule_words(const design::Design& design, const EngineShape& engine,
                    const datapath::DelayTable& delays, ItemWords& words) {
  const bool has_rows = !engine.row_columns.empty();
  const auto schedule = [&](const fixed::FixedLane& loader) {
    return datapath::schedule_lane(loader, multipliers_of(design), delays,
                                   design.system.target_mhz);
  };
  words.items.schedule = schedule(words.split->items.lane);
  if (has_rows) words.rows.schedule = schedule(words.split->rows.lane);
  const int latency_cycles =
      std::max(words.items.schedule.latency_cycles, words.rows.schedule.latency_cycles);
  const auto name = [&](Word& word, const char* what) {
    word.schedule.latency_cycles = latency_cycles;
    word.module =
        fmt::format("{}{}_{}_l{}", design.system.prefix, design.name, what, latency_cycles);
  };
  name(words.items, has_rows ? "candidate" : "item");
  if (has_rows) name(words.rows, "row");
}

}  // namespace

ItemWords item_words(const design::Design& design, const EngineShape& engine,
                     const datapath::DelayTable& delays) {
  ItemWords words = WordMaker(design, engine, delays).run();
  if (words.split) schedule_words(design, engine, delays, words);
  return words;
}

Module item_word_module(const ItemWords& words, data::Item item, const EngineShape& engine) {
  const Word& word = words.of(item);
  std::vector<InputPort> ports;
  for (std::size_t k = 0; k < engine.columns_of(item).size(); ++k) {
    ports.push_back({engine.columns_of(item)[k], engine.formats_of(item)[k].width()});
  }
  const fixed::FixedLane& loader = words.loader_of(item);
  widen(ports, fixed::arriving_formats(loader), loader.input_format, word.schedule);
  return datapath_module(
      word.module, ports, {{Direction::output, word.bits(), "word"}},
      [&](DatapathBuilder& datapath) { build_word(datapath, words, item); }, 1,
      word.schedule.entry_cycles);
}

Module word_lane_module(const std::string& name, const WordLane& lane,
                        const datapath::Schedule& schedule) {
  std::vector<InputPort> ports;
  for (const LanePort& port : lane.ports) ports.push_back({port.name, port.width});
  return lane_module(name, ports, lane.lane, schedule);
}

}  // namespace mixcmp::rtl
