#include "generator/hardware/rtl/arg_min_module.hpp"

#include <bit>

#include "generator/hardware/rtl/connections.hpp"
#include "generator/hardware/rtl/engine_operands.hpp"
#include "generator/hardware/rtl/unread_bits.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::rtl {
namespace {

const std::vector<Counters> own_counters = {{"rows"}, {"stalled_cycles"}};

std::vector<Port> arg_min_ports(const EngineShape& engine, const SystemShape& system) {
  std::vector<Port> ports;
  add_input(ports, 1, "aclk");
  add_input(ports, 1, "aresetn");
  add_input(ports, 1, "s_candidate_tvalid");
  add_output(ports, 1, "s_candidate_tready");
  add_input(ports, engine.item_bytes() * 8, "s_candidate_tdata");
  add_input(ports, 1, "s_candidate_tlast");
  add_input(ports, 1, "s_axis_tvalid");
  add_output(ports, 1, "s_axis_tready");
  add_input(ports, engine.row_bytes() * 8, "s_axis_tdata");
  add_input(ports, engine.spec.row_tag_bits, "s_axis_tuser");
  add_input(ports, 1, "s_axis_tlast");
  add_output(ports, 1, "m_axis_tvalid");
  add_input(ports, 1, "m_axis_tready");
  add_output(ports, engine.index_field_bits(), "m_axis_tdata");
  add_output(ports, engine.spec.row_tag_bits, "m_axis_tuser");
  add_output(ports, 1, "m_axis_tlast");
  add_output(ports, 1, "overrun");
  add_counters(arg_min_counters(system), system, ports);
  return ports;
}

/// The lowest bit of an item's word among the words that a lane gets. The row's word is lowest,
/// then comes the best candidate's, then that of the lane's own candidate.
int lowest_bit_of(data::Item item, const ItemWords& words) {
  switch (item) {
    case data::Item::row: return 0;
    case data::Item::first: return words.rows.bits();
    case data::Item::second: return words.rows.bits() + words.items.bits();
  }
  MIXCMP_CHECK(false);
}

/// Declares the streams of pairs from the engine to the lanes, as words, and of verdicts back. The
/// row's word is in the tag.
void declare_lane_streams(const ArgMinShape& shape, const SystemShape& system,
                          std::vector<ModuleItem>& items) {
  const int word_bits = shape.words.items.bits();
  const int tdata_bits = system.lane_tdata_bytes() * 8;
  items.push_back(Comment{"Pairs from the engine, their words to the lanes, verdicts back."});
  declare({{1, "pair_tvalid"},
           {1, "pair_tready"},
           {word_bits, "pair_best"},
           {word_bits, "pair_own"},
           {system.tag_bits, "pair_tag"},
           {tdata_bits, "words"},
           {1, "result_tvalid"},
           {1, "result_tready"},
           {result_bits, "result_tdata"},
           {system.tag_bits, "result_tag"}},
          system.lanes, items);
  std::vector<ModuleItem> mapping;
  mapping.push_back(Wire{system.tag_bits, "tag", indexed("pair_tag", "lane", system.tag_bits)});
  const int names_bits = system.ask_bits();
  consume_unread("tag", system.tag_bits, {{names_bits, system.tag_bits - names_bits}}, mapping);
  std::vector<Operand> words = {indexed("pair_own", "lane", word_bits),
                                indexed("pair_best", "lane", word_bits),
                                slice("tag", system.tag_bits - 1, names_bits)};
  const int padding = tdata_bits - system.lane_operand_bits();
  if (padding > 0) words.insert(words.begin(), literal(padding, 0));
  mapping.push_back(
      Assignment{indexed("words", "lane", tdata_bits), concatenation(std::move(words))});
  items.push_back(loop("lane", 0, system.lanes, "lane_words", std::move(mapping)));
}

/// Declares the streams of tags from the references to the engine, and of rows and candidates back,
/// as operands.
void declare_refetch_streams(const ArgMinShape& shape, const SystemShape& system,
                             std::vector<ModuleItem>& items) {
  const EngineShape& engine = shape.engine;
  const int answer_bits = engine.row_bits() + 2 * engine.item_bits();
  const int tdata_bits = system.tdata_bytes() * 8;
  items.push_back(Comment{"Undecided pairs by their tags, their operands to the references."});
  declare({{1, "refetch_tvalid"},
           {1, "refetch_tready"},
           {system.refetch_bits(), "refetch_tdata"},
           {system.ask_bits(), "asked"},
           {1, "refetched_tvalid"},
           {1, "refetched_tready"},
           {answer_bits, "refetched_tdata"},
           {tdata_bits, "operands"}},
          system.references, items);
  std::vector<ModuleItem> mapping;
  mapping.push_back(Wire{system.refetch_bits(), "tag",
                         indexed("refetch_tdata", "reference", system.refetch_bits())});
  consume_unread("tag", system.refetch_bits(), {{0, system.ask_bits()}}, mapping);
  mapping.push_back(Assignment{indexed("asked", "reference", system.ask_bits()),
                               slice("tag", system.ask_bits() - 1, 0)});
  mapping.push_back(
      Wire{answer_bits, "answer", indexed("refetched_tdata", "reference", answer_bits)});
  int low = 0;
  for (const auto& [width, name] : Nets{
           {engine.row_bits(), "row"}, {engine.item_bits(), "best"}, {engine.item_bits(), "own"}}) {
    mapping.push_back(Wire{width, name, slice("answer", low + width - 1, low)});
    low += width;
  }
  map_operands(engine, system, {"row", "best", "own"}, indexed("operands", "reference", tdata_bits),
               mapping);
  items.push_back(
      loop("reference", 0, system.references, "reference_operands", std::move(mapping)));
}

void add_conversions(const ArgMinShape& shape, std::vector<ModuleItem>& items) {
  items.push_back(Comment{"What the lanes know of a candidate and of a row."});
  items.push_back(Wire{shape.engine.item_bits(), "candidate", nullptr});
  add_conversion(shape.words, data::Item::first, shape.engine,
                 {.columns = "candidate", .word = "candidate_word", .instance = "conversion"},
                 items);
  add_conversion(shape.words, data::Item::row, shape.engine,
                 {.columns = "s_axis_tdata", .word = "row_word", .instance = "row_conversion"},
                 items);
}

/// Connects the engine's streams to and from the references, or ties them off if there is none.
void connect_refetch_streams(const ArgMinShape& shape, const SystemShape& system,
                             std::vector<ModuleItem>& items, std::vector<Connection>& connections) {
  if (system.recomputes()) {
    append(connections, {"refetch_tvalid", "refetch_tready"});
    connections.push_back({"refetch_tdata", net("asked")});
    append(connections, {"refetched_tvalid", "refetched_tready", "refetched_tdata"});
    return;
  }
  const int answer_bits = shape.engine.row_bits() + 2 * shape.engine.item_bits();
  items.push_back(Comment{"No reference: the lanes decide all pairs."});
  items.push_back(Wire{1, "unused_refetch_tready", nullptr});
  items.push_back(Wire{1, "unused_refetched_tvalid", nullptr});
  items.push_back(Wire{answer_bits, "unused_refetched_tdata", nullptr});
  connections.push_back({"refetch_tvalid", literal(1, 0)});
  connections.push_back({"refetch_tready", net("unused_refetch_tready")});
  connections.push_back({"refetch_tdata", literal(system.ask_bits(), 0)});
  connections.push_back({"refetched_tvalid", net("unused_refetched_tvalid")});
  connections.push_back({"refetched_tready", literal(1, 1)});
  connections.push_back({"refetched_tdata", net("unused_refetched_tdata")});
}

Instance arg_min_instance(const ArgMinShape& shape, const SystemShape& system,
                          std::vector<ModuleItem>& items) {
  const EngineShape& engine = shape.engine;
  std::vector<Connection> connections = clock_and_reset();
  append(connections, {"s_candidate_tvalid", "s_candidate_tready"});
  connections.push_back(
      {"s_candidate_tdata", slice("s_candidate_tdata", engine.item_bits() - 1, 0)});
  append(connections,
         {"s_candidate_tlast", "candidate", "candidate_word", "s_axis_tvalid", "s_axis_tready"});
  connections.push_back({"s_axis_tdata", slice("s_axis_tdata", engine.row_bits() - 1, 0)});
  append(connections,
         {"s_axis_tuser", "s_axis_tlast", "row_word", "pair_tvalid", "pair_tready", "pair_best",
          "pair_own", "pair_tag", "result_tvalid", "result_tready", "result_tdata", "result_tag"});
  connect_refetch_streams(shape, system, items, connections);
  append(connections, {"m_axis_tvalid", "m_axis_tready", "m_axis_tdata", "m_axis_tuser",
                       "m_axis_tlast", "overrun"});
  connect_counters(system, own_counters, items, connections);
  TemplateInstance around = arg_min_template(shape, system);
  return {around.module, "engine", std::move(around.parameters), std::move(connections)};
}

/// The instance of the system, between the streams to the lanes and to the references.
Instance system_instance(const SystemShape& system) {
  std::vector<Connection> connections = clock_and_reset();
  const auto connect = [&](const std::vector<std::pair<std::string, std::string>>& nets) {
    for (const auto& [port, name] : nets) connections.push_back({port, net(name)});
  };
  connect({{"s_axis_tvalid", "pair_tvalid"},
           {"s_axis_tready", "pair_tready"},
           {"s_axis_tdata", "words"},
           {"s_axis_tuser", "pair_tag"},
           {"m_axis_tvalid", "result_tvalid"},
           {"m_axis_tready", "result_tready"},
           {"m_axis_tdata", "result_tdata"},
           {"m_axis_tuser", "result_tag"}});
  if (system.recomputes()) {
    connect({{"m_refetch_tvalid", "refetch_tvalid"},
             {"m_refetch_tready", "refetch_tready"},
             {"m_refetch_tdata", "refetch_tdata"},
             {"s_refetch_tvalid", "refetched_tvalid"},
             {"s_refetch_tready", "refetched_tready"},
             {"s_refetch_tdata", "operands"}});
  }
  for (const Counters& each : system_counters(system)) connections.push_back(by_name(each.name));
  return {system.top, "system", {}, std::move(connections)};
}

}  // namespace

