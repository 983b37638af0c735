#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>

#include "model/base/common/quote.hpp"
#include "model/base/settings/section.hpp"
#include "model/comparison/data/sphere_family.hpp"
#include "model/comparison/expression/name.hpp"
#include "model/scene/sections.hpp"

namespace mixcmp::scene {
namespace {

constexpr double largest_number = 1e30;

void read_data_file(settings::Section& section, const std::string& key,
                    const std::filesystem::path& scene, std::filesystem::path& path) {
  std::string file;
  section.text(key, file);
  if (section.find(key) == nullptr) return;
  const std::array<std::string_view, 3> readable = {".pdb", ".csv", ".npy"};
  path = scene.parent_path() / file;
  if (std::find(readable.begin(), readable.end(), path.extension()) == readable.end()) {
    section.fail(key, "not a data file by its ending", in_quotes(file),
                 "a file that ends in .pdb, .csv or .npy");
  }
}

std::optional<data::ColumnKey> column_key(const settings::Setting& setting) {
  const auto* name = std::get_if<std::string>(&setting.value);
  if (name != nullptr) return *name;
  const auto* number = std::get_if<std::int64_t>(&setting.value);
  if (number == nullptr || *number < 0) return std::nullopt;
  return static_cast<std::uint64_t>(*number);
}

/// Reads an entry that is one column or a list of columns. On a mistake the result has no columns,
/// and `wrong` points to the faulty entry or element.
data::ColumnNames read_column_names(const std::string& field, const settings::Setting& entry,
                                    const settings::Setting*& wrong) {
  data::ColumnNames names{.name = name_spelling(entry.key),
                          .columns = {},
                          .field = field,
                          .place = {.file = settings::file_of(entry), .line = entry.line}};
  const auto* list = std::get_if<settings::Setting::Array>(&entry.value);
  names.is_list = list != nullptr;
  wrong = &entry;
  const std::span<const settings::Setting> items =
      list == nullptr ? std::span(&entry, 1) : std::span(*list);
  for (const settings::Setting& item : items) {
    const std::optional<data::ColumnKey> column = column_key(item);
    if (!column) {
      if (list != nullptr) wrong = &item;
      names.columns.clear();
      break;
    }
    names.columns.push_back(*column);
  }
  return names;
}

void read_columns(settings::Section& section, const std::string& key,
                  std::vector<data::ColumnNames>& columns) {
  const settings::Setting* setting = section.find(key);
  if (setting == nullptr) return;
  const auto* table = std::get_if<settings::Setting::Table>(&setting->value);
  if (table == nullptr) {
    section.fail(key, "wrong type", setting->shown(), "{ p = [\"x\", \"y\"], r = \"radius\" }");
    return;
  }
  for (const settings::Setting& entry : table->entries) {
    const std::string field = fmt::format("data.{}.{}", key, entry.key);
    const std::string problem = subscript_problem(entry.key);
    if (!problem.empty()) {
      section.fail(settings::mistake_at(entry, field, problem, fmt::format("\"{}\"", entry.key),
                                        std::string(accepted_subscripts())));
    }
    const settings::Setting* wrong = nullptr;
    columns.push_back(read_column_names(field, entry, wrong));
    if (!columns.back().columns.empty()) continue;
    section.fail(
        settings::mistake_at(entry, field, "not a column", wrong->shown(),
                             "the name of a column, its number counted from 0, or a list of "
                             "these"));
  }
}

void read_second_table(settings::Section& section, const std::filesystem::path& scene,
                       data::DataSpec& spec) {
  read_data_file(section, "with", scene, spec.with);
  read_columns(section, "with_columns", spec.with_columns);
  section.integer("with_count", spec.with_count, settings::limits::items);
  const bool given = section.find("with") != nullptr;
  const bool is_drawn = spec.items == "uniform";
  if (given && is_drawn) {
    section.fail("with", "not used: both tables are drawn", section.find("with")->shown(),
                 "with_count beside items = \"uniform\", or file in place of items");
    return;
  }
  if (given && !data::has_second_table(spec.pairing)) {
    section.fail("with", "a second file needs pairs that use it", section.find("with")->shown(),
                 "pairs = \"cross\" or \"arg_min\" beside it");
  }
  if (!given && !is_drawn && data::has_second_table(spec.pairing)) {
    section.fail("with", "required", "nothing",
                 fmt::format("a second file, for pairs = \"{}\"", to_string(spec.pairing)));
  }
  if (!given && section.find("with_columns") != nullptr) {
    section.fail("with_columns", "names columns of no file", "no data.with", "with = \"file.csv\"");
  }
}

void check_family(settings::Section& section, const data::DataSpec& spec) {
  const bool given = section.find("family") != nullptr;
  if (spec.items != "sphere_family") {
    if (!given) return;
    section.fail("family", "only of items = \"sphere_family\"", in_quotes(spec.family),
                 "no family here");
    return;
  }
  const std::vector<std::string> names = data::sphere_family_names();
  if (!given) {
    section.fail("family", "required", "nothing", data::accepted_sphere_families(""));
  } else if (std::find(names.begin(), names.end(), spec.family) == names.end()) {
    section.fail("family", "not a family of sphere pairs", in_quotes(spec.family),
                 data::accepted_sphere_families(spec.family));
  }
  if (spec.pairing != data::Pairing::rows) {
    section.fail("pairs", "the rows of a family are pairs already",
                 in_quotes(std::string(to_string(spec.pairing))), "no pairs here");
  }
}

/// The key for an error if both sources are given: the one that a plan or --set adds to the scene.
std::string later_source(settings::Section& section, const settings::Settings& settings) {
  return settings::file_of(*section.find("file")) == settings.path.string() ? "items" : "file";
}

/// Refuses keys that this source of data does not use.
void refuse_unused(settings::Section& section, std::initializer_list<const char*> keys,
                   const std::string& reason, const std::string& accepted) {
  for (const char* key : keys) {
    const settings::Setting* setting = section.find(key);
    if (setting == nullptr) continue;
    section.fail(key, "not used: " + reason, setting->shown(), "no such key here, or " + accepted);
  }
}

void check_data_source(settings::Section& section, const settings::Settings& settings,
                       const data::DataSpec& spec) {
  const bool items = section.find("items") != nullptr;
  const bool file = section.find("file") != nullptr;
  if (items == file) {
    section.fail(
        items ? later_source(section, settings) : "",
        items ? "two sources of data" : "no source of data",
        items ? "items and file" : "neither items nor file",
        "items = \"uniform\", \"uniform_spheres\" or \"sphere_family\", or file = a .pdb, .csv or "
        ".npy file");
  }
  const bool family = spec.items == "sphere_family", uniform = spec.items == "uniform";
  if (items && !family && !uniform && spec.items != "uniform_spheres") {
    section.fail("items", "not a choice", fmt::format("\"{}\"", spec.items),
                 "uniform, uniform_spheres, sphere_family");
  }
  check_family(section, spec);
  if (file) {
    refuse_unused(section, {"count", "side", "radius_max", "seed"}, "the data come from a file",
                  "items in place of file beside it");
  } else if (family) {
    refuse_unused(section, {"side", "radius_max"}, "a family has its own sizes",
                  "items = \"uniform_spheres\" beside it");
  } else if (uniform) {
    refuse_unused(section, {"side", "radius_max"}, "numbers are drawn from the inputs' ranges",
                  "items = \"uniform_spheres\" beside it");
    refuse_unused(section, {"columns", "with_columns"}, "columns have the inputs' names",
                  "file in place of items");
  }
  if (!uniform || !data::has_second_table(spec.pairing)) {
    refuse_unused(section, {"with_count"}, "no second table is drawn",
                  "items = \"uniform\" with pairs = \"cross\" or \"arg_min\" beside it");
  }
}

}  // namespace

Result<std::optional<data::DataSpec>> read_data(const settings::Settings& settings) {
  settings::Section section(settings, "data");
  const settings::Setting* data = settings.root.find("data");
  if (data == nullptr) return std::optional<data::DataSpec>();
  data::DataSpec spec;
  spec.places[""] = {.file = settings::file_of(*data), .line = data->line};
  for (const settings::Setting& entry : section.entries()) {
    spec.places[entry.key] = {.file = settings::file_of(entry), .line = entry.line};
  }
  section.text("items", spec.items);
  section.text("family", spec.family);
  read_data_file(section, "file", settings.path, spec.file);
  section.integer("count", spec.count, settings::limits::items);
  section.number("side", spec.side, 0, largest_number);
  section.number("radius_max", spec.radius_max, 0, largest_number);
  section.integer("seed", spec.seed, 0, std::numeric_limits<std::int64_t>::max());
  section.choice("pairs", spec.pairing,
                 {data::Pairing::all, data::Pairing::cross, data::Pairing::arg_min});
  read_columns(section, "columns", spec.columns);
  read_second_table(section, settings.path, spec);
  check_data_source(section, settings, spec);
  if (const auto error = section.finish()) return *error;
  return std::optional<data::DataSpec>(spec);
}

}  // namespace mixcmp::scene
