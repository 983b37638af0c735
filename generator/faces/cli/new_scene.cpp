#include "generator/faces/cli/new_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>

#include "model/base/number/double.hpp"
#include "model/base/settings/settings.hpp"
#include "model/cost/devices/device.hpp"
#include "model/judge/workload/load_comparisons.hpp"
#include "model/scene/plan.hpp"

namespace mixcmp::cli {
namespace {

using settings::Setting;
using settings::toml_string;

/// A column as `columns` takes it: its number where it is one, else its name.
Setting column_key(const std::string& text) {
  const bool is_number =
      !text.empty() && text.size() < 10 && std::all_of(text.begin(), text.end(), [](char c) {
        return std::isdigit(static_cast<unsigned char>(c)) != 0;
      });
  if (is_number) return {.key = "", .value = std::int64_t{std::stoll(text)}};
  return {.key = "", .value = text};
}

Setting::Table table_of(const std::vector<NewScene::Column>& columns) {
  Setting::Table table;
  for (const auto& [name, text] : columns) {
    Setting& entry = table.entries.emplace_back(column_key(text));
    entry.key = name;
    if (text.find(',') == std::string::npos) continue;
    Setting::Array list;
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      list.push_back(column_key(text.substr(begin, end - begin)));
      begin = end + 1;
    }
    entry.value = std::move(list);
  }
  return table;
}

void put(Setting::Table& root, const std::string& section, const std::string& key,
         const std::string& value) {
  auto& table = std::get<Setting::Table>(settings::find_or_add(root, section).value);
  table.entries.push_back({.key = key, .value = value});
}

void put(Setting::Table& root, const std::string& section, const std::string& key,
         const std::vector<NewScene::Column>& columns) {
  if (columns.empty()) return;
  auto& table = std::get<Setting::Table>(settings::find_or_add(root, section).value);
  table.entries.push_back({.key = key, .value = table_of(columns)});
}

settings::Settings settings_of(const NewScene& scene) {
  settings::Settings all{.path = scene.path, .root = {}};
  put(all.root, "comparison", "name", scene.name);
  put(all.root, "comparison", "f", scene.f);
  put(all.root, "comparison", "g", scene.g);
  put(all.root, "reference", "format", scene.reference);
  put(all.root, "system", "device", scene.device);
  if (scene.file.empty()) return all;
  put(all.root, "data", "file", scene.file);
  if (scene.pairing != data::Pairing::rows) {
    put(all.root, "data", "pairs", std::string(to_string(scene.pairing)));
  }
  if (!scene.with.empty()) put(all.root, "data", "with", scene.with);
  put(all.root, "data", "columns", scene.columns);
  put(all.root, "data", "with_columns", scene.with_columns);
  return all;
}

/// The error with the option of `mixcmp new` in the place of a key that it has set.
Error with_option(Error error) {
  static const std::map<std::string, std::string> options = {
      {"comparison.name", "NAME"},   {"comparison.f", "--f"},
      {"comparison.g", "--g"},       {"reference.format", "--reference"},
      {"system.device", "--device"}, {"data.file", "--data"},
      {"data.with", "--with"},       {"data.pairs", "--pairs"},
      {"data.columns", "--column"},  {"data.with_columns", "--with-column"}};
  if (!error.file.empty() && !error.file.starts_with("--set")) return error;
  const std::size_t inner = error.field.find('.', error.field.find('.') + 1);
  const auto option = options.find(error.field.substr(0, inner));
  if (option != options.end()) error.file = option->second;
  return error;
}

/// The range of an input's finite numbers in the data.
struct Numbers {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool any() const { return low <= high; }
};

Numbers numbers_of(const data::Comparisons& data, std::size_t input) {
  const data::Comparisons::Source& source = data.sources()[input];
  const data::Table& table = data.tables()[source.table];
  Numbers numbers;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double value = to_double(table.format, table.at(row, source.column));
    if (!std::isfinite(value)) continue;
    numbers.low = std::min(numbers.low, value);
    numbers.high = std::max(numbers.high, value);
  }
  return numbers;
}

