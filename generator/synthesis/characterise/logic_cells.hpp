#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mixcmp::characterise {

/// The number of logic cells that a mapped iCE40 netlist (Yosys' write_json) fills. Each cell holds
/// a LUT, the flip-flop that only this LUT feeds, and the carry of the LUT's inputs. Any other
/// flip-flop or carry fills a cell by itself. nextpnr packs in the same way, but adds cells at the
/// ends of carry chains.
int ice40_logic_cells(const nlohmann::json& netlist, const std::string& top);

}  // namespace mixcmp::characterise
