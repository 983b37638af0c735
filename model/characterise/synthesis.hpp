#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/characterise/measurement.hpp"
#include "model/common/process.hpp"

namespace mixcmp::model {

/// A Verilog source text.
struct SourceText {
  std::string name;  ///< "fp_add.v", no folders
  std::string text;
};

/// One module to be synthesised alone. Parameters are set by a wrapper among the sources.
struct SynthesisJob {
  std::vector<SourceText> sources;
  std::string top;
  std::string clock_port = "aclk";
};

enum class TimingEffort {
  area_only,
  timing,  ///< and the clock, where the device has a tool for it
};

struct SynthesisOptions {
  TimingEffort effort = TimingEffort::timing;
  int seeds = 3;                             ///< of the router
  ToolLimits each_tool = {.seconds = 3600};  ///< for one run of Yosys or of the router
};

struct SynthesisResult {
  Area area;
  std::optional<Clock> clock;
  std::string no_clock;  ///< why there is none, where there is none
};

/// The tools a device needs, with their versions, as they go into a store's key. An error names
/// the package to install. A router that is missing is no error: there is no clock then, and the
/// text says "no router".
Result<std::string> tool_versions(const Device& device, TimingEffort effort);

/// Runs Yosys (and the router) in `directory`, which must exist; logs stay there.
Result<SynthesisResult> synthesise(const SynthesisJob& job, const Device& device,
                                   const SynthesisOptions& options,
                                   const std::filesystem::path& directory);

}  // namespace mixcmp::model
