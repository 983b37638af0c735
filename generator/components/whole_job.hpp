#pragma once

#include "generator/components/component_maker.hpp"
#include "generator/emit/system.hpp"

namespace mixcmp::gen {

/// A generated system as it is.
model::SynthesisJob system_job(const GeneratedSystem& system);

/// What a mixed-precision system has to be better than: `count` (1 or more) reference datapaths
/// alone, without streams, tags or anything else around them, each with operands and verdict of its
/// own.
model::Result<model::SynthesisJob> references_job(const model::Scene& scene, int count);

}  // namespace mixcmp::gen
