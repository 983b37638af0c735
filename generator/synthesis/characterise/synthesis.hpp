#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generator/synthesis/characterise/netlist_check.hpp"
#include "model/base/common/process.hpp"
#include "model/cost/measured/measurement.hpp"

namespace mixcmp::characterise {

/// A Verilog source text.
struct SourceText {
  std::string name;  ///< "fp_add.v", no folders
  std::string text;
  /// A family of devices, such as "ecp5", for which this text replaces the text of the same module
  /// without a family. Empty: the text is for all devices.
  std::string cells = {};
};

/// Whether `source` replaces a module on `device`.
bool is_cell_of(const SourceText& source, const devices::Device& device);

/// One module, synthesised by itself. A wrapper among the sources sets its parameters.
struct SynthesisJob {
  std::vector<SourceText> sources;
  std::string top;
  std::string clock_port = "aclk";
  /// The parts that synthesis must keep; empty: not known. They are no part of the hash,
  /// since they follow from the sources.
  NeededParts needed = {};
};

enum class TimingEffort {
  area_only,
  timing,  ///< area and clock, if the device has a timing tool
};

struct SynthesisOptions {
  TimingEffort effort = TimingEffort::timing;
  int seeds = 3;                             ///< seeds of the router
  ToolLimits each_tool = {.seconds = 3600};  ///< for one run of Yosys or of the router
};

struct SynthesisResult {
  devices::Area area;
  std::optional<measured::Clock> clock;
  std::string no_clock;  ///< why there is no clock; else empty
};

/// The versions of the tools that a device needs, as part of a store's key. If Yosys is missing,
/// the error names the package to install. A missing router is no error: the text says "no router",
/// and there will be no clocks.
Result<std::string> tool_versions(const devices::Device& device, TimingEffort effort);

/// Runs Yosys (and the router) in `directory`, which must exist; logs stay there. An error if
/// the netlist lacks a part that the job needs.
Result<SynthesisResult> synthesise(const SynthesisJob& job, const devices::Device& device,
                                   const SynthesisOptions& options,
                                   const std::filesystem::path& directory);

/// Units of one template, which one run of Yosys maps: most of a small unit's time is Yosys' start.
struct UnitBatch {
  std::vector<SourceText> sources;      ///< the template and those that it instantiates
  std::string module;                   ///< the template
  std::vector<std::string> parameters;  ///< of each unit: ".WIDTH(12), .CUTS(2'b11)"
};

/// Maps each unit of a batch by itself in `directory`, with nothing shared between units. Areas are
/// in the order of `parameters`.
Result<std::vector<devices::Area>> map_units(const UnitBatch& batch, const devices::Device& device,
                                             const ToolLimits& limits,
                                             const std::filesystem::path& directory);

}  // namespace mixcmp::characterise
