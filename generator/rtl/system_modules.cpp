#include "generator/rtl/system_modules.hpp"

#include <bit>

#include "generator/rtl/connections.hpp"
#include "generator/rtl/counter_port.hpp"
#include "generator/rtl/datapath_builder.hpp"
#include "generator/rtl/unread_bits.hpp"

namespace mixcmp::rtl {
namespace {

/// OUTSTANDING_BITS of reference_port: the operands of 2^4 comparisons may be on their way from the
/// user's memory to each reference.
constexpr int outstanding_bits = 4;

/// Connects each operand port of a datapath to its slice of `packed`.
void append_operands(std::vector<Connection>& connections, const DatapathGroup& group,
                     const std::string& packed) {
  for (const OperandPort& port : group.operands) {
    connections.push_back({port.name, slice(packed, port.low + port.width - 1, port.low)});
  }
}

/// Consumes the bits of a lane's words that are of other kinds of lanes.
void consume_unread_words(const SystemShape& shape, const DatapathGroup& group,
                          std::vector<ModuleItem>& items) {
  std::vector<BitRange> read;
  for (const OperandPort& port : group.operands) read.push_back({port.low, port.width});
  consume_unread("lane_operands", shape.lane_operand_bits(), read, items);
}

/// A lane between `operands` and what it says of them.
Instance lane_instance(const DatapathGroup& group, const std::string& operands, Operand verdict,
                       Operand decided) {
  std::vector<Connection> connections = {by_name("aclk")};
  append_operands(connections, group, operands);
  connections.push_back({"verdict", std::move(verdict)});
  connections.push_back({"decided", std::move(decided)});
  return {group.datapath, "lane", {}, std::move(connections)};
}

/// The lanes of a channel: one, or a group in a loop.
void add_lanes(const SystemShape& shape, const DatapathGroup& group,
               std::vector<ModuleItem>& items) {
  const int bits = shape.lane_operand_bits();
  const int lanes = shape.lanes_per_group;
  items.push_back(Wire{lanes * bits, "lane_operands", nullptr});
  if (lanes == 1) consume_unread_words(shape, group, items);
  items.push_back(Wire{lanes * verdict_bits, "lane_verdict", nullptr});
  items.push_back(Wire{lanes, "lane_decided", nullptr});
  if (lanes == 1) {
    items.push_back(
        lane_instance(group, "lane_operands", net("lane_verdict"), net("lane_decided")));
    return;
  }
  std::vector<ModuleItem> body = {
      Wire{bits, "operands", indexed("lane_operands", "k", bits)},
      lane_instance(group, "operands", indexed("lane_verdict", "k", verdict_bits),
                    indexed("lane_decided", "k", 1))};
  items.push_back(
      std::make_shared<const ForGenerate>(ForGenerate{"k", 0, lanes, "lanes", std::move(body)}));
}

const std::vector<std::string> request_stream = {"m_request_tvalid", "m_request_tready",
                                                 "m_request_tdata"};
const std::vector<std::string> answer_ports = {"s_answer_valid", "s_answer_slot",
                                               "s_answer_verdict"};
const std::vector<std::string> channel_counters = {"comparisons", "recomputations", "stalls"};

std::vector<Port> lane_channel_ports(const SystemShape& shape) {
  std::vector<Port> ports;
  add_input(ports, 1, "aclk");
  add_input(ports, 1, "aresetn");
  add_input(ports, 1, "s_axis_tvalid");
  add_output(ports, 1, "s_axis_tready");
  add_input(ports, shape.lanes_per_group * shape.lane_operand_bits(), "s_axis_tdata");
  add_input(ports, shape.tag_bits, "s_axis_tuser");
  if (shape.recomputes()) {
    add_output(ports, 1, "m_request_tvalid");
    add_input(ports, 1, "m_request_tready");
    add_output(ports, shape.slot_bits + shape.payload_bits(), "m_request_tdata");
    add_input(ports, 1, "s_answer_valid");
    add_input(ports, shape.slot_bits, "s_answer_slot");
    add_input(ports, verdict_bits, "s_answer_verdict");
  }
  add_output(ports, 1, "m_axis_tvalid");
  add_input(ports, 1, "m_axis_tready");
  add_output(ports, shape.lanes_per_group * result_bits, "m_axis_tdata");
  add_output(ports, shape.tag_bits, "m_axis_tuser");
  if (shape.counter_bits > 0) {
    for (const std::string& counter : channel_counters)
      add_output(ports, shape.counter_bits, counter);
  }
  return ports;
}

/// Connects the requests, answers and counters of a lane's tracker. Requests and answers are tied
/// off where there is no reference, counters where none are wanted.
void tie_off(const SystemShape& shape, std::vector<ModuleItem>& items,
             std::vector<Connection>& connections) {
  if (shape.recomputes()) {
    append(connections, request_stream);
    append(connections, answer_ports);
  } else {
    items.push_back(Comment{"No reference: undecided comparisons leave as undecided."});
    items.push_back(Wire{1, "unused_request_tvalid", nullptr});
    items.push_back(Wire{shape.slot_bits + shape.payload_bits(), "unused_request_tdata", nullptr});
    connections.push_back({"m_request_tvalid", net("unused_request_tvalid")});
    connections.push_back({"m_request_tready", literal(1, 0)});
    connections.push_back({"m_request_tdata", net("unused_request_tdata")});
    connections.push_back({"s_answer_valid", literal(1, 0)});
    connections.push_back({"s_answer_slot", literal(shape.slot_bits, 0)});
    connections.push_back({"s_answer_verdict", literal(verdict_bits, 0)});
  }
  for (const std::string& counter : channel_counters) {
    if (shape.counter_bits > 0) {
      connections.push_back(by_name(counter));
    } else {
      items.push_back(Wire{1, "unused_" + counter, nullptr});
      connections.push_back({counter, net("unused_" + counter)});
    }
  }
}

void add_per_reference_refetch(std::vector<Port>& ports, const SystemShape& shape, int count,
                               bool vector) {
  add_output(ports, count, "m_refetch_tvalid", vector);
  add_input(ports, count, "m_refetch_tready", vector);
  add_output(ports, count * shape.refetch_bits(), "m_refetch_tdata", vector);
  add_input(ports, count, "s_refetch_tvalid", vector);
  add_output(ports, count, "s_refetch_tready", vector);
  const int bits = vector ? shape.tdata_bytes() * 8 : shape.operand_bits();
  add_input(ports, count * bits, "s_refetch_tdata", vector);
}

/// Connects the refetch streams of a reference_port to the channel's ports, or ties them off where
/// operands are carried.
void connect_refetch(const SystemShape& shape, std::vector<ModuleItem>& items,
                     std::vector<Connection>& connections) {
  if (shape.refetches()) {
    append(connections, {"m_refetch_tvalid", "m_refetch_tready"});
    connections.push_back({"m_refetch_tdata", slice("m_refetch_tdata", shape.ask_bits() - 1, 0)});
    append(connections, {"s_refetch_tvalid", "s_refetch_tready", "s_refetch_tdata"});
    const int padding = shape.refetch_bits() - shape.ask_bits();
    if (padding > 0) {
      items.push_back(
          Assignment{slice("m_refetch_tdata", shape.refetch_bits() - 1, shape.ask_bits()),
                     literal(padding, 0)});
    }
    return;
  }
  items.push_back(Comment{"Operands are carried: nothing is fetched again."});
  items.push_back(Wire{1, "unused_refetch_tvalid", nullptr});
  items.push_back(Wire{shape.ask_bits(), "unused_refetch_tdata", nullptr});
  items.push_back(Wire{1, "unused_refetch_tready", nullptr});
  connections.push_back({"m_refetch_tvalid", net("unused_refetch_tvalid")});
  connections.push_back({"m_refetch_tready", literal(1, 0)});
  connections.push_back({"m_refetch_tdata", net("unused_refetch_tdata")});
  connections.push_back({"s_refetch_tvalid", literal(1, 0)});
  connections.push_back({"s_refetch_tready", net("unused_refetch_tready")});
  connections.push_back({"s_refetch_tdata", zeros(shape.operand_bits())});
}

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
  if (shape.refetches()) add_per_reference_refetch(ports, shape, shape.references, true);
  add_counters(system_counters(shape), shape, ports);
  return ports;
}

/// A wire of the top between the crossbar and the channels, with one field per lane or reference.
/// Its name is that of the channel's port, with "lane" or "reference" in place of the first letter;
/// a group of lanes counts as one.
struct Bundle {
  std::string port;
  int width;

