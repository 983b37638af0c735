#pragma once

#include "generator/rtl/engine_module.hpp"

namespace mixcmp::gen {

/// The template that makes the comparisons, unconnected.
TemplateInstance pairwise_template(const EngineShape& engine, const SystemShape& system);

/// Items in, reports out, the system between.
rtl::Module pairwise_module(const EngineShape& engine, const SystemShape& system);

}  // namespace mixcmp::gen
