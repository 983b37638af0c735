#include "generator/emit/system.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "generator/emit/system_plan.hpp"
#include "generator/emit/templates.hpp"
#include "generator/emit/verilog.hpp"
#include "generator/emit/version.hpp"
#include "generator/rtl/datapath_module.hpp"
#include "generator/rtl/system_modules.hpp"
#include "model/common/content_hash.hpp"

namespace mixcmp::gen {
namespace {

using model::Design;
using model::Result;
using rtl::Module;

std::vector<SignatureLanes> lanes_of(const Design& design, const SystemShape& shape) {
  std::vector<SignatureLanes> lanes;
  for (std::size_t k = 0; k < design.lanes.size(); ++k) {
    const model::LaneGroup& group = design.lanes[k];
    lanes.push_back({.count = group.count,
                     .module = shape.lane_groups[k].channel,
                     .format = group.lane.graph.arithmetic.format,
                     .latency_cycles = shape.lane_groups[k].latency_cycles,
                     .certified = group.lane.certified(),
                     .decision = describe_decision(group.lane),
                     .inputs = group.inputs,
                     .multipliers = group.multipliers});
  }
  return lanes;
}

std::vector<SignatureReferences> references_of(const Design& design, const SystemShape& shape) {
  std::vector<SignatureReferences> references;
  for (std::size_t k = 0; k < design.references.size(); ++k) {
    references.push_back({.count = design.references[k].count,
                          .module = shape.reference_groups[k].channel,
                          .latency_cycles = shape.reference_groups[k].latency_cycles,
                          .multipliers = design.references[k].multipliers});
  }
  return references;
}

Signature signature_of(const Design& design, const SystemShape& shape) {
  return {.top = shape.top,
          .generator_version = std::string(version),
          .spec_hash = {},
          .reference_format = design.reference.arithmetic.format,
          .certified = design.certified(),
          .inputs = design.inputs,
          .lanes = shape.lanes,
          .references = shape.references,
          .lane_groups = lanes_of(design, shape),
          .reference_groups = references_of(design, shape),
          .tdata_bytes = shape.tdata_bytes(),
          .tag_bits = shape.tag_bits,
          .counter_bits = shape.counter_bits,
          .slots = 1 << shape.slot_bits,
          .order = shape.order,
          .operands = shape.operands,
          .target_mhz = design.system.target_mhz,
          .ports = {},
          .files = {}};
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

Described describe_lane(const Design& design, const std::string& name,
                        const model::LaneGroup& group, const Schedule& schedule) {
  Described lane = {lane_module(name, design.inputs, group.lane, schedule),
                    {name + ": decides the sign of f - g in reduced precision, or says it cannot.",
                     fmt::format("Operands: {}, {}.", design.reference.input_format.name(),
                                 fmt::join(design.inputs, ", ")),
                     arithmetic_fact(group.lane.graph.arithmetic)}};
  for (std::string& fact : decision_facts(group.lane)) lane.facts.push_back(std::move(fact));
  lane.facts.push_back(
      fmt::format("Latency {} cycles, initiation interval 1, no reset.", schedule.latency_cycles));
  return lane;
}

Described describe_reference(const Design& design, const std::string& name,
                             const Schedule& schedule) {
  return {reference_module(name, design.inputs, design.reference, schedule),
          {name + ": the ordering of f and g as computed in reference precision.",
           arithmetic_fact(design.reference.arithmetic),
           "A NaN operand or result makes the verdict unordered.",
           fmt::format("Latency {} cycles, initiation interval 1, no reset.",
                       schedule.latency_cycles)}};
}

Described describe_lane_channel(const SystemShape& shape, const DatapathGroup& group) {
  const bool in_order = shape.order == model::ResultOrder::in_order;
  return {
      lane_channel_module(shape, group),
      {group.channel + ": one lane between its AXI4-Streams.",
       in_order ? "Results leave in the order of acceptance."
                : "Results may overtake a recomputed one; the tag (tuser) tells which is which.",
       fmt::format("{} comparisons may be inside. Reset: aresetn, synchronous, active low.",
                   1 << shape.slot_bits)}};
}

Described describe_reference_channel(const SystemShape& shape, const DatapathGroup& group) {
  return {reference_channel_module(shape, group),
          {group.channel + ": one reference datapath behind the crossbar.",
           shape.refetches() ? "The operands are fetched again by tag on m_refetch and s_refetch."
                             : "The operands arrive with the request.",
           "Reset: aresetn, synchronous, active low."}};
}

/// One kind of each is told in a sentence, several in a line each.
std::vector<std::string> count_facts(const Design& design, const SystemShape& shape) {
  const std::string reference = design.reference.arithmetic.format.name();
  if (design.lanes.size() == 1 && design.references.size() <= 1) {
    return {fmt::format("{}: p_L = {} in {}, p_H = {} in {}.", shape.top, shape.lanes,
                        design.lanes.front().lane.graph.arithmetic.format.name(), shape.references,
                        reference)};
  }
  std::vector<std::string> facts = {fmt::format("{}: p_L = {}, p_H = {} in {}.", shape.top,
                                                shape.lanes, shape.references, reference)};
  const auto tell = [&facts](const char* what, const std::vector<DatapathGroup>& groups) {
    for (const DatapathGroup& group : groups) {
      facts.push_back(fmt::format("{} {} to {}: {}, {} cycles.", what, group.first,
                                  group.first + group.count - 1, group.channel,
                                  group.latency_cycles));
    }
  };
  tell("Lanes", shape.lane_groups);
  tell("References", shape.reference_groups);
  return facts;
}

int shortest_latency_cycles(const SystemShape& shape) {
  const auto shortest = std::min_element(shape.lane_groups.begin(), shape.lane_groups.end(),
                                         [](const DatapathGroup& a, const DatapathGroup& b) {
                                           return a.latency_cycles < b.latency_cycles;
                                         });
  return shortest->latency_cycles + shape.channel_latency_cycles();
}

Described describe_top(const Design& design, const SystemShape& shape) {
  const int tdata_bits = shape.tdata_bytes() * 8;
  std::vector<std::string> facts = count_facts(design, shape);
  const auto tell = [&facts](std::string fact) { facts.push_back(std::move(fact)); };
  tell("Every per-lane port is a vector of one field a lane, lane 0 in the lowest bits.");
  tell(fmt::format("s_axis_tdata, {} bits a lane, operands {} bits each, the first lowest:",
                   tdata_bits, shape.input_width));
  tell(fmt::format("  {}.", fmt::join(design.inputs, ", ")));
  tell(fmt::format("s_axis_tuser, m_axis_tuser, {} bits a lane: the tag.", shape.tag_bits));
  tell("m_axis_tdata, 8 bits a lane: {4'b0, undecided, recomputed, verdict[1:0]};");
  tell("  verdict: 0 less, 1 equal, 2 greater, 3 unordered.");
  if (shape.refetches()) {
    tell("m_refetch_tdata, s_refetch_tdata, a field a reference: a tag out, in the");
    tell("  order of the tags the operands of each back in.");
  }
  if (shape.counter_bits > 0) {
    tell("comparisons, recomputations, stalls: counts since reset, they wrap.");
  }
  tell(
      fmt::format("Initiation interval 1 a lane, latency {} cycles and up. Reset: aresetn, "
                  "synchronous, active low.",
                  shortest_latency_cycles(shape)));
  return {top_module(shape), std::move(facts)};
}

/// Every module once, the top last; groups of the same hardware share theirs.
std::vector<Described> describe_modules(const Design& design, const SystemPlan& plan) {
  const SystemShape& shape = plan.shape;
  std::vector<Described> modules;
  std::set<std::string> written;
  for (std::size_t k = 0; k < shape.lane_groups.size(); ++k) {
    const DatapathGroup& group = shape.lane_groups[k];
    if (!written.insert(group.datapath).second) continue;
    modules.push_back(describe_lane(design, group.datapath, design.lanes[k], plan.lanes[k]));
    modules.push_back(describe_lane_channel(shape, group));
  }
  for (std::size_t k = 0; k < shape.reference_groups.size(); ++k) {
    const DatapathGroup& group = shape.reference_groups[k];
    if (!written.insert(group.datapath).second) continue;
    modules.push_back(describe_reference(design, group.datapath, plan.references[k]));
    modules.push_back(describe_reference_channel(shape, group));
  }
  modules.push_back(describe_top(design, shape));
  return modules;
}

/// Stages that the delay table cannot bring under the period, each with where it is.
std::vector<std::string> slow_stages(const SystemPlan& plan) {
  std::vector<std::string> notes;
  const auto tell = [&notes](const std::string& what, const std::vector<DatapathGroup>& groups,
                             const std::vector<Schedule>& schedules) {
    for (std::size_t k = 0; k < groups.size(); ++k) {
      const std::string& where = groups.size() == 1 ? what : groups[k].datapath;
      for (const std::string& stage : schedules[k].slow_stages) {
        notes.push_back(fmt::format("{}: {}", where, stage));
      }
    }
  };
  tell("lane", plan.shape.lane_groups, plan.lanes);
  tell("reference", plan.shape.reference_groups, plan.references);
  return notes;
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
  MIXCMP_TRY(plan, plan_system(design));
  std::vector<Described> modules = describe_modules(design, plan);

  std::set<std::string> instantiated;
  for (const Described& described : modules) {
    instantiated.merge(rtl::instantiated_modules(described.module));
  }
  const std::vector<std::string> templates = template_closure(instantiated);

  GeneratedSystem system = {signature_of(design, plan.shape), {}, slow_stages(plan)};
  system.signature.spec_hash = spec_hash(modules, templates);
  system.signature.ports = signature_ports(modules.back().module);
  for (const std::string& name : templates) system.files.push_back(template_file(name));
  for (Described& described : modules) {
    system.files.push_back(verilog_file(std::move(described), system.signature, command));
  }
  for (const GeneratedFile& file : system.files) system.signature.files.push_back(file.name);

  std::string list;
  for (const std::string& file : system.signature.files) list += file + "\n";
  system.files.push_back({plan.shape.top + ".f", list});
  system.files.push_back(constraint_file(system.signature));
  system.files.push_back({plan.shape.top + ".json", to_json(system.signature)});
  return system;
}

}  // namespace mixcmp::gen
