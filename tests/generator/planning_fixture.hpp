#pragma once

#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.hpp"

namespace mixcmp::test {

/// A scene that asks for a plan, beside a made-up table of areas.
class PlanningTest : public ProgramTest {
protected:
  PlanningTest() {
    std::ofstream(path("scene.toml"))
        << "[comparison]\nname = \"spheres\"\n"
        << "f = \"(cxi - cxj)^2 + (cyi - cyj)^2 + (czi - czj)^2\"\ng = \"(ri + rj)^2\"\n"
        << "[inputs]\n\"c*\" = { range = [0, 100] }\n\"r*\" = { range = [0, 100] }\n"
        << "[reference]\nformat = \"s53e8\"\n[reduced]\nformat = \"auto\"\n"
        << "[system]\ndevice = \"virtex6-lx760\"\nlanes = \"auto\"\nreferences = \"auto\"\n"
        << "[data]\nitems = \"uniform_spheres\"\ncount = 300\nradius_max = 25\npairs = \"all\"\n";
    write_table("scene-virtex6-lx760.csv", "virtex6-lx760");
  }

  /// Lanes of 8 and 12 digits with exact inputs, one reference, streams.
  void write_table(const std::string& name, const std::string& device,
                   const std::string& scene = "spheres", int lane_luts = 2000) {
    std::filesystem::create_directories(path("characterisation"));
    std::ofstream table(path("characterisation") / name);
    table << "# device: " << device << "\n# scene: " << scene << "\n# command: made up\n"
          << "# target_mhz: 250\n"
          << "kind,name,format,inputs,bound,multipliers,initiation_interval,ports,latency_cycles,"
             "luts,registers,dsps,memories,carries,shift_luts,mhz,low_mhz,high_mhz,seeds,"
             "clock_source,timing_seeds,hash,tools\n";
    row(table, "lane,,s8e8,exact,relative,embedded,0,0", 20, lane_luts, 4);
    row(table, "lane,,s8e8,exact,relative,logic,0,0", 21, 2300, 0);
    row(table, "lane,,s12e8,exact,relative,embedded,0,0", 20, 2500, 4);
    row(table, "reference,,s53e8,,,embedded,1,0", 30, 8000, 40);
    row(table, "fifo,,,,,,0,64", 0, 300, 0);
    row(table, "crossbar,,,,,,0,1", 0, 10, 0);
    row(table, "crossbar,,,,,,0,256", 0, 2000, 0);
  }

  static void row(std::ofstream& table, const std::string& key, int latency, int luts, int dsps,
                  int memories = 0) {
    table << fmt::format("{},{},{},{},{},{},0,0,,,,,,0,00,made up\n", key, latency, luts, luts,
                         dsps, memories);
  }

  /// The JSON that a run printed, without the lines of standard error before it.
  static nlohmann::json json_of(const Outcome& run) {
    return json_of(run.output.substr(run.output.find('{')));
  }

  /// The parsed text; if it is an array, its first element.
  static nlohmann::json json_of(const std::string& text) {
    const auto json = nlohmann::json::parse(text);
    return json.is_array() ? json.at(0) : json;
  }
};

}  // namespace mixcmp::test
