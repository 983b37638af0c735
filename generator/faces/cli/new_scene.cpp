#include "generator/faces/cli/new_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "generator/faces/cli/new_formats.hpp"
#include "generator/faces/cli/new_functions.hpp"
#include "model/base/settings/settings.hpp"
#include "model/comparison/expression/parser.hpp"
#include "model/cost/devices/device.hpp"
#include "model/judge/workload/load_comparisons.hpp"
#include "model/scene/plan.hpp"

namespace mixcmp::cli {
namespace {

using settings::Setting;
using settings::toml_string;

/// Some reference in fixed point, until the ranges are known.
constexpr const char* first_fixed_reference = "q24";

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

Setting range_of(const Range& range) {
  Setting::Array ends(2);
  ends[0].value = range.low.get_d();
  ends[1].value = range.high.get_d();
  return {.key = "range", .value = std::move(ends)};
}

settings::Settings settings_of(const NewScene& scene, const NewFormats& formats) {
  settings::Settings all{.path = scene.path, .root = {}};
  put(all.root, "comparison", "name", scene.name);
  put(all.root, "comparison", "f", scene.f);
  put(all.root, "comparison", "g", scene.g);
  put(all.root, "reference", "format", formats.reference);
  for (const auto& [input, format] : formats.operands) {
    put(all.root, "inputs", input, {{"format", format}});
    if (!formats.range || OperandFormat::parse(format)->floating() == nullptr) continue;
    auto& inputs = std::get<Setting::Table>(settings::find_or_add(all.root, "inputs").value);
    std::get<Setting::Table>(settings::find_or_add(inputs, input).value)
        .entries.push_back(scene.file.empty()
                               ? range_of(*formats.range)
                               : Setting{.key = "range", .value = std::string("data")});
  }
  put(all.root, "system", "device", scene.device);
  if (scene.file.empty()) {
    if (formats.range) put(all.root, "data", "items", std::string("uniform"));
    return all;
  }
  put(all.root, "data", "file", scene.file);
  if (scene.pairing != data::Pairing::rows) {
    put(all.root, "data", "pairs", std::string(to_string(scene.pairing)));
  }
  if (!scene.with.empty()) put(all.root, "data", "with", scene.with);
  put(all.root, "data", "columns", scene.columns);
  put(all.root, "data", "with_columns", scene.with_columns);
  return all;
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

/// The formats of operands in floating point. Where the user asks for exact references, the data
/// must be seen first.
NewFormats plain_formats(const NewScene& scene) {
  const bool is_open = scene.reference.empty() || scene.reference == "exact";
  return {.reference = is_open ? "s53e8" : scene.reference};
}

/// Whether operands are to arrive as integers, since the user or the type of the data says so.
bool wants_integers(const NewScene& scene, const LoadedScene& loaded) {
  if (!scene.reference.empty()) return scene.reference == "exact";
  return are_integers(types_of_data(loaded));
}

/// The scene with integers as operands; else why its systems cannot have the first choice of these.
Result<LoadedScene> with_integers(const NewScene& scene, const LoadedScene& loaded) {
  Error reason{.field = "reference.format",
               .message = "exact references need operands in fixed point",
               .received = loaded.data ? "data whose numbers are not all whole" : "no data",
               .accepted = "data whose numbers are all whole"};
  bool is_first = true;
  for (const NewFormats& formats : integer_formats(loaded)) {
    Result<LoadedScene> tried = load_from(settings_of(scene, formats));
    const Result<Done> possible =
        tried.ok() ? check_integers(tried->scene) : Result<Done>(tried.error());
    if (possible.ok()) return tried;
    if (is_first) reason = possible.error();
    is_first = false;
  }
  return reason;
}

/// Whether references are to be in fixed point: the user says so, or leaves it open and has a
/// function.
bool wants_fixed_references(const NewScene& scene) {
  if (FixedPoint::parse(scene.reference)) return true;
  if (!scene.reference.empty()) return false;
  Graph graph;
  for (const std::string& side : {scene.f, scene.g}) {
    if (!parse_expression(graph, side, {}).ok()) return false;
  }
  return graph.first_function().has_value();
}

/// The scene with references in fixed point, whose bits follow from the ranges of the data unless
/// the user has chosen them.
Result<LoadedScene> with_fixed_references(const NewScene& scene) {
  NewFormats formats{.reference = scene.reference.empty() ? first_fixed_reference : scene.reference,
                     .operands = {{"*", "binary32"}},
                     .range = assumed_range()};
  MIXCMP_TRY(first, load_from(settings_of(scene, formats)));
  formats.operands = function_operands(first);
  if (scene.reference.empty()) {
    MIXCMP_TRY(reference, function_reference(first));
    formats.reference = reference;
  }
  return load_from(settings_of(scene, formats));
}

/// The scene in the formats that suit its data, unless the user has chosen the reference's.
Result<LoadedScene> with_suitable_formats(const NewScene& scene) {
  if (wants_fixed_references(scene)) return with_fixed_references(scene);
  Result<LoadedScene> plain = load_from(settings_of(scene, plain_formats(scene)));
  if (!plain.ok()) return plain;
  if (wants_integers(scene, *plain)) {
    Result<LoadedScene> integers = with_integers(scene, *plain);
    const bool is_asked_for = !scene.reference.empty();
    return integers.ok() || is_asked_for ? std::move(integers) : std::move(plain);
  }
  if (!scene.reference.empty() || !are_single(types_of_data(*plain))) return plain;
  Result<LoadedScene> single = load_from(settings_of(scene, {.reference = "s24e8"}));
  return single.ok() ? std::move(single) : std::move(plain);
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

/// An input's line, with its numbers in a comment.
std::string input_line(const std::string& input, const std::string& promise,
                       const Numbers& numbers) {
  if (!numbers.any()) return fmt::format("# {}: the data have no finite number for it\n", input);
  const std::string entry = fmt::format("{} = {{ {} }}", input, promise);
  return fmt::format("{:<32} # now {:.6g} to {:.6g}\n", entry, numbers.low, numbers.high);
}

/// Text has no types: a comment tells how its numbers may arrive as integers.
std::string integers_hint(const NewScene& scene, const LoadedScene& loaded) {
  if (!types_of_data(loaded).empty()) return "";
  for (const NewFormats& formats : integer_formats(loaded)) {
    const auto tried = load_from(settings_of(scene, formats));
    if (!tried.ok() || !check_integers(tried->scene).ok()) return "";
    return fmt::format(
        "# All numbers are whole. If your hardware meets no others, let them arrive as integers:\n"
        "# ports are narrower, and lanes may be exact. In place of these lines and of\n"
        "# reference.format:\n"
        "# \"*\" = {{ format = \"{}\" }}\n",
        formats.operands.at("*"));
  }
  return "";
}

std::string integers_text(const LoadedScene& loaded) {
  std::string text =
      "# The integers in which operands arrive. A narrower format saves hardware, and a number of\n"
      "# the data that it lacks is an error.";
  if (const std::optional<OperandFormat> narrowest = narrowest_integers(loaded)) {
    text += fmt::format(" These data need only \"{}\".", narrowest->name());
  }
  text += "\n[inputs]\n";
  const std::vector<std::string>& inputs = loaded.scene.graph.inputs();
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const std::string format = loaded.scene.operand_formats[k].name();
    text +=
        input_line(inputs[k], fmt::format("format = \"{}\"", format), numbers_of(*loaded.data, k));
  }
  return text;
}

/// The format of an input whose type in the data's file is narrower than the reference's, as the
/// beginning of a declaration; empty for others.
std::string narrower_format(const LoadedScene& loaded, const std::vector<OperandFormat>& types,
                            std::size_t input) {
  const FloatFormat reference = loaded.scene.reference.format;
  if (types.empty() || types[input].floating() == nullptr || !types[input].is_held_by(reference) ||
      *types[input].floating() == reference) {
    return "";
  }
  return fmt::format("format = \"{}\", ", types[input].name());
}

/// The inputs of a scene whose references are in fixed point: each has a format, and those in
/// floating point have a range.
std::string fixed_inputs_text(const LoadedScene& loaded, bool has_file) {
  std::string text =
      has_file
          ? "# The range of an input is a promise: numbers beyond the next power of two make the\n"
            "# verdict unordered. \"data\" takes the least and the greatest number of the data.\n"
            "# Better, write what your hardware will meet: range = [0, 100].\n[inputs]\n"
          : "# Write the ranges that your hardware will meet in place of these: numbers beyond "
            "the\n"
            "# next power of two make the verdict unordered. Wider ranges may ask for more bits "
            "in\n"
            "# reference.format.\n[inputs]\n";
  const std::vector<std::string>& inputs = loaded.scene.graph.inputs();
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const OperandFormat& format = loaded.scene.operand_formats[k];
    std::string promise = fmt::format("format = \"{}\"", format.name());
    if (format.floating() != nullptr)
      promise += has_file
                     ? ", range = \"data\""
                     : fmt::format(", range = {}", settings::toml_value(range_of(assumed_range())));
    text += has_file ? input_line(inputs[k], promise, numbers_of(*loaded.data, k))
                     : fmt::format("{} = {{ {} }}\n", inputs[k], promise);
  }
  return text;
}

std::string ranges_text(const NewScene& scene, const LoadedScene& loaded) {
  if (loaded.scene.reference_fixed_point) return fixed_inputs_text(loaded, !scene.file.empty());
  if (arrive_as_integers(loaded.scene)) return integers_text(loaded);
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
  const std::vector<OperandFormat> types = types_of_data(loaded);
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    text += input_line(inputs[k], narrower_format(loaded, types, k) + "range = \"data\"",
                       numbers_of(*loaded.data, k));
  }
  return text + integers_hint(scene, loaded);
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
  if (loaded.data && scene.file.empty()) {
    return "# Numbers drawn from the ranges of the inputs, until you have data: .csv, .npy or "
           ".pdb.\n"
           "# Then, in place of items: file = \"points.csv\", whose columns are called as the "
           "inputs.\n"
           "[data]\nitems = \"uniform\"\n";
  }
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

std::string head_text(const NewScene& scene, const LoadedScene& loaded) {
  return "# Every key of this file: docs/scene_file.md of mixcmp. What comes next:\n#\n" +
         next_text(loaded, scene.path.filename(), "#   ");
}

std::string comparison_text(const NewScene& scene) {
  return fmt::format(
      "# The verdict is the order of f and g: less, equal or greater; unordered for a NaN. `name`\n"
      "# begins the names of the generated modules.\n"
      "[comparison]\nname = {}\nf = {}\ng = {}\n",
      toml_string(scene.name), toml_string(scene.f), toml_string(scene.g));
}

std::string exact_formats_text() {
  return "# What decides close comparisons: \"exact\" rounds nothing.\n"
         "[reference]\nformat = \"exact\"\n\n"
         "# The lanes, which decide nearly all comparisons. \"auto\" leaves their format to "
         "`mixcmp\n"
         "# optimise`; \"q13\" is fixed point of 13 bits. \"exact\" takes the bits that round "
         "nothing:\n"
         "# such lanes need no references. \"certified\": a lane decides only where its error "
         "bound is\n"
         "# proven to allow it.\n"
         "[reduced]\nformat = \"auto\"\nbound = \"certified\"\n";
}

std::string fixed_formats_text(const FixedPoint& reference) {
  return fmt::format(
      "# What you would trust to decide every comparison: functions are computed in fixed point, "
      "here\n"
      "# of {} bits below the power of two above each range. `mixcmp check` says by how much f - "
      "g\n"
      "# errs; \"q{}\" errs less and costs more.\n"
      "[reference]\nformat = \"{}\"\n\n"
      "# The lanes, which decide nearly all comparisons. \"auto\" leaves their format to `mixcmp\n"
      "# optimise`; \"q13\" is fixed point of 13 bits. \"certified\": a lane decides only where "
      "its "
      "error\n"
      "# bound is proven to allow it.\n"
      "[reduced]\nformat = \"auto\"\nbound = \"certified\"\n",
      reference.bits, reference.bits + 4, reference.name());
}

std::string formats_text(const NewScene& scene, const LoadedScene& loaded) {
  if (const auto& reference = loaded.scene.reference_fixed_point) {
    return fixed_formats_text(*reference);
  }
  if (arrive_as_integers(loaded.scene)) return exact_formats_text();
  const FloatFormat format = loaded.scene.reference.format;
  const bool follows_data = scene.reference.empty() && are_single(types_of_data(loaded));
  const char* const reason =
      follows_data ? "# The data have at most single precision. \"s53e8\" would decide in 53 "
                     "digits.\n"
                   : "";
  return reason +
         fmt::format(
             "# What you would trust to decide every comparison, and the format of operands that "
             "have no\n"
             "# other: {} bits of significand, the leading one included, and {} exponent bits.\n"
             "[reference]\nformat = {}\n\n"
             "# The lanes, which decide nearly all comparisons. \"auto\" leaves their format to "
             "`mixcmp\n"
             "# optimise`; \"s13e8\" are 13 bits of significand, \"q13\" is fixed point of 13 "
             "bits.\n"
             "# \"certified\": a lane decides only where its error bound is proven to allow it.\n"
             "[reduced]\nformat = \"auto\"\nbound = \"certified\"\n",
             format.precision(), format.exponent_bits(),
             toml_string(scene.reference.empty() ? format.name() : scene.reference));
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

}  // namespace

Result<LoadedScene> load_new(const NewScene& scene) {
  if (const auto device = devices::find_device(scene.device); !device.ok()) {
    return with_option(device.error());
  }
  Result<LoadedScene> loaded = with_suitable_formats(scene);
  if (!loaded.ok()) return with_option(loaded.error());
  // The file says a little more than the options. This text must also load.
  MIXCMP_TRY(written, settings::parse_settings(scene_text(scene, *loaded), scene.path));
  MIXCMP_TRY(same, load_from(std::move(written)));
  return loaded;
}

std::optional<Error> why_not_integers(const NewScene& scene, const LoadedScene& loaded) {
  if (loaded.scene.reference_fixed_point) return std::nullopt;
  if (!scene.reference.empty() || arrive_as_integers(loaded.scene)) return std::nullopt;
  const std::vector<OperandFormat> types = types_of_data(loaded);
  if (are_integers(types)) return with_integers(scene, loaded).error();
  const auto integer = std::find_if(types.begin(), types.end(), [](const OperandFormat& type) {
    return type.fixed() != nullptr;
  });
  if (integer == types.end()) return std::nullopt;
  return Error{.message = "not all columns have integers",
               .received = integer->name() + " beside floats",
               .accepted = "columns of integers only"};
}

std::string scene_text(const NewScene& scene, const LoadedScene& loaded) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}", head_text(scene, loaded), comparison_text(scene),
                     ranges_text(scene, loaded), formats_text(scene, loaded),
                     system_text(scene, loaded), data_text(scene, loaded));
}

