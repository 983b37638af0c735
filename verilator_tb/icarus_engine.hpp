#pragma once

#include "verilator_tb/build.hpp"

namespace mixcmp::verilator_tb {

/// Compiles a system's engine with Icarus Verilog, and our harness as a module that Icarus loads:
/// what it drives, what it checks and how it speaks with the host is the same as with Verilator.
/// Icarus knows what is unknown besides. Meant for small engines and sets.
Result<Executable> build_engine_in_icarus(const System& system, const BuildOptions& options);

}  // namespace mixcmp::verilator_tb
