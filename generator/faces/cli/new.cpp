#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/new_scene.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/present/report/json_text.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/output_file.hpp"
#include "model/base/common/quote.hpp"
#include "model/comparison/data/input_sources.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;
using data::Pairing;

constexpr std::array pairings = {Pairing::rows, Pairing::all, Pairing::cross, Pairing::arg_min};

struct NewCommand {
  NewScene scene;
  std::string pairs;  ///< empty: as the names of inputs and columns suggest
  std::string data;   ///< as typed, from the working directory
  std::string with;
  std::vector<std::string> columns;
  std::vector<std::string> with_columns;
  fs::path output;
  bool json = false;
};

/// The answer to a question, or the error that its option is missing where nobody can be asked.
std::string answer_to(const std::string& question, const std::string& option) {
  const Error missing{.field = option,
                      .message = "missing",
                      .received = "nothing",
                      .accepted = option + ", or an answer on a terminal"};
  if (!can_ask()) fail(missing);
  const std::optional<std::string> answer = ask(question);
  if (!answer) fail(missing);
  if (is_one_line(*answer)) return *answer;
  fail({.field = option,
        .message = "cannot be written into files",
        .received = in_quotes(*answer),
        .accepted = "UTF-8 without control characters"});
}

Result<Done> check_new(const fs::path& path) {
  if (!path_exists(path)) return check_writable({path});
  return Error{.file = path.string(),
               .message = "is not replaced",
               .received = "a file that exists",
               .accepted = "-o with another name"};
}

fs::path path_of(const NewCommand& command) {
  return command.output.empty() ? fs::path(command.scene.name + ".toml") : command.output;
}

/// Checks the command without its data. Simple expressions stand for answers that are still
/// missing.
Result<Done> check_so_far(const NewCommand& command) {
  NewScene scene = command.scene;
  scene.path = path_of(command);
  if (!command.output.empty() || !scene.name.empty()) {
    MIXCMP_DO(check_new(scene.path));
  }
  if (scene.name.empty()) scene.name = "unnamed";
  if (scene.f.empty()) scene.f = "x";
  if (scene.g.empty()) scene.g = "y";
  MIXCMP_TRY(loaded, load_new(scene));
  return Done{};
}

/// Asks for a text that the command does not give, until an answer is right.
void ask_if_empty(NewCommand& command, std::string NewScene::*text, const std::string& question,
                  const std::string& option) {
  if (!(command.scene.*text).empty()) return;
  while (true) {
    command.scene.*text = answer_to(question, option);
    if ((command.scene.*text).empty()) continue;
    const Result<Done> checked = check_so_far(command);
    if (checked.ok()) return;
    tell(checked.error().to_string());
  }
}

/// Asks for the parts that a scene must have and the command does not give. Returns whether any was
/// missing. The options given are checked before the first question.
bool ask_for_missing(NewCommand& command) {
  const NewScene& scene = command.scene;
  if (!scene.name.empty() && !scene.f.empty() && !scene.g.empty()) return false;
  if (can_ask()) value_or_exit(check_so_far(command));
  ask_if_empty(command, &NewScene::name, "A name, which the Verilog modules get: ", "NAME");
  ask_if_empty(command, &NewScene::f, "f, one side of the comparison, such as (x - y)^2: ", "--f");
  ask_if_empty(command, &NewScene::g, "g, the other side, such as r^2: ", "--g");
  return true;
}

/// The path with which the scene's file in `folder` names a file.
std::string seen_from(const fs::path& folder, const std::string& path) {
  if (path.empty() || fs::path(path).is_absolute()) return path;
  std::error_code failed;
  const fs::path from = fs::weakly_canonical(fs::current_path() / folder, failed);
  const fs::path file = fs::absolute(path);
  const fs::path parent = fs::weakly_canonical(file.parent_path(), failed);
  return (parent / file.filename()).lexically_relative(from).generic_string();
}

/// Reads "name=column".
Result<NewScene::Column> column_of(const std::string& word, const std::string& option) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == word.size()) {
    return Error{.field = option,
                 .message = "no column",
                 .received = in_quotes(word),
                 .accepted = "name=column, such as x=width, x=0 or p=width,height"};
  }
  return NewScene::Column{word.substr(0, equals), word.substr(equals + 1)};
}

std::vector<NewScene::Column> columns_of(const std::vector<std::string>& words,
                                         const std::string& option) {
  std::vector<NewScene::Column> columns;
  for (const std::string& word : words) columns.push_back(value_or_exit(column_of(word, option)));
  return columns;
}

