#include <fmt/core.h>
#include <fmt/ranges.h>

#include "generator/cli/completion.hpp"

namespace mixcmp::cli {
namespace {

/// Text in single quotes of fish, where a backslash escapes quotes and itself.
std::string fish_text(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result + "'";
}

/// The flags of `complete` for an option's value: none, a file, one of some words, or any text.
std::string fish_value(const CommandOption& option) {
  switch (option.value) {
    case OptionValue::none: return "";
    case OptionValue::path: return " -r -F";
    case OptionValue::choice:
      return fmt::format(" -x -a {}", fish_text(fmt::format("{}", fmt::join(option.choices, " "))));
    case OptionValue::text: return " -x";
  }
  return "";
}

std::string fish_names(const CommandOption& option) {
  std::string text;
  for (const std::string& name : option.names) {
    const bool is_long = name.starts_with("--");
    text += fmt::format(" -{} {}", is_long ? 'l' : 's', name.substr(is_long ? 2 : 1));
  }
  return text;
}

/// One line: the option under this condition.
std::string fish_line(const CommandOption& option, const std::string& condition) {
  if (!option.is_argument) {
    return fmt::format("complete -c mixcmp -n {}{} -d {}{}\n", condition, fish_names(option),
                       fish_text(option.help), fish_value(option));
  }
  const bool is_path = option.value == OptionValue::path;
  return fmt::format("complete -c mixcmp -n {}{}\n", condition,
                     is_path ? " -F" : fish_value(option));
}

}  // namespace

std::string fish_completion(const CommandTable& table) {
  std::string text =
      "# Completion of mixcmp for fish, printed by: mixcmp completion fish\n"
      "complete -c mixcmp -f\n";
  const std::string no_verb = "__fish_use_subcommand";
  for (const CommandOption& option : table.program.options) text += fish_line(option, no_verb);
  for (const CommandEntry& verb : table.verbs) {
    text += fmt::format("complete -c mixcmp -n {} -a {} -d {}\n", no_verb, verb.name,
                        fish_text(verb.help));
  }
  for (const CommandEntry& verb : table.verbs) {
    const std::string condition = fish_text("__fish_seen_subcommand_from " + verb.name);
    for (const CommandOption& option : verb.options) text += fish_line(option, condition);
  }
  return text;
}

}  // namespace mixcmp::cli
