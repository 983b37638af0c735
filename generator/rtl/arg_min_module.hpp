#pragma once

#include "generator/rtl/engine_module.hpp"

namespace mixcmp::gen {

/// The template that makes the comparisons, unconnected.
TemplateInstance arg_min_template(const EngineShape& engine, const SystemShape& system);

/// Candidates and rows in, indices out, the system between.
rtl::Module arg_min_module(const EngineShape& engine, const SystemShape& system);

}  // namespace mixcmp::gen
