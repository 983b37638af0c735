#pragma once

#include <string>
#include <vector>

#include "generator/hardware/emit/signature.hpp"
#include "model/base/common/result.hpp"
#include "verilator_tb/report.hpp"

namespace mixcmp::tasks {

/// Keeps the result of `verify` for the design with this hash in
/// $XDG_CACHE_HOME/mixcmp/simulations, for a later `generate` of the same design. Each simulator
/// has one record. A run that failed replaces the record, a run that passed only if it made at
/// least as many comparisons. It is an error if the record cannot be written.
Result<Done> keep_simulation(const std::string& spec_hash,
                             const verilator_tb::VerifyReport& report);

/// The records of the design. Those that cannot be read are left out.
std::vector<emit::SignatureSimulation> simulations_of(const std::string& spec_hash);

}  // namespace mixcmp::tasks
