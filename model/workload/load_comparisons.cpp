#include "model/workload/load_comparisons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "model/common/file.hpp"
#include "model/data/csv.hpp"
#include "model/data/npy.hpp"
#include "model/data/pdb.hpp"
#include "model/data/sphere_family.hpp"
#include "model/data/uniform_spheres.hpp"
#include "model/number/exact.hpp"
#include "model/workload/compare_by_reference.hpp"

namespace mixcmp::workload {
namespace {

/// The columns that the inputs need of each table, in order of first need.
Result<std::array<std::vector<std::string>, 2>> needed_columns(const scene::Scene& scene) {
  std::array<std::vector<std::string>, 2> columns;
  for (const std::string& input : scene.graph.inputs()) {
    MIXCMP_TRY(place, data::input_column(scene.data->pairing, input));
    std::vector<std::string>& known = columns[place.table];
    if (std::find(known.begin(), known.end(), place.name) == known.end()) {
      known.push_back(place.name);
    }
  }
  return columns;
}

/// A coordinate or radius may be rounded up to its limit.
Result<Done> check_limit(const char* field, double limit, FloatFormat format) {
  if (!format.is_infinite(from_rational(format, mpq_class(limit)))) return Done{};
  return Error{.field = field,
               .message = fmt::format("beyond the largest number of {}", format.name()),
               .received = fmt::format("{}", limit),
               .accepted = "a smaller number, or a reference format with more exponent bits"};
}

Result<data::Table> generated_table(const scene::DataSpec& data, FloatFormat format) {
  const auto count = static_cast<std::uint64_t>(data.count);
  if (data.items == "sphere_family") {
    return data::sphere_family({.name = data.family, .count = count, .seed = data.seed}, format);
  }
  MIXCMP_TRY(side, check_limit("data.side", data.side, format));
  MIXCMP_TRY(radius, check_limit("data.radius_max", data.radius_max, format));
  return data::uniform_spheres(
      {.count = count, .side = data.side, .radius_max = data.radius_max, .seed = data.seed},
      format);
}

/// Selects the wanted columns of a table that was read or generated whole. If the scene names no
/// columns, all of them stay.
Result<data::Table> chosen_columns(data::Table table, std::span<const data::ColumnNames> names,
                                   std::span<const data::WantedColumn> wanted) {
  MIXCMP_TRY(selected, data::select_columns(table, wanted));
  if (!names.empty()) return selected;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    table.origins.push_back({.number = k, .name = table.columns[k]});
  }
  return table;
}

/// Reads or generates the table `which`, 0 or 1, of the scene; its columns get the scene's names.
Result<data::Table> read_table(const scene::DataSpec& data, std::size_t which, FloatFormat format,
                               std::span<const data::WantedColumn> wanted) {
  const std::filesystem::path& file = which == 0 ? data.file : data.with;
  if (file.extension() == ".csv") return data::read_csv(file, format, wanted);
  if (file.extension() == ".npy") return data::read_npy(file, format, wanted);
  MIXCMP_TRY(table, file.empty() ? generated_table(data, format) : data::read_pdb(file, format));
  table.source = scene::table_name(data, which);
  return chosen_columns(std::move(table), which == 0 ? data.columns : data.with_columns, wanted);
}

/// The rule that assigns an input to a table by its name, as the end of an error message.
std::string input_rule(const scene::DataSpec& data) {
  const std::string first = scene::table_name(data, 0), second = scene::table_name(data, 1);
  switch (data.pairing) {
    case data::Pairing::rows: return "";
    case data::Pairing::all:
      return fmt::format(": an input ending in i or j is of an item of {}", first);
    case data::Pairing::cross:
      return fmt::format(": an input ending in i is of an item of {}, in j of {}", first, second);
    case data::Pairing::arg_min:
      return fmt::format(
          ": an input ending in i or j is of a candidate of {}, any other of a row of {}", second,
          first);
  }
  MIXCMP_CHECK(false);
}

/// The first input that needs the column which the scene calls `column`.
std::string needing_input(const scene::Scene& scene, std::size_t which, const std::string& column) {
  for (const std::string& input : scene.graph.inputs()) {
    const Result<data::InputColumn> place = data::input_column(scene.data->pairing, input);
    if (place.ok() && place->table == which && place->name == column) return input;
  }
  MIXCMP_CHECK(false);
}

Place place_of(const scene::DataSpec& data, const std::string& key) {
  const auto found = data.places.find(key);
  if (found != data.places.end()) return found->second;
  const auto section = data.places.find("");
  return section == data.places.end() ? Place{} : section->second;
}

std::string source_key(const scene::DataSpec& data, std::size_t which) {
  if (which == 1) return "with";
  return data.file.empty() ? "items" : "file";
}

/// Checks that the file can be read; the error is placed at the key that names the file.
Result<Done> check_source(const scene::DataSpec& data, std::size_t which) {
  const std::filesystem::path& path = which == 0 ? data.file : data.with;
  if (path.empty()) return Done{};
  const Result<Done> readable = check_readable(path);
  if (readable.ok()) return Done{};
  const Place place = place_of(data, source_key(data, which));
  Error error = readable.error();
  error.message += " " + path.string();
  error.file = place.file;
  error.line = place.line;
  error.field = "data." + source_key(data, which);
  return error;
}

/// Adds to the error of a missing column the input that needs it, and the rule that assigns this
/// input to the table.
Error with_input(const scene::Scene& scene, std::size_t which, const std::string& wanted,
                 Error error) {
  const std::string need = fmt::format(
      ", which the input {} needs{}", needing_input(scene, which, wanted), input_rule(*scene.data));
  if (!error.file.empty()) {
    error.message += need;
    return error;
  }
  error.message = fmt::format("no column {}{}", error.field, need);
  error.field = which == 0 ? "data.file" : "data.with";
  return error;
}

/// Places an error about missing column numbers at the key that gives such numbers or, where that
/// is absent, at the key that names the file.
Error with_columns_key(const scene::DataSpec& data, std::size_t which, Error error) {
  const std::string key = which == 0 ? "columns" : "with_columns";
  const Place place = place_of(data, data.places.contains(key) ? key : source_key(data, which));
  error.file = place.file;
  error.line = place.line;
  error.field = "data." + key;
  error.message += ", and " + scene::table_name(data, which) + " is one";
  return error;
}

Result<data::Table> load_table(const scene::Scene& scene, std::size_t which,
                               const std::vector<std::string>& wanted) {
  const scene::DataSpec& data = *scene.data;
  MIXCMP_TRY(source_checked, check_source(data, which));
  MIXCMP_TRY(columns, data::file_columns(which == 0 ? data.columns : data.with_columns, wanted));
  const Result<data::Table> table = read_table(data, which, scene.reference.format, columns);
  if (table.ok()) return table;
  const Error& error = table.error();
  if (error.kind == ErrorKind::unnamed_columns) return with_columns_key(data, which, error);
  if (error.kind != ErrorKind::missing_column) return error;
  const auto missing =
      std::find_if(columns.begin(), columns.end(), [&](const data::WantedColumn& column) {
        return column.column == data::ColumnKey(error.field);
      });
  return with_input(scene, which, missing->name, error);
}

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

Result<data::Comparisons> arrange(const scene::Scene& scene, const ComparisonProgress& progress) {
  const std::vector<std::string>& inputs = scene.graph.inputs();
  MIXCMP_TRY(needed, needed_columns(scene));
  MIXCMP_TRY(first, load_table(scene, 0, needed[0]));
  switch (scene.data->pairing) {
    case data::Pairing::rows: return data::Comparisons::rows(std::move(first), inputs);
    case data::Pairing::all: return data::Comparisons::all_pairs(std::move(first), inputs);
    case data::Pairing::cross:
    case data::Pairing::arg_min: break;
  }
  MIXCMP_TRY(second, load_table(scene, 1, needed[1]));
  if (scene.data->pairing == data::Pairing::cross) {
    return data::Comparisons::cross(std::move(first), std::move(second), inputs);
  }
  const data::CompareItems compare =
      compare_by_reference(reference_graph(scene.graph, scene.reference));
  return data::Comparisons::arg_min(std::move(first), std::move(second), inputs,
                                    with_progress(compare, progress));
}

/// Places an error that has no file yet at the key that it names, or at [data]. An error about one
/// table also names that table.
Error with_location(const scene::Scene& scene, Error error) {
  if (!error.file.empty()) return error;
  error.file = scene.path.string();
  if (error.field.empty()) error.field = "data";
  if (!scene.data) return error;
  const scene::DataSpec& data = *scene.data;
  for (const std::size_t which : {std::size_t{0}, std::size_t{1}}) {
    if (error.field != (which == 0 ? "data.file" : "data.with")) continue;
    error.field = "data." + source_key(data, which);
    error.received += " in " + scene::table_name(data, which);
    break;
  }
  const std::string_view section = "data.";
  const Place place = place_of(
      data, error.field.starts_with(section) ? error.field.substr(section.size()) : std::string());
  if (!place.file.empty()) error.file = place.file;
  error.line = place.line;
  return error;
}

}  // namespace

Result<data::Comparisons> load_comparisons(const scene::Scene& scene,
                                           const ComparisonProgress& progress) {
  if (!scene.data) {
    return with_location(scene, {.message = "the scene has no data",
                                 .received = "nothing",
                                 .accepted = "a section [data]"});
  }
  Result<data::Comparisons> comparisons = arrange(scene, progress);
  if (!comparisons.ok()) return with_location(scene, comparisons.error());
  return comparisons;
}

}  // namespace mixcmp::workload
