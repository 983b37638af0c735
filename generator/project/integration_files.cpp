#include <fmt/core.h>

#include <algorithm>

#include "generator/hardware/emit/verilog.hpp"
#include "generator/project/builders.hpp"
#include "generator/project/packing_files.hpp"
#include "generator/project/stream_wrapper.hpp"
#include "generator/project/vhdl.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::project {
namespace {

/// A module that may be instantiated, with its ports in order.
struct Unit {
  std::string name;
  std::vector<rtl::Port> ports;  ///< `vector`: the port has a range in Verilog
};

/// The ports of a generated top. Those with fields of a system's lanes have a range even where it
/// is [0:0].
Unit build_unit(const ProjectSpec& spec) {
  Unit unit{spec.build_top(), {}};
  const bool is_system = !spec.signature.engine;
  for (const emit::SignaturePort& port : spec.build_ports()) {
    const bool is_field = is_system && !port.is_clock_or_reset() && !port.is_counter_bus();
    const bool has_range = is_field || port.width > 1;
    unit.ports.push_back({port.direction, port.width, port.name, has_range});
  }
  return unit;
}

/// `wrapped`: the only module that the wrapper instantiates.
GeneratedFile wrapper_file(const emit::Described& wrapper, const Unit& wrapped) {
  const rtl::CheckedModules tree(
      {wrapper.module}, [&](const rtl::Instance& instance) -> Result<std::vector<rtl::Port>> {
        MIXCMP_CHECK(instance.module == wrapped.name);
        return wrapped.ports;
      });
  return {.name = fmt::format("integration/{}.v", wrapper.module.name),
          .text = emit::to_comment(wrapper.facts) + emit::to_verilog(tree).front()};
}

Unit wrapper_unit(const rtl::Module& wrapper) {
  Unit unit{wrapper.name, wrapper.ports};
  for (rtl::Port& port : unit.ports) port.vector = port.width > 1;
  return unit;
}

std::string verilog_instance(const Unit& unit) {
  std::size_t longest = 0;
  for (const rtl::Port& port : unit.ports) longest = std::max(longest, port.name.size());
  std::string text = fmt::format("{} your_instance (\n", unit.name);
  for (const rtl::Port& port : unit.ports) {
    const std::string range = port.vector ? fmt::format(" [{}:0]", port.width - 1) : "";
    text += fmt::format("    .{:<{}}(){}  // {}{}\n", port.name, longest,
                        &port == &unit.ports.back() ? "" : ",",
                        port.direction == rtl::Direction::input ? "input" : "output", range);
  }
  return text + ");\n";
}

GeneratedFile instantiation_template(const ProjectSpec& spec, const std::vector<Unit>& units) {
  std::string text = common_values(spec, "//").at("PROVENANCE") +
                     "\n//\n// To be copied into a module, with a net for each port.\n";
  for (const Unit& unit : units) text += "\n" + verilog_instance(unit);
  return {.name = fmt::format("integration/{}.veo", spec.build_top()), .text = std::move(text)};
}

std::string component(const Unit& unit) {
  std::vector<VhdlPort> ports;
  for (const rtl::Port& port : unit.ports) {
    ports.push_back({.name = port.name,
                     .is_input = port.direction == rtl::Direction::input,
                     .is_vector = port.vector,
                     .width = port.width});
  }
  return vhdl_component(unit.name, ports);
}

GeneratedFile vhdl_package(const ProjectSpec& spec, const std::vector<Unit>& units) {
  const std::string package = vhdl_name(spec.build_top() + "_components");
  std::string components;
  for (const Unit& unit : units) components += "\n" + component(unit);
  return {.name = fmt::format("integration/{}_components.vhd", spec.build_top()),
          .text = fmt::format("{}\n\nlibrary ieee;\nuse ieee.std_logic_1164.all;\n\n"
                              "package {} is\n{}\nend package;\n",
                              common_values(spec, "--").at("PROVENANCE"), package, components)};
}

/// The header with which C and C++ programs read the counters of an AXI4-Lite port.
GeneratedFile counters_header(const ProjectSpec& spec) {
  Values values = common_values(spec, "//");
  const std::string name = in_capitals(spec.build_top());
  std::string kinds;
  for (const emit::SignatureCounters& counters : spec.signature.counter_map) {
    kinds += fmt::format("#define {0}_{1}_OFFSET {2}\n#define {0}_{1}_COUNT {3}\n", name,
                         in_capitals(counters.name), counters.offset, counters.count);
  }
  values["NAME"] = name;
  const int lanes_per_group = spec.signature.lanes_per_group;
  values["GROUPED"] = lanes_per_group > 1 ? "yes" : "";
  values["LANES_PER_GROUP"] = std::to_string(lanes_per_group);
  values["KINDS"] = kinds;
  values["COUNTER_BITS"] = std::to_string(spec.signature.counter_bits);
  return file_from(fmt::format("integration/{}_counters.h", spec.build_top()), "counters.h",
                   values);
}

/// The operands that each input stream of the module takes.
std::vector<PackedRecord> packed_records(const emit::Signature& signature) {
  if (!signature.engine) {
    return {{"operands", "s_axis_tdata", signature.inputs, signature.input_formats,
             signature.tdata_bytes}};
  }
  const emit::SignatureEngine& engine = *signature.engine;
  if (engine.kind == scene::EngineKind::pairwise) {
    return {{"item", "s_axis_tdata", engine.columns, engine.column_formats, engine.item_bytes}};
  }
  return {
      {"candidate", "s_candidate_tdata", engine.columns, engine.column_formats, engine.item_bytes},
      {"row", "s_axis_tdata", engine.row_columns, engine.row_column_formats, engine.row_bytes}};
}

}  // namespace

std::vector<GeneratedFile> integration_files(const ProjectSpec& spec) {
  std::vector<Unit> units = {build_unit(spec)};
  std::vector<GeneratedFile> files;
  if (has_stream_wrapper(spec.signature)) {
    const emit::Described wrapper = stream_wrapper(spec);
    files.push_back(wrapper_file(wrapper, units.front()));
    units.push_back(wrapper_unit(wrapper.module));
  }
  files.push_back(instantiation_template(spec, units));
  files.push_back(vhdl_package(spec, units));
  for (GeneratedFile& file : packing_files({spec.build_top(), packed_records(spec.signature)},
                                           common_values(spec, "//").at("PROVENANCE"),
                                           common_values(spec, "#").at("PROVENANCE"))) {
    files.push_back(std::move(file));
  }
  if (emit::counter_address_bits(spec.signature) > 0) files.push_back(counters_header(spec));
  return files;
}

}  // namespace mixcmp::project
