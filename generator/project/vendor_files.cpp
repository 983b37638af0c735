#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "generator/project/builders.hpp"
#include "generator/project/stream_wrapper.hpp"

namespace mixcmp::project {
namespace {

/// An AXI4-Stream interface and its ports.
struct Stream {
  std::string name;
  std::vector<std::string> ports;
};

/// The ports of the counters' AXI4-Lite port.
std::vector<std::string> counter_bus_of(const std::vector<std::string>& ports) {
  std::vector<std::string> bus;
  for (const std::string& port : ports) {
    if (port.starts_with("s_axi_")) bus.push_back(port);
  }
  return bus;
}

/// Groups ports by the name in front of _tvalid, _tready, _tdata, _tuser and _tlast.
std::vector<Stream> streams_of(const std::vector<std::string>& ports) {
  std::vector<Stream> streams;
  for (const std::string& port : ports) {
    const std::size_t end = port.rfind("_t");
    const bool is_stream = port.starts_with("s_") || port.starts_with("m_");
    if (!is_stream || end == std::string::npos) continue;
    const std::string name = port.substr(0, end);
    const auto known = std::find_if(streams.begin(), streams.end(),
                                    [&](const Stream& stream) { return stream.name == name; });
    if (known == streams.end()) {
      streams.push_back({name, {port}});
    } else {
      known->ports.push_back(port);
    }
  }
  return streams;
}

/// The module that is packaged as IP: the wrapper with streams of their own, or an engine that
/// needs none.
struct Packaged {
  std::string top;
  std::vector<std::string> ports;
  std::vector<std::string> sources;  ///< beside those of the top
};

Packaged packaged(const ProjectSpec& spec) {
  Packaged packaged{spec.build_top(), {}, {}};
  if (!has_stream_wrapper(spec.signature)) {
    for (const emit::SignaturePort& port : spec.build_ports()) packaged.ports.push_back(port.name);
    return packaged;
  }
  const rtl::Module wrapper = stream_wrapper(spec).module;
  packaged.top = wrapper.name;
  for (const rtl::Port& port : wrapper.ports) packaged.ports.push_back(port.name);
  packaged.sources = {fmt::format("integration/{}.v", wrapper.name)};
  return packaged;
}

/// One line of a Tcl list for each stream: its name and the list of its ports.
std::string stream_list(const std::vector<Stream>& streams) {
  std::string text;
  for (const Stream& stream : streams) {
    text += fmt::format("  {} {{", stream.name);
    for (const std::string& port : stream.ports) {
      text += fmt::format("{}{}", &port == &stream.ports.front() ? "" : " ", port);
    }
    text += "}\n";
  }
  return text;
}

Values vendor_values(const ProjectSpec& spec) {
  Values values = common_values(spec, "#");
  values["DEVICE"] = spec.device.name;
  values["SOURCES"] = source_list(spec, "  ", "\n");
  return values;
}

}  // namespace

std::vector<GeneratedFile> vivado_files(const ProjectSpec& spec) {
  const Packaged ip = packaged(spec);
  Values values = vendor_values(spec);
  values["PART"] = spec.device.vivado_part;
  values["IP_TOP"] = ip.top;
  values["IP_SOURCES"] = joined(ip.sources, "  ", "\n");
  values["STREAMS"] = stream_list(streams_of(ip.ports));
  values["COUNTER_BUS"] = fmt::format("{}", fmt::join(counter_bus_of(ip.ports), " "));
  return {file_from("vivado/sources.tcl", "vivado_sources.tcl", values),
          file_from("vivado/synthesise.tcl", "vivado_synthesise.tcl", values),
          file_from("vivado/package_ip.tcl", "vivado_package_ip.tcl", values),
          file_from(fmt::format("vivado/{}.xdc", spec.build_top()), "vivado_clock.xdc", values)};
}

std::vector<GeneratedFile> quartus_files(const ProjectSpec& spec) {
  Values values = vendor_values(spec);
  values["PART"] = spec.device.quartus_part;
  return {file_from("quartus/compile.tcl", "quartus_compile.tcl", values),
          file_from(fmt::format("quartus/{}.sdc", spec.build_top()), "quartus_clock.sdc", values),
          script_from("quartus/run", "quartus_run", values)};
}

}  // namespace mixcmp::project
