#pragma once

#include "generator/hardware/emit/system.hpp"
#include "generator/synthesis/components/component_maker.hpp"

namespace mixcmp::components {

/// The job that synthesises a whole generated system.
characterise::SynthesisJob system_job(const emit::GeneratedSystem& system);

/// The job that synthesises `count` (1 or more) reference datapaths and nothing else, the baseline
/// that a mixed-precision system has to beat. They have no streams or tags around them; each has
/// its own operands and verdict.
Result<characterise::SynthesisJob> references_job(const scene::Scene& scene, int count);

}  // namespace mixcmp::components