int place_bits(int lanes, int slot_bits, int word_latency_cycles) {
  constexpr int around_lane = 2;  // rows before a lane and behind it
  constexpr int queue_and_more = 16;
  const int inside =
      lanes * ((1 << slot_bits) + around_lane) + 3 * word_latency_cycles + queue_and_more;
  return std::bit_width(static_cast<unsigned>(inside - 1));
}

int asking_bits(const EngineShape& engine, int place_bits) {
  return 2 * engine.index_bits() + place_bits;
}

ArgMinShape arg_min_shape(const EngineShape& engine, ItemWords words, SystemShape& system) {
  const int places = place_bits(system.lanes, system.slot_bits, words.latency_cycles());
  system.asking_bits = asking_bits(engine, places);
  system.tag_bits = words.rows.bits() + system.asking_bits;
  system.word_bits = words.rows.bits() + 2 * words.items.bits();
  for (std::size_t k = 0; k < system.lane_groups.size(); ++k) {
    std::vector<OperandPort>& ports = system.lane_groups[k].operands;
    ports.clear();
    for (const LanePort& port : words.lanes[k].ports) {
      ports.push_back({port.name, lowest_bit_of(port.item, words) + port.low, port.width});
    }
  }
  return {.engine = engine, .words = std::move(words), .place_bits = places};
}

