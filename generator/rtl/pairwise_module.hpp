#pragma once

#include "generator/rtl/engine_module.hpp"

namespace mixcmp::rtl {

/// The template pairwise_engine, which makes the comparisons, with its parameters; unconnected.
TemplateInstance pairwise_template(const EngineShape& engine, const SystemShape& system);

/// The engine's top module around the system: it takes items and returns reports of pairs.
Module pairwise_module(const EngineShape& engine, const SystemShape& system);

}  // namespace mixcmp::rtl
