#pragma once

#include <optional>
#include <vector>

#include "generator/rtl/engine_module.hpp"
#include "generator/rtl/system_modules.hpp"
#include "model/design/design.hpp"

namespace mixcmp::emit {

/// A design with its datapaths scheduled, and the names and widths that the modules around them
/// agree on.
struct ScheduledSystem {
  rtl::SystemShape shape;
  std::optional<rtl::EngineShape> engine;
};

/// The part of a SystemShape that the streams alone decide; names, counts and latencies are left to
/// the caller. `format`: of the operands that arrive.
rtl::SystemShape stream_shape(const std::vector<std::string>& inputs, FloatFormat format,
                              const scene::SystemSpec& system);

/// Schedules the datapaths and names the modules. An error means that the device is unknown.
Result<ScheduledSystem> schedule_system(const design::Design& design);

}  // namespace mixcmp::emit
