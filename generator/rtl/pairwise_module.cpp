#include "generator/rtl/pairwise_module.hpp"

#include "generator/rtl/connections.hpp"
#include "generator/rtl/engine_operands.hpp"

namespace mixcmp::rtl {
namespace {

constexpr int result_bits = 8;
const std::vector<std::string> engine_counters = {"reports", "busy_cycles", "stalled_cycles"};

std::vector<Port> pairwise_ports(const EngineShape& engine, const SystemShape& system) {
  std::vector<Port> ports;
  add_input(ports, 1, "aclk");
  add_input(ports, 1, "aresetn");
  add_input(ports, 1, "s_axis_tvalid");
  add_output(ports, 1, "s_axis_tready");
  add_input(ports, engine.item_bytes() * 8, "s_axis_tdata");
  add_input(ports, 1, "s_axis_tlast");
  add_output(ports, 1, "m_axis_tvalid");
  add_input(ports, 1, "m_axis_tready");
  add_output(ports, 2 * engine.index_field_bits(), "m_axis_tdata");
  add_output(ports, result_bits, "m_axis_tuser");
  add_output(ports, 1, "m_axis_tlast");
  add_counters(system, engine_counters, ports);
  return ports;
}

/// Assigns to `target` the operands of the two items in `pair`; item i is in its lower half.
void map_pair(const EngineShape& engine, const SystemShape& system, const Operand& pair,
              const Operand& target, std::vector<ModuleItem>& items) {
  const int bits = engine.item_bits();
  items.push_back(Wire{2 * bits, "pair", pair});
  items.push_back(Wire{bits, "item_i", slice("pair", bits - 1, 0)});
  items.push_back(Wire{bits, "item_j", slice("pair", 2 * bits - 1, bits)});
  map_operands(engine, system, {"", "item_i", "item_j"}, target, items);
}

void declare_lane_streams(const EngineShape& engine, const SystemShape& system,
                          std::vector<ModuleItem>& items) {
  const int lanes = system.lanes;
  items.push_back(Comment{"Pairs from the engine, their operands to the lanes, results back."});
  for (const auto& [width, name] :
       std::vector<std::pair<int, std::string>>{{1, "pair_tvalid"},
                                                {1, "pair_tready"},
                                                {2 * engine.item_bits(), "pair_items"},
                                                {system.tag_bits, "pair_tag"},
                                                {system.tdata_bytes() * 8, "operands"},
                                                {1, "result_tvalid"},
                                                {1, "result_tready"},
                                                {result_bits, "result_tdata"},
                                                {system.tag_bits, "result_tag"}}) {
    items.push_back(Wire{lanes * width, name, nullptr, true});
  }
  std::vector<ModuleItem> mapping;
  map_pair(engine, system, indexed("pair_items", "lane", 2 * engine.item_bits()),
           indexed("operands", "lane", system.tdata_bytes() * 8), mapping);
  items.push_back(loop("lane", lanes, "lane_operands", std::move(mapping)));
}

void declare_refetch_streams(const EngineShape& engine, const SystemShape& system,
                             std::vector<ModuleItem>& items) {
  const int references = system.references;
  items.push_back(Comment{
      "References send tags; the engine answers with the operands of the items that a tag names."});
  for (const auto& [width, name] :
       std::vector<std::pair<int, std::string>>{{1, "refetch_tvalid"},
                                                {1, "refetch_tready"},
                                                {system.refetch_bits(), "refetch_tdata"},
                                                {system.tag_bits, "refetch_tag"},
                                                {1, "answer_tvalid"},
                                                {1, "answer_tready"},
                                                {system.tdata_bytes() * 8, "answer_operands"}}) {
    items.push_back(Wire{references * width, name, nullptr, true});
  }
  items.push_back(Wire{2 * engine.item_bits(), "answer_items", nullptr});
  std::vector<ModuleItem> mapping;
  mapping.push_back(Wire{system.refetch_bits(), "padded_tag",
                         indexed("refetch_tdata", "reference", system.refetch_bits())});
  if (system.refetch_bits() > system.tag_bits) {
    mapping.push_back(Wire{
        1, "unused_padding",
        all_bits(concatenation(
            {literal(1, 0), slice("padded_tag", system.refetch_bits() - 1, system.tag_bits)}))});
  }
  mapping.push_back(Assignment{indexed("refetch_tag", "reference", system.tag_bits),
                               slice("padded_tag", system.tag_bits - 1, 0)});
  map_pair(engine, system, net("answer_items"),
           indexed("answer_operands", "reference", system.tdata_bytes() * 8), mapping);
  items.push_back(loop("reference", references, "reference_operands", std::move(mapping)));
}

/// Connects the refetch ports of the engine to the references, or ties them off if there is none.
void connect_refetch(const EngineShape& engine, const SystemShape& system,
                     std::vector<ModuleItem>& items, std::vector<Connection>& connections) {
  if (system.recomputes()) {
    for (const auto& [port, name] :
         std::vector<std::pair<std::string, std::string>>{{"s_refetch_tvalid", "refetch_tvalid"},
                                                          {"s_refetch_tready", "refetch_tready"},
                                                          {"s_refetch_tdata", "refetch_tag"},
                                                          {"m_answer_tvalid", "answer_tvalid"},
                                                          {"m_answer_tready", "answer_tready"},
                                                          {"m_answer_tdata", "answer_items"}}) {
      connections.push_back({port, net(name)});
    }
    return;
  }
  items.push_back(Comment{"No reference: nothing is fetched again."});
  items.push_back(Wire{1, "unused_refetch_tready", nullptr});
  items.push_back(Wire{1, "unused_answer_tvalid", nullptr});
  items.push_back(Wire{2 * engine.item_bits(), "unused_answer_tdata", nullptr});
  connections.push_back({"s_refetch_tvalid", literal(1, 0)});
  connections.push_back({"s_refetch_tready", net("unused_refetch_tready")});
  connections.push_back({"s_refetch_tdata", zeros(system.tag_bits)});
  connections.push_back({"m_answer_tvalid", net("unused_answer_tvalid")});
  connections.push_back({"m_answer_tready", literal(1, 0)});
  connections.push_back({"m_answer_tdata", net("unused_answer_tdata")});
}

Instance pairwise_instance(const EngineShape& engine, const SystemShape& system,
                           std::vector<ModuleItem>& items) {
  std::vector<Connection> connections = clock_and_reset();
  append(connections, {"s_axis_tvalid", "s_axis_tready"});
  connections.push_back({"s_axis_tdata", slice("s_axis_tdata", engine.item_bits() - 1, 0)});
  append(connections, {"s_axis_tlast", "pair_tvalid", "pair_tready", "pair_items", "pair_tag",
                       "result_tvalid", "result_tready", "result_tdata", "result_tag"});
  connect_refetch(engine, system, items, connections);
  append(connections,
         {"m_axis_tvalid", "m_axis_tready", "m_axis_tdata", "m_axis_tuser", "m_axis_tlast"});
  connect_counters(system, engine_counters, items, connections);
  TemplateInstance around = pairwise_template(engine, system);
  return {around.module, "engine", std::move(around.parameters), std::move(connections)};
}

}  // namespace

TemplateInstance pairwise_template(const EngineShape& engine, const SystemShape& system) {
  return {"pairwise_engine",
          {{"LANES", system.lanes},
           {"REFERENCES", system.references},
           {"CAPACITY", engine.capacity},
           {"ITEM_BITS", engine.item_bits()},
           {"INDEX_BITS", engine.index_bits()},
           {"SLOT_BITS", system.slot_bits},
           {"REPORT", engine.spec.report.mask()},
           {"COUNTER_BITS", system.counter_bits}}};
}

Module pairwise_module(const EngineShape& engine, const SystemShape& system) {
  Module module = {engine.top, {}, pairwise_ports(engine, system), {}};
  std::vector<ModuleItem>& items = module.items;
  declare_lane_streams(engine, system, items);
  if (system.refetches()) declare_refetch_streams(engine, system, items);
  consume_padding("s_axis_tdata", engine.item_bits(), engine.item_bytes() * 8, items);
  Instance around = pairwise_instance(engine, system, items);
  items.push_back(std::move(around));
  items.push_back(system_instance(system, net("pair_tag")));
  return module;
}

}  // namespace mixcmp::rtl
