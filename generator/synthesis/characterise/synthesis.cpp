#include "generator/synthesis/characterise/synthesis.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "generator/synthesis/characterise/logic_cells.hpp"
#include "generator/synthesis/characterise/mapped_area.hpp"
#include "generator/synthesis/characterise/register_wrapper.hpp"
#include "generator/synthesis/characterise/router.hpp"
#include "generator/synthesis/characterise/static_timing.hpp"
#include "generator/synthesis/characterise/tools.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/output_file.hpp"

namespace mixcmp::characterise {
namespace {

using measured::Clock;
using measured::ClockSource;

namespace fs = std::filesystem;

/// One job on one device in one folder: the inputs of each step.
struct Run {
  const SynthesisJob& job;
  const devices::Device& device;
  const SynthesisOptions& options;
  const fs::path& directory;
  const Router* router = router_of(device);

  bool is_ice40() const { return device.synthesis.starts_with("synth_ice40"); }
  bool is_xilinx() const { return device.synthesis.starts_with("synth_xilinx"); }
  /// Whether netlists for the router must have no ports.
  bool has_no_pins() const { return router != nullptr && *router->free_pins == '\0'; }
  /// The netlist of the module by itself, for the router.
  const char* to_pack() const { return has_no_pins() ? "pack.json" : "map.json"; }
};

Result<Done> write_sources(const Run& run) {
  for (const SourceText& source : run.job.sources) {
    MIXCMP_DO(write_file(run.directory / source.name, source.text));
  }
  return Done{};
}

std::string read_sources(const Run& run) {
  std::string names, replacements;
  for (const SourceText& source : run.job.sources) {
    if (source.cells.empty()) names += " " + source.name;
    if (is_cell_of(source, run.device)) replacements += " " + source.name;
  }
  std::string script = fmt::format("read_verilog{}\n", names);
  if (!replacements.empty()) script += fmt::format("read_verilog -overwrite{}\n", replacements);
  return script;
}

Result<Done> run_yosys(const Run& run, const std::string& name, const std::string& script) {
  MIXCMP_DO(write_file(run.directory / (name + ".ys"), script));
  Command command = yosys_command(run.device);
  command.insert(command.end(), {"-q", "-s", name + ".ys"});
  return run_in(run.directory, command, name + ".log", run.options.each_tool);
}

/// synth_xilinx of Yosys 0.23 gives each register with an inverted reset its own inverter. One
/// inverter is enough for all registers of a reset.
constexpr const char* share_inverters = "opt_merge -share_all t:INV\nopt_clean\n";

/// Maps the module by itself. Leaves the netlist in map.json and, in Yosys' own form, in map.il. A
/// device's command need not flatten the design; the names in the netlist are those of a flat one.
Result<devices::Area> map_alone(const Run& run) {
  const std::string& top = run.job.top;
  const std::string script = fmt::format(
      "{}{} -top {}\n{}tee -q -o area.json stat -json\nflatten\nwrite_json map.json\n"
      "select {}\nwrite_rtlil -selected map.il\n{}",
      read_sources(run), run.device.synthesis, top, run.is_xilinx() ? share_inverters : "", top,
      run.has_no_pins() ? fmt::format("{}write_json {}\n", remove_ports, run.to_pack()) : "");
  MIXCMP_DO(run_yosys(run, "map", script));
  MIXCMP_TRY(statistics, read_json(run.directory / "area.json"));
  MIXCMP_TRY(area,
             in_file(area_of_statistics(statistics, run.device), run.directory / "area.json"));
  if (run.is_ice40()) {
    MIXCMP_TRY(netlist, read_json(run.directory / "map.json"));
    area.luts = ice40_logic_cells(netlist, top);
  }
  return area;
}

/// Refuses a netlist, or an area, that lacks a part which the job needs.
Result<Done> check_parts(const Run& run, const devices::Area& area) {
  MIXCMP_DO(check_multipliers(area, run.job.needed, run.device));
  if (run.job.needed.nets.empty()) return Done{};
  MIXCMP_TRY(netlist, read_json(run.directory / "map.json"));
  return check_nets(netlist, run.job.top, run.job.needed.nets, area.dsps > 0);
}

/// The last line of Yosys' report. Yosys reports no error when a full disk cuts the file short.
constexpr const char* end_of_timing = "end of the timing report";

/// After -abc9 the carry cells in memory have lost their delays (Yosys 0.23 and 0.52), so the
/// netlist is read again, beside the library of cells. One techmap pass is enough: a mapped shift
/// register contains another one, which must stay. Newer versions leave cells that only name
/// flattened modules, which `sta` does not know.
std::string timing_script(const Run& run) {
  const std::string& top = run.job.top;
  return fmt::format(
      "{}{} -top {}\ndelete t:$scopeinfo\nselect {}\nwrite_rtlil -selected timing.il\n"
      "design -reset\n"
      "read_rtlil timing.il\ntechmap -max_iter 1 -map {}\n"
      "read_verilog -lib -specify +/xilinx/cells_sim.v\n"
      "hierarchy -top {}\ntee -q -o timing.txt sta\ntee -q -a timing.txt log {}\n",
      read_sources(run), run.device.timing_synthesis, top, top, shift_register_output().name, top,
      end_of_timing);
}

/// A clock, or the reason why there is none. A tool that fails is an error instead, since that is
/// no property of the design.
struct Timing {
  std::optional<Clock> clock;
  std::string no_clock;
};

Result<Timing> estimate_clock(const Run& run) {
  const EmbeddedFile& techmap = shift_register_output();
  MIXCMP_DO(write_file(run.directory / techmap.name, techmap.text));
  MIXCMP_DO(run_yosys(run, "timing", timing_script(run)));
  MIXCMP_TRY(log, read_file(run.directory / "timing.txt"));
  if (!log.ends_with(std::string(end_of_timing) + "\n")) {
    return Error{.file = (run.directory / "timing.txt").string(),
                 .message = "Yosys' report of the timing is cut short"};
  }
  const Result<int> picoseconds = longest_path_ps(log);
  if (!picoseconds.ok()) return Timing{std::nullopt, picoseconds.error().message};
  const double mhz = 1e6 / *picoseconds;
  return Timing{Clock{.mhz = mhz,
                      .low_mhz = mhz,
                      .high_mhz = mhz,
                      .seeds = 1,
                      .source = ClockSource::estimate_before_routing},
                ""};
}

/// Puts registers around the mapped module and maps the whole: wrapped.json.
Result<Done> wrap(const Run& run) {
  const std::string name = "mixcmp_wrapper_of_" + run.job.top;
  MIXCMP_TRY(netlist, read_json(run.directory / "map.json"));
  MIXCMP_TRY(wrapper, register_wrapper(netlist, run.job.top, run.job.clock_port, name));
  MIXCMP_DO(write_file(run.directory / "mixcmp_wrapper.v", wrapper));
  return run_yosys(run, "wrap",
                   fmt::format("read_rtlil map.il\nread_verilog mixcmp_wrapper.v\n{} -top {}\n"
                               "{}write_json wrapped.json\n",
                               run.device.synthesis, name, run.has_no_pins() ? remove_ports : ""));
}

std::optional<std::string> shortage(const devices::Area& area, const devices::Area& available) {
  for (const devices::Resource& resource : devices::bounded_resources) {
    if (area.*resource.amount <= available.*resource.amount) continue;
    return fmt::format("does not fit: {} {} of {}", area.*resource.amount, resource.name,
                       available.*resource.amount);
  }
  return std::nullopt;
}

/// Finds the clock by routing. Also corrects the LUTs in `area` to the number that the router
/// packs.
Result<Timing> route_clock(const Run& run, devices::Area& area) {
  const ToolLimits& limits = run.options.each_tool;
  const Result<std::string> version = router_version(*run.router);
  if (!version.ok() && version.error().kind != ErrorKind::missing_tool) return version.error();
  if (!version.ok()) return Timing{std::nullopt, version.error().message};
  MIXCMP_TRY(packed, packed_luts(run.device, run.directory, run.to_pack(), limits));
  if (const auto* refusal = std::get_if<Refusal>(&packed)) {
    return Timing{std::nullopt, refusal->reason};
  }
  area.luts = std::get<int>(packed);
  if (const auto message = shortage(area, run.device.available)) {
    return Timing{std::nullopt, *message};
  }
  MIXCMP_TRY(wrapped, wrap(run));
  MIXCMP_TRY(routed, route(run.device, run.directory, "wrapped.json", run.options.seeds, limits));
  if (const auto* refusal = std::get_if<Refusal>(&routed)) {
    return Timing{std::nullopt, refusal->reason};
  }
  return Timing{std::get<Clock>(routed), ""};
}

Result<Timing> find_clock(const Run& run, devices::Area& area) {
  if (run.options.effort == TimingEffort::area_only) return Timing{std::nullopt, "not asked for"};
  switch (run.device.timing) {
    case devices::TimingTool::none:
      return Timing{std::nullopt, fmt::format("no tool times {}", run.device.name)};
    case devices::TimingTool::yosys_sta: return estimate_clock(run);
    case devices::TimingTool::nextpnr_ice40:
    case devices::TimingTool::nextpnr_ecp5:
    case devices::TimingTool::nextpnr_nexus:
    case devices::TimingTool::nextpnr_gowin:
    case devices::TimingTool::nextpnr_gatemate:
    case devices::TimingTool::nextpnr_machxo2: return route_clock(run, area);
  }
  MIXCMP_CHECK(!"a timing tool of no enumerator");
}

/// A module that instantiates every unit of a batch. Their pins stay open: Yosys maps a module with
/// keep_hierarchy as if it were alone.
std::string top_of(const UnitBatch& batch, const std::string& name) {
  std::string text = fmt::format("module {};\n", name);
  for (std::size_t k = 0; k < batch.parameters.size(); ++k) {
    text +=
        fmt::format("  (* keep *) {} #({}) unit_{} ();\n", batch.module, batch.parameters[k], k);
  }
  return text + "endmodule\n";
}

/// The sources of a batch, in which the hierarchy ends at its template.
std::vector<SourceText> kept_apart(std::vector<SourceText> sources, const std::string& module) {
  const std::regex head("\\bmodule\\s+" + module + "\\b");
  for (SourceText& source : sources) {
    source.text = std::regex_replace(source.text, head, "(* keep_hierarchy *) $&");
  }
  return sources;
}

}  // namespace

Result<std::vector<devices::Area>> map_units(const UnitBatch& batch, const devices::Device& device,
                                             const ToolLimits& limits, const fs::path& directory) {
  const std::string top = "mixcmp_units";
  SynthesisJob job{.sources = kept_apart(batch.sources, batch.module), .top = top};
  job.sources.push_back({top + ".v", top_of(batch, top)});
  const SynthesisOptions options{.effort = TimingEffort::area_only, .each_tool = limits};
  const Run run = {job, device, options, directory};
  MIXCMP_DO(write_sources(run));
  MIXCMP_DO(run_yosys(run, "units",
                      fmt::format("{}hierarchy -top {}\nproc\nwrite_json made.json\n{} -top {}\n{}"
                                  "tee -q -o area.json stat -json\nwrite_json map.json\n",
                                  read_sources(run), top, device.synthesis, top,
                                  run.is_xilinx() ? share_inverters : "")));
  MIXCMP_TRY(made, read_json(directory / "made.json"));
  MIXCMP_TRY(statistics, read_json(directory / "area.json"));
  MIXCMP_TRY(netlist, read_json(directory / "map.json"));
  const auto& cells = made.at("modules").at(top).at("cells");
  std::vector<devices::Area> areas;
  for (std::size_t k = 0; k < batch.parameters.size(); ++k) {
    const std::string module = cells.at(fmt::format("unit_{}", k)).at("type");
    MIXCMP_TRY(area, area_of_module(statistics, module, device));
    if (run.is_ice40()) area.luts = ice40_logic_cells(netlist, module);
    areas.push_back(area);
  }
  return areas;
}

bool is_cell_of(const SourceText& source, const devices::Device& device) {
  return !source.cells.empty() && source.cells == device.cells;
}

Result<std::string> tool_versions(const devices::Device& device, TimingEffort effort) {
  MIXCMP_DO(check_is_synthesised(device));
  MIXCMP_TRY(yosys, yosys_version(device));
  const Router* of_device = router_of(device);
  if (effort == TimingEffort::area_only || of_device == nullptr) return yosys;
  const Result<std::string> router = router_version(*of_device);
  if (!router.ok() && router.error().kind != ErrorKind::missing_tool) return router.error();
  return fmt::format("{}; {}", yosys, router.ok() ? *router : "no router");
}

Result<SynthesisResult> synthesise(const SynthesisJob& job, const devices::Device& device,
                                   const SynthesisOptions& options, const fs::path& directory) {
  const Run run = {job, device, options, directory};
  MIXCMP_DO(write_sources(run));
  MIXCMP_TRY(area, map_alone(run));
  MIXCMP_DO(check_parts(run, area));
  MIXCMP_TRY(timing, find_clock(run, area));
  return SynthesisResult{.area = area, .clock = timing.clock, .no_clock = timing.no_clock};
}

}  // namespace mixcmp::characterise
