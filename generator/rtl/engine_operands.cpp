#include "generator/rtl/engine_operands.hpp"

#include <algorithm>

#include "generator/rtl/connections.hpp"
#include "generator/rtl/net_names.hpp"

namespace mixcmp::rtl {

namespace {

Operand column_of(const EngineShape& engine, const std::string& net, std::size_t column) {
  const int low = static_cast<int>(column) * engine.column_width;
  return slice(net, low + engine.column_width - 1, low);
}

/// Columns of the items that the comparison does not read.
std::vector<Operand> unused_columns(const EngineShape& engine, const ItemNets& nets) {
  std::vector<Operand> unused;
  for (std::size_t item = 0; item < nets.size(); ++item) {
    if (nets[item].empty()) continue;
    const std::size_t count = engine.columns_of(static_cast<data::Item>(item)).size();
    for (std::size_t column = 0; column < count; ++column) {
      const bool used = std::any_of(
          engine.sources.begin(), engine.sources.end(), [&](const EngineShape::Source& source) {
            return source.column == column && source.item == static_cast<data::Item>(item);
          });
      if (!used) unused.push_back(column_of(engine, nets[item], column));
    }
  }
  return unused;
}

}  // namespace

Operand packed_operands(const EngineShape& engine, const SystemShape& system, const ItemNets& nets,
                        std::vector<ModuleItem>& items) {
  NamePool names({"pair", nets[0], nets[1], nets[2], "unused_columns"});
  std::vector<Operand> operands;
  for (std::size_t k = 0; k < engine.sources.size(); ++k) {
    const EngineShape::Source& source = engine.sources[k];
    const std::string name = names.unique("operand_" + system.input_ports[k]);
    items.push_back(
        Wire{engine.column_width, name,
             column_of(engine, nets[static_cast<std::size_t>(source.item)], source.column)});
    operands.insert(operands.begin(), net(name));
  }
  std::vector<Operand> unused = unused_columns(engine, nets);
  if (!unused.empty()) {
    unused.insert(unused.begin(), literal(1, 0));
    items.push_back(Wire{1, "unused_columns", all_bits(concatenation(std::move(unused)))});
  }
  return concatenation(std::move(operands));
}

void map_operands(const EngineShape& engine, const SystemShape& system, const ItemNets& nets,
                  const Operand& target, std::vector<ModuleItem>& items) {
  Operand operands = packed_operands(engine, system, nets, items);
  const int padding = system.tdata_bytes() * 8 - system.operand_bits();
  if (padding > 0) operands = concatenation({literal(padding, 0), std::move(operands)});
  items.push_back(Assignment{target, std::move(operands)});
}

std::shared_ptr<const ForGenerate> loop(const std::string& variable, int first, int count,
                                        const std::string& label, std::vector<ModuleItem> items) {
  return std::make_shared<const ForGenerate>(
      ForGenerate{variable, first, count, label, std::move(items)});
}

void consume_padding(const std::string& port, int bits, int port_bits,
                     std::vector<ModuleItem>& items) {
  if (port_bits == bits) return;
  items.push_back(Wire{1, "unused_" + port,
                       all_bits(concatenation({literal(1, 0), slice(port, port_bits - 1, bits)}))});
}

void connect_counters(const SystemShape& system, const std::vector<Counters>& counters,
                      std::vector<ModuleItem>& items, std::vector<Connection>& connections) {
  for (const auto& [counter, count] : counters) {
    if (system.counter_bits > 0) {
      connections.push_back(by_name(counter));
    } else {
      items.push_back(Wire{count, "unused_" + counter, nullptr});
      connections.push_back({counter, net("unused_" + counter)});
    }
  }
}

Instance system_instance(const SystemShape& system, const Operand& tag) {
  std::vector<Connection> connections = clock_and_reset();
  for (const auto& [port, name] :
       std::vector<std::pair<std::string, std::string>>{{"s_axis_tvalid", "pair_tvalid"},
                                                        {"s_axis_tready", "pair_tready"},
                                                        {"s_axis_tdata", "operands"}}) {
    connections.push_back({port, net(name)});
  }
  connections.push_back({"s_axis_tuser", tag});
  for (const auto& [port, name] :
       std::vector<std::pair<std::string, std::string>>{{"m_axis_tvalid", "result_tvalid"},
                                                        {"m_axis_tready", "result_tready"},
                                                        {"m_axis_tdata", "result_tdata"},
                                                        {"m_axis_tuser", "result_tag"}}) {
    connections.push_back({port, net(name)});
  }
  if (system.refetches()) {
    for (const char* part : {"tvalid", "tready", "tdata"}) {
      connections.push_back(
          {std::string("m_refetch_") + part, net(std::string("refetch_") + part)});
    }
    connections.push_back({"s_refetch_tvalid", net("answer_tvalid")});
    connections.push_back({"s_refetch_tready", net("answer_tready")});
    connections.push_back({"s_refetch_tdata", net("answer_operands")});
  }
  for (const Counters& each : system_counters(system)) connections.push_back(by_name(each.name));
  return {system.top, "system", {}, std::move(connections)};
}

}  // namespace mixcmp::rtl
