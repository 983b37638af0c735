#include "generator/synthesis/components/planning.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "generator/synthesis/components/characterise.hpp"
#include "model/base/common/file.hpp"
#include "model/plan/optimise/plan_inputs.hpp"

namespace mixcmp::components {
namespace {

Result<Done> check_table_exists(const std::filesystem::path& path, const TableAdvice& advice) {
  if (path_exists(path)) return Done{};
  return Error{.file = path.string(),
               .field = advice.field,
               .message = "no areas and clocks of this scene's lanes and references",
               .received = "no such file",
               .accepted = advice.accepted};
}

void note_outdated(Planning& planning, const data::Comparisons* data) {
  const RowCount rows = count_rows(planning.table, planning.scene, data, planning.device);
  if (rows.outdated == 0) return;
  planning.notes.push_back(
      fmt::format("{}: {} of {} rows were measured on other RTL than what is generated today",
                  planning.table_path.filename().string(), rows.outdated, rows.all));
}

/// Adds a note if the table has areas of a vendor's tool beside those of Yosys.
void note_imported(Planning& planning) {
  const auto& rows = planning.table.rows;
  const auto imported = std::count_if(
      rows.begin(), rows.end(), [](const measured::Measurement& row) { return row.is_imported(); });
  if (imported == 0 || static_cast<std::size_t>(imported) == rows.size()) return;
  planning.notes.push_back(
      fmt::format("{}: {} of {} rows are from a vendor's reports, the others from Yosys, which "
                  "counts otherwise",
                  planning.table_path.filename().string(), imported, rows.size()));
}

}  // namespace

Result<Planning> load_planning(const scene::Scene& scene, const data::Comparisons* data,
                               const devices::Device& device, const std::filesystem::path& table,
                               const TableAdvice& advice) {
  MIXCMP_DO(check_table_exists(table, advice));
  MIXCMP_TRY(areas, optimise::read_table(table, scene, device));
  MIXCMP_TRY(placed, optimise::with_target_of(areas, table, scene));
  Planning planning{std::move(placed), device, std::move(areas), table, {}};
  note_outdated(planning, data);
  note_imported(planning);
  return planning;
}

}  // namespace mixcmp::components
