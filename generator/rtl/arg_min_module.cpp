#include "generator/rtl/arg_min_module.hpp"

#include "generator/rtl/connections.hpp"
#include "generator/rtl/engine_operands.hpp"

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

void declare_lane_streams(const EngineShape& engine, const SystemShape& system,
                          std::vector<ModuleItem>& items) {
  items.push_back(Comment{"Pairs from the engine, their operands to the lanes, verdicts back."});
  for (const auto& [width, name] :
       std::vector<std::pair<int, std::string>>{{1, "pair_tvalid"},
                                                {1, "pair_tready"},
                                                {engine.row_bits(), "pair_row"},
                                                {engine.item_bits(), "pair_best"},
                                                {engine.item_bits(), "pair_own"},
                                                {system.tdata_bytes() * 8, "operands"},
                                                {1, "result_tvalid"},
                                                {1, "result_tready"},
                                                {result_bits, "result_tdata"},
                                                {system.tag_bits, "result_tag"}}) {
    items.push_back(Wire{system.lanes * width, name, nullptr, true});
  }
  items.push_back(Wire{1, "unused_result_tag", all_bits(net("result_tag"))});
  std::vector<ModuleItem> mapping;
  mapping.push_back(Wire{engine.row_bits(), "row", indexed("pair_row", "lane", engine.row_bits())});
  mapping.push_back(
      Wire{engine.item_bits(), "best", indexed("pair_best", "lane", engine.item_bits())});
  mapping.push_back(
      Wire{engine.item_bits(), "own", indexed("pair_own", "lane", engine.item_bits())});
  map_operands(engine, system, {"row", "best", "own"},
               indexed("operands", "lane", system.tdata_bytes() * 8), mapping);
  items.push_back(loop("lane", 0, system.lanes, "lane_operands", std::move(mapping)));
}

Instance arg_min_instance(const EngineShape& engine, const SystemShape& system,
                          std::vector<ModuleItem>& items) {
  std::vector<Connection> connections = clock_and_reset();
  append(connections, {"s_candidate_tvalid", "s_candidate_tready"});
  connections.push_back(
      {"s_candidate_tdata", slice("s_candidate_tdata", engine.item_bits() - 1, 0)});
  append(connections, {"s_candidate_tlast", "s_axis_tvalid", "s_axis_tready"});
  connections.push_back({"s_axis_tdata", slice("s_axis_tdata", engine.row_bits() - 1, 0)});
  append(connections,
         {"s_axis_tuser", "s_axis_tlast", "pair_tvalid", "pair_tready", "pair_row", "pair_best",
          "pair_own", "result_tvalid", "result_tready", "result_tdata", "m_axis_tvalid",
          "m_axis_tready", "m_axis_tdata", "m_axis_tuser", "m_axis_tlast", "overrun"});
  connect_counters(system, own_counters, items, connections);
  TemplateInstance around = arg_min_template(engine, system);
  return {around.module, "engine", std::move(around.parameters), std::move(connections)};
}

}  // namespace

TemplateInstance arg_min_template(const EngineShape& engine, const SystemShape& system) {
  return {"arg_min_engine",
          {{"CANDIDATES", engine.capacity},
           {"CANDIDATE_BITS", engine.item_bits()},
           {"ROW_BITS", engine.row_bits()},
           {"TAG_BITS", engine.spec.row_tag_bits},
           {"INDEX_BITS", engine.index_bits()},
           {"SLOT_BITS", system.slot_bits},
           {"COUNTER_BITS", system.counter_bits}}};
}

std::vector<Counters> arg_min_counters(const SystemShape& system) {
  std::vector<Counters> counters = system_counters(system);
  if (system.counter_bits == 0) return counters;
  counters.insert(counters.end(), own_counters.begin(), own_counters.end());
  return counters;
}

Module arg_min_module(const EngineShape& engine, const SystemShape& system) {
  Module module = {engine.top, {}, arg_min_ports(engine, system), {}};
  std::vector<ModuleItem>& items = module.items;
  declare_lane_streams(engine, system, items);
  consume_padding("s_candidate_tdata", engine.item_bits(), engine.item_bytes() * 8, items);
  consume_padding("s_axis_tdata", engine.row_bits(), engine.row_bytes() * 8, items);
  Instance around = arg_min_instance(engine, system, items);
  items.push_back(std::move(around));
  // The engine keeps the rows' tags itself: the system's own tags are unused zeros.
  items.push_back(system_instance(system, zeros(system.lanes * system.tag_bits)));
  return module;
}

}  // namespace mixcmp::rtl