  std::string wire(const std::string& side) const { return side + port.substr(1); }
};

std::vector<Bundle> lane_bundles(const SystemShape& shape) {
  return {{"m_request_tvalid", 1},
          {"m_request_tready", 1},
          {"m_request_tdata", shape.slot_bits + shape.payload_bits()},
          {"s_answer_valid", 1},
          {"s_answer_slot", shape.slot_bits},
          {"s_answer_verdict", verdict_bits}};
}

std::vector<Bundle> reference_bundles(const SystemShape& shape) {
  const int sender_bits = shape.channel_bits() + shape.slot_bits;
  return {{"s_request_tvalid", 1},
          {"s_request_tready", 1},
          {"s_request_tdata", sender_bits + shape.payload_bits()},
          {"m_answer_valid", 1},
          {"m_answer_tdata", sender_bits + verdict_bits}};
}

void declare(std::vector<ModuleItem>& items, const std::vector<Bundle>& bundles,
             const std::string& side, int count) {
  for (const Bundle& bundle : bundles) {
    items.push_back(Wire{count * bundle.width, bundle.wire(side), nullptr, true});
  }
}

/// A generate loop over the group's channels, each of which has `width` of its lanes or references;
/// an iteration holds `items` and one channel.
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
    for (const Bundle& bundle : lane_bundles(shape)) {
      connect(bundle.port, bundle.wire("lane"), bundle.width);
    }
  }
  connect("m_axis_tvalid", "m_axis_tvalid", 1);
  connect("m_axis_tready", "m_axis_tready", 1);
  connect("m_axis_tdata", "m_axis_tdata", width * result_bits);
  connect("m_axis_tuser", "m_axis_tuser", shape.tag_bits);
  if (shape.counter_bits > 0) {
    for (const std::string& counter : channel_counters)
      connect(counter, counter, shape.counter_bits);
  }
  return channel_loop(variable, group, width, std::move(items), std::move(connections));
}

