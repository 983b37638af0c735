#include "generator/rtl/segment_module.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>

#include "generator/rtl/connections.hpp"
#include "generator/rtl/engine_operands.hpp"

namespace mixcmp::rtl {
namespace {

/// Bits of the address of a queue with room for all beats that may still come when it says stop,
/// and for four that wait.
int queue_bits(int lane_latency_cycles) {
  const int may_come = lane_latency_cycles + 3;
  return std::bit_width(static_cast<unsigned>(may_come + 3));
}

/// Bits of a word that no port of a lane reads.
std::vector<Operand> unread(const std::string& word, const WordLane& lane, bool second, int bits) {
  std::vector<bool> read(static_cast<std::size_t>(bits), false);
  for (const LanePort& port : lane.ports) {
    if (port.second != second) continue;
    std::fill_n(read.begin() + port.low, port.width, true);
  }
  std::vector<Operand> slices;
  for (int low = 0; low < bits;) {
    int high = low;
    while (high + 1 < bits && read[high + 1] == read[low]) ++high;
    if (!read[low]) slices.push_back(slice(word, high, low));
    low = high + 1;
  }
  return slices;
}

/// One lane between the word that it holds and the one that passes.
void add_lane(const SystemShape& system, const ItemWords& words, const SegmentGroup& segments,
              std::vector<ModuleItem>& items) {
  const int bits = words.bits();
  const WordLane& lane = words.lanes[segments.lane_group];
  std::vector<ModuleItem> body;
  body.push_back(Wire{bits, "item_i", indexed("held_words", "k", bits)});
  std::vector<Operand> unused = unread("item_i", lane, false, bits);
  if (!unused.empty()) {
    unused.insert(unused.begin(), literal(1, 0));
    body.push_back(Wire{1, "unused_item_i", all_bits(concatenation(std::move(unused)))});
  }
  std::vector<Connection> connections = {by_name("aclk")};
  for (const LanePort& port : lane.ports) {
    connections.push_back(
        {port.name, slice(port.second ? "item_j" : "item_i", port.low + port.width - 1, port.low)});
  }
  connections.push_back({"verdict", indexed("verdicts", "k", verdict_bits)});
  connections.push_back({"decided", indexed("decided", "k", 1)});
  body.push_back(Instance{
      system.lane_groups[segments.lane_group].datapath, "lane", {}, std::move(connections)});
  items.push_back(loop("k", 0, segments.lanes, "lanes", std::move(body)));
}

std::vector<Port> segment_ports(const EngineShape& engine, const ItemWords& words, int lanes) {
  std::vector<Port> ports;
  add_input(ports, 1, "aclk");
  add_input(ports, 1, "aresetn");
  add_input(ports, 1, "s_word_tvalid");
  add_output(ports, 1, "s_word_tready");
  add_input(ports, chain_bits(engine, words), "s_word_tdata");
  add_output(ports, 1, "m_word_tvalid");
  add_input(ports, 1, "m_word_tready");
  add_output(ports, chain_bits(engine, words), "m_word_tdata");
  add_output(ports, 1, "m_axis_tvalid");
  add_input(ports, 1, "m_axis_tready");
  add_output(ports, entry_bits(engine, lanes), "m_axis_tdata");
  add_output(ports, 1, "m_axis_tlast");
  return ports;
}

}  // namespace

std::vector<SegmentGroup> segment_groups(const SystemShape& system, int lanes_per_segment) {
  std::vector<SegmentGroup> groups;
  int first = 0;
  const auto add = [&](std::size_t lane_group, int lanes, int count) {
    if (count == 0) return;
    const std::string& datapath = system.lane_groups[lane_group].datapath;
    groups.push_back({.module = fmt::format("{}_segment_of_{}", datapath, lanes),
                      .label = fmt::format("segments_{}", groups.size()),
                      .lane_group = lane_group,
                      .lanes = lanes,
                      .first = first,
                      .count = count});
    first += count;
  };
  for (std::size_t k = 0; k < system.lane_groups.size(); ++k) {
    const int count = system.lane_groups[k].count;
    add(k, lanes_per_segment, count / lanes_per_segment);
    add(k, count % lanes_per_segment, count % lanes_per_segment > 0 ? 1 : 0);
  }
  if (groups.size() == 1) groups.front().label = "segments";
  return groups;
}

int chain_bits(const EngineShape& engine, const ItemWords& words) {
  constexpr int flags = 4;  // close, first, stays, meets
  return flags + engine.index_bits() + words.bits();
}

int code_bits(const scene::EngineSpec& engine) {
  return std::popcount(static_cast<unsigned>(engine.report.mask())) <= 1 ? 2 : 3;
}

int entry_bits(const EngineShape& engine, int lanes) {
  return 2 * engine.index_bits() + lanes * code_bits(engine.spec);
}

Module segment_module(const SystemShape& system, const EngineShape& engine, const ItemWords& words,
                      const SegmentGroup& segments) {
  Module module = {segments.module, {}, segment_ports(engine, words, segments.lanes), {}};
  std::vector<ModuleItem>& items = module.items;
  const int bits = words.bits();
  const int latency_cycles = system.lane_groups[segments.lane_group].schedule.latency_cycles;
  items.push_back(Wire{bits, "item_j", nullptr});
  items.push_back(Wire{segments.lanes * bits, "held_words", nullptr, true});
  items.push_back(Wire{segments.lanes * verdict_bits, "verdicts", nullptr, true});
  items.push_back(Wire{segments.lanes, "decided", nullptr, true});
  std::vector<Operand> unused = unread("item_j", words.lanes[segments.lane_group], true, bits);
  if (!unused.empty()) {
    unused.insert(unused.begin(), literal(1, 0));
    items.push_back(Wire{1, "unused_item_j", all_bits(concatenation(std::move(unused)))});
  }
  std::vector<Connection> connections = clock_and_reset();
  append(connections, {"s_word_tvalid", "s_word_tready", "s_word_tdata", "m_word_tvalid",
                       "m_word_tready", "m_word_tdata"});
  connections.push_back({"passing_word", net("item_j")});
  append(connections, {"held_words", "verdicts", "decided", "m_axis_tvalid", "m_axis_tready",
                       "m_axis_tdata", "m_axis_tlast"});
  items.push_back(Instance{"pair_segment",
                           "segment",
                           {{"LANES", segments.lanes},
                            {"WORD_BITS", bits},
                            {"INDEX_BITS", engine.index_bits()},
                            {"LANE_LATENCY", latency_cycles},
                            {"REPORT", engine.spec.report.mask()},
                            {"CODE_BITS", code_bits(engine.spec)},
                            {"COUNT", engine.spec.report_as == scene::ReportForm::count ? 1 : 0},
                            {"QUEUE_BITS", queue_bits(latency_cycles)}},
                           std::move(connections)});
  add_lane(system, words, segments, items);
  return module;
}

}  // namespace mixcmp::rtl
