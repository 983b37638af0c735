#include <fmt/core.h>
#include <fmt/ranges.h>

#include "generator/cli/completion.hpp"

namespace mixcmp::cli {
namespace {

/// Text inside '...[TEXT]...' of _arguments: in single quotes, with brackets and colons escaped.
std::string zsh_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
      continue;
    }
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

/// ":MESSAGE:ACTION" of an option's value; nothing for a flag.
std::string zsh_value(const CommandOption& option) {
  const std::string message = zsh_text(option.type);
  switch (option.value) {
    case OptionValue::none: return "";
    case OptionValue::path: return fmt::format(":{}:_files", message);
    case OptionValue::choice:
      return fmt::format(":{}:({})", message, fmt::join(option.choices, " "));
    case OptionValue::text: return fmt::format(":{}: ", message);
  }
  return "";
}

/// The specification of argument number `number`, from 1 on, for _arguments.
std::string argument_specification(const CommandOption& option, int number) {
  const std::string place = option.repeated ? "*" : std::to_string(number);
  return fmt::format("        '{}{}' \\\n", place, zsh_value(option));
}

/// The specifications of one option for _arguments, one per name, each on a line.
std::string specifications(const CommandOption& option) {
  // Names of one option exclude each other, unless it may be repeated.
  const std::string others =
      option.repeated ? "*" : fmt::format("({})", fmt::join(option.names, " "));
  std::string text;
  for (const std::string& name : option.names) {
    text += fmt::format("        '{}{}[{}]{}' \\\n", others, name, zsh_text(option.help),
                        zsh_value(option));
  }
  return text;
}

std::string zsh_arguments(const CommandEntry& command) {
  std::string text = "_arguments \\\n";
  int number = 0;
  for (const CommandOption& option : command.options) {
    text += option.is_argument ? argument_specification(option, ++number) : specifications(option);
  }
  return text;
}

}  // namespace

std::string zsh_completion(const CommandTable& table) {
  std::string verbs, cases;
  for (const CommandEntry& verb : table.verbs) {
    verbs += fmt::format("    '{}:{}'\n", verb.name, zsh_text(verb.help));
    cases += fmt::format("      {})\n      {}        && return\n      ;;\n", verb.name,
                         zsh_arguments(verb));
  }
  return fmt::format(R"(#compdef mixcmp
# Completion of mixcmp for zsh, printed by: mixcmp completion zsh
_mixcmp() {{
  local state line
  local -a verbs=(
{}  )
  {}        '1:verb:->verb' '*::argument:->argument' && return
  case $state in
    verb) _describe 'verb' verbs ;;
    argument)
      case $line[1] in
{}      esac ;;
  esac
}}
_mixcmp "$@"
)",
                     verbs, "_arguments -C" + zsh_arguments(table.program).substr(10), cases);
}

}  // namespace mixcmp::cli
