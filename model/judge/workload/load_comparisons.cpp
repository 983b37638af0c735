#include "model/judge/workload/load_comparisons.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/base/common/result.hpp"
#include "model/base/number/decimal.hpp"
#include "model/comparison/data/load_tables.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/judge/workload/compare_by_reference.hpp"
#include "model/scene/reference_model.hpp"

namespace mixcmp::workload {
namespace {

/// Makes the comparisons report its progress.
data::CompareItems with_progress(data::CompareItems compare, const ComparisonProgress& progress) {
  if (!progress) return compare;
  return [compare = std::move(compare), progress, done = std::uint64_t{0}](
             const data::Comparisons& data, std::span<const data::Items> items,
             std::span<std::uint8_t> greater) mutable {
    compare(data, items, greater);
    done += items.size();
    progress(done, data.size());
  };
}

/// The row and the column of a table, in an error.
std::string place_in(const data::Table& table, std::size_t row, std::size_t column) {
  const std::string name =
      table.origins.empty() ? table.columns[column] : table.origins[column].shown();
  return fmt::format("row {}, {}", table.label(row), name);
}

/// Checks that the numbers of a column are of an input's format.
Result<Done> check_column(const data::Table& table, std::size_t column, const std::string& input,
                          const OperandFormat& format) {
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Bits number = table.at(row, column);
    if (format.holds(table.format, number)) continue;
    return Error{
        .file = table.source,
        .field = place_in(table, row, column),
        .message =
            fmt::format("not a number of {}, the format of the input {}", format.name(), input),
        .received = to_text(table.format, number),
        .accepted = fmt::format("multiples of {} from {} to {}", to_text(format.fixed()->unit()),
                                to_text(format.fixed()->smallest() * format.fixed()->unit()),
                                to_text(format.fixed()->largest() * format.fixed()->unit()))};
  }
  return Done{};
}

/// Checks the numbers of all inputs in fixed point.
Result<Done> check_numbers(const scene::Scene& scene, const std::vector<data::Table>& tables) {
  for (std::size_t k = 0; k < scene.operand_formats.size(); ++k) {
    const OperandFormat& format = scene.operand_formats[k];
    if (format.fixed() == nullptr) continue;
    const std::string& input = scene.graph.inputs()[k];
    MIXCMP_TRY(source, data::input_column(scene.data->pairing, input));
    const data::Table& table = tables[source.table];
    const auto column = std::find(table.columns.begin(), table.columns.end(), source.name);
    MIXCMP_DO(check_column(table, static_cast<std::size_t>(column - table.columns.begin()), input,
                           format));
  }
  return Done{};
}

Result<data::Comparisons> arrange(const scene::Scene& scene, std::vector<data::Table> tables,
                                  const ComparisonProgress& progress) {
  using data::Comparisons;
  const std::vector<std::string>& inputs = scene.graph.inputs();
  data::Table& first = tables.front();
  data::Table& second = tables.back();
  switch (scene.data->pairing) {
    case data::Pairing::rows: return Comparisons::rows(std::move(first), inputs);
    case data::Pairing::all: return Comparisons::all_pairs(std::move(first), inputs);
    case data::Pairing::cross:
      return Comparisons::cross(std::move(first), std::move(second), inputs);
    case data::Pairing::arg_min: break;
  }
  MIXCMP_TRY(reference, scene::reference_model(scene));
  const data::CompareItems compare = compare_by_reference(reference);
  return Comparisons::arg_min(std::move(first), std::move(second), inputs,
                              with_progress(compare, progress));
}

}  // namespace

Result<data::Comparisons> load_comparisons(const scene::Scene& scene,
                                           const ComparisonProgress& progress) {
  if (!scene.data) {
    return Error{.file = scene.path.string(),
                 .field = "data",
                 .message = "the scene has no data",
                 .received = "nothing",
                 .accepted = "a section [data]"};
  }
  MIXCMP_TRY(tables, data::load_tables(*scene.data, scene.graph.inputs(), scene.reference.format,
                                       scene.operand_formats));
  MIXCMP_DO(check_numbers(scene, tables));
  Result<data::Comparisons> comparisons = arrange(scene, std::move(tables), progress);
  if (!comparisons.ok()) return data::with_place(*scene.data, comparisons.error());
  return comparisons;
}

}  // namespace mixcmp::workload
