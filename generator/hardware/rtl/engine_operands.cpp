#include "generator/hardware/rtl/engine_operands.hpp"

#include <algorithm>
#include <span>

#include "generator/hardware/rtl/connections.hpp"
#include "generator/hardware/rtl/datapath_builder.hpp"
#include "generator/hardware/rtl/net_names.hpp"

namespace mixcmp::rtl {

namespace {

/// A column of an item or row that the net holds.
Operand column_of(const EngineShape& engine, data::Item item, const std::string& net,
                  std::size_t column) {
  const std::span<const OperandFormat> formats = engine.formats_of(item);
  const int low = total_width(formats.first(column));
  return slice(net, low + formats[column].width() - 1, low);
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
      if (!used) {
        unused.push_back(column_of(engine, static_cast<data::Item>(item), nets[item], column));
      }
    }
  }
  return unused;
}

}  // namespace

void declare(const Nets& nets, int count, std::vector<ModuleItem>& items) {
  for (const auto& [width, name] : nets) {
    items.push_back(Wire{count * width, name, nullptr, true});
  }
}

Operand packed_operands(const EngineShape& engine, const SystemShape& system, const ItemNets& nets,
                        std::vector<ModuleItem>& items) {
  NamePool names({"pair", nets[0], nets[1], nets[2], "unused_columns"});
  std::vector<Operand> operands;
  for (std::size_t k = 0; k < engine.sources.size(); ++k) {
    const EngineShape::Source& source = engine.sources[k];
    const std::string name = names.unique("operand_" + system.input_ports[k]);
    items.push_back(Wire{system.input_formats[k].width(), name,
                         column_of(engine, source.item, nets[static_cast<std::size_t>(source.item)],
                                   source.column)});
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

void add_conversion(const ItemWords& words, data::Item item, const EngineShape& engine,
                    const ConvertedNets& nets, std::vector<ModuleItem>& items) {
  const Word& word = words.of(item);
  items.push_back(Wire{word.bits(), nets.word, nullptr});
  if (!word.converts()) {
    std::vector<Operand> fields;
    for (const std::size_t k : word.columns) {
      fields.insert(fields.begin(), column_of(engine, item, nets.columns, k));
    }
    items.push_back(Assignment{net(nets.word), concatenation(std::move(fields))});
    return;
  }
  std::vector<Connection> connections = {by_name("aclk")};
  const std::vector<std::string> ports = input_ports(engine.columns_of(item));
  for (std::size_t k = 0; k < ports.size(); ++k) {
    connections.push_back({ports[k], column_of(engine, item, nets.columns, k)});
  }
  connections.push_back({"word", net(nets.word)});
  items.push_back(Instance{word.module, nets.instance, {}, std::move(connections)});
}

}  // namespace mixcmp::rtl
