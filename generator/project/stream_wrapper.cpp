#include "generator/project/stream_wrapper.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "generator/hardware/rtl/module.hpp"

namespace mixcmp::project {
namespace {

using rtl::Operand;

/// Ports of the wrapper, field by field: those of one stream stand together.
void add_ports_of_fields(rtl::Module& module, const std::vector<FieldPort>& ports,
                         bool (*belongs)(const FieldPort&)) {
  int most_fields = 0;
  for (const FieldPort& each : ports) {
    if (belongs(each)) most_fields = std::max(most_fields, each.count);
  }
  for (int k = 0; k < most_fields; ++k) {
    for (const FieldPort& each : ports) {
      if (!belongs(each)) continue;
      module.ports.push_back({each.port->direction, each.field_width(), each.field_name(k)});
    }
  }
}

bool is_refetch(const FieldPort& port) {
  return port.port->name.find("_refetch_") != std::string::npos;
}

/// The ports of the top but aclk and aresetn.
std::vector<FieldPort> field_ports(const ProjectSpec& spec) {
  std::vector<FieldPort> ports;
  for (const emit::SignaturePort& port : spec.build_ports()) {
    if (port.is_clock_or_reset()) continue;
    FieldPort field{.port = &port, .count = emit::group_count(spec.signature)};
    if (is_refetch(field)) field.count = emit::refetch_streams(spec.signature);
    if (port.is_counter_bus()) {
      field.count = 1;
      field.is_single = true;
    }
    if (spec.signature.engine) {
      field.is_single = !port.name.starts_with("m_axis_") && port.name != "reports";
      field.count = field.is_single ? 1 : spec.signature.engine->report_streams;
    }
    ports.push_back(field);
  }
  return ports;
}

void connect_input(rtl::Module& module, const FieldPort& port) {
  std::vector<Operand> fields;
  for (int k = port.count; k-- > 0;) fields.push_back(rtl::net(port.field_name(k)));
  module.items.emplace_back(
      rtl::Assignment{rtl::net(port.port->name), rtl::concatenation(std::move(fields))});
}

void connect_output(rtl::Module& module, const FieldPort& port) {
  const int width = port.field_width();
  for (int k = 0; k < port.count; ++k) {
    const Operand field = width == 1 ? rtl::bit(port.port->name, k)
                                     : rtl::slice(port.port->name, (k + 1) * width - 1, k * width);
    module.items.emplace_back(rtl::Assignment{rtl::net(port.field_name(k)), field});
  }
}

rtl::Instance wrapped_instance(const ProjectSpec& spec) {
  rtl::Instance instance{.module = spec.build_top(),
                         .name = spec.signature.engine ? "engine" : "system",
                         .parameters = {},
                         .connections = {}};
  for (const emit::SignaturePort& port : spec.build_ports()) {
    instance.connections.push_back({port.name, rtl::net(port.name)});
  }
  return instance;
}

std::string wrapper_name(const ProjectSpec& spec) {
  const std::string& top = spec.build_top();
  const std::string name = top + "_streams";
  // Every top leaves room for three more characters, those of a test bench's "_tb".
  return name.size() <= emit::longest_module_name ? name : top + "_io";
}

/// Lines that say to which lane, group, reference or stream the ports with number k belong.
std::vector<std::string> description(const emit::Signature& signature) {
  const bool counters = has_counter_ports(signature);
  std::vector<std::string> lines;
  if (signature.engine) {
    lines.push_back(
        fmt::format("Stream k is m_axis_k_*{}.", counters ? " with the counter reports_k" : ""));
  } else {
    const bool grouped = signature.lanes_per_group > 1;
    lines.push_back(fmt::format("{} k has s_axis_k_*, m_axis_k_*{}.", grouped ? "Group" : "Lane",
                                counters ? " and its counters" : ""));
    if (grouped) {
      lines.push_back(
          fmt::format("It has {} lanes; those of group 0 come first, and its lane 0 is "
                      "lowest in tdata.",
                      signature.lanes_per_group));
    }
    if (emit::refetch_streams(signature) > 0) {
      lines.emplace_back("Reference k has m_refetch_k_*, s_refetch_k_*.");
      if (signature.second_tier) {
        lines.push_back(fmt::format("Lane j of the second tier has those of number {} + j.",
                                    signature.references));
      }
    }
  }
  if (!signature.counter_map.empty()) lines.emplace_back("All counters are read on s_axi_*.");
  return lines;
}

std::vector<std::string> facts(const ProjectSpec& spec) {
  const char* const owner = spec.signature.engine                ? "stream of reports"
                            : spec.signature.lanes_per_group > 1 ? "group of lanes"
                                                                 : "lane";
  std::vector<std::string> lines = {
      fmt::format("{}: {} with an AXI4-Stream of its own for each {}.", wrapper_name(spec),
                  spec.build_top(), owner)};
  for (std::string& line : description(spec.signature)) lines.push_back(std::move(line));
  lines.emplace_back();
  for (std::string& line : emit::provenance(spec.signature, spec.command)) {
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

std::string FieldPort::field_name(int k) const {
  if (is_single) return port->name;
  const std::size_t last_part = port->name.rfind("_t");
  if (last_part == std::string::npos) return fmt::format("{}_{}", port->name, k);
  return fmt::format("{}_{}{}", port->name.substr(0, last_part), k, port->name.substr(last_part));
}

bool has_stream_wrapper(const emit::Signature& signature) {
  return !signature.engine || signature.engine->report_streams > 1;
}

emit::Described stream_wrapper(const ProjectSpec& spec) {
  rtl::Module module{.name = wrapper_name(spec), .ports = {}, .items = {}};
  for (const char* name : {"aclk", "aresetn"}) {
    module.ports.push_back({rtl::Direction::input, 1, name});
  }
  const std::vector<FieldPort> ports = field_ports(spec);
  add_ports_of_fields(module, ports, [](const FieldPort& port) { return port.is_single; });
  add_ports_of_fields(module, ports,
                      [](const FieldPort& port) { return !port.is_single && !is_refetch(port); });
  add_ports_of_fields(module, ports, is_refetch);
  for (const FieldPort& port : ports) {
    if (port.is_single) continue;
    module.items.emplace_back(rtl::Wire{port.port->width, port.port->name, nullptr, true});
  }
  module.items.emplace_back(wrapped_instance(spec));
  for (const FieldPort& port : ports) {
    if (port.is_single) continue;
    port.port->direction == rtl::Direction::input ? connect_input(module, port)
                                                  : connect_output(module, port);
  }
  return {std::move(module), facts(spec)};
}

}  // namespace mixcmp::project
