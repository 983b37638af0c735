#include "generator/synthesis/characterise/mapped_area.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "generator/synthesis/characterise/tools.hpp"

namespace mixcmp::characterise {
namespace {

struct CellArea {
  std::string_view cell;
  devices::Area area;
};

constexpr devices::Area lut = {.luts = 1};
constexpr devices::Area free_of_charge = {};

constexpr devices::Area memory_luts(int luts) {
  return {.luts = luts, .shift_luts = luts};
}

/// The areas of cells by their whole names.
constexpr std::array cells = std::to_array<CellArea>({
    // Xilinx: UG190, UG364, UG474 and UG574 (the CLB user guides) say how many LUTs a memory takes.
    {"LUT1", lut},
    {"LUT2", lut},
    {"LUT3", lut},
    {"LUT4", lut},  // ECP5 has a cell of that name as well
    {"LUT5", lut},
    {"LUT6", lut},
    {"LUT6_2", lut},
    {"INV", lut},
    {"CARRY4", {.carries = 1}},
    {"CARRY8", {.carries = 1}},
    {"MUXF7", free_of_charge},
    {"MUXF8", free_of_charge},
    {"MUXF9", free_of_charge},
    {"SRL16E", memory_luts(1)},
    {"SRLC16E", memory_luts(1)},
    {"SRLC32E", memory_luts(1)},
    {"RAM32X1S", memory_luts(1)},
    {"RAM64X1S", memory_luts(1)},
    {"RAM128X1S", memory_luts(2)},
    {"RAM256X1S", memory_luts(4)},
    {"RAM16X1D", memory_luts(2)},
    {"RAM32X1D", memory_luts(2)},
    {"RAM64X1D", memory_luts(2)},
    {"RAM128X1D", memory_luts(4)},
    {"RAM256X1D", memory_luts(8)},
    {"RAM32M", memory_luts(4)},
    {"RAM64M", memory_luts(4)},
    {"RAM32M16", memory_luts(8)},
    {"RAM64M8", memory_luts(8)},
    {"DSP48E", {.dsps = 1}},
    {"DSP48E1", {.dsps = 1}},
    {"DSP48E2", {.dsps = 1}},
    {"BUFG", free_of_charge},
    // ECP5: the slices of a distributed RAM's write port have no other use.
    {"CCU2C", {.luts = 2, .carries = 1}},
    {"TRELLIS_DPR16X4", memory_luts(6)},
    {"PFUMX", free_of_charge},
    {"L6MUX21", free_of_charge},
    {"TRELLIS_FF", {.registers = 1}},
    {"MULT18X18D", {.dsps = 1}},
    {"DP16KD", {.memories = 1}},
    {"PDPW16KD", {.memories = 1}},
    // iCE40
    {"SB_LUT4", lut},
    {"SB_CARRY", {.carries = 1}},
    {"SB_MAC16", {.dsps = 1}},
    {"SB_GB", free_of_charge},
    // Yosys' note of a flattened cell
    {"$scopeinfo", free_of_charge},
});

/// The areas of families of cells by the start of their names. The longest start comes first.
constexpr std::array prefixes = std::to_array<CellArea>({
    {"FD", {.registers = 1}},  // FDRE, FDSE_1, FDCPE
    {"LDCE", {.registers = 1}},
    {"LDPE", {.registers = 1}},
    {"SB_DFF", {.registers = 1}},
    {"SB_RAM40_4K", {.memories = 1}},
    {"RAMB18", {.memories = 1}},
    {"RAMB36", {.memories = 2}},  // a block of 36 Kb is two of 18 Kb
});

constexpr int most_cells = 10'000'000;  ///< cells of one type; no device has as many

Error no_cell_count(const std::string& field, const nlohmann::json& received) {
  return {.field = field,
          .message = "Yosys' statistics have no number of cells",
          .received = received.dump(),
          .accepted = fmt::format("a whole number from 0 to {}", most_cells)};
}

}  // namespace

Result<devices::Area> area_of_cell(std::string_view cell) {
  for (const CellArea& known : cells) {
    if (known.cell == cell) return known.area;
  }
  for (const CellArea& known : prefixes) {
    if (cell.starts_with(known.cell)) return known.area;
  }
  return Error{.field = "synthesis.command",
               .message = "the netlist has a cell whose area is not known",
               .received = std::string(cell),
               .accepted = "cells of Xilinx Virtex-5 to UltraScale+, Lattice ECP5 and iCE40"};
}

Result<devices::Area> area_of_statistics(const nlohmann::json& statistics) {
  const nlohmann::json counts = member_of(member_of(statistics, "design"), "num_cells_by_type");
  if (!counts.is_object()) return no_cell_count("design.num_cells_by_type", counts);
  if (counts.empty()) {
    return Error{.field = "design.num_cells_by_type",
                 .message = "the mapped netlist has no cells",
                 .received = counts.dump(),
                 .accepted = "at least one: what computes nothing has no area to measure"};
  }
  devices::Area sum;
  for (const auto& [cell, count] : counts.items()) {
    const bool whole = count.is_number_integer() && count >= 0 && count <= most_cells;
    if (!whole) return no_cell_count(cell, count);
    MIXCMP_TRY(area, area_of_cell(cell));
    sum += count.get<int>() * area;
  }
  return sum;
}

}  // namespace mixcmp::characterise
