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

/// One branch of `case`: what may follow one of these words.
std::string bash_branch(const std::vector<std::string>& before, const std::string& commands) {
  std::string text;
  for (const std::string& words : before) text += (text.empty() ? "" : " | ") + words;
  return fmt::format("    {}) {} ;;\n", text, commands);
}

std::string bash_words(const std::vector<std::string>& choices) {
  return fmt::format("words=\"{}\"", fmt::join(choices, " "));
}

/// The branches for values of the verb's options, and for the verb itself.
std::string bash_branches(const CommandEntry& verb) {
  std::string text, argument;
  for (const CommandOption& option : verb.options) {
    const std::string values = option.value == OptionValue::choice ? bash_words(option.choices)
                               : option.value == OptionValue::path ? "paths=yes"
                                                                   : ":";
    if (option.is_argument) {
      argument = values + "; ";
      continue;
    }
    std::vector<std::string> before;
    for (const std::string& name : option.names) {
      before.push_back(fmt::format("\"{} {}\"", verb.name, name));
    }
    if (option.value != OptionValue::none) text += bash_branch(before, values);
  }
  const std::string options = fmt::format("options=\"{}\"", fmt::join(bash_options(verb), " "));
  return text + bash_branch({fmt::format("\"{} \"*", verb.name)}, argument + options);
}

}  // namespace

std::string bash_completion(const CommandTable& table) {
  std::vector<std::string> verbs;
  std::string branches;
  for (const CommandEntry& verb : table.verbs) {
    verbs.push_back(verb.name);
    branches += bash_branches(verb);
  }
  const std::string names = fmt::format("{}", fmt::join(verbs, " "));
  return fmt::format(
      R"(# Completion of mixcmp for bash, printed by: mixcmp completion bash
_mixcmp() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
  local verb="" words="" options="" paths="" k
  for ((k = 1; k < COMP_CWORD; ++k)); do
    case " {0} " in
      *" ${{COMP_WORDS[k]}} "*) verb=${{COMP_WORDS[k]}}; break ;;
    esac
  done
  case "$verb $previous" in
{1}    *) words="{0}"; options="{2}" ;;
  esac
  [[ $current == -* ]] && words=$options paths=""
  COMPREPLY=()
  [[ -z $paths ]] || compopt -o default 2>/dev/null
  [[ -z $words ]] || mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}}
complete -F _mixcmp mixcmp
)",
      names, branches, fmt::join(bash_options(table.program), " "));
}

}  // namespace mixcmp::cli
