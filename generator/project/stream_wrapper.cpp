#include "generator/project/stream_wrapper.hpp"

#include <fmt/core.h>

namespace mixcmp::project {
namespace {

using rtl::Operand;

/// Ports of the wrapper, lane by lane: those of one stream stand together.
void add_ports_of_fields(rtl::Module& module, const std::vector<FieldPort>& ports,
                         bool (*belongs)(const FieldPort&), int count) {
  for (int k = 0; k < count; ++k) {
    for (const FieldPort& each : ports) {
      if (!belongs(each)) continue;
      module.ports.push_back({each.port->direction, each.field_width(), each.field_name(k)});
    }
  }
}

bool is_refetch(const FieldPort& port) {
  return port.port->name.find("_refetch_") != std::string::npos;
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

rtl::Instance system_instance(const emit::Signature& signature) {
  rtl::Instance instance{
      .module = signature.top, .name = "system", .parameters = {}, .connections = {}};
  for (const emit::SignaturePort& port : signature.ports) {
    instance.connections.push_back({port.name, rtl::net(port.name)});
  }
  return instance;
}

std::vector<std::string> header(const ProjectSpec& spec) {
  std::vector<std::string> lines = {
      stream_wrapper_name(spec.signature) + ": " + spec.signature.top +
          " with an AXI4-Stream of its own for each lane.",
      "Lane k has s_axis_k_*, m_axis_k_* and its counters; reference k has its refetch streams.",
      ""};
  for (std::string& line : emit::provenance(spec.signature, spec.command)) {
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

std::string FieldPort::field_name(int k) const {
  const std::size_t last_part = port->name.rfind("_t");
  if (last_part == std::string::npos) return fmt::format("{}_{}", port->name, k);
  return fmt::format("{}_{}{}", port->name.substr(0, last_part), k, port->name.substr(last_part));
}

std::vector<FieldPort> field_ports(const emit::Signature& signature) {
  std::vector<FieldPort> ports;
  for (const emit::SignaturePort& port : signature.ports) {
    if (port.is_clock_or_reset()) continue;
    FieldPort field{.port = &port, .count = signature.lanes};
    if (is_refetch(field)) field.count = signature.references;
    ports.push_back(field);
  }
  return ports;
}

std::string stream_wrapper_name(const emit::Signature& signature) {
  return signature.top + "_streams";
}

rtl::Module stream_wrapper(const ProjectSpec& spec) {
  const emit::Signature& signature = spec.signature;
  rtl::Module module{
      .name = stream_wrapper_name(signature), .header = header(spec), .ports = {}, .items = {}};
  for (const char* name : {"aclk", "aresetn"}) {
    module.ports.push_back({rtl::Direction::input, 1, name});
  }
  const std::vector<FieldPort> ports = field_ports(signature);
  const auto of_lane = [](const FieldPort& port) { return !is_refetch(port); };
  add_ports_of_fields(module, ports, of_lane, signature.lanes);
  add_ports_of_fields(module, ports, is_refetch, signature.references);
  for (const FieldPort& port : ports) {
    module.items.emplace_back(rtl::Wire{port.port->width, port.port->name, nullptr, true});
  }
  module.items.emplace_back(system_instance(signature));
  for (const FieldPort& port : ports) {
    port.port->direction == rtl::Direction::input ? connect_input(module, port)
                                                  : connect_output(module, port);
  }
  return module;
}

}  // namespace mixcmp::project
