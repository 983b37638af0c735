#include "generator/cli/lane_area.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

#include "generator/cli/scratch.hpp"
#include "model/common/check.hpp"
#include "model/common/process.hpp"

namespace mixcmp::cli {
namespace {

/// Devices by the start of their names, and the Yosys command that maps to their family.
struct Flow {
  std::string_view device;
  std::string_view synthesis;
};
constexpr std::array<Flow, 6> flows = {{
    {"virtex5", "synth_xilinx -family xc5v -flatten -noiopad"},
    {"virtex6", "synth_xilinx -family xc6v -flatten -noiopad"},
    {"artix7", "synth_xilinx -family xc7 -flatten -noiopad"},
    {"ultrascale", "synth_xilinx -family xcup -flatten -noiopad"},
    {"ecp5", "synth_ecp5"},
    {"ice40", "synth_ice40 -dsp"},
}};

std::string_view synthesis_for(const std::string& device) {
  for (const Flow& flow : flows) {
    if (device.starts_with(flow.device)) return flow.synthesis;
  }
  MIXCMP_CHECK(!"a device without a flow");
}

bool starts_with_any(const std::string& cell, std::initializer_list<const char*> prefixes) {
  return std::any_of(prefixes.begin(), prefixes.end(),
                     [&](const char* prefix) { return cell.starts_with(prefix); });
}

Area count_cells(const nlohmann::json& statistics) {
  Area area;
  for (const auto& [cell, count] : statistics.at("design").at("num_cells_by_type").items()) {
    const int cells = count.get<int>();
    if (starts_with_any(cell, {"LUT", "SRL", "SB_LUT", "TRELLIS_SLICE"})) area.luts += cells;
    if (starts_with_any(cell, {"FD", "SB_DFF", "TRELLIS_FF"})) area.registers += cells;
    if (starts_with_any(cell, {"DSP", "MULT18", "SB_MAC"})) area.dsps += cells;
  }
  return area;
}

std::string lane_module(const gen::GeneratedSystem& system) {
  const std::string& channel = system.signature.lane_groups.front().module;
  return channel.substr(0, channel.size() - std::string_view("_channel").size());
}

}  // namespace

model::Result<Area> lane_area(const model::Design& design) {
  MIXCMP_TRY(version, model::tool_version("yosys", "-V", "yosys"));
  MIXCMP_TRY(system, gen::generate_system(design, ""));
  const Scratch scratch;
  for (const gen::GeneratedFile& file : system.files) {
    std::ofstream(scratch.path() / file.name) << file.text;
  }
  const std::string script =
      fmt::format("read_verilog *.v; {} -top {}; tee -q -o statistics.json stat -json",
                  synthesis_for(design.system.device), lane_module(system));
  MIXCMP_TRY(ran, model::run_tool({"yosys", "-q", "-p", script}, scratch.path(),
                               scratch.path() / "yosys.log", {}));
  std::ifstream stream(scratch.path() / "statistics.json");
  return count_cells(nlohmann::json::parse(stream));
}

}  // namespace mixcmp::cli
