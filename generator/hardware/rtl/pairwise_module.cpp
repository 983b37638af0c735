#include "generator/hardware/rtl/pairwise_module.hpp"

#include <algorithm>
#include <bit>

#include "generator/hardware/rtl/connections.hpp"
#include "generator/hardware/rtl/datapath_builder.hpp"
#include "generator/hardware/rtl/engine_operands.hpp"
#include "generator/hardware/rtl/unread_bits.hpp"

namespace mixcmp::rtl {
namespace {

/// The counters of the template pairwise_engine.
std::vector<Counters> engine_counters(const PairwiseShape& shape) {
  return {{"reports", shape.streams()}, {"recomputations"}, {"busy_cycles"}, {"stalled_cycles"}};
}

std::vector<Port> pairwise_ports(const PairwiseShape& shape, const SystemShape& system) {
  const int streams = shape.streams();
  const bool vector = streams > 1;
  std::vector<Port> ports;
  add_input(ports, 1, "aclk");
  add_input(ports, 1, "aresetn");
  add_input(ports, 1, "s_axis_tvalid");
  add_output(ports, 1, "s_axis_tready");
  add_input(ports, shape.engine.item_bytes() * 8, "s_axis_tdata");
  add_input(ports, 1, "s_axis_tuser");
  add_input(ports, 1, "s_axis_tlast");
  add_output(ports, streams, "m_axis_tvalid", vector);
  add_input(ports, streams, "m_axis_tready", vector);
  add_output(ports, streams * 8 * shape.report_bytes(), "m_axis_tdata");
  add_output(ports, streams * result_bits, "m_axis_tuser");
  add_output(ports, streams, "m_axis_tlast", vector);
  add_counters(pairwise_counters(shape, system), system, ports);
  return ports;
}

/// The fields of a vector, moved up by one field; `low` is the lowest one.
Operand shifted_up(const std::string& vector, int count, int width, const std::string& lowest) {
  if (count == 1) return net(lowest);
  return concatenation({slice(vector, (count - 1) * width - 1, 0), net(lowest)});
}

/// Declares the chain of segments. A word that leaves one segment arrives at the next; after the
/// last one it has met all other words.
void declare_chain(const PairwiseShape& shape, std::vector<ModuleItem>& items) {
  const int count = shape.segment_count();
  const int bits = chain_bits(shape.engine, shape.words);
  items.push_back(Comment{"Words from the engine, past one segment after the other."});
  items.push_back(Wire{1, "word_tvalid", nullptr});
  items.push_back(Wire{1, "word_tready", nullptr});
  items.push_back(Wire{bits, "word_tdata", nullptr});
  declare({{1, "passed_tvalid"}, {1, "passed_tready"}, {bits, "passed_tdata"}}, count, items);
  items.push_back(
      Wire{count, "arriving_tvalid", shifted_up("passed_tvalid", count, 1, "word_tvalid"), true});
  items.push_back(Wire{count, "arriving_tready", nullptr, true});
  items.push_back(Wire{count * bits, "arriving_tdata",
                       shifted_up("passed_tdata", count, bits, "word_tdata"), true});
  items.push_back(Assignment{net("word_tready"), bit("arriving_tready", 0)});
  Operand ready = literal(1, 1);
  if (count > 1) ready = concatenation({ready, slice("arriving_tready", count - 1, 1)});
  items.push_back(Assignment{net("passed_tready"), std::move(ready)});
  items.push_back(
      Wire{1, "unused_passed",
           all_bits(concatenation({literal(1, 0), bit("passed_tvalid", count - 1),
                                   slice("passed_tdata", count * bits - 1, (count - 1) * bits)}))});
  items.push_back(Comment{"Exceptions of each segment, back to the engine."});
  declare({{1, "entry_tvalid"},
           {1, "entry_tready"},
           {entry_bits(shape.engine, shape.lanes_per_segment()), "entry_tdata"},
           {1, "entry_tlast"}},
          count, items);
}

ModuleItem segment_loop(const PairwiseShape& shape, const SegmentGroup& segments) {
  std::vector<ModuleItem> items;
  std::vector<Connection> connections = clock_and_reset();
  const auto connect = [&](const std::string& port, const std::string& name, int width) {
    connections.push_back({port, indexed(name, "s", width)});
  };
  const int bits = chain_bits(shape.engine, shape.words);
  connect("s_word_tvalid", "arriving_tvalid", 1);
  connect("s_word_tready", "arriving_tready", 1);
  connect("s_word_tdata", "arriving_tdata", bits);
  connect("m_word_tvalid", "passed_tvalid", 1);
  connect("m_word_tready", "passed_tready", 1);
  connect("m_word_tdata", "passed_tdata", bits);
  connect("m_axis_tvalid", "entry_tvalid", 1);
  connect("m_axis_tready", "entry_tready", 1);
  const int own_bits = entry_bits(shape.engine, segments.lanes);
  const int common_bits = entry_bits(shape.engine, shape.lanes_per_segment());
  if (own_bits == common_bits) {
    connect("m_axis_tdata", "entry_tdata", common_bits);
  } else {  // the codes of lanes that this segment lacks are 0
    items.push_back(Wire{own_bits, "entry", nullptr});
    items.push_back(Assignment{indexed("entry_tdata", "s", common_bits),
                               concatenation({zeros(common_bits - own_bits), net("entry")})});
    connections.push_back({"m_axis_tdata", net("entry")});
  }
  connect("m_axis_tlast", "entry_tlast", 1);
  items.push_back(Instance{segments.module, "segment", {}, std::move(connections)});
  return loop("s", segments.first, segments.count, segments.label, std::move(items));
}

void declare_requests(const PairwiseShape& shape, const SystemShape& system,
                      std::vector<ModuleItem>& items) {
  const int references = system.references;
  items.push_back(Comment{"Undecided pairs with their items to the references, verdicts back."});
  items.push_back(Wire{system.tag_bits, "request_tag", nullptr});
  items.push_back(Wire{2 * shape.engine.item_bits(), "request_items", nullptr});
  declare({{1, "request_tvalid"},
           {1, "request_tready"},
           {1, "answer_valid"},
           {system.tag_bits + verdict_bits, "answer_tdata"}},
          references, items);
  const int bits = shape.engine.item_bits();
  items.push_back(Wire{bits, "item_i", slice("request_items", bits - 1, 0)});
  items.push_back(Wire{bits, "item_j", slice("request_items", 2 * bits - 1, bits)});
  Operand operands = packed_operands(shape.engine, system, {"", "item_i", "item_j"}, items);
  items.push_back(Wire{system.operand_bits(), "request_operands", nullptr});
  items.push_back(Assignment{net("request_operands"), std::move(operands)});
}

bool takes_every_cycle(const DatapathGroup& references) {
  return references.schedule.initiation_interval == 1;
}

/// A bit for each reference that takes a request in every cycle.
long long every_cycle_mask(const SystemShape& system) {
  long long mask = 0;
  for (const DatapathGroup& references : system.reference_groups) {
    if (!takes_every_cycle(references)) continue;
    mask |= ((1LL << references.count) - 1) << references.first;
  }
  return mask;
}

/// Adds a register that keeps a request for a reference of a folded group. The reference reads its
/// operands over several cycles, and the engine goes on with other requests meanwhile. A reference
/// that reads them up to its last phase needs the next request at once: its register therefore
/// takes the next request in the cycle in which the previous one leaves. Returns the nets of its
/// output stream.
std::vector<Connection> add_request_register(const std::vector<Connection>& request, int bits,
                                             const DatapathGroup& group,
                                             std::vector<ModuleItem>& items) {
  const datapath::Schedule& schedule = group.schedule;
  const bool is_next_at_once = schedule.last_operand_phase + 1 == schedule.initiation_interval;
  items.push_back(Wire{1, "waiting_tvalid", nullptr});
  items.push_back(Wire{1, "waiting_tready", nullptr});
  items.push_back(Wire{bits, "waiting_tdata", nullptr});
  std::vector<Connection> connections = clock_and_reset();
  const std::vector<std::string> parts = {"tvalid", "tready", "tdata"};
  std::vector<Connection> waiting;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    connections.push_back({"s_axis_" + parts[k], request[k].value});
    waiting.push_back({request[k].port, net("waiting_" + parts[k])});
  }
  for (const std::string& part : parts) {
    connections.push_back({"m_axis_" + part, net("waiting_" + part)});
  }
  items.push_back(Instance{"stream_arbiter",
                           "request",
                           {{"INPUTS", 1}, {"WIDTH", bits}, {"HALF_RATE", is_next_at_once ? 0 : 1}},
                           std::move(connections)});
  return waiting;
}

std::string reset_phases_name(const DatapathGroup& group) {
  return group.label + "_reset_phases";
}

/// Declares the phases in which the references of a folded group begin after reset, one field for
/// each reference of the engine up to the last one of the group. If operands are read late, the
/// phases are spread over the interval: requests come one by one, one per cycle, and a reference
/// that takes its operands late has few cycles until it needs the next ones.
void declare_reset_phases(const DatapathGroup& group, std::vector<ModuleItem>& items) {
  const int interval = group.schedule.initiation_interval;
  const int bits = phase_bits(interval);
  const bool is_late = group.schedule.last_operand_phase + group.count + 2 > interval;
  std::vector<Operand> phases;
  for (int k = group.count - 1; k >= 0; --k) {
    const int later = is_late ? k * interval / group.count : 0;
    phases.push_back(literal(bits, static_cast<Bits>((interval - later) % interval)));
  }
  if (group.first > 0) phases.push_back(zeros(group.first * bits));
  const std::string name = reset_phases_name(group);
  items.push_back(
      Wire{(group.first + group.count) * bits, name, concatenation(std::move(phases)), true});
  if (group.first > 0) {
    items.push_back(Wire{1, "unused_" + name, all_bits(slice(name, group.first * bits - 1, 0))});
  }
}

ModuleItem engine_reference_loop(const SystemShape& system, const DatapathGroup& group) {
  std::vector<ModuleItem> items;
  const auto one = [](const std::string& name, int width) {
    return indexed(name, "reference", width);
  };
  std::vector<Connection> request = {
      {"s_request_tvalid", one("request_tvalid", 1)},
      {"s_request_tready", one("request_tready", 1)},
      {"s_request_tdata", concatenation({net("request_tag"), net("request_operands")})}};
  std::vector<Connection> connections = clock_and_reset();
  if (!takes_every_cycle(group)) {
    request = add_request_register(request, system.tag_bits + system.operand_bits(), group, items);
    connections.push_back({"reset_phase", one(reset_phases_name(group),
                                              phase_bits(group.schedule.initiation_interval))});
  }
  connections.insert(connections.end(), request.begin(), request.end());
  connections.push_back({"m_answer_valid", one("answer_valid", 1)});
  connections.push_back({"m_answer_tdata", one("answer_tdata", system.tag_bits + verdict_bits)});
  if (system.counts_answers()) {
    connections.push_back({"answers", one("answers", system.counter_bits)});
  }
  items.push_back(Instance{group.channel, "channel", {}, std::move(connections)});
  return loop("reference", group.first, group.count, group.label, std::move(items));
}

/// Connects the engine's ports for references, or ties them off if there is none.
void connect_references(const PairwiseShape& shape, const SystemShape& system,
                        std::vector<ModuleItem>& items, std::vector<Connection>& connections) {
  if (system.recomputes()) {
    for (const auto& [port, name] :
         std::vector<std::pair<std::string, std::string>>{{"m_request_tvalid", "request_tvalid"},
                                                          {"m_request_tready", "request_tready"},
                                                          {"m_request_tag", "request_tag"},
                                                          {"m_request_items", "request_items"},
                                                          {"s_answer_valid", "answer_valid"},
                                                          {"s_answer_tdata", "answer_tdata"}}) {
      connections.push_back({port, net(name)});
    }
    return;
  }
  items.push_back(Comment{"No reference: undecided pairs leave as undecided."});
  items.push_back(Wire{1, "unused_request_tvalid", nullptr});
  items.push_back(Wire{system.tag_bits, "unused_request_tag", nullptr});
  items.push_back(Wire{2 * shape.engine.item_bits(), "unused_request_items", nullptr});
  connections.push_back({"m_request_tvalid", net("unused_request_tvalid")});
  connections.push_back({"m_request_tready", literal(1, 0)});
  connections.push_back({"m_request_tag", net("unused_request_tag")});
  connections.push_back({"m_request_items", net("unused_request_items")});
  connections.push_back({"s_answer_valid", literal(1, 0)});
  connections.push_back({"s_answer_tdata", zeros(system.tag_bits + verdict_bits)});
}

Instance engine_instance(const PairwiseShape& shape, const SystemShape& system,
                         std::vector<ModuleItem>& items) {
  std::vector<Connection> connections = clock_and_reset();
  append(connections, {"s_axis_tvalid", "s_axis_tready"});
  connections.push_back({"s_axis_tdata", slice("s_axis_tdata", shape.engine.item_bits() - 1, 0)});
  append(connections, {"s_axis_tuser", "s_axis_tlast", "item_word"});
  for (const char* part : {"tvalid", "tready", "tdata"}) {
    connections.push_back({std::string("m_word_") + part, net(std::string("word_") + part)});
  }
  for (const char* part : {"tvalid", "tready", "tdata", "tlast"}) {
    connections.push_back({std::string("s_entry_") + part, net(std::string("entry_") + part)});
  }
  connect_references(shape, system, items, connections);
  append(connections,
         {"m_axis_tvalid", "m_axis_tready", "m_axis_tdata", "m_axis_tuser", "m_axis_tlast"});
  connect_counters(system, engine_counters(shape), items, connections);
  TemplateInstance around = pairwise_template(shape, system);
  return {around.module, "engine", std::move(around.parameters), std::move(connections)};
}

/// Bits of the number of pairs that may be on their way to the references. At most one pair comes
/// in each cycle, for as long as the slowest reference takes.
int outstanding_bits(const SystemShape& system) {
  constexpr int around = 12;  // cycles from memory to reference, and from there to the verdicts
  int slowest = 0;
  for (const DatapathGroup& references : system.reference_groups) {
    slowest = std::max(slowest, references.schedule.latency_cycles);
  }
  return std::bit_width(static_cast<unsigned>(slowest + around));
}

}  // namespace

