#pragma once

#include <string>
#include <vector>

#include "generator/emit/signature.hpp"
#include "verilator_tb/report.hpp"

namespace mixcmp::cli {

/// Keeps what `verify` found of the design with this hash, for a later `generate` of the same
/// design, in $XDG_CACHE_HOME/mixcmp/simulations. There is one record of each simulator. A run that
/// passed replaces it only if it made as many comparisons. A failure to write is told, no more.
void keep_simulation(const std::string& spec_hash, const verilator_tb::VerifyReport& report);

/// What was kept of the design; records that cannot be read are left out.
std::vector<emit::SignatureSimulation> simulations_of(const std::string& spec_hash);

/// "simulated: Verilator, 207046 comparisons, 164 recomputed, passed", a line for each simulator.
/// Without any: "not simulated yet: COMMAND".
std::string simulation_lines(const std::vector<emit::SignatureSimulation>& simulations,
                             const std::string& command);

}  // namespace mixcmp::cli
