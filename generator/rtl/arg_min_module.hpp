#pragma once

#include "generator/rtl/counter_port.hpp"
#include "generator/rtl/engine_shape.hpp"

namespace mixcmp::rtl {

/// The template arg_min_engine, which makes the comparisons, with its parameters; unconnected.
TemplateInstance arg_min_template(const EngineShape& engine, const SystemShape& system);

/// The counters of the engine's top: those of the system inside and its own.
std::vector<Counters> arg_min_counters(const SystemShape& system);

/// The engine's top module around the system: it takes candidates and rows, and returns the index
/// of the best candidate for each row.
Module arg_min_module(const EngineShape& engine, const SystemShape& system);

}  // namespace mixcmp::rtl
