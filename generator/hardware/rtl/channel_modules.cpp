#include "generator/hardware/rtl/channel_modules.hpp"

#include "generator/hardware/rtl/connections.hpp"
#include "generator/hardware/rtl/counter_port.hpp"
#include "generator/hardware/rtl/datapath_builder.hpp"
#include "generator/hardware/rtl/unread_bits.hpp"

namespace mixcmp::rtl {
namespace {

/// OUTSTANDING_BITS: the operands of 2^4 comparisons may be on their way from the user's memory to
/// each reference, and to each lane of a second tier.
constexpr int outstanding_bits = 4;

/// Connects each operand port of a datapath to its slice of `packed`.
void append_operands(std::vector<Connection>& connections, const DatapathGroup& group,
                     const std::string& packed) {
  for (const OperandPort& port : group.operands) {
    connections.push_back({port.name, slice(packed, port.low + port.width - 1, port.low)});
  }
}

/// Consumes the bits of a lane's words that belong to other kinds of lanes.
void consume_unread_words(const SystemShape& shape, const DatapathGroup& group,
                          std::vector<ModuleItem>& items) {
  std::vector<BitRange> read;
  for (const OperandPort& port : group.operands) read.push_back({port.low, port.width});
  consume_unread("lane_operands", shape.lane_operand_bits(), read, items);
}

/// A lane with `operands` as its inputs, and `verdict` and `decided` as its outputs.
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

/// Adds ports of a channel. The names of streams that it sends begin with "m_".
void add_ports(std::vector<Port>& ports, const std::vector<Bundle>& bundles) {
  for (const Bundle& bundle : bundles) {
    const bool is_ready = bundle.port.ends_with("_tready");
    const bool output = bundle.port.starts_with("m_") != is_ready;
    ports.push_back({output ? Direction::output : Direction::input, bundle.width, bundle.port});
  }
}

std::vector<Port> lane_channel_ports(const SystemShape& shape) {
  std::vector<Port> ports;
  add_input(ports, 1, "aclk");
  add_input(ports, 1, "aresetn");
  add_input(ports, 1, "s_axis_tvalid");
  add_output(ports, 1, "s_axis_tready");
  add_input(ports, shape.lanes_per_group * shape.lane_operand_bits(), "s_axis_tdata");
  add_input(ports, shape.tag_bits, "s_axis_tuser");
  if (shape.recomputes()) add_ports(ports, asking_bundles(shape));
  add_output(ports, 1, "m_axis_tvalid");
  add_input(ports, 1, "m_axis_tready");
  add_output(ports, shape.lanes_per_group * result_bits, "m_axis_tdata");
  add_output(ports, shape.tag_bits, "m_axis_tuser");
  if (shape.counter_bits > 0) {
    for (const std::string& counter : channel_counters()) {
      add_output(ports, shape.counter_bits, counter);
    }
  }
  return ports;
}

/// Connects the requests, answers and counters of a lane's tracker. Requests and answers are tied
/// off if there is no reference, counters if none are wanted.
void tie_off(const SystemShape& shape, std::vector<ModuleItem>& items,
             std::vector<Connection>& connections) {
  if (shape.recomputes()) {
    for (const Bundle& bundle : asking_bundles(shape)) connections.push_back(by_name(bundle.port));
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
  for (const std::string& counter : channel_counters()) {
    if (shape.counter_bits > 0) {
      connections.push_back(by_name(counter));
    } else {
      items.push_back(Wire{1, "unused_" + counter, nullptr});
      connections.push_back({counter, net("unused_" + counter)});
    }
  }
}

/// Connects the refetch streams of a reference_port or of requested_operands to the channel's
/// ports, or ties them off if operands are carried.
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

/// The ports of a channel that the lanes of `shape` ask, the streams of its operands among them.
std::vector<Port> asked_ports(const SystemShape& shape) {
  std::vector<Port> ports;
  add_input(ports, 1, "aclk");
  add_input(ports, 1, "aresetn");
  add_ports(ports, asked_bundles(shape));
  if (shape.refetches()) add_refetch_ports(ports, shape, 1, false);
  return ports;
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

/// Adds the stream of operands that the first tier asks about, for the lane behind it. With each
/// comparison go its sender and, for the references, the tag by which operands are fetched again.
void add_requested_operands(const SystemShape& shape, const SystemShape& tier,
                            std::vector<ModuleItem>& items) {
  const int payload_bits = shape.payload_bits();
  const int request_bits = shape.channel_bits() + shape.slot_bits + payload_bits;
  items.push_back(Wire{1, "asked_tvalid", nullptr});
  items.push_back(Wire{1, "asked_tready", nullptr});
  items.push_back(Wire{shape.operand_bits(), "asked_tdata", nullptr});
  items.push_back(Wire{tier.tag_bits, "asked_tuser", nullptr});
  std::vector<Connection> connections = clock_and_reset();
  append(connections, {"s_request_tvalid", "s_request_tready"});
  connections.push_back({"s_request_tdata", slice("s_request_tdata", payload_bits - 1, 0)});
  connections.push_back({"s_request_tuser",
                         slice("s_request_tdata", request_bits - 1, request_bits - tier.tag_bits)});
  connect_refetch(shape, items, connections);
  for (const char* signal : {"tvalid", "tready", "tdata", "tuser"}) {
    connections.push_back({std::string("m_axis_") + signal, net(std::string("asked_") + signal)});
  }
  items.push_back(Instance{"requested_operands",
                           "requests",
                           {{"OPERAND_BITS", shape.operand_bits()},
                            {"TAG_BITS", shape.ask_bits()},
                            {"SENDER_BITS", tier.tag_bits},
                            {"CARRIED", shape.refetches() ? 0 : 1},
                            {"BEAT_BITS", shape.beat_bits},
                            {"OUTSTANDING_BITS", outstanding_bits}},
                           std::move(connections)});
}

/// A lane's tracker between streams whose names begin with `in` and `out`.
Instance tracker_instance(const SystemShape& shape, const DatapathGroup& group,
                          const std::string& in, const std::string& out,
                          std::vector<ModuleItem>& items) {
  std::vector<Connection> connections = clock_and_reset();
  const auto connect_stream = [&](const std::string& port, const std::string& stream) {
    for (const char* signal : {"_tvalid", "_tready", "_tdata", "_tuser"}) {
      connections.push_back({port + signal, net(stream + signal)});
    }
  };
  connect_stream("s_axis", in);
  append(connections, {"lane_operands", "lane_verdict", "lane_decided"});
  tie_off(shape, items, connections);
  connect_stream("m_axis", out);
  TemplateInstance tracker = tracker_template(shape, group.schedule.latency_cycles);
  return {tracker.module, "tracker", std::move(tracker.parameters), std::move(connections)};
}

}  // namespace

std::vector<Bundle> asking_bundles(const SystemShape& shape) {
  return {{"m_request_tvalid", 1},
          {"m_request_tready", 1},
          {"m_request_tdata", shape.slot_bits + shape.payload_bits()},
          {"s_answer_valid", 1},
          {"s_answer_slot", shape.slot_bits},
          {"s_answer_verdict", verdict_bits}};
}

std::vector<Bundle> asked_bundles(const SystemShape& shape) {
  const int sender_bits = shape.channel_bits() + shape.slot_bits;
  return {{"s_request_tvalid", 1},
          {"s_request_tready", 1},
          {"s_request_tdata", sender_bits + shape.payload_bits()},
          {"m_answer_valid", 1},
          {"m_answer_tdata", sender_bits + verdict_bits}};
}

void add_refetch_ports(std::vector<Port>& ports, const SystemShape& shape, int count, bool vector) {
  add_output(ports, count, "m_refetch_tvalid", vector);
  add_input(ports, count, "m_refetch_tready", vector);
  add_output(ports, count * shape.refetch_bits(), "m_refetch_tdata", vector);
  add_input(ports, count, "s_refetch_tvalid", vector);
  add_output(ports, count, "s_refetch_tready", vector);
  const int bits = vector ? shape.tdata_bytes() * 8 : shape.operand_bits();
  add_input(ports, count * bits, "s_refetch_tdata", vector);
}

const std::vector<std::string>& channel_counters() {
  static const std::vector<std::string> names = {"comparisons", "recomputations", "stalls"};
  return names;
}

TemplateInstance tracker_template(const SystemShape& shape, int lane_latency_cycles) {
  const bool in_order = shape.order == scene::ResultOrder::in_order;
  const bool carries =
      shape.operands == scene::OperandStore::carried || shape.asking_bits > 0;  // operands, or tags
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

Module lane_channel_module(const SystemShape& shape, const DatapathGroup& group) {
  Module module = {group.channel, lane_channel_ports(shape), {}};
  std::vector<ModuleItem>& items = module.items;
  add_lanes(shape, group, items);
  Instance tracker = tracker_instance(shape, group, "s_axis", "m_axis", items);
  items.push_back(std::move(tracker));
  return module;
}

Module second_tier_channel_module(const SystemShape& shape) {
  SystemShape tier = second_tier_shape(shape);
  tier.counter_bits = 0;  // counted by the lanes that ask and the references that answer
  const DatapathGroup& group = *shape.second_tier;
  Module module = {group.channel, asked_ports(shape), {}};
  add_ports(module.ports, asking_bundles(tier));

  std::vector<ModuleItem>& items = module.items;
  add_requested_operands(shape, tier, items);
  add_lanes(tier, group, items);
  items.push_back(Wire{1, "result_tvalid", nullptr});
  items.push_back(Wire{1, "result_tready", literal(1, 1)});
  items.push_back(Wire{result_bits, "result_tdata", nullptr});
  items.push_back(Wire{tier.tag_bits, "result_tuser", nullptr});
  consume_unread("result_tdata", result_bits, {{0, verdict_bits}}, items);
  Instance tracker = tracker_instance(tier, group, "asked", "result", items);
  items.push_back(std::move(tracker));

  const int sender_bits = shape.channel_bits() + shape.slot_bits;
  const int operand_tag_bits = tier.tag_bits - sender_bits;  // 0 if operands are carried
  consume_unread("result_tuser", tier.tag_bits, {{operand_tag_bits, sender_bits}}, items);
  items.push_back(Assignment{net("m_answer_valid"), net("result_tvalid")});
  items.push_back(
      Assignment{net("m_answer_tdata"),
                 concatenation({slice("result_tuser", tier.tag_bits - 1, operand_tag_bits),
                                slice("result_tdata", verdict_bits - 1, 0)})});
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
  Module module = {group.channel, asked_ports(shape), {}};
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
  for (const Bundle& bundle : asked_bundles(shape)) port.push_back(by_name(bundle.port));
  port.push_back({"reset_phase", folded ? net("reset_phase") : literal(bits, 0)});
  port.push_back({"reference_phase", net(phase)});
  append(port, {"reference_operands", "reference_verdict"});
  connect_refetch(shape, items, port);
  TemplateInstance around = reference_port_template(shape, schedule);
  items.push_back(Instance{around.module, "port", std::move(around.parameters), std::move(port)});
  if (shape.counts_answers()) items.push_back(answer_counter(shape));
  return module;
}

}  // namespace mixcmp::rtl