ModuleItem reference_loop(const SystemShape& shape, const DatapathGroup& group) {
  std::vector<ModuleItem> items;
  std::vector<Connection> connections = clock_and_reset();
  const auto connect = [&](const std::string& port, const std::string& name, int width) {
    connections.push_back({port, indexed(name, "reference", width)});
  };
  for (const Bundle& bundle : reference_bundles(shape)) {
    connect(bundle.port, bundle.wire("reference"), bundle.width);
  }
  if (shape.refetches()) {
    const int tdata_bits = shape.tdata_bytes() * 8;
    items.push_back(
        Wire{tdata_bits, "refetched", indexed("s_refetch_tdata", "reference", tdata_bits)});
    consume_unread("refetched", tdata_bits, {{0, shape.operand_bits()}}, items);
    connect("m_refetch_tvalid", "m_refetch_tvalid", 1);
    connect("m_refetch_tready", "m_refetch_tready", 1);
    connect("m_refetch_tdata", "m_refetch_tdata", shape.refetch_bits());
    connect("s_refetch_tvalid", "s_refetch_tvalid", 1);
    connect("s_refetch_tready", "s_refetch_tready", 1);
    connections.push_back({"s_refetch_tdata", slice("refetched", shape.operand_bits() - 1, 0)});
  }
  if (shape.counts_answers()) connect("answers", "answers", shape.counter_bits);
  const int interval = group.schedule.initiation_interval;
  if (interval > 1) connections.push_back({"reset_phase", literal(phase_bits(interval), 0)});
  return channel_loop("reference", group, 1, std::move(items), std::move(connections));
}

/// Counts the answers of a reference.
Instance answer_counter(const SystemShape& shape) {
  std::vector<Connection> connections = clock_and_reset();
  connections.push_back({"step", net("m_answer_valid")});
  connections.push_back({"count", net("answers")});
  return {"event_counter",
          "answer_counter",
          {{"COUNTER_BITS", shape.counter_bits}},
          std::move(connections)};
}

