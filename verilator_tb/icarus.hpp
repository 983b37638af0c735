#pragma once

#include <cstdint>
#include <string>

#include "model/base/common/folder_lock.hpp"
#include "verilator_tb/system_simulation.hpp"

namespace mixcmp::verilator_tb {

/// How many time units of the testbench's waves one clock cycle takes.
inline constexpr std::uint64_t icarus_time_per_cycle = 4;

/// Adds the Debian package to an error which says that a program of Icarus is missing, other than
/// iverilog itself. Other errors stay as they are.
Error naming_the_package(Error error, const std::string& program);

/// Runs a block on an event-driven simulator, so that no result depends only on Verilator. It is
/// meant for small systems and thousands of comparisons: the whole run is one block. Sources,
/// stimulus, results and logs stay in a folder of `work_dir`.
Result<Answer> simulate_in_icarus(const System& system, const Block& block,
                                  const std::filesystem::path& work_dir,
                                  const SimulationOptions& options, const Progress& progress,
                                  const Waiting& waiting);

}  // namespace mixcmp::verilator_tb
