#pragma once

#include <optional>
#include <vector>

#include "generator/hardware/rtl/arg_min_module.hpp"
#include "generator/hardware/rtl/counter_port.hpp"
#include "generator/hardware/rtl/engine_shape.hpp"
#include "generator/hardware/rtl/pairwise_module.hpp"
#include "generator/hardware/rtl/system_shape.hpp"
#include "model/design/design.hpp"

namespace mixcmp::emit {

/// A design with its datapaths scheduled, and the names and widths that the modules around them
/// agree on.
struct ScheduledSystem {
  rtl::SystemShape shape;
  std::optional<rtl::EngineShape> engine;
  /// The other parts of a pairwise engine. Its lanes are those of the shape, behind the conversion
  /// of their operands.
  std::optional<rtl::PairwiseShape> pairwise;
  /// The parts of an arg-min engine around the system. Its lanes also begin behind the conversion.
  std::optional<rtl::ArgMinShape> arg_min;

  /// The words of an engine's items, which its lanes read; null if there is no engine.
  const rtl::ItemWords* words() const;

  /// The counters of the outermost module.
  std::vector<rtl::Counters> counters() const;
};

/// The part of a SystemShape that depends only on the streams; names, counts and latencies are left
/// to the caller. `formats`: one per input.
rtl::SystemShape stream_shape(const std::vector<std::string>& inputs,
                              const std::vector<OperandFormat>& formats,
                              const scene::SystemSpec& system);

/// Schedules the datapaths and names the modules. An error means that the device is unknown.
Result<ScheduledSystem> schedule_system(const design::Design& design);

}  // namespace mixcmp::emit
