#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "generator/rtl/engine_module.hpp"

/// What the modules of all engines need: operands out of items, and the system they feed.
namespace mixcmp::gen {

/// The nets that hold the items of a comparison, by model::Item; empty where there is none.
using ItemNets = std::array<std::string, 3>;

/// Assigns the operands of a comparison of these items to `target`, and consumes the columns that
/// it does not read.
void map_operands(const EngineShape& engine, const SystemShape& system, const ItemNets& nets,
                  const rtl::Operand& target, std::vector<rtl::Item>& items);

std::shared_ptr<const rtl::ForGenerate> loop(const std::string& variable, int count,
                                             const std::string& label,
                                             std::vector<rtl::Item> items);

/// Consumes the bits of `port` above `bits`, if it has some.
void consume_padding(const std::string& port, int bits, int port_bits,
                     std::vector<rtl::Item>& items);

/// The counters of each lane, and all counters as ports of an engine.
const std::vector<std::string>& lane_counters();
void add_counters(const SystemShape& system, const std::vector<std::string>& engine_counters,
                  std::vector<rtl::Port>& ports);
/// To the engine's ports, or to nets that say that nobody counts.
void connect_counters(const SystemShape& system, const std::vector<std::string>& engine_counters,
                      std::vector<rtl::Item>& items, std::vector<rtl::Connection>& connections);

/// The system, its streams connected to pair_*, operands and result_*; `tag` goes in with each
/// pair.
rtl::Instance system_instance(const SystemShape& system, const rtl::Operand& tag);

}  // namespace mixcmp::gen
