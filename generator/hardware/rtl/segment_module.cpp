#include "generator/hardware/rtl/segment_module.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "generator/hardware/rtl/connections.hpp"
#include "generator/hardware/rtl/engine_operands.hpp"
#include "generator/hardware/rtl/unread_bits.hpp"
#include "model/design/slots.hpp"

namespace mixcmp::rtl {
namespace {

/// Consumes the bits of an item's word that no port of a lane reads.
void consume_unread(const std::string& word, const WordLane& lane, data::Item item, int bits,
                    std::vector<ModuleItem>& items) {
  std::vector<BitRange> read;
  for (const LanePort& port : lane.ports) {
    if (port.item == item) read.push_back({port.low, port.width});
  }
  rtl::consume_unread(word, bits, read, items);
}

/// A lane between the words `item_i` and `item_j`.
Instance lane_instance(const std::string& module, const WordLane& lane, const std::string& item_i,
                       const std::string& item_j, Operand verdict, Operand decided) {
  std::vector<Connection> connections = {by_name("aclk")};
  for (const LanePort& port : lane.ports) {
    const std::string& word = port.item == data::Item::second ? item_j : item_i;
    connections.push_back({port.name, slice(word, port.low + port.width - 1, port.low)});
  }
  connections.push_back({"verdict", std::move(verdict)});
  connections.push_back({"decided", std::move(decided)});
  return {module, "lane", {}, std::move(connections)};
}

/// The segment's own lanes, each between the word that it holds and the one that passes.
void add_lanes(const SystemShape& system, const ItemWords& words, const SegmentGroup& segments,
               std::vector<ModuleItem>& items) {
  const int bits = words.items.bits();
  const WordLane& lane = words.lanes[segments.lane_group];
  std::vector<ModuleItem> body;
  body.push_back(Wire{bits, "item_i", indexed("held_words", "k", bits)});
  consume_unread("item_i", lane, data::Item::first, bits, body);
  body.push_back(lane_instance(system.lane_groups[segments.lane_group].datapath, lane, "item_i",
                               "item_j", indexed("verdicts", "k", verdict_bits),
                               indexed("decided", "k", 1)));
  items.push_back(loop("k", 0, segments.lanes, "lanes", std::move(body)));
}

/// Bits of the number of one of a segment's lanes.
int lane_bits(int lanes) {
  return scene::index_bits_for(std::max(lanes, 2));
}

/// The parameters that the templates of a segment and of its second tier share.
std::vector<Parameter> common_parameters(const EngineShape& engine, int lanes, int word_bits,
                                         int lane_latency_cycles) {
  return {{"LANES", lanes},
          {"LANE_BITS", lane_bits(lanes)},
          {"WORD_BITS", word_bits},
          {"INDEX_BITS", engine.index_bits()},
          {"LANE_LATENCY", lane_latency_cycles},
          {"REPORT", engine.spec.report.mask()},
          {"CODE_BITS", code_bits(engine.spec)},
          {"COUNT", engine.spec.report_as == scene::ReportForm::count ? 1 : 0}};
}

/// Adds the lane of higher precision behind the segment's own lanes, with the template that keeps
/// their words.
void add_second_tier(const SystemShape& system, const EngineShape& engine, const ItemWords& words,
                     int lanes, std::vector<ModuleItem>& items) {
  const int bits = words.items.bits();
  const DatapathGroup& tier = *system.second_tier;
  items.push_back(Comment{"What they leave undecided is decided again with more precision."});
  for (const char* word : {"tier_item_i", "tier_item_j"}) {
    items.push_back(Wire{bits, word, nullptr});
  }
  items.push_back(Wire{verdict_bits, "tier_verdict", nullptr});
  items.push_back(Wire{1, "tier_decided", nullptr});
  consume_unread("tier_item_i", *words.second_tier, data::Item::first, bits, items);
  consume_unread("tier_item_j", *words.second_tier, data::Item::second, bits, items);
  std::vector<Parameter> parameters =
      common_parameters(engine, lanes, bits, tier.schedule.latency_cycles);
  parameters.push_back({"QUEUE_BITS", design::tier_queue_bits(tier.schedule.latency_cycles)});
  std::vector<Connection> connections = clock_and_reset();
  for (const char* part : {"tvalid", "tready", "tdata", "tlast"}) {
    connections.push_back({std::string("s_axis_") + part, net(std::string("beat_") + part)});
  }
  connections.push_back({"item_i", net("tier_item_i")});
  connections.push_back({"item_j", net("tier_item_j")});
  connections.push_back({"verdict", net("tier_verdict")});
  connections.push_back({"decided", net("tier_decided")});
  append(connections, {"m_axis_tvalid", "m_axis_tready", "m_axis_tdata", "m_axis_tlast"});
  items.push_back(
      Instance{"pair_tier", "second_tier", std::move(parameters), std::move(connections)});
  Instance lane = lane_instance(tier.datapath, *words.second_tier, "tier_item_i", "tier_item_j",
                                net("tier_verdict"), net("tier_decided"));
  lane.name = "second_lane";
  items.push_back(std::move(lane));
}

/// Declares the beats between a segment and its second tier, and names them in `connections`.
void connect_tier(int beat_bits, std::vector<ModuleItem>& items,
                  std::vector<Connection>& connections) {
  items.push_back(Wire{1, "beat_tvalid", nullptr});
  items.push_back(Wire{1, "beat_tready", nullptr});
  items.push_back(Wire{beat_bits, "beat_tdata", nullptr});
  items.push_back(Wire{1, "beat_tlast", nullptr});
  for (const char* part : {"tvalid", "tready", "tdata", "tlast"}) {
    connections.push_back({std::string("m_axis_") + part, net(std::string("beat_") + part)});
  }
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
  return flags + engine.index_bits() + words.items.bits();
}

int code_bits(const scene::EngineSpec& engine) {
  return std::popcount(static_cast<unsigned>(engine.report.mask())) <= 1 ? 2 : 3;
}

int entry_bits(const EngineShape& engine, int lanes) {
  return 2 * engine.index_bits() + lanes * code_bits(engine.spec);
}

Module segment_module(const SystemShape& system, const EngineShape& engine, const ItemWords& words,
                      const SegmentGroup& segments) {
  Module module = {segments.module, segment_ports(engine, words, segments.lanes), {}};
  std::vector<ModuleItem>& items = module.items;
  const int bits = words.items.bits();
  const int lanes = segments.lanes;
  items.push_back(Wire{bits, "item_j", nullptr});
  items.push_back(Wire{lanes * bits, "held_words", nullptr, true});
  items.push_back(Wire{lanes * verdict_bits, "verdicts", nullptr, true});
  items.push_back(Wire{lanes, "decided", nullptr, true});
  consume_unread("item_j", words.lanes[segments.lane_group], data::Item::second, bits, items);
  std::vector<Connection> connections = clock_and_reset();
  append(connections, {"s_word_tvalid", "s_word_tready", "s_word_tdata", "m_word_tvalid",
                       "m_word_tready", "m_word_tdata"});
  connections.push_back({"passing_word", net("item_j")});
  append(connections, {"held_words", "verdicts", "decided"});
  const int latency_cycles = system.lane_groups[segments.lane_group].schedule.latency_cycles;
  std::vector<Parameter> parameters = common_parameters(engine, lanes, bits, latency_cycles);
  parameters.push_back({"QUEUE_BITS", design::segment_queue_bits(latency_cycles)});
  if (system.second_tier) {
    constexpr int flags = 2;  // first, stays
    const int pairs_bits = lane_bits(lanes) + 1;
    parameters.push_back({"TIERED", 1});
    connect_tier(entry_bits(engine, lanes) + bits + flags + pairs_bits, items, connections);
  } else {
    append(connections, {"m_axis_tvalid", "m_axis_tready", "m_axis_tdata", "m_axis_tlast"});
  }
  items.push_back(
      Instance{"pair_segment", "segment", std::move(parameters), std::move(connections)});
  add_lanes(system, words, segments, items);
  if (system.second_tier) add_second_tier(system, engine, words, lanes, items);
  return module;
}

}  // namespace mixcmp::rtl
