#pragma once

#include <string>

#include "generator/synthesis/characterise/synthesis.hpp"

namespace mixcmp::characterise {

/// The key of a job in a store: a hash of everything that its result depends on. `tools` is the
/// text of tool_versions().
std::string job_hash(const SynthesisJob& job, const devices::Device& device,
                     const SynthesisOptions& options, const std::string& tools);

/// The hash of a row that a vendor's report gives for the component of a job. `tool` names the tool
/// and the part.
std::string imported_hash(const SynthesisJob& job, const std::string& tool);

}  // namespace mixcmp::characterise
