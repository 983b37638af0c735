#pragma once

#include <optional>
#include <vector>

#include "generator/datapath/schedule.hpp"
#include "generator/rtl/engine_module.hpp"
#include "generator/rtl/system_modules.hpp"
#include "model/design/design.hpp"

namespace mixcmp::gen {

/// A design with its datapaths placed in time, and what the modules around them agree on.
struct SystemPlan {
  std::vector<Schedule> lanes;       ///< one a group
  std::vector<Schedule> references;  ///< one a group
  SystemShape shape;
  std::optional<EngineShape> engine;
};

/// What the streams carry, whatever the datapaths between them compute: names, counts and latencies
/// are left to the caller. `format`: of the operands.
SystemShape stream_shape(const std::vector<std::string>& inputs, model::FloatFormat format,
                         const model::SystemSpec& system);

/// An error where the device is unknown.
model::Result<SystemPlan> plan_system(const model::Design& design);

}  // namespace mixcmp::gen