int PairwiseShape::lanes_per_segment() const {
  const auto widest = std::max_element(
      segments.begin(), segments.end(),
      [](const SegmentGroup& a, const SegmentGroup& b) { return a.lanes < b.lanes; });
  return widest->lanes;
}

int PairwiseShape::streams() const {
  return std::min(engine.spec.report_streams, segment_count());
}

int PairwiseShape::report_bytes() const {
  const bool bitmap = engine.spec.report_as == scene::ReportForm::bitmap;
  const int flag_bits = bitmap ? lanes_per_segment() : 0;
  return (flag_bits + 7) / 8 + 2 * engine.index_field_bits() / 8;
}

SystemShape reference_shape(SystemShape system) {
  system.operands = scene::OperandStore::carried;
  system.lanes = 1;
  system.slot_bits = system.tag_bits - system.channel_bits();
  return system;
}

TemplateInstance pairwise_template(const PairwiseShape& shape, const SystemShape& system) {
  const scene::EngineSpec& spec = shape.engine.spec;
  return {"pairwise_engine",
          {{"SEGMENTS", shape.segment_count()},
           {"LANES_PER_SEGMENT", shape.lanes_per_segment()},
           {"LANES", system.lanes},
           {"STREAMS", shape.streams()},
           {"REFERENCES", system.references},
           {"CAPACITY", shape.engine.capacity},
           {"ITEM_BITS", shape.engine.item_bits()},
           {"WORD_BITS", shape.words.items.bits()},
           {"WORD_LATENCY", shape.words.latency_cycles()},
           {"INDEX_BITS", shape.engine.index_bits()},
           {"REPORT", spec.report.mask()},
           {"CODE_BITS", code_bits(spec)},
           {"BITMAP", spec.report_as == scene::ReportForm::bitmap ? 1 : 0},
           {"COUNT", spec.report_as == scene::ReportForm::count ? 1 : 0},
           {"EVERY_CYCLE", every_cycle_mask(system)},
           {"OUTSTANDING_BITS", outstanding_bits(system)},
           {"COUNTER_BITS", system.counter_bits}}};
}

