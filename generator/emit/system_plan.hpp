#pragma once

#include <optional>
#include <vector>

#include "generator/datapath/schedule.hpp"
#include "generator/rtl/engine_module.hpp"
#include "generator/rtl/system_modules.hpp"
#include "model/design/design.hpp"

namespace mixcmp::gen {

/// A design with its datapaths scheduled, and the names and widths that the modules around them
/// agree on.
struct SystemPlan {
  std::vector<Schedule> lanes;       ///< one per group
  std::vector<Schedule> references;  ///< one per group
  SystemShape shape;
  std::optional<EngineShape> engine;
};

/// The part of a SystemShape that the streams alone decide; names, counts and latencies are left to
/// the caller. `format`: of the operands that arrive.
SystemShape stream_shape(const std::vector<std::string>& inputs, model::FloatFormat format,
                         const model::SystemSpec& system);

/// Schedules the datapaths and names the modules. An error means that the device is unknown.
model::Result<SystemPlan> plan_system(const model::Design& design);

}  // namespace mixcmp::gen