Pairing pairing_of(const std::string& word) {
  for (const Pairing pairing : pairings) {
    if (word == to_string(pairing)) return pairing;
  }
  MIXCMP_CHECK(false);
}

/// The pairings that may be meant, the likeliest first.
std::vector<Pairing> possible_pairings(const NewCommand& command) {
  if (!command.pairs.empty()) return {pairing_of(command.pairs)};
  if (!command.with.empty()) return {Pairing::cross};
  if (command.data.empty()) return {Pairing::rows};
  return {Pairing::rows, Pairing::all};
}

/// How many inputs name a column of an item i or j.
enum class ItemNames { none, some, all };

ItemNames item_names_of(const NewScene& scene) {
  NewScene without_data = scene;
  without_data.file.clear();
  const auto loaded = load_new(without_data);
  if (!loaded.ok()) return ItemNames::none;
  const std::vector<std::string>& inputs = loaded->scene.graph.inputs();
  const auto items = std::count_if(inputs.begin(), inputs.end(), [](const std::string& input) {
    return data::item_column(input).has_value();
  });
  if (items == 0) return ItemNames::none;
  return static_cast<std::size_t>(items) == inputs.size() ? ItemNames::all : ItemNames::some;
}

/// An error that follows from a guessed pairing, with the guess: the user did not give it. Where no
/// input names an item, nothing but rows was meant.
Error with_guess(Error error, Pairing guessed, ItemNames names) {
  if (error.file != "--pairs" && error.kind != ErrorKind::missing_column) return error;
  if (guessed == Pairing::rows && names == ItemNames::none) return error;
  const bool is_cross = guessed == Pairing::cross;
  const char* const reason = is_cross                   ? "--with gives a second file"
                             : guessed == Pairing::rows ? "not all inputs end in i or j"
                                                        : "all inputs end in i or j";
  if (error.file == "--pairs") error.file = is_cross ? "--with" : "--data";
  error.message += fmt::format(" (pairs = {} is a guess, since {}; --pairs chooses)",
                               to_string(guessed), reason);
  return error;
}

/// Loads the scene with the first pairing that suits the data, and puts that pairing into `scene`.
/// If none does, the error is that of the pairing that the inputs' names suggest: if all of them
/// name items, an error of pairs tells more than one of rows.
Result<LoadedScene> load_with_pairing(const NewCommand& command, NewScene& scene) {
  const std::vector<Pairing> possible = possible_pairings(command);
  for (const Pairing pairing : possible) {
    scene.pairing = pairing;
    Result<LoadedScene> loaded = load_new(scene);
    if (loaded.ok()) return loaded;
  }
  const ItemNames names = item_names_of(scene);
  scene.pairing =
      possible.size() > 1 && names != ItemNames::all ? possible.front() : possible.back();
  Result<LoadedScene> loaded = load_new(scene);
  if (loaded.ok() || !command.pairs.empty()) return loaded;
  return with_guess(loaded.error(), scene.pairing, names);
}

/// Asks which column is meant by a name that the data do not have. `missing` is the error if the
/// user gives up.
NewScene::Column ask_for_column(const Error& missing) {
  while (true) {
    const std::string word = answer_to(
        "Which column is it (name=column, such as x=width; empty: give up)? ", "--column");
    if (word.empty()) fail(missing);
    const Result<NewScene::Column> column = column_of(word, "--column");
    if (column.ok()) return *column;
    tell(column.error().to_string());
  }
}

/// Loads the scene. On a terminal, asks which column is meant for one that the data do not have.
Result<LoadedScene> load_or_ask(const NewCommand& command, NewScene& scene) {
  while (true) {
    Result<LoadedScene> loaded = load_with_pairing(command, scene);
    if (loaded.ok()) return loaded;
    const Error& error = loaded.error();
    if (error.kind != ErrorKind::missing_column || !can_ask()) return error;
    tell(error.to_string());
    const bool second = error.field == "data.with" || error.file.ends_with(scene.with);
    auto& columns = !scene.with.empty() && second ? scene.with_columns : scene.columns;
    columns.push_back(ask_for_column(error));
  }
}

