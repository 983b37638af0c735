#include <fmt/core.h>
#include <fmt/ranges.h>

#include "generator/cli/completion.hpp"

namespace mixcmp::cli {
namespace {

std::vector<std::string> bash_options(const CommandEntry& command) {
  std::vector<std::string> names;
  for (const CommandOption& option : command.options) {
    if (!option.is_argument) names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

/// One branch of `case`: the commands for these places.
std::string bash_branch(const std::vector<std::string>& places, const std::string& commands) {
  return fmt::format("    {}) {} ;;\n", fmt::join(places, " | "), commands);
}

/// The commands that offer an option's or argument's value.
std::string bash_value(const CommandOption& option) {
  switch (option.value) {
    case OptionValue::choice: return fmt::format("words=\"{}\"", fmt::join(option.choices, " "));
    case OptionValue::path: return "paths=yes";
    case OptionValue::none:
    case OptionValue::text: return ":";
  }
  return ":";
}

/// The branches for values of the verb's options: "VERB OPTION".
std::string bash_value_branches(const CommandEntry& verb) {
  std::string text;
  for (const CommandOption& option : verb.options) {
    if (option.is_argument || option.value == OptionValue::none) continue;
    std::vector<std::string> places;
    for (const std::string& name : option.names) {
      places.push_back(fmt::format("\"{} {}\"", verb.name, name));
    }
    text += bash_branch(places, bash_value(option));
  }
  return text;
}

/// The branches for the verb's arguments: "VERB NUMBER", from 1 on.
std::string bash_argument_branches(const CommandEntry& verb) {
  std::string text;
  int number = 0;
  for (const CommandOption& option : verb.options) {
    if (!option.is_argument) continue;
    ++number;
    const std::string place = option.repeated ? fmt::format("\"{} \"*", verb.name)
                                              : fmt::format("\"{} {}\"", verb.name, number);
    text += bash_branch({place}, bash_value(option));
  }
  return text;
}

std::string bash_option_branch(const CommandEntry& verb) {
  return bash_branch({verb.name},
                     fmt::format("options=\"{}\"", fmt::join(bash_options(verb), " ")));
}

}  // namespace

std::string bash_completion(const CommandTable& table) {
  std::vector<std::string> verbs;
  std::string values, arguments, options;
  for (const CommandEntry& verb : table.verbs) {
    verbs.push_back(verb.name);
    values += bash_value_branches(verb);
    arguments += bash_argument_branches(verb);
    options += bash_option_branch(verb);
  }
  return fmt::format(
      R"(# Completion of mixcmp for bash, printed by: mixcmp completion bash
# Offers the value of option $2 of verb $1; fails where that is no option with a value.
_mixcmp_value() {{
  case "$1 $2" in
{1}    *) return 1 ;;
  esac
}}
# Offers argument number $2 of verb $1.
_mixcmp_argument() {{
  case "$1 $2" in
{2}  esac
}}
_mixcmp_options() {{
  case "$1" in
{3}  esac
}}
_mixcmp() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
  local verb="" words="" options="" paths="" number=1 word k
  for ((k = 1; k < COMP_CWORD; ++k)); do
    word=${{COMP_WORDS[k]}}
    if [[ -z $verb ]]; then
      case " {0} " in
        *" $word "*) verb=$word ;;
      esac
    elif _mixcmp_value "$verb" "$word"; then
      ((++k))
    elif [[ $word != -* ]]; then
      ((++number))
    fi
  done
  words="" paths=""
  if [[ -z $verb ]]; then
    words="{0}" options="{4}"
  elif ! _mixcmp_value "$verb" "$previous"; then
    _mixcmp_argument "$verb" "$number"
    _mixcmp_options "$verb"
  fi
  [[ $current == -* ]] && words=$options paths=""
  COMPREPLY=()
  [[ -z $paths ]] || compopt -o default 2>/dev/null
  [[ -z $words ]] || mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}}
complete -F _mixcmp mixcmp
)",
      fmt::join(verbs, " "), values, arguments, options,
      fmt::join(bash_options(table.program), " "));
}

}  // namespace mixcmp::cli
