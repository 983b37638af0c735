#include "generator/faces/cli/command_table.hpp"

#include <CLI/CLI.hpp>

#include "generator/faces/cli/verb.hpp"

namespace mixcmp::cli {
namespace {

/// The words of "{embedded,logic,memory}", as CLI11 describes IsMember: it keeps no list that could
/// be asked for. Nothing for any other description.
std::vector<std::string> choice_words(const std::string& description) {
  if (!description.starts_with('{') || !description.ends_with('}')) return {};
  return CLI::detail::split(description.substr(1, description.size() - 2), ',');
}

std::vector<std::string> option_names(const CLI::Option& option) {
  if (option.get_positional()) return {option.get_name()};
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

CommandOption table_entry(const CLI::Option& option) {
  CommandOption described{.names = option_names(option),
                          .help = option.get_description(),
                          .is_argument = option.get_positional(),
                          .required = option.get_required(),
                          .repeated = option.get_items_expected_max() > 1};
  if (option.get_items_expected_max() == 0) return described;  // a flag
  described.type = option.get_type_name();
  // After the type and a colon come the words of the option's validator.
  described.choices = choice_words(described.type.substr(described.type.find(':') + 1));
  described.value = described.type == path_placeholder ? OptionValue::path
                    : described.choices.empty()        ? OptionValue::text
                                                       : OptionValue::choice;
  return described;
}

CommandEntry table_entry(const CLI::App& app) {
  CommandEntry command{.name = app.get_name(), .help = app.get_description(), .options = {}};
  for (const CLI::Option* option : app.get_options())
    command.options.push_back(table_entry(*option));
  return command;
}

}  // namespace

CommandTable command_table(const CLI::App& app) {
  CommandTable table{.program = table_entry(app), .verbs = {}};
  for (const CLI::App* verb : app.get_subcommands({})) table.verbs.push_back(table_entry(*verb));
  return table;
}

std::vector<std::string> verbs_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* verb : app.get_subcommands({})) names.push_back(verb->get_name());
  return names;
}

}  // namespace mixcmp::cli
