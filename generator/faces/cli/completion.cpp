#include "generator/faces/cli/completion.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

namespace mixcmp::cli {
namespace {

/// Words as they were typed: bash also splits them at '='.
std::vector<std::string> rejoined(const std::vector<std::string>& words) {
  std::vector<std::string> result;
  for (const std::string& word : words) {
    const bool goes_on = !result.empty() && (word == "=" || result.back().ends_with('='));
    if (goes_on) {
      result.back() += word;
    } else {
      result.push_back(word);
    }
  }
  return result;
}

/// Takes the words before the one to complete, and then offers what may stand in its place.
class Completer {
public:
  explicit Completer(const CommandTable& table) : table_(table), command_(&table.program) {}

  void take(const std::string& word) {
    if (open_ != nullptr) {
      open_ = nullptr;
    } else if (word.starts_with('-')) {
      take_option(word);
    } else if (command_ != &table_.program) {
      ++arguments_;
    } else {
      for (const CommandEntry& verb : table_.verbs) {
        if (verb.name == word) command_ = &verb;
      }
    }
  }

  std::string offers(const std::string& word) {
    word_ = word;
    if (open_ != nullptr) {
      offer_values(*open_, "");
    } else if (word.starts_with('-')) {
      offer_options();
    } else if (command_ == &table_.program) {
      for (const CommandEntry& verb : table_.verbs) offer(verb.name, verb.help);
    } else {
      offer_argument();
    }
    return lines_;
  }

private:
  const CommandOption* option_named(const std::string& name) const {
    for (const CommandOption& option : command_->options) {
      const auto found = std::find(option.names.begin(), option.names.end(), name);
      if (!option.is_argument && found != option.names.end()) return &option;
    }
    return nullptr;
  }

  void take_option(const std::string& word) {
    const std::size_t end = word.find('=');
    const CommandOption* option = option_named(word.substr(0, end));
    if (option == nullptr) return;
    given_.insert(option);
    if (option->value != OptionValue::none && end == std::string::npos) open_ = option;
  }

  void offer(const std::string& candidate, const std::string& help) {
    if (candidate.starts_with(word_)) lines_ += fmt::format("{}\t{}\n", candidate, help);
  }

  /// Values of an option or argument, `before` in front of each.
  void offer_values(const CommandOption& option, const std::string& before) {
    if (option.value == OptionValue::path) lines_ = ":path\n";
    for (const std::string& choice : option.choices) offer(before + choice, option.help);
  }

  void offer_options() {
    const std::size_t end = word_.find('=');
    if (end != std::string::npos) {
      const CommandOption* option = option_named(word_.substr(0, end));
      if (option != nullptr) offer_values(*option, word_.substr(0, end + 1));
      return;
    }
    for (const CommandOption& option : command_->options) {
      if (option.is_argument || (given_.contains(&option) && !option.repeated)) continue;
      for (const std::string& name : option.names) offer(name, option.help);
    }
  }

  void offer_argument() {
    std::size_t before = arguments_;
    for (const CommandOption& option : command_->options) {
      if (!option.is_argument) continue;
      if (before-- == 0) return offer_values(option, "");
    }
  }

  const CommandTable& table_;
  const CommandEntry* command_;
  const CommandOption* open_ = nullptr;  ///< the option whose value comes next; null: none
  std::set<const CommandOption*> given_;
  std::size_t arguments_ = 0;
  std::string word_;
  std::string lines_;
};

constexpr const char* bash_script = R"(_mixcmp() {
  local words=("${COMP_WORDS[@]:1:COMP_CWORD}")
  mapfile -t COMPREPLY < <("${COMP_WORDS[0]/#\~/$HOME}" --complete "${words[@]}" 2>/dev/null)
  COMPREPLY=("${COMPREPLY[@]%%$'\t'*}")
  [[ $COMP_WORDBREAKS != *=* ]] || COMPREPLY=("${COMPREPLY[@]#*=}")
  [[ ${COMPREPLY-} != :path ]] || { COMPREPLY=() && compopt -o default 2>/dev/null; }
}
complete -F _mixcmp mixcmp
)";

constexpr const char* zsh_script = R"zsh(_mixcmp() {
  local -a lines=(${(f)"$(${~words[1]} --complete "${(@Q)words[2,CURRENT]}" 2>/dev/null)"})
  lines=(${lines/$'\t'/:})
  compset -P '--*=' && lines=(${lines#--*=})
  [[ $lines == :path ]] && _files || _describe mixcmp lines
}
_mixcmp "$@"
)zsh";

constexpr const char* fish_script = R"(function __mixcmp
    set -l words (commandline -opc)
    set -l program (string replace -r '^~' ~ -- $words[1])
    set -l current (commandline -ct)
    set -e words[1]
    command -q $program; and $program --complete $words "$current" 2>/dev/null
end
complete -c mixcmp -f -a '(__mixcmp | string match -v :path)'
complete -c mixcmp -n '__mixcmp | string match -q :path' -F
)";

}  // namespace

std::string completions(const CommandTable& table, const std::vector<std::string>& words) {
  std::vector<std::string> before = rejoined(words);
  if (before.empty()) return "";
  const std::string last = before.back();
  before.pop_back();
  Completer completer(table);
  for (const std::string& word : before) completer.take(word);
  return completer.offers(last);
}

std::string completion_script(const std::string& shell) {
  const std::string header =
      fmt::format("# Completion of mixcmp for {0}, printed by: mixcmp completion {0}\n", shell);
  if (shell == "bash") return header + bash_script;
  return shell == "zsh" ? "#compdef mixcmp\n" + header + zsh_script : header + fish_script;
}

}  // namespace mixcmp::cli
