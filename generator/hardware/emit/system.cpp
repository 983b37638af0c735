#include "generator/hardware/emit/system.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "generator/hardware/emit/constraints.hpp"
#include "generator/hardware/emit/described_modules.hpp"
#include "generator/hardware/emit/template_ports.hpp"
#include "generator/hardware/emit/templates.hpp"
#include "generator/hardware/emit/verilog.hpp"
#include "generator/hardware/emit/version.hpp"
#include "model/base/common/content_hash.hpp"
#include "model/cost/devices/device.hpp"

namespace mixcmp::emit {
namespace {

using design::Design;
using rtl::Module;

SignatureLanes signature_lanes(const design::LaneGroup& group, const std::string& module,
                               int latency_cycles) {
  return {.count = group.count,
          .module = module,
          .format = design::format_name(group.lane),
          .latency_cycles = latency_cycles,
          .certified = design::is_certified(group.lane),
          .decision = design::describe_criterion(group.lane),
          .inputs = group.inputs,
          .multipliers = group.multipliers};
}

std::vector<SignatureLanes> lanes_of(const Design& design, const rtl::SystemShape& shape) {
  // The lanes of a pairwise engine share a segment instead of having channels.
  const bool in_channels = design.system.engine.kind != scene::EngineKind::pairwise;
  std::vector<SignatureLanes> lanes;
  for (std::size_t k = 0; k < design.lanes.size(); ++k) {
    const rtl::DatapathGroup& built = shape.lane_groups[k];
    lanes.push_back(signature_lanes(design.lanes[k], in_channels ? built.channel : built.datapath,
                                    built.schedule.latency_cycles));
  }
  return lanes;
}

std::optional<SignatureLanes> second_tier_of(const Design& design,
                                             const ScheduledSystem& scheduled) {
  if (!scheduled.shape.second_tier) return std::nullopt;
  const rtl::DatapathGroup& built = *scheduled.shape.second_tier;
  if (!scheduled.pairwise) {
    return signature_lanes(*design.second_tier, built.channel, built.schedule.latency_cycles);
  }
  SignatureLanes tier =
      signature_lanes(*design.second_tier, built.datapath, built.schedule.latency_cycles);
  tier.count = scheduled.pairwise->segment_count();
  return tier;
}

std::vector<SignatureReferences> references_of(const Design& design,
                                               const rtl::SystemShape& shape) {
  std::vector<SignatureReferences> references;
  for (std::size_t k = 0; k < design.references.size(); ++k) {
    references.push_back(
        {.count = design.references[k].count,
         .module = shape.reference_groups[k].channel,
         .format = design::format_name(design.reference_datapath()),
         .latency_cycles = shape.reference_groups[k].schedule.latency_cycles,
         .initiation_interval_cycles = design.references[k].structure.initiation_interval,
         .multipliers = design.references[k].structure.multipliers});
  }
  return references;
}

std::vector<SignatureCounters> counter_map(const ScheduledSystem& scheduled) {
  std::vector<SignatureCounters> map;
  if (!scheduled.shape.has_counter_port()) return map;
  for (const auto& [kind, offset] : rtl::counter_offsets(scheduled.counters())) {
    map.push_back({.name = kind.name, .count = kind.count, .offset = offset});
  }
  return map;
}

Signature signature_of(const Design& design, const ScheduledSystem& scheduled) {
  const rtl::SystemShape& shape = scheduled.shape;
  return {.top = shape.top,
          .generator_version = std::string(version),
          .spec_hash = {},
          .reference_format = design.reference.arithmetic.format,
          .reference_sums = design.reference.arithmetic.sums,
          .certified = design.certified(),
          .parts = design.parts,
          .combination = design.reference.combination,
          .lets = design.lets,
          .inputs = design.inputs,
          .input_formats = design.formats_of_inputs(),
          .lanes = shape.lanes,
          .lanes_per_group = shape.lanes_per_group,
          .references = shape.references,
          .lane_groups = lanes_of(design, shape),
          .reference_groups = references_of(design, shape),
          .tdata_bytes = shape.tdata_bytes(),
          .tag_bits = shape.ask_bits(),
          .counter_bits = shape.has_counter_port() ? shape.read_counter_bits : shape.counter_bits,
          .counter_map = counter_map(scheduled),
          .slots = 1 << shape.slot_bits,
          .input_registers = shape.input_registers,
          .request_beats = 1 << shape.beat_bits,
          .order = shape.order,
          .operands = shape.operands,
          .target_mhz = design.system.target_mhz,
          .ports = {},
          .engine = {},
          .files = {}};
}

/// Notes on stages that, by the delay table, no cut brings under the period. Each names its
/// datapath.
std::vector<std::string> slow_stages(const rtl::SystemShape& shape) {
  std::vector<std::string> notes;
  const auto add_notes = [&notes](const std::string& what,
                                  const std::vector<rtl::DatapathGroup>& groups) {
    for (const rtl::DatapathGroup& group : groups) {
      const std::string& where = groups.size() == 1 ? what : group.datapath;
      for (const std::string& stage : group.schedule.slow_stages) {
        notes.push_back(fmt::format("{}: {}", where, stage));
      }
    }
  };
  add_notes("lane", shape.lane_groups);
  if (shape.second_tier) add_notes("second tier", {*shape.second_tier});
  add_notes("reference", shape.reference_groups);
  return notes;
}

/// Adds a note if an engine reports only the number of pairs and has no reference: undecided pairs
/// are then in this number.
void note_undecided_count(const Design& design, std::vector<std::string>& notes) {
  const scene::EngineSpec& engine = design.system.engine;
  const bool counts =
      engine.kind == scene::EngineKind::pairwise && engine.report_as == scene::ReportForm::count;
  if (!counts || design.reference_count() > 0) return;
  notes.emplace_back(
      "there is no reference: pairs that stay undecided are in the number that is reported");
}

/// The error of f - g as a share of its largest magnitude, in the part where that is largest.
mpq_class relative_error(const fixed::FixedLane& lane) {
  mpq_class most = 0;
  for (const fixed::FixedPart& part : lane.parts) {
    const fixed::FixedNode& difference = lane.nodes[static_cast<std::size_t>(part.difference)];
    const mpq_class value = absolute(difference.value).high;
    if (value != 0) most = std::max<mpq_class>(most, absolute(difference.error).high / value);
  }
  return most;
}

/// Adds a note if references in fixed point err more than lanes, whose undecided comparisons they
/// order: lanes read the exponents of operands near 0, where references may not.
void note_rough_references(const Design& design, std::vector<std::string>& notes) {
  if (!design.fixed_reference || design.reference_count() == 0) return;
  const mpq_class error = relative_error(*design.fixed_reference);
  for (const design::LaneGroup& group : design.lanes) {
    const auto* lane = std::get_if<fixed::FixedLane>(&group.lane);
    if (lane == nullptr || error <= relative_error(*lane)) continue;
    notes.push_back(fmt::format(
        "references in {} err more than lanes in {} do, and may order wrongly what these leave "
        "undecided: declare operands of functions that come near 0, or span many binades, in "
        "narrower ranges",
        design.fixed_reference->format.name(), lane->format.name()));
    return;
  }
}

std::vector<SignaturePort> signature_ports(const Module& top) {
  std::vector<SignaturePort> ports;
  for (const rtl::Port& port : top.ports) {
    ports.push_back({port.name, port.direction, port.width});
  }
  return ports;
}

SignatureEngine signature_engine(const ScheduledSystem& scheduled, const Module& top) {
  const rtl::EngineShape& engine = *scheduled.engine;
  SignatureEngine signature{.kind = engine.spec.kind,
                            .top = engine.top,
                            .capacity = engine.capacity,
                            .index_bits = engine.index_bits(),
                            .columns = engine.columns,
                            .column_formats = engine.column_formats,
                            .item_bytes = engine.item_bytes(),
                            .report = {},
                            .ports = signature_ports(top)};
  if (engine.spec.kind == scene::EngineKind::arg_min) {
    signature.row_columns = engine.row_columns;
    signature.row_column_formats = engine.row_column_formats;
    signature.row_bytes = engine.row_bytes();
    signature.tag_bits = engine.spec.row_tag_bits;
    return signature;
  }
  for (const std::string_view verdict : reported_verdicts(engine.spec)) {
    signature.report.emplace_back(verdict);
  }
  signature.report_as = engine.spec.report_as;
  signature.report_streams = scheduled.pairwise->streams();
  signature.report_lanes = scheduled.pairwise->lanes_per_segment();
  signature.report_bytes = scheduled.pairwise->report_bytes();
  return signature;
}

const Module& find_module(const std::vector<Described>& modules, const std::string& name) {
  const auto found = std::find_if(modules.begin(), modules.end(), [&](const Described& described) {
    return described.module.name == name;
  });
  MIXCMP_CHECK(found != modules.end());
  return found->module;
}

std::string spec_hash(const std::vector<std::string>& texts,
                      const std::vector<std::string>& templates) {
  ContentHash hash;
  for (const std::string& text : texts) hash.add(text);
  for (const std::string& name : templates) hash.add(template_text(name));
  return hash.hex().substr(0, 16);
}

/// Makes the file of a module whose printed text is `text`.
GeneratedFile verilog_file(const Described& described, const std::string& text,
                           const Signature& signature, const std::string& command) {
  return {described.module.name + ".v", to_comment(described.facts) + to_comment({""}) +
                                            to_comment(provenance(signature, command)) + text};
}

std::vector<std::string> checked_texts(const std::vector<Described>& modules,
                                       const std::string& prefix) {
  std::vector<Module> tree;
  for (const Described& described : modules) tree.push_back(described.module);
  return to_verilog(checked(std::move(tree)), prefix);
}

std::string copied(std::string_view text, const std::string& prefix) {
  return fmt::format(
      "// Copied by mixcmp {}. This copy is unencumbered: use it as you like.\n//\n{}", version,
      with_prefix(text, prefix));
}

GeneratedFile template_file(const std::string& name, const std::string& prefix) {
  return {prefix + name + ".v", copied(template_text(name), prefix)};
}

/// The file of a cell. Its name does not end in ".v": tools that read DIR/*.v find the template of
/// the same module.
GeneratedFile cell_file(const TechnologyCell& cell, const std::string& prefix) {
  return {prefix + cell.module + ".v." + cell.cells, copied(cell.text, prefix), cell.cells};
}

/// The list of the Verilog files. Names are relative to the list's own folder, since absolute names
/// would differ from place to place. Tools differ in how they read a list of files, so its head
/// gives a command for each; tests/system/lint_test.cpp runs these commands.
GeneratedFile file_list(const Signature& signature, const devices::Device& device) {
  const std::string& top = signature.engine ? signature.engine->top : signature.top;
  std::string text = fmt::format(
      "// The Verilog files of {0}, relative to the folder of this list, here called DIR.\n"
      "// From any folder:\n"
      "//   verilator --lint-only -Wall --top-module {0} -F DIR/{1}.f\n"
      "//   iverilog -g2001 -Wall -s {0} -y DIR -o {0}.vvp DIR/{0}.v\n"
      "//   yosys -q -p 'read_verilog DIR/*.v; hierarchy -check -top {0}'\n"
      "// Others with an option -F (slang, Verific) take the list as Verilator does. With -f or "
      "-c\n"
      "// names are relative to the working directory.\n",
      top, signature.top);
  if (!signature.cells.empty()) {
    text += fmt::format(
        "// Only Yosys needs the device's own cells, with their registers, in place of some "
        "modules:\n"
        "//   yosys -p 'read_verilog DIR/*.v; read_verilog -overwrite DIR/*.v.{}; {} -top {}'\n",
        device.cells, device.synthesis, top);
  }
  for (const std::string& file : signature.files) text += file + "\n";
  return {signature.top + ".f", text};
}

/// Refuses modules whose names some tool does not take. Other files are named after the top.
Result<Done> check_module_names(const std::vector<GeneratedFile>& files) {
  for (const GeneratedFile& file : files) {
    const std::filesystem::path path = file.name;
    const std::string name = path.stem().string();
    if (path.extension() != ".v" || name.size() <= longest_module_name) continue;
    return Error{.field = "comparison.name",
                 .message =
                     "with system.prefix and the lanes' formats it makes a module's name too long "
                     "for some tools",
                 .received = fmt::format("{} of {} characters", name, name.size()),
                 .accepted = fmt::format("a shorter name or prefix: {} characters at most in the "
                                         "module's name",
                                         longest_module_name)};
  }
  return Done{};
}

std::string signature_file(const Signature& signature) {
  return signature.top + ".json";
}

/// Prints the signature into its file again, after a change.
void rewrite_signature_file(GeneratedSystem& system) {
  for (GeneratedFile& file : system.files) {
    if (file.name == signature_file(system.signature)) file.text = to_json(system.signature);
  }
}

/// Makes the file of constraints. `planned_clock` is as in a design.
GeneratedFile constraint_file(const Signature& signature, const devices::Device& device,
                              const std::string& planned_clock) {
  const std::string expected =
      planned_clock.empty() ? "" : fmt::format("# The plan expects {}.\n", planned_clock);
  return {signature.top + ".sdc",
          fmt::format("# {:g} MHz, the target the cut points were chosen for.\n{}"
                      "create_clock -name aclk -period {:.3f} [get_ports aclk]\n\n{}\n",
                      signature.target_mhz, expected, 1000 / signature.target_mhz,
                      fmt::join(port_delays(signature, device), "\n"))};
}

}  // namespace

Result<GeneratedSystem> generate_system(const Design& design, const std::string& command) {
  MIXCMP_TRY(scheduled, schedule_system(design));
  const std::vector<Described> modules = describe_modules(design, scheduled);

  std::set<std::string> instantiated;
  for (const Described& described : modules) {
    instantiated.merge(rtl::instantiated_modules(described.module));
  }
  const std::vector<std::string> templates = template_closure(instantiated);
  const std::string& prefix = design.system.prefix;
  const std::vector<std::string> texts = checked_texts(modules, prefix);

  GeneratedSystem system = {signature_of(design, scheduled), {}, slow_stages(scheduled.shape)};
  note_undecided_count(design, system.notes);
  note_rough_references(design, system.notes);
  system.signature.spec_hash = spec_hash(texts, templates);
  system.signature.second_tier = second_tier_of(design, scheduled);
  if (!scheduled.engine) {
    system.signature.ports = signature_ports(find_module(modules, scheduled.shape.top));
  }
  if (scheduled.engine) {
    system.signature.engine =
        signature_engine(scheduled, find_module(modules, scheduled.engine->top));
  }
  for (const std::string& name : templates) system.files.push_back(template_file(name, prefix));
  for (std::size_t k = 0; k < modules.size(); ++k) {
    system.files.push_back(verilog_file(modules[k], texts[k], system.signature, command));
  }
  for (const GeneratedFile& file : system.files) system.signature.files.push_back(file.name);
  MIXCMP_TRY(device, devices::find_device(design.system.device));
  for (const TechnologyCell& cell : technology_cells(templates)) {
    if (cell.cells != device.cells) continue;
    system.files.push_back(cell_file(cell, prefix));
    system.signature.cells.push_back(system.files.back().name);
  }

  system.files.push_back(file_list(system.signature, device));
  system.files.push_back(constraint_file(system.signature, device, design.planned_clock));
  system.files.push_back({signature_file(system.signature), to_json(system.signature)});
  MIXCMP_DO(check_module_names(system.files));
  return system;
}

std::vector<std::string> provenance(const Signature& signature, const std::string& command) {
  return {fmt::format("Written by mixcmp {}, spec {}, with:", signature.generator_version,
                      signature.spec_hash),
          "  " + command, "This output is unencumbered: use it as you like."};
}

void set_simulations(GeneratedSystem& system, std::vector<SignatureSimulation> simulations) {
  system.signature.simulations = std::move(simulations);
  rewrite_signature_file(system);
}

Result<Done> add_project_files(GeneratedSystem& system, std::vector<GeneratedFile> files) {
  MIXCMP_DO(check_module_names(files));
  for (GeneratedFile& file : files) {
    system.signature.project.push_back(file.name);
    system.files.push_back(std::move(file));
  }
  rewrite_signature_file(system);
  return Done{};
}

}  // namespace mixcmp::emit