std::vector<std::pair<std::string, std::string>> next_commands(const LoadedScene& loaded,
                                                               const std::filesystem::path& path) {
  const auto plan = path.parent_path() / (path.stem().string() + "_plan.toml");
  std::vector<std::pair<std::string, std::string>> commands = {
      {CommandLine("check", path, {}).text(), "what was understood of it"}};
  if (!loaded.data) return commands;
  commands.insert(
      commands.end(),
      {{CommandLine("optimise", path, {}).add("-o", plan.string()).text(),
        "the best system for the device, in minutes"},
       {CommandLine("generate", plan, {}).add("-o", "rtl").text(), "its Verilog"},
       {CommandLine("verify", plan, {}).text(), "simulated on the data, every verdict checked"},
       {CommandLine("report", plan, {}).text(), "an HTML page about all of it"}});
  return commands;
}

std::string next_text(const LoadedScene& loaded, const std::filesystem::path& path,
                      const std::string& margin) {
  const auto commands = next_commands(loaded, path);
  std::size_t width = 0;
  for (const auto& [command, purpose] : commands) width = std::max(width, command.size());
  std::string text;
  for (const auto& [command, purpose] : commands) {
    text += fmt::format("{}{:<{}}  {}\n", margin, command, width, purpose);
  }
  return text;
}

}  // namespace mixcmp::cli
