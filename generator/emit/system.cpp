#include "generator/emit/system.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>

#include "generator/datapath/delays.hpp"
#include "generator/datapath/schedule.hpp"
#include "generator/emit/templates.hpp"
#include "generator/emit/verilog.hpp"
#include "generator/emit/version.hpp"
#include "generator/rtl/datapath_builder.hpp"
#include "generator/rtl/datapath_module.hpp"
#include "generator/rtl/system_modules.hpp"
#include "model/common/content_hash.hpp"

namespace mixcmp::gen {
namespace {

using model::Design;
using model::Result;
using rtl::Module;

/// Cycles a comparison spends in a channel beside the lane itself, at full rate
/// (docs/architecture.md): with this many slots more than the lane's latency nothing waits.
constexpr int channel_overhead_cycles = 6;
/// Slots that recomputations may hold while the lane goes on at full rate.
constexpr int recomputation_slots = 16;

SystemShape shape_of(const Design& design, const Schedule& lane, const Schedule& reference) {
  const std::string lane_format = design.lane.graph.arithmetic.format.name();
  const std::string reference_format = design.reference.arithmetic.format.name();
  SystemShape shape;
  shape.top = fmt::format("{}_{}_{}x{}", design.name, lane_format, design.lanes, design.references);
  shape.lane = fmt::format("{}_lane_{}_l{}", design.name, lane_format, lane.latency_cycles);
  shape.lane_channel = shape.lane + "_channel";
  shape.reference =
      fmt::format("{}_reference_{}_l{}", design.name, reference_format, reference.latency_cycles);
  shape.reference_channel = shape.reference + "_channel";
  shape.input_ports = input_ports(design.inputs);
  shape.input_width = design.reference.input_format.width();
  shape.lanes = design.lanes;
  shape.references = design.references;
  shape.tag_bits = design.system.tag_bits;
  shape.counter_bits = design.system.counter_bits;
  shape.lane_latency_cycles = lane.latency_cycles;
  shape.reference_latency_cycles = reference.latency_cycles;
  shape.order = design.system.order;
  shape.operands = design.system.operands;
  const unsigned slots = static_cast<unsigned>(lane.latency_cycles + channel_overhead_cycles +
                                               (design.references > 0 ? recomputation_slots : 0));
  shape.slot_bits = static_cast<int>(std::bit_width(slots - 1));
  return shape;
}

Signature signature_of(const Design& design, const SystemShape& shape) {
  Signature signature = {.top = shape.top,
                         .generator_version = std::string(version),
                         .spec_hash = {},
                         .lane_format = design.lane.graph.arithmetic.format,
                         .reference_format = design.reference.arithmetic.format};
  signature.certified = design.lane.certified();
  signature.inputs = design.inputs;
  signature.channel_module = shape.lane_channel;
  signature.reference_module = shape.recomputes() ? shape.reference_channel : "";
  signature.lanes = shape.lanes;
  signature.references = shape.references;
  signature.tdata_bytes = shape.tdata_bytes();
  signature.tag_bits = shape.tag_bits;
  signature.counter_bits = shape.counter_bits;
  signature.slots = 1 << shape.slot_bits;
  signature.lane_latency_cycles = shape.lane_latency_cycles;
  signature.reference_latency_cycles = shape.reference_latency_cycles;
  signature.order = shape.order;
  signature.operands = shape.operands;
  signature.target_mhz = design.system.target_mhz;
  return signature;
}

/// One module with what its header says of it.
struct Described {
  Module module;
  std::vector<std::string> facts;
};

std::string arithmetic_fact(const model::Arithmetic& arithmetic) {
  return fmt::format("Format: {}, rounding {}, subnormals {}.", arithmetic.format.name(),
                     model::to_string(arithmetic.rounding),
                     model::to_string(arithmetic.subnormals));
}

std::vector<std::string> decision_facts(const model::Lane& lane) {
  const std::string decision = "Decision: " + describe_decision(lane) + ".";
  if (!lane.certified()) return {decision};
  return {decision, "Infinities, NaNs, overflow and underflow are left undecided."};
}

Described describe_lane(const Design& design, const SystemShape& shape, const Schedule& schedule) {
  Described lane = {
      lane_module(shape.lane, design.inputs, design.lane, schedule),
      {shape.lane + ": decides the sign of f - g in reduced precision, or says it cannot.",
       fmt::format("Operands: {}, {}.", design.reference.input_format.name(),
                   fmt::join(design.inputs, ", ")),
       arithmetic_fact(design.lane.graph.arithmetic)}};
  for (std::string& fact : decision_facts(design.lane)) lane.facts.push_back(std::move(fact));
  lane.facts.push_back(
      fmt::format("Latency {} cycles, initiation interval 1, no reset.", schedule.latency_cycles));
  return lane;
}

Described describe_reference(const Design& design, const SystemShape& shape,
                             const Schedule& schedule) {
  return {reference_module(shape.reference, design.inputs, design.reference, schedule),
          {shape.reference + ": the ordering of f and g as computed in reference precision.",
           arithmetic_fact(design.reference.arithmetic),
           "A NaN operand or result makes the verdict unordered.",
           fmt::format("Latency {} cycles, initiation interval 1, no reset.",
                       schedule.latency_cycles)}};
}

Described describe_lane_channel(const SystemShape& shape) {
  const bool in_order = shape.order == model::ResultOrder::in_order;
  return {
      lane_channel_module(shape),
      {shape.lane_channel + ": one lane between its AXI4-Streams.",
       in_order ? "Results leave in the order of acceptance."
                : "Results may overtake a recomputed one; the tag (tuser) tells which is which.",
       fmt::format("{} comparisons may be inside. Reset: aresetn, synchronous, active low.",
                   1 << shape.slot_bits)}};
}

Described describe_reference_channel(const SystemShape& shape) {
  return {reference_channel_module(shape),
          {shape.reference_channel + ": one reference datapath behind the crossbar.",
           shape.refetches() ? "The operands are fetched again by tag on m_refetch and s_refetch."
                             : "The operands arrive with the request.",
           "Reset: aresetn, synchronous, active low."}};
}

Described describe_top(const Design& design, const SystemShape& shape) {
  const int tdata_bits = shape.tdata_bytes() * 8;
  Described top = {
      top_module(shape),
      {fmt::format("{}: p_L = {} in {}, p_H = {} in {}.", shape.top, shape.lanes,
                   design.lane.graph.arithmetic.format.name(), shape.references,
                   design.reference.arithmetic.format.name()),
       "Every per-lane port is a vector of one field a lane, lane 0 in the lowest bits.",
       fmt::format("s_axis_tdata, {} bits a lane, operands {} bits each, the first lowest:",
                   tdata_bits, shape.input_width),
       fmt::format("  {}.", fmt::join(design.inputs, ", ")),
       fmt::format("s_axis_tuser, m_axis_tuser, {} bits a lane: the tag.", shape.tag_bits),
       "m_axis_tdata, 8 bits a lane: {4'b0, undecided, recomputed, verdict[1:0]};",
       "  verdict: 0 less, 1 equal, 2 greater, 3 unordered."}};
  if (shape.refetches()) {
    top.facts.push_back("m_refetch_tdata, s_refetch_tdata, a field a reference: a tag out, in the");
    top.facts.push_back("  order of the tags the operands of each back in.");
  }
  if (shape.counter_bits > 0) {
    top.facts.push_back("comparisons, recomputations, stalls: counts since reset, they wrap.");
  }
  top.facts.push_back(
      fmt::format("Initiation interval 1 a lane, latency {} cycles and up. Reset: aresetn, "
                  "synchronous, active low.",
                  shape.lane_latency_cycles + shape.channel_latency_cycles()));
  return top;
}

std::vector<Described> describe_modules(const Design& design, const SystemShape& shape,
                                        const Schedule& lane, const Schedule& reference) {
  std::vector<Described> modules = {describe_lane(design, shape, lane),
                                    describe_lane_channel(shape)};
  if (shape.recomputes()) {
    modules.push_back(describe_reference(design, shape, reference));
    modules.push_back(describe_reference_channel(shape));
  }
  modules.push_back(describe_top(design, shape));
  return modules;
}

std::vector<SignaturePort> signature_ports(const Module& top) {
  std::vector<SignaturePort> ports;
  for (const rtl::Port& port : top.ports) {
    const bool input = port.direction == rtl::Direction::input;
    ports.push_back({port.name, input ? "input" : "output", port.width});
  }
  return ports;
}

std::string spec_hash(const std::vector<Described>& modules,
                      const std::vector<std::string>& templates) {
  model::ContentHash hash;
  for (const Described& described : modules) hash.add(to_verilog(described.module));
  for (const std::string& name : templates) hash.add(template_text(name));
  return hash.hex().substr(0, 16);
}

std::vector<std::string> provenance(const Signature& signature, const std::string& command) {
  return {"",
          fmt::format("Written by mixcmp {}, spec {}, with:", signature.generator_version,
                      signature.spec_hash),
          "  " + command, "This output is unencumbered: use it as you like."};
}

GeneratedFile verilog_file(Described described, const Signature& signature,
                           const std::string& command) {
  described.module.header = std::move(described.facts);
  for (std::string& line : provenance(signature, command)) {
    described.module.header.push_back(std::move(line));
  }
  return {described.module.name + ".v", to_verilog(described.module)};
}

GeneratedFile template_file(const std::string& name) {
  return {name + ".v",
          fmt::format("// Copied by mixcmp {}. This copy is unencumbered: use it as you "
                      "like.\n//\n{}",
                      version, template_text(name))};
}

GeneratedFile constraint_file(const Signature& signature) {
  return {signature.top + ".sdc",
          fmt::format("# {:g} MHz, the target the cut points were chosen for.\n"
                      "create_clock -name aclk -period {:.3f} [get_ports aclk]\n",
                      signature.target_mhz, 1000 / signature.target_mhz)};
}

}  // namespace

Result<GeneratedSystem> generate_system(const Design& design, const std::string& command) {
  MIXCMP_TRY(delays, delays_of(design.system.device));
  const double target_mhz = design.system.target_mhz;
  const Schedule lane = schedule_lane(design.lane, design.lane_multipliers, delays, target_mhz);
  const Schedule reference =
      schedule_reference(design.reference, design.reference_multipliers, delays, target_mhz);
  const SystemShape shape = shape_of(design, lane, reference);
  std::vector<Described> modules = describe_modules(design, shape, lane, reference);

  std::set<std::string> instantiated;
  for (const Described& described : modules) {
    instantiated.merge(rtl::instantiated_modules(described.module));
  }
  const std::vector<std::string> templates = template_closure(instantiated);

  GeneratedSystem system = {signature_of(design, shape), {}, {}};
  system.signature.spec_hash = spec_hash(modules, templates);
  system.signature.ports = signature_ports(modules.back().module);
  for (const std::string& name : templates) system.files.push_back(template_file(name));
  for (Described& described : modules) {
    system.files.push_back(verilog_file(std::move(described), system.signature, command));
  }
  for (const GeneratedFile& file : system.files) system.signature.files.push_back(file.name);

  std::string list;
  for (const std::string& file : system.signature.files) list += file + "\n";
  system.files.push_back({shape.top + ".f", list});
  system.files.push_back(constraint_file(system.signature));
  system.files.push_back({shape.top + ".json", to_json(system.signature)});
  for (const std::string& stage : lane.slow_stages) system.notes.push_back("lane: " + stage);
  if (!shape.recomputes()) return system;
  for (const std::string& stage : reference.slow_stages) {
    system.notes.push_back("reference: " + stage);
  }
  return system;
}

}  // namespace mixcmp::gen
