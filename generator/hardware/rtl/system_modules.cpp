#include "generator/hardware/rtl/system_modules.hpp"

#include "generator/hardware/rtl/connections.hpp"
#include "generator/hardware/rtl/counter_port.hpp"
#include "generator/hardware/rtl/datapath_builder.hpp"
#include "generator/hardware/rtl/unread_bits.hpp"

namespace mixcmp::rtl {
namespace {

std::vector<Port> top_ports(const SystemShape& shape) {
  std::vector<Port> ports;
  add_input(ports, 1, "aclk");
  add_input(ports, 1, "aresetn");
  const int channels = shape.channels();
  add_input(ports, channels, "s_axis_tvalid", true);
  add_output(ports, channels, "s_axis_tready", true);
  add_input(ports, shape.lanes * shape.lane_tdata_bytes() * 8, "s_axis_tdata", true);
  add_input(ports, channels * shape.tag_bits, "s_axis_tuser", true);
  add_output(ports, channels, "m_axis_tvalid", true);
  add_input(ports, channels, "m_axis_tready", true);
  add_output(ports, shape.lanes * result_bits, "m_axis_tdata", true);
  add_output(ports, channels * shape.tag_bits, "m_axis_tuser", true);
  if (shape.refetches()) add_refetch_ports(ports, shape, shape.refetch_streams(), true);
  add_counters(system_counters(shape), shape, ports);
  return ports;
}

void declare(std::vector<ModuleItem>& items, const std::vector<Bundle>& bundles,
             const std::string& side, int count) {
  for (const Bundle& bundle : bundles) {
    items.push_back(Wire{count * bundle.width, bundle.wire(side), nullptr, true});
  }
}

/// A generate loop over the channels of a group. Each channel has `width` of the group's lanes or
/// references. An iteration holds `items` and one channel.
ModuleItem channel_loop(const std::string& variable, const DatapathGroup& group, int width,
                        std::vector<ModuleItem> items, std::vector<Connection> connections) {
  items.push_back(Instance{group.channel, "channel", {}, std::move(connections)});
  return std::make_shared<const ForGenerate>(ForGenerate{
      variable, group.first / width, group.count / width, group.label, std::move(items)});
}

/// The operands of a channel's lanes, without the padding of each to whole bytes.
Operand channel_operands(const SystemShape& shape, const std::string& variable,
                         std::vector<ModuleItem>& items) {
  const int lanes = shape.lanes_per_group;
  const int bits = shape.lane_operand_bits();
  const int tdata_bits = shape.lane_tdata_bytes() * 8;
  items.push_back(
      Wire{lanes * tdata_bits, "tdata", indexed("s_axis_tdata", variable, lanes * tdata_bits)});
  std::vector<BitRange> read;
  for (int k = 0; k < lanes; ++k) read.push_back({k * tdata_bits, bits});
  consume_unread("tdata", lanes * tdata_bits, read, items);
  if (lanes == 1 || bits == tdata_bits) return slice("tdata", lanes * bits - 1, 0);
  items.push_back(Wire{lanes * bits, "operands", nullptr});
  for (int k = 0; k < lanes; ++k) {
    items.push_back(Assignment{slice("operands", (k + 1) * bits - 1, k * bits),
                               slice("tdata", k * tdata_bits + bits - 1, k * tdata_bits)});
  }
  return net("operands");
}

ModuleItem lane_loop(const SystemShape& shape, const DatapathGroup& group) {
  std::vector<ModuleItem> items;
  const int width = shape.lanes_per_group;
  const std::string variable = width == 1 ? "lane" : "group";
  Operand operands = channel_operands(shape, variable, items);
  std::vector<Connection> connections = clock_and_reset();
  const auto connect = [&](const std::string& port, const std::string& name, int bits) {
    connections.push_back({port, indexed(name, variable, bits)});
  };
  connect("s_axis_tvalid", "s_axis_tvalid", 1);
  connect("s_axis_tready", "s_axis_tready", 1);
  connections.push_back({"s_axis_tdata", std::move(operands)});
  connect("s_axis_tuser", "s_axis_tuser", shape.tag_bits);
  if (shape.recomputes()) {
    for (const Bundle& bundle : asking_bundles(shape)) {
      connect(bundle.port, bundle.wire("lane"), bundle.width);
    }
  }
  connect("m_axis_tvalid", "m_axis_tvalid", 1);
  connect("m_axis_tready", "m_axis_tready", 1);
  connect("m_axis_tdata", "m_axis_tdata", width * result_bits);
  connect("m_axis_tuser", "m_axis_tuser", shape.tag_bits);
  if (shape.counter_bits > 0) {
    for (const std::string& counter : channel_counters()) {
      connect(counter, counter, shape.counter_bits);
    }
  }
  return channel_loop(variable, group, width, std::move(items), std::move(connections));
}

/// Connects a channel that lanes of `shape` ask to field `variable` of the wires of `side`, and to
/// the stream of operands with the number `first_stream` + `variable`.
void connect_asked(const SystemShape& shape, const std::string& variable, const std::string& side,
                   int first_stream, std::vector<ModuleItem>& items,
                   std::vector<Connection>& connections) {
  for (const Bundle& bundle : asked_bundles(shape)) {
    connections.push_back({bundle.port, indexed(bundle.wire(side), variable, bundle.width)});
  }
  if (!shape.refetches()) return;
  const int tdata_bits = shape.tdata_bytes() * 8;
  items.push_back(Wire{tdata_bits, "refetched",
                       indexed("s_refetch_tdata", variable, tdata_bits, first_stream)});
  consume_unread("refetched", tdata_bits, {{0, shape.operand_bits()}}, items);
  const auto connect = [&](const std::string& port, int width) {
    connections.push_back({port, indexed(port, variable, width, first_stream)});
  };
  connect("m_refetch_tvalid", 1);
  connect("m_refetch_tready", 1);
  connect("m_refetch_tdata", shape.refetch_bits());
  connect("s_refetch_tvalid", 1);
  connect("s_refetch_tready", 1);
  connections.push_back({"s_refetch_tdata", slice("refetched", shape.operand_bits() - 1, 0)});
}

ModuleItem reference_loop(const SystemShape& shape, const DatapathGroup& group) {
  std::vector<ModuleItem> items;
  std::vector<Connection> connections = clock_and_reset();
  connect_asked(shape, "reference", "reference", 0, items, connections);
  if (shape.counts_answers()) {
    connections.push_back({"answers", indexed("answers", "reference", shape.counter_bits)});
  }
  const int interval = group.schedule.initiation_interval;
  if (interval > 1) connections.push_back({"reset_phase", literal(phase_bits(interval), 0)});
  return channel_loop("reference", group, 1, std::move(items), std::move(connections));
}

ModuleItem second_tier_loop(const SystemShape& shape) {
  std::vector<ModuleItem> items;
  std::vector<Connection> connections = clock_and_reset();
  connect_asked(shape, "lane", "second_tier", shape.references, items, connections);
  const SystemShape tier = second_tier_shape(shape);
  for (const Bundle& bundle : asking_bundles(tier)) {
    connections.push_back({bundle.port, indexed(bundle.wire("second_lane"), "lane", bundle.width)});
  }
  return channel_loop("lane", *shape.second_tier, 1, std::move(items), std::move(connections));
}

/// Connects a port of the crossbar to a port of the channel, which has the opposite direction.
Connection crossbar_connection(const Bundle& bundle, const std::string& side) {
  const std::string mirrored = bundle.port[0] == 'm' ? "s" : "m";
  return {mirrored + bundle.port.substr(1), net(bundle.wire(side))};
}

/// The crossbar between the lanes of `shape` and the `count` channels that they ask. On the side of
/// the lanes, names of wires begin with `asking`.
Instance crossbar(const SystemShape& shape, const std::string& asking, const std::string& asked,
                  int count, const std::string& name) {
  std::vector<Connection> connections = clock_and_reset();
  for (const Bundle& bundle : asking_bundles(shape)) {
    connections.push_back(crossbar_connection(bundle, asking));
  }
  for (const Bundle& bundle : asked_bundles(shape)) {
    connections.push_back(crossbar_connection(bundle, asked));
  }
  TemplateInstance crossbar = crossbar_template(shape, count);
  return {crossbar.module, name, std::move(crossbar.parameters), std::move(connections)};
}

/// Adds the second tier, between the crossbar in front of it and the wires of its lanes' requests.
void add_second_tier(const SystemShape& shape, std::vector<ModuleItem>& items) {
  items.push_back(
      Comment{"Requests at the second tier, with the number of the lane or group that asks."});
  declare(items, asked_bundles(shape), "second_tier", shape.second_lanes());
  items.push_back(Comment{"Requests of the second tier's lanes, verdicts back to them."});
  declare(items, asking_bundles(second_tier_shape(shape)), "second_lane", shape.second_lanes());
  items.push_back(crossbar(shape, "lane", "second_tier", shape.second_lanes(), "second_decision"));
  items.push_back(second_tier_loop(shape));
}

/// Adds the references, and the crossbar from the lanes that ask them.
void add_references(const SystemShape& asking, const std::string& side,
                    std::vector<ModuleItem>& items) {
  items.push_back(Comment{asking.lanes_per_group == 1
                              ? "The same at the references, with the number of the lane."
                              : "The same at the references, with the number of the group."});
  declare(items, asked_bundles(asking), "reference", asking.references);
  items.push_back(crossbar(asking, side, "reference", asking.references, "recomputation"));
  for (const DatapathGroup& group : asking.reference_groups) {
    items.push_back(reference_loop(asking, group));
  }
}

}  // namespace

TemplateInstance crossbar_template(const SystemShape& shape, int asked) {
  return {"stream_crossbar",
          {{"LANES", shape.channels()},
           {"REFERENCES", asked},
           {"LANE_BITS", shape.channel_bits()},
           {"SLOT_BITS", shape.slot_bits},
           {"PAYLOAD_BITS", shape.payload_bits()},
           {"BEAT_BITS", shape.beat_bits}}};
}

Module top_module(const SystemShape& shape) {
  Module module = {shape.top, top_ports(shape), {}};
  std::vector<ModuleItem>& items = module.items;
  if (shape.recomputes()) {
    items.push_back(
        Comment{shape.lanes_per_group == 1
                    ? "Undecided comparisons from the lanes, verdicts back to them."
                    : "Undecided comparisons from the groups of lanes, verdicts back."});
    declare(items, asking_bundles(shape), "lane", shape.channels());
  }
  for (const DatapathGroup& group : shape.lane_groups) items.push_back(lane_loop(shape, group));
  if (!shape.recomputes()) return module;
  if (!shape.second_tier) {
    add_references(shape, "lane", items);
  } else {
    add_second_tier(shape, items);
    add_references(second_tier_shape(shape), "second_lane", items);
  }
  return module;
}

}  // namespace mixcmp::rtl