TemplateInstance arg_min_template(const ArgMinShape& shape, const SystemShape& system) {
  const EngineShape& engine = shape.engine;
  return {"arg_min_engine",
          {{"CANDIDATES", engine.capacity},
           {"CANDIDATE_BITS", engine.item_bits()},
           {"ROW_BITS", engine.row_bits()},
           {"WORD_BITS", shape.words.items.bits()},
           {"ROW_WORD_BITS", shape.words.rows.bits()},
           {"WORD_LATENCY", shape.words.latency_cycles()},
           {"TAG_BITS", engine.spec.row_tag_bits},
           {"INDEX_BITS", engine.index_bits()},
           {"PLACE_BITS", shape.place_bits},
           {"REFERENCES", system.references},
           {"COUNTER_BITS", system.counter_bits}}};
}

TemplateInstance operand_memory_template(const EngineShape& engine, int place_bits,
                                         int references) {
  return {"operand_memory",
          {{"REFERENCES", references},
           {"CANDIDATE_BITS", engine.item_bits()},
           {"ROW_BITS", engine.row_bits()},
           {"INDEX_BITS", engine.index_bits()},
           {"PLACE_BITS", place_bits}}};
}

Module arg_min_conversions_module(const ArgMinShape& shape) {
  const EngineShape& engine = shape.engine;
  Module module = {engine.top + "_conversions", {}, {}};
  add_input(module.ports, 1, "aclk");
  add_input(module.ports, engine.item_bits(), "candidate");
  add_input(module.ports, engine.row_bits(), "row");
  add_output(module.ports, shape.words.items.bits(), "candidate_word");
  add_output(module.ports, shape.words.rows.bits(), "row_word");
  const auto convert = [&](data::Item item, const std::string& columns,
                           const std::string& instance) {
    const std::string word = "converted_" + columns;
    add_conversion(shape.words, item, engine, {columns, word, instance}, module.items);
    module.items.push_back(Assignment{net(columns + "_word"), net(word)});
  };
  convert(data::Item::first, "candidate", "conversion");
  convert(data::Item::row, "row", "row_conversion");
  return module;
}

std::vector<Counters> arg_min_counters(const SystemShape& system) {
  std::vector<Counters> counters = system_counters(system);
  if (system.counter_bits == 0) return counters;
  counters.insert(counters.end(), own_counters.begin(), own_counters.end());
  return counters;
}

Module arg_min_module(const ArgMinShape& shape, const SystemShape& system) {
  const EngineShape& engine = shape.engine;
  Module module = {engine.top, arg_min_ports(engine, system), {}};
  std::vector<ModuleItem>& items = module.items;
  consume_unread("s_candidate_tdata", engine.item_bytes() * 8, {{0, engine.item_bits()}}, items);
  consume_unread("s_axis_tdata", engine.row_bytes() * 8, {{0, engine.row_bits()}}, items);
  add_conversions(shape, items);
  declare_lane_streams(shape, system, items);
  if (system.recomputes()) declare_refetch_streams(shape, system, items);
  Instance around = arg_min_instance(shape, system, items);
  items.push_back(std::move(around));
  items.push_back(system_instance(system));
  return module;
}

}  // namespace mixcmp::rtl
