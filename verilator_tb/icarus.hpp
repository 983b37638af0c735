#pragma once

#include "verilator_tb/build.hpp"

namespace mixcmp::verilator_tb {

/// Builds a program that simulates a system, or the engine around it, in Icarus Verilog, so that no
/// result depends only on Verilator. The program has the same harness as the one of
/// build_simulator(): it drives the hardware alike, makes the same checks and speaks with the host
/// by the same protocol. In addition, Icarus simulates unknown bits (x). Such a bit is a violation
/// in a tvalid or tready that the hardware drives, or in a payload that it sends with tvalid high.
/// Counters and `overrun` are not looked at for unknown bits. Meant for small systems and sets of
/// data, because Icarus is slow.
Result<Executable> build_in_icarus(const System& system, const BuildOptions& options);

}  // namespace mixcmp::verilator_tb
