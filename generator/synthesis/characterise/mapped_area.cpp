#include "generator/synthesis/characterise/mapped_area.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "generator/synthesis/characterise/tools.hpp"

namespace mixcmp::characterise {
namespace {

constexpr int most_cells = 10'000'000;  ///< of one type; no device has as many

Error no_cell_count(const std::string& field, const nlohmann::json& received) {
  return {.field = field,
          .message = "Yosys' statistics have no number of cells",
          .received = received.dump(),
          .accepted = fmt::format("a whole number from 0 to {}", most_cells)};
}

}  // namespace

Result<devices::Area> area_of_cell(std::string_view cell, const devices::Device& device) {
  if (const auto area = device.cell_areas.find(cell)) return *area;
  return Error{.field = "synthesis.command",
               .message = "the netlist has a cell whose area is not known",
               .received = std::string(cell),
               .accepted = fmt::format("{}, or an entry of [areas] in the device file",
                                       device.cell_areas.names())};
}

namespace {

Result<devices::Area> sum_of_cells(const nlohmann::json& counts, const devices::Device& device) {
  devices::Area sum;
  for (const auto& [cell, count] : counts.items()) {
    const bool whole = count.is_number_integer() && count >= 0 && count <= most_cells;
    if (!whole) return no_cell_count(cell, count);
    MIXCMP_TRY(area, area_of_cell(cell, device));
    sum += count.get<int>() * area;
  }
  return sum;
}

}  // namespace

Result<devices::Area> area_of_statistics(const nlohmann::json& statistics,
                                         const devices::Device& device) {
  const nlohmann::json counts = member_of(member_of(statistics, "design"), "num_cells_by_type");
  if (!counts.is_object()) return no_cell_count("design.num_cells_by_type", counts);
  if (counts.empty()) {
    return Error{.field = "design.num_cells_by_type",
                 .message = "the mapped netlist has no cells",
                 .received = counts.dump(),
                 .accepted = "at least one: what computes nothing has no area to measure"};
  }
  return sum_of_cells(counts, device);
}

Result<devices::Area> area_of_module(const nlohmann::json& statistics, const std::string& module,
                                     const devices::Device& device) {
  const nlohmann::json modules = member_of(statistics, "modules");
  for (const std::string& name : {module, "\\" + module}) {
    const nlohmann::json counts = member_of(member_of(modules, name.c_str()), "num_cells_by_type");
    if (counts.is_object()) return sum_of_cells(counts, device);
  }
  return no_cell_count("modules." + module, modules);
}

}  // namespace mixcmp::characterise
