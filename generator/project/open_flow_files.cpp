#include <fmt/core.h>

#include <algorithm>

#include "generator/project/builders.hpp"
#include "generator/synthesis/characterise/register_wrapper.hpp"
#include "generator/synthesis/characterise/tools.hpp"
#include "model/base/common/quote.hpp"

namespace mixcmp::project {
namespace {

/// Commands for Yosys that read the system, with cells of the device's family where it has some.
std::string read_commands(const ProjectSpec& spec) {
  return source_list(spec, "read_verilog .rtl/", "\n") +
         joined(spec.signature.cells, "read_verilog -overwrite .rtl/", "\n");
}

/// `folder`: that of the script, in the system's.
Values yosys_values(const ProjectSpec& spec, const char* folder) {
  Values values = common_values(spec, "#");
  values["FOLDER"] = folder;
  values["DEVICE"] = spec.device.name;
  values["READ"] = read_commands(spec);
  values["SYNTHESIS"] = spec.device.synthesis;
  return values;
}

std::string pins_name(const ProjectSpec& spec) {
  return spec.build_top() + "_pins";
}

/// A module of three pins around the top. The top itself has more ports than a package has pins.
Result<GeneratedFile> pins_file(const ProjectSpec& spec) {
  std::vector<characterise::WrappedPort> ports;
  for (const emit::SignaturePort& port : spec.build_ports()) {
    ports.push_back({port.name, port.direction == rtl::Direction::input, port.width});
  }
  MIXCMP_TRY(module,
             characterise::register_wrapper(ports, spec.build_top(), "aclk", pins_name(spec)));
  return GeneratedFile{
      .name = fmt::format("nextpnr/{}.v", pins_name(spec)),
      .text = fmt::format("// {} between registers and three pins, so that nextpnr can place and "
                          "time it.\n//\n{}\n\n{}",
                          spec.build_top(), common_values(spec, "//").at("PROVENANCE"), module)};
}

Values nextpnr_values(const ProjectSpec& spec) {
  Values values = yosys_values(spec, "nextpnr");
  const characterise::Router& router = *characterise::router_of(spec.device);
  const bool has_free_pins = *router.free_pins != '\0';
  values["PINS"] = pins_name(spec);
  values["ROUTER"] = router.program;
  values["REMOVE_PORTS"] = has_free_pins ? "" : characterise::remove_ports;
  values["RESULT"] = router.result;
  std::string arguments = has_free_pins ? std::string(router.free_pins) + " " : "";
  for (const std::string& argument : spec.device.timing_arguments) {
    arguments += quoted(argument) + " ";
  }
  values["ARGUMENTS"] = arguments;
  return values;
}

Error not_routed(const ProjectSpec& spec) {
  return {.field = "--project",
          .message = "nextpnr does not place on the scene's device",
          .received = spec.device.name,
          .accepted =
              "--device with one of those that `mixcmp devices nextpnr` lists, or a device file "
              "with such a timing.tool"};
}

}  // namespace

Result<std::vector<GeneratedFile>> yosys_files(const ProjectSpec& spec) {
  MIXCMP_DO(characterise::check_is_synthesised(spec.device));
  const Values values = yosys_values(spec, "yosys");
  return std::vector<GeneratedFile>{file_from("yosys/synthesise.ys", "yosys_synthesise.ys", values),
                                    script_from("yosys/run", "yosys_run", values)};
}

Result<std::vector<GeneratedFile>> nextpnr_files(const ProjectSpec& spec) {
  if (!characterise::is_routed(spec.device)) return not_routed(spec);
  const Values values = nextpnr_values(spec);
  MIXCMP_TRY(pins, pins_file(spec));
  return std::vector<GeneratedFile>{
      std::move(pins), file_from("nextpnr/synthesise.ys", "nextpnr_synthesise.ys", values),
      script_from("nextpnr/run", "nextpnr_run", values)};
}

}  // namespace mixcmp::project
