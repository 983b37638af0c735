#pragma once

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "generator/hardware/rtl/counter_port.hpp"
#include "generator/hardware/rtl/engine_shape.hpp"
#include "generator/hardware/rtl/item_words.hpp"

/// Parts that the modules of all engines share: words and operands taken out of items, counters.
namespace mixcmp::rtl {

/// Widths and names of nets.
using Nets = std::vector<std::pair<int, std::string>>;
/// Adds vectors of `count` fields each, of these widths.
void declare(const Nets& nets, int count, std::vector<ModuleItem>& items);

/// The nets that hold the items of a comparison, by data::Item; empty if the comparison has no such
/// item.
using ItemNets = std::array<std::string, 3>;

/// The operands of a comparison of these items, the first lowest. Adds the nets that name them, and
/// consumes the columns that it does not read.
Operand packed_operands(const EngineShape& engine, const SystemShape& system, const ItemNets& nets,
                        std::vector<ModuleItem>& items);
/// Assigns the operands, padded to bytes, to `target`.
void map_operands(const EngineShape& engine, const SystemShape& system, const ItemNets& nets,
                  const Operand& target, std::vector<ModuleItem>& items);

/// The nets around the conversion of items or rows.
struct ConvertedNets {
  std::string columns;
  std::string word;
  std::string instance;
};
/// Adds the datapath that computes the word of an item or a row, or wires if the word consists of
/// columns.
void add_conversion(const ItemWords& words, data::Item item, const EngineShape& engine,
                    const ConvertedNets& nets, std::vector<ModuleItem>& items);

/// A generate loop with `variable` from `first` to first + count - 1.
std::shared_ptr<const ForGenerate> loop(const std::string& variable, int first, int count,
                                        const std::string& label, std::vector<ModuleItem> items);

/// Connects an engine's counters to its ports or, if the system does not count, to unused nets.
void connect_counters(const SystemShape& system, const std::vector<Counters>& counters,
                      std::vector<ModuleItem>& items, std::vector<Connection>& connections);

}  // namespace mixcmp::rtl