std::string range_line(const std::string& key, const Numbers& numbers) {
  if (!numbers.any()) return fmt::format("# {}: the data have no finite number for it\n", key);
  const std::string entry = fmt::format("{} = {{ range = \"data\" }}", key);
  return fmt::format("{:<32} # now {:.6g} to {:.6g}\n", entry, numbers.low, numbers.high);
}

std::string ranges_text(const LoadedScene& loaded) {
  const std::vector<std::string>& inputs = loaded.scene.graph.inputs();
  if (!loaded.data) {
    std::string text =
        "# Promise a range for each input, where you can: it saves hardware, and lanes in fixed\n"
        "# point need one. A value outside costs a recomputation and is never decided wrongly.\n"
        "# [inputs]\n";
    for (const std::string& input : inputs) {
      text += fmt::format("# {} = {{ range = [0, 100] }}\n", input);
    }
    return text;
  }
  std::string text =
      "# The range of an input is a promise that saves hardware; a value outside costs a\n"
      "# recomputation and is never decided wrongly. \"data\" takes the least and the greatest\n"
      "# number of the data. Better, write what your hardware will meet: range = [0, 100].\n"
      "[inputs]\n";
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    text += range_line(inputs[k], numbers_of(*loaded.data, k));
  }
  return text;
}

std::string columns_text(const std::string& key, const std::vector<NewScene::Column>& columns) {
  if (columns.empty()) return "";
  std::vector<std::string> entries;
  for (const Setting& entry : table_of(columns).entries) {
    entries.push_back(
        fmt::format("{} = {}", settings::toml_key(entry.key), settings::toml_value(entry)));
  }
  return fmt::format("{} = {{ {} }}\n", key, fmt::join(entries, ", "));
}

std::string_view meaning_of(data::Pairing pairing) {
  switch (pairing) {
    case data::Pairing::rows: return "each row is one comparison";
    case data::Pairing::all: return "each row, i, with each later one, j";
    case data::Pairing::cross: return "each row of file, i, with each row of with, j";
    case data::Pairing::arg_min: return "for each row of file the row of with that costs it least";
  }
  return "";
}

std::string data_text(const NewScene& scene, const LoadedScene& loaded) {
  if (!loaded.data) {
    return "# Data are needed to verify, to profile and to optimise: .csv, .npy or .pdb.\n"
           "# [data]\n"
           "# file = \"points.csv\"           # its columns are called as the inputs above\n"
           "# Without a file: numbers drawn from the ranges of all inputs.\n"
           "# [data]\n"
           "# items = \"uniform\"\n";
  }
  std::string text = fmt::format("# {} comparisons: {}.\n[data]\nfile = {}\n", loaded.data->size(),
                                 meaning_of(scene.pairing), toml_string(scene.file));
  if (!scene.with.empty()) text += fmt::format("with = {}\n", toml_string(scene.with));
  if (scene.pairing != data::Pairing::rows) {
    text += fmt::format("pairs = \"{}\"\n", to_string(scene.pairing));
  }
  return text + columns_text("columns", scene.columns) +
         columns_text("with_columns", scene.with_columns);
}

std::string head_text(const NewScene& scene) {
  return "# Every key of this file: docs/scene_file.md of mixcmp. What comes next:\n#\n" +
         next_text(scene, scene.path.filename(), "#   ");
}

std::string comparison_text(const NewScene& scene) {
  return fmt::format(
      "# The verdict is the order of f and g: less, equal or greater; unordered for a NaN. `name`\n"
      "# begins the names of the generated modules.\n"
      "[comparison]\nname = {}\nf = {}\ng = {}\n",
      toml_string(scene.name), toml_string(scene.f), toml_string(scene.g));
}

