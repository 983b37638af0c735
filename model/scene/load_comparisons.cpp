#include "model/scene/load_comparisons.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "model/data/csv.hpp"
#include "model/data/npy.hpp"
#include "model/data/pdb.hpp"
#include "model/data/sphere_family.hpp"
#include "model/data/uniform_spheres.hpp"
#include "model/emulator/reference_contest.hpp"

namespace mixcmp::model {
namespace {

/// The columns that the inputs need of each table, in order of first need.
Result<std::array<std::vector<std::string>, 2>> needed_columns(const Scene& scene) {
  std::array<std::vector<std::string>, 2> columns;
  for (const std::string& input : scene.graph.inputs()) {
    MIXCMP_TRY(place, input_column(scene.data->pairing, input));
    std::vector<std::string>& known = columns[place.table];
    if (std::find(known.begin(), known.end(), place.name) == known.end()) {
      known.push_back(place.name);
    }
  }
  return columns;
}

/// A table of a file, in the file's names.
Result<Table> read_table(const std::filesystem::path& file, FloatFormat format,
                         std::span<const std::string> columns) {
  if (file.extension() == ".pdb") return read_pdb(file, format);
  if (file.extension() == ".csv") return read_csv(file, format, columns);
  return read_npy(file, format, columns);
}

Result<Table> first_table(const DataSpec& data, FloatFormat format,
                          std::span<const std::string> columns) {
  const auto count = static_cast<std::uint64_t>(data.count);
  if (!data.file.empty()) return read_table(data.file, format, columns);
  if (data.items == "sphere_family") {
    return sphere_family({.name = data.family, .count = count, .seed = data.seed}, format);
  }
  return uniform_spheres(
      {.count = count, .side = data.side, .radius_max = data.radius_max, .seed = data.seed},
      format);
}

/// Readers of some files give the wanted columns alone, others all that there are; without names of
/// the scene's own those keep their columns, which errors can then list.
Result<Table> renamed(Table table, const std::vector<ColumnNames>& names,
                      const std::vector<std::string>& columns,
                      const std::vector<std::string>& wanted) {
  if (table.columns == columns) {
    table.columns = wanted;
    return table;
  }
  if (names.empty()) return table;
  return select_columns(table, columns, wanted);
}

Result<Table> load_table(const Scene& scene, std::size_t which,
                         const std::vector<std::string>& wanted) {
  const DataSpec& data = *scene.data;
  const FloatFormat format = scene.reference.format;
  const std::vector<ColumnNames>& names = which == 0 ? data.columns : data.with_columns;
  MIXCMP_TRY(columns, file_columns(names, wanted));
  MIXCMP_TRY(table, which == 0 ? first_table(data, format, columns)
                               : read_table(data.with, format, columns));
  return renamed(std::move(table), names, columns, wanted);
}

Result<Comparisons> arrange(const Scene& scene) {
  const std::vector<std::string>& inputs = scene.graph.inputs();
  MIXCMP_TRY(needed, needed_columns(scene));
  MIXCMP_TRY(first, load_table(scene, 0, needed[0]));
  switch (scene.data->pairing) {
    case Pairing::rows: return Comparisons::rows(std::move(first), inputs);
    case Pairing::all: return Comparisons::all_pairs(std::move(first), inputs);
    case Pairing::cross:
    case Pairing::arg_min: break;
  }
  MIXCMP_TRY(second, load_table(scene, 1, needed[1]));
  if (scene.data->pairing == Pairing::cross) {
    return Comparisons::cross(std::move(first), std::move(second), inputs);
  }
  const Contest contest = reference_contest(reference_graphs(scene.graph, scene.reference));
  return Comparisons::arg_min(std::move(first), std::move(second), inputs, contest);
}

/// A mistake that no data file names stands in the scene's [data].
Error in_scene(const Scene& scene, Error error) {
  if (!error.file.empty()) return error;
  error.file = scene.path.string();
  if (scene.data && error.line == 0) error.line = scene.data->line;
  if (error.field.empty()) error.field = "data";
  return error;
}

}  // namespace

Result<Comparisons> load_comparisons(const Scene& scene) {
  if (!scene.data) {
    return in_scene(scene, {.message = "the scene has no data",
                            .received = "nothing",
                            .accepted = "a section [data]"});
  }
  Result<Comparisons> comparisons = arrange(scene);
  if (!comparisons.ok()) return in_scene(scene, comparisons.error());
  return comparisons;
}

}  // namespace mixcmp::model