/// Connects a port of the crossbar, which mirrors the channel's: what a channel sends, it receives.
Connection crossbar_connection(const Bundle& bundle, const std::string& side) {
  const std::string mirrored = bundle.port[0] == 'm' ? "s" : "m";
  return {mirrored + bundle.port.substr(1), net(bundle.wire(side))};
}

Instance crossbar(const SystemShape& shape) {
  std::vector<Connection> connections = clock_and_reset();
  for (const Bundle& bundle : lane_bundles(shape))
    connections.push_back(crossbar_connection(bundle, "lane"));
  for (const Bundle& bundle : reference_bundles(shape)) {
    connections.push_back(crossbar_connection(bundle, "reference"));
  }
  TemplateInstance crossbar = crossbar_template(shape);
  return {crossbar.module, "recomputation", std::move(crossbar.parameters), std::move(connections)};
}

}  // namespace

int SystemShape::channel_bits() const {
  return std::max(1, static_cast<int>(std::bit_width(static_cast<unsigned>(channels() - 1))));
}

int SystemShape::payload_bits() const {
  return operands == scene::OperandStore::carried ? ((operand_bits() - 1) >> beat_bits) + 1
                                                  : ask_bits();
}

std::vector<OperandPort> SystemShape::operand_ports() const {
  std::vector<OperandPort> ports;
  for (std::size_t k = 0; k < input_ports.size(); ++k) {
    ports.push_back({input_ports[k], static_cast<int>(k) * input_width, input_width});
  }
  return ports;
}

int SystemShape::channel_latency_cycles() const {
  const bool merges = order == scene::ResultOrder::tagged && recomputes();
  return (merges ? 5 : 4) + input_registers;
}

TemplateInstance tracker_template(const SystemShape& shape, int lane_latency_cycles) {
  const bool in_order = shape.order == scene::ResultOrder::in_order;
  const bool carries =
      shape.operands == scene::OperandStore::carried || shape.asking_bits > 0;  // tags, at least
  TemplateInstance tracker{in_order ? "lane_reorder" : "lane_scoreboard",
                           {{"OPERAND_BITS", shape.lane_operand_bits()},
                            {"TAG_BITS", shape.tag_bits},
                            {"SLOT_BITS", shape.slot_bits},
                            {"LANE_LATENCY", lane_latency_cycles},
                            {"COUNTER_BITS", shape.counter_bits},
                            {"RECOMPUTE", shape.recomputes() ? 1 : 0},
                            {"CARRIED", carries ? 1 : 0},
                            {"BEAT_BITS", shape.beat_bits},
                            {"BLOCK", shape.block_memory ? 1 : 0}}};
  if (shape.lanes_per_group > 1) {
    tracker.parameters.insert(tracker.parameters.begin(), {"LANES", shape.lanes_per_group});
  }
  if (shape.asking_bits > 0) tracker.parameters.push_back({"ASK_BITS", shape.asking_bits});
  if (shape.input_registers > 0) {
    tracker.parameters.push_back({"INPUT_REGISTERS", shape.input_registers});
  }
  return tracker;
}

TemplateInstance crossbar_template(const SystemShape& shape) {
  return {"stream_crossbar",
          {{"LANES", shape.channels()},
           {"REFERENCES", shape.references},
           {"LANE_BITS", shape.channel_bits()},
           {"SLOT_BITS", shape.slot_bits},
           {"PAYLOAD_BITS", shape.payload_bits()},
           {"BEAT_BITS", shape.beat_bits}}};
}

Module lane_channel_module(const SystemShape& shape, const DatapathGroup& group) {
  Module module = {group.channel, {}, lane_channel_ports(shape), {}};
  std::vector<ModuleItem>& items = module.items;
  add_lanes(shape, group, items);

  std::vector<Connection> tracker = clock_and_reset();
  append(tracker, {"s_axis_tvalid", "s_axis_tready", "s_axis_tdata", "s_axis_tuser",
                   "lane_operands", "lane_verdict", "lane_decided"});
  tie_off(shape, items, tracker);
  append(tracker, {"m_axis_tvalid", "m_axis_tready", "m_axis_tdata", "m_axis_tuser"});
  TemplateInstance tracking = tracker_template(shape, group.schedule.latency_cycles);
  items.push_back(
      Instance{tracking.module, "tracker", std::move(tracking.parameters), std::move(tracker)});
  return module;
}