std::vector<Counters> pairwise_counters(const PairwiseShape& shape, const SystemShape& system) {
  if (system.counter_bits == 0) return {};
  std::vector<Counters> counters = engine_counters(shape);
  for (Counters& answers : answer_counters(system)) counters.push_back(std::move(answers));
  return counters;
}

Module pairwise_module(const PairwiseShape& shape, const SystemShape& system) {
  Module module = {shape.engine.top, pairwise_ports(shape, system), {}};
  std::vector<ModuleItem>& items = module.items;
  consume_unread("s_axis_tdata", shape.engine.item_bytes() * 8, {{0, shape.engine.item_bits()}},
                 items);
  items.push_back(Comment{"What the lanes know of an item."});
  add_conversion(shape.words, data::Item::first, shape.engine,
                 {.columns = "s_axis_tdata", .word = "item_word", .instance = "conversion"}, items);
  declare_chain(shape, items);
  if (system.recomputes()) declare_requests(shape, system, items);
  Instance around = engine_instance(shape, system, items);
  items.push_back(std::move(around));
  for (const SegmentGroup& segments : shape.segments) {
    items.push_back(segment_loop(shape, segments));
  }
  for (const DatapathGroup& group : system.reference_groups) {
    if (!takes_every_cycle(group)) declare_reset_phases(group, items);
    items.push_back(engine_reference_loop(system, group));
  }
  return module;
}

}  // namespace mixcmp::rtl
