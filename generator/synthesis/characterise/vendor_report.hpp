#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/cost/measured/measurement.hpp"

namespace mixcmp::characterise {

enum class Vendor { vivado, quartus };
std::string_view to_string(Vendor vendor);

/// The area of one instance in a design's hierarchy, with all its contents.
struct InstanceArea {
  std::string path;  ///< below the top, "g_lanes[0].channel/lane"; empty: the whole design
  devices::Area area;
  int line = 0;  ///< line of the report
};

/// The facts that one report of a vendor's tool states. A report has areas or a clock.
struct VendorReport {
  std::filesystem::path file;
  Vendor vendor = Vendor::vivado;
  std::string tool;    ///< "Vivado v.2019.2 Build 2708876"
  std::string design;  ///< the top module
  int design_line = 0;
  std::string device;  ///< as the report spells it: "7a200tfbg676-2", or "7a200t-fbg676 -2"
  int device_line = 0;
  measured::AreaStage stage = measured::AreaStage::synthesised;
  std::vector<InstanceArea> instances;  ///< empty: the report has no areas
  std::optional<double> mhz;            ///< the highest clock aclk, placed and routed
};

/// Reads a report of areas by instance or of timing: from Vivado (report_utilization -hierarchical,
/// report_timing_summary) or Quartus (TOP.fit.rpt, TOP.sta.rpt). Errors name file and line. The
/// timing of a design that is not routed is an error.
Result<VendorReport> read_vendor_report(const std::filesystem::path& path);

/// Whether a report's device is this part, spelled as in the device's file. Reports leave out "xc",
/// hyphens, and the end of a part's name.
bool is_part(const VendorReport& report, const std::string& part);

}  // namespace mixcmp::characterise