std::string formats_text(const NewScene& scene, const LoadedScene& loaded) {
  const FloatFormat format = loaded.scene.reference.format;
  return fmt::format(
      "# What you would trust to decide every comparison, and the format in which operands "
      "arrive:\n"
      "# {} bits of significand, the leading one included, and {} exponent bits.\n"
      "[reference]\nformat = {}\n\n"
      "# The lanes, which decide nearly all comparisons. \"auto\" leaves their format to `mixcmp\n"
      "# optimise`; \"s13e8\" are 13 bits of significand, \"q13\" is fixed point of 13 bits.\n"
      "# \"certified\": a lane decides only where its error bound is proven to allow it.\n"
      "[reduced]\nformat = \"auto\"\nbound = \"certified\"\n",
      format.precision(), format.exponent_bits(), toml_string(scene.reference));
}

std::string system_text(const NewScene& scene, const LoadedScene& loaded) {
  return fmt::format(
      "# A device is an FPGA's part number, a board (`mixcmp devices` lists both), or the path of "
      "a\n"
      "# device file.\n"
      "# How many lanes and references there are `mixcmp optimise` finds out; it leaves the share\n"
      "# `slack` of the device to the rest of your design. Registers are placed for target_mhz, "
      "by\n"
      "# default a clock that suits the device: here {:g}.\n"
      "[system]\ndevice = {}\nlanes = \"auto\"\nreferences = \"auto\"\nslack = 0.2\n",
      loaded.scene.system.target_mhz, toml_string(scene.device));
}

Result<LoadedScene> load_from(settings::Settings all) {
  const std::filesystem::path path = all.path;
  MIXCMP_TRY(scene, scene::interpret({.settings = std::move(all), .plan = {}, .files = {path}}));
  LoadedScene loaded{std::move(scene), std::nullopt};
  if (!loaded.scene.data) return loaded;
  MIXCMP_TRY(data, workload::load_comparisons(loaded.scene));
  loaded.data = std::move(data);
  return loaded;
}

}  // namespace

Result<LoadedScene> load_new(const NewScene& scene) {
  if (const auto device = devices::find_device(scene.device); !device.ok()) {
    return with_option(device.error());
  }
  Result<LoadedScene> loaded = load_from(settings_of(scene));
  if (!loaded.ok()) return with_option(loaded.error());
  // The file says a little more than the options. This text must also load.
  MIXCMP_TRY(written, settings::parse_settings(scene_text(scene, *loaded), scene.path));
  MIXCMP_TRY(same, load_from(std::move(written)));
  return loaded;
}

std::string scene_text(const NewScene& scene, const LoadedScene& loaded) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}", head_text(scene), comparison_text(scene),
                     ranges_text(loaded), formats_text(scene, loaded), system_text(scene, loaded),
                     data_text(scene, loaded));
}

std::vector<std::pair<std::string, std::string>> next_commands(const NewScene& scene,
                                                               const std::filesystem::path& path) {
  const auto plan = path.parent_path() / (path.stem().string() + "_plan.toml");
  std::vector<std::pair<std::string, std::string>> commands = {
      {CommandLine("check", path, {}).text(), "what was understood of it"}};
  if (scene.file.empty()) return commands;
  commands.insert(
      commands.end(),
      {{CommandLine("optimise", path, {}).add("-o", plan.string()).text(),
        "the best system for the device, in minutes"},
       {CommandLine("generate", plan, {}).add("-o", "rtl").text(), "its Verilog"},
       {CommandLine("verify", plan, {}).text(), "simulated on the data, every verdict checked"},
       {CommandLine("report", plan, {}).text(), "an HTML page about all of it"}});
  return commands;
}

std::string next_text(const NewScene& scene, const std::filesystem::path& path,
                      const std::string& margin) {
  const auto commands = next_commands(scene, path);
  std::size_t width = 0;
  for (const auto& [command, purpose] : commands) width = std::max(width, command.size());
  std::string text;
  for (const auto& [command, purpose] : commands) {
    text += fmt::format("{}{:<{}}  {}\n", margin, command, width, purpose);
  }
  return text;
}

}  // namespace mixcmp::cli
