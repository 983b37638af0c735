#pragma once

#include "generator/components/component_maker.hpp"
#include "generator/emit/system.hpp"

namespace mixcmp::gen {

/// The job that synthesises a whole generated system.
model::SynthesisJob system_job(const GeneratedSystem& system);

/// The job that synthesises `count` (1 or more) reference datapaths alone, which a mixed-precision
/// system has to beat. They have no streams or tags around them; each has its own operands and
/// verdict.
model::Result<model::SynthesisJob> references_job(const model::Scene& scene, int count);

}  // namespace mixcmp::gen
