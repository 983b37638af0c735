#pragma once

#include <string>
#include <vector>

#include "generator/hardware/emit/signature.hpp"
#include "verilator_tb/report.hpp"

namespace mixcmp::cli {

/// Keeps the result of `verify` for the design with this hash in
/// $XDG_CACHE_HOME/mixcmp/simulations, for a later `generate` of the same design. Each simulator
/// has one record. A run that failed replaces the record, a run that passed only if it made at
/// least as many comparisons. A record that cannot be written is reported on standard error, and is
/// no error.
void keep_simulation(const std::string& spec_hash, const verilator_tb::VerifyReport& report);

/// The records of the design. Those that cannot be read are left out.
std::vector<emit::SignatureSimulation> simulations_of(const std::string& spec_hash);

/// A line for each simulator, "simulated: Verilator, 207046 comparisons, 164 recomputed, passed",
/// or "not simulated yet: COMMAND" if there is none.
std::string simulation_lines(const std::vector<emit::SignatureSimulation>& simulations,
                             const std::string& command);

}  // namespace mixcmp::cli
