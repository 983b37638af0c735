#include "model/data/load.hpp"

#include <algorithm>
#include <cstdint>

#include "model/data/csv.hpp"
#include "model/data/npy.hpp"
#include "model/data/pdb.hpp"
#include "model/data/sphere_family.hpp"
#include "model/data/uniform_spheres.hpp"

namespace mixcmp::model {
namespace {

/// The columns that the inputs need, in order of first need.
std::vector<std::string> needed_columns(const std::vector<std::string>& inputs, bool pairs) {
  std::vector<std::string> columns;
  for (const std::string& input : inputs) {
    const auto item = item_column(input);
    const std::string name = pairs && item ? item->name : input;
    if (std::find(columns.begin(), columns.end(), name) == columns.end()) columns.push_back(name);
  }
  return columns;
}

Result<Table> load_table(const Scene& scene) {
  const DataSpec& data = *scene.data;
  const FloatFormat format = scene.reference.format;
  const auto count = static_cast<std::uint64_t>(data.count);
  if (data.items == "sphere_family") {
    return sphere_family({.name = data.family, .count = count, .seed = data.seed}, format);
  }
  if (data.file.empty()) {
    return uniform_spheres(
        {.count = count, .side = data.side, .radius_max = data.radius_max, .seed = data.seed},
        format);
  }
  const auto columns = needed_columns(scene.graph.inputs(), data.all_pairs);
  if (data.file.extension() == ".pdb") return read_pdb(data.file, format);
  if (data.file.extension() == ".csv") return read_csv(data.file, format, columns);
  return read_npy(data.file, format, columns);
}

/// A mistake that no data file names stands in the scene's [data].
Error in_scene(const Scene& scene, Error error) {
  if (!error.file.empty()) return error;
  error.file = scene.path.string();
  if (scene.data) error.line = scene.data->line;
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
  Result<Table> table = load_table(scene);
  if (!table.ok()) return in_scene(scene, table.error());
  const std::vector<std::string>& inputs = scene.graph.inputs();
  Result<Comparisons> comparisons = scene.data->all_pairs
                                        ? Comparisons::all_pairs(std::move(table).value(), inputs)
                                        : Comparisons::rows(std::move(table).value(), inputs);
  if (!comparisons.ok()) return in_scene(scene, comparisons.error());
  return comparisons;
}

}  // namespace mixcmp::model