/// Asks for data until they can be loaded, or none are given.
LoadedScene load_with_data_asked_for(NewCommand& command) {
  NewScene& scene = command.scene;
  while (true) {
    command.data = answer_to("A file of data, .csv, .npy or .pdb (empty: none): ", "--data");
    scene.file = seen_from(scene.path.parent_path(), command.data);
    scene.columns.clear();
    Result<LoadedScene> loaded = load_or_ask(command, scene);
    if (loaded.ok()) return std::move(loaded).value();
    if (command.data.empty()) fail(loaded.error());
    tell(loaded.error().to_string());
  }
}

nlohmann::ordered_json to_json(const NewScene& scene, const LoadedScene& loaded) {
  nlohmann::ordered_json json = {{"scene", scene.path.string()},
                                 {"inputs", loaded.scene.graph.inputs()}};
  if (loaded.data) {
    json["pairs"] = to_string(scene.pairing);
    json["comparisons"] = loaded.data->size();
  }
  for (const auto& [command, purpose] : next_commands(loaded, scene.path))
    json["next"].push_back(command);
  return json;
}

std::string to_text(const NewScene& scene, const LoadedScene& loaded) {
  std::string text = fmt::format("{}: {}\n", scene.path.string(), loaded.scene.name);
  if (loaded.data) {
    for (const data::InputSource& input :
         data::input_sources(*loaded.data, loaded.scene.graph.inputs())) {
      text += fmt::format("  {:<12} <- {}\n", input.input, input.shown());
    }
    text += fmt::format("  {} comparisons, pairs = {}\n", loaded.data->size(),
                        to_string(scene.pairing));
  }
  return text + "next:\n" + next_text(loaded, scene.path, "  ");
}

void run(NewCommand& command) {
  const bool asked = ask_for_missing(command);
  NewScene& scene = command.scene;
  scene.path = path_of(command);
  value_or_exit(check_new(scene.path));
  scene.file = seen_from(scene.path.parent_path(), command.data);
  scene.with = seen_from(scene.path.parent_path(), command.with);
  scene.columns = columns_of(command.columns, "--column");
  scene.with_columns = columns_of(command.with_columns, "--with-column");
  const LoadedScene loaded = asked && command.data.empty() && can_ask()
                                 ? load_with_data_asked_for(command)
                                 : value_or_exit(load_or_ask(command, scene));
  value_or_exit(write_new_file(scene.path, scene_text(scene, loaded)));
  if (const std::optional<Error> reason = why_not_integers(scene, loaded)) {
    tell_note("the data have integers, but operands arrive in " +
              loaded.scene.reference.format.name() + ": " + reason->message);
  }
  print(command.json ? report::json_text(to_json(scene, loaded)) : to_text(scene, loaded));
}

void add_options(const Verb& verb, NewCommand& command) {
  NewScene& scene = command.scene;
  verb.option("NAME", scene.name, "of the comparison; the file is NAME.toml");
  verb.option("--f", scene.f, "one side of the comparison (docs/scene_file.md, Expressions)");
  verb.option("--g", scene.g, "the other side; the verdict is the order of f and g");
  const Option data = verb.option("--data", command.data, "a .csv, .npy or .pdb file");
  verb.option("--pairs", command.pairs,
              "what is compared: rows, each one comparison; all, each two of a file; cross, each "
              "of --data with each of --with; arg_min (default: as the columns' names suggest)")
      .one_of({"rows", "all", "cross", "arg_min"})
      .needs(data);
  const Option with = verb.option("--with", command.with, "the second file of cross and arg_min");
  with.needs(data);
  verb.option("--column", command.columns,
              "a column of --data that is called or numbered otherwise: x=width, x=0, "
              "p=width,height; may be repeated")
      .one_value_each()
      .needs(data);
  verb.option("--with-column", command.with_columns, "likewise, a column of --with")
      .one_value_each()
      .needs(with);
  verb.option(
      "--reference", scene.reference,
      "format of the operands and of what decides close comparisons (default: as the data suggest: "
      "exact for integers and s24e8 for single precision in .npy, qW such as q32 beside functions, "
      "otherwise s53e8)");
  verb.option("--device", scene.device,
              "the device to fill (default: " + scene::SystemSpec().device + ")");
  verb.option("-o,--output", command.output, "the file, which must not exist (default: NAME.toml)");
  verb.flag("--json", command.json, "print the result as JSON");
}

}  // namespace

void add_new(CLI::App& app) {
  const Verb verb(app, "new", "write a scene file from f, g and data; asks for what is missing");
  auto command = std::make_shared<NewCommand>();
  command->scene.device = scene::SystemSpec().device;
  add_options(verb, *command);
  verb.when_chosen([command] { run(*command); });
}

}  // namespace mixcmp::cli
