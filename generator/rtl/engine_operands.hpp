#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "generator/rtl/counter_port.hpp"
#include "generator/rtl/engine_shape.hpp"

/// Parts that the modules of all engines share: operands taken out of items, counters, and the
/// instance of the system.
namespace mixcmp::rtl {

/// The nets that hold the items of a comparison, by data::Item; empty where there is none.
using ItemNets = std::array<std::string, 3>;

/// The operands of a comparison of these items, the first lowest. Adds the nets that name them, and
/// consumes the columns that it does not read.
Operand packed_operands(const EngineShape& engine, const SystemShape& system, const ItemNets& nets,
                        std::vector<ModuleItem>& items);
/// Assigns the operands, padded to bytes, to `target`.
void map_operands(const EngineShape& engine, const SystemShape& system, const ItemNets& nets,
                  const Operand& target, std::vector<ModuleItem>& items);

/// A generate loop with `variable` from `first` to first + count - 1.
std::shared_ptr<const ForGenerate> loop(const std::string& variable, int first, int count,
                                        const std::string& label, std::vector<ModuleItem> items);

/// Consumes the bits of `port` above its lowest `bits`, if there are any.
void consume_padding(const std::string& port, int bits, int port_bits,
                     std::vector<ModuleItem>& items);

/// Connects an engine's counters to its ports or, if the system does not count, to unused nets.
void connect_counters(const SystemShape& system, const std::vector<Counters>& counters,
                      std::vector<ModuleItem>& items, std::vector<Connection>& connections);

/// An instance of the system: its streams are connected to the nets pair_*, operands and result_*,
/// its s_axis_tuser to `tag`.
Instance system_instance(const SystemShape& system, const Operand& tag);

}  // namespace mixcmp::rtl