TemplateInstance reference_port_template(const SystemShape& shape,
                                         const datapath::Schedule& reference) {
  return {"reference_port",
          {{"OPERAND_BITS", shape.operand_bits()},
           {"TAG_BITS", shape.ask_bits()},
           {"LANE_BITS", shape.channel_bits()},
           {"SLOT_BITS", shape.slot_bits},
           {"REFERENCE_LATENCY", reference.latency_cycles},
           {"INITIATION_INTERVAL", reference.initiation_interval},
           {"LAST_OPERAND_PHASE", reference.last_operand_phase},
           {"PHASE_BITS", phase_bits(reference.initiation_interval)},
           {"CARRIED", shape.refetches() ? 0 : 1},
           {"BEAT_BITS", shape.beat_bits},
           {"OUTSTANDING_BITS", outstanding_bits}}};
}

Module reference_channel_module(const SystemShape& shape, const DatapathGroup& group) {
  Module module = {group.channel, {}, {}, {}};
  add_input(module.ports, 1, "aclk");
  add_input(module.ports, 1, "aresetn");
  for (const Bundle& bundle : reference_bundles(shape)) {
    const bool output = bundle.port == "s_request_tready" || bundle.port[0] == 'm';
    module.ports.push_back(
        {output ? Direction::output : Direction::input, bundle.width, bundle.port});
  }
  if (shape.refetches()) add_per_reference_refetch(module.ports, shape, 1, false);
  if (shape.counts_answers()) add_output(module.ports, shape.counter_bits, "answers");
  const datapath::Schedule& schedule = group.schedule;
  const bool folded = schedule.initiation_interval > 1;
  const int bits = phase_bits(schedule.initiation_interval);
  if (folded) module.ports.push_back({Direction::input, bits, "reset_phase", true});

  std::vector<ModuleItem>& items = module.items;
  items.push_back(Wire{shape.operand_bits(), "reference_operands", nullptr});
  items.push_back(Wire{verdict_bits, "reference_verdict", nullptr});
  const std::string phase = folded ? "reference_phase" : "unused_reference_phase";
  items.push_back(Wire{bits, phase, nullptr, folded});
  std::vector<Connection> reference = {by_name("aclk")};
  if (folded) reference.push_back({"phase", net(phase)});
  append_operands(reference, group, "reference_operands");
  reference.push_back({"verdict", net("reference_verdict")});
  items.push_back(Instance{group.datapath, "reference", {}, std::move(reference)});

  std::vector<Connection> port = clock_and_reset();
  for (const Bundle& bundle : reference_bundles(shape)) port.push_back(by_name(bundle.port));
  port.push_back({"reset_phase", folded ? net("reset_phase") : literal(bits, 0)});
  port.push_back({"reference_phase", net(phase)});
  append(port, {"reference_operands", "reference_verdict"});
  connect_refetch(shape, items, port);
  TemplateInstance around = reference_port_template(shape, schedule);
  items.push_back(Instance{around.module, "port", std::move(around.parameters), std::move(port)});
  if (shape.counts_answers()) items.push_back(answer_counter(shape));
  return module;
}

Module top_module(const SystemShape& shape) {
  Module module = {shape.top, {}, top_ports(shape), {}};
  std::vector<ModuleItem>& items = module.items;
  const auto add_lanes = [&] {
    for (const DatapathGroup& group : shape.lane_groups) items.push_back(lane_loop(shape, group));
  };
  if (!shape.recomputes()) {
    add_lanes();
    return module;
  }
  items.push_back(Comment{shape.lanes_per_group == 1
                              ? "Undecided comparisons from the lanes, verdicts back to them."
                              : "Undecided comparisons from the groups of lanes, verdicts back."});
  declare(items, lane_bundles(shape), "lane", shape.channels());
  items.push_back(Comment{shape.lanes_per_group == 1
                              ? "The same at the references, with the number of the lane."
                              : "The same at the references, with the number of the group."});
  declare(items, reference_bundles(shape), "reference", shape.references);
  add_lanes();
  items.push_back(crossbar(shape));
  for (const DatapathGroup& group : shape.reference_groups) {
    items.push_back(reference_loop(shape, group));
  }
  return module;
}

}  // namespace mixcmp::rtl
