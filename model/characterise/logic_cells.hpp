#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mixcmp::characterise {

/// The logic cells that a mapped iCE40 netlist (Yosys' write_json) fills: each holds a LUT, the
/// flip-flop that this LUT alone feeds, and the carry of the LUT's inputs; a flip-flop or a carry
/// without such a LUT fills one by itself. nextpnr packs in the same way, but adds cells at the
/// ends of carry chains.
int ice40_logic_cells(const nlohmann::json& netlist, const std::string& top);

}  // namespace mixcmp::characterise
