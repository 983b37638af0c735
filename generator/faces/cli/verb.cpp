#include "generator/faces/cli/verb.hpp"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <type_traits>
#include <utility>

#include "generator/faces/cli/console.hpp"
#include "model/base/common/nearest.hpp"

namespace mixcmp::cli {

Option Option::required() const {
  return Option(option_->required());
}

Option Option::check(const Condition& check) const {
  return Option(option_->check(CLI::Validator(check.problem, check.description)));
}

Option Option::one_of(const std::vector<std::string>& words) const {
  const auto problem = [words](const std::string& text) {
    const bool accepted = std::find(words.begin(), words.end(), text) != words.end();
    return accepted ? std::string()
                    : fmt::format("received {}; accepted {}", text, list_with_nearest(text, words));
  };
  return check({problem, fmt::format("{{{}}}", fmt::join(words, ","))});
}

Option Option::needs(Option other) const {
  return Option(option_->needs(other.option_));
}

Option Option::excludes(Option other) const {
  return Option(option_->excludes(other.option_));
}

Option Option::excludes(const std::string& name) const {
  return Option(option_->excludes(name));
}

Option Option::separated_by(char separator) const {
  return Option(option_->delimiter(separator));
}

Option Option::one_value_each() const {
  return Option(option_->allow_extra_args(false));
}

Verb::Verb(CLI::App& app, const std::string& name, const std::string& help)
    : verb_(app.add_subcommand(name, help)) {
  flag("--quiet", be_quiet, "no progress and no notes on standard error");
}

Option Verb::flag(const std::string& names, bool& target, const std::string& help) const {
  return Option(verb_->add_flag(names, target, help));
}

Option Verb::flag(const std::string& names, const std::function<void()>& use,
                  const std::string& help) const {
  return Option(verb_->add_flag_callback(names, use, help));
}

template <class Value>
Option Verb::option(const std::string& names, Value& target, const std::string& help) const {
  CLI::Option* option = verb_->add_option(names, target, help);
  if constexpr (std::is_same_v<Value, std::filesystem::path> ||
                std::is_same_v<Value, std::vector<std::filesystem::path>>) {
    option->type_name(path_placeholder);
  }
  return Option(option);
}

template Option Verb::option(const std::string&, int&, const std::string&) const;
template Option Verb::option(const std::string&, unsigned&, const std::string&) const;
template Option Verb::option(const std::string&, std::uint64_t&, const std::string&) const;
template Option Verb::option(const std::string&, double&, const std::string&) const;
template Option Verb::option(const std::string&, std::string&, const std::string&) const;
template Option Verb::option(const std::string&, std::filesystem::path&, const std::string&) const;
template Option Verb::option(const std::string&, std::optional<int>&, const std::string&) const;
template Option Verb::option(const std::string&, std::optional<double>&, const std::string&) const;
template Option Verb::option(const std::string&, std::optional<std::uint64_t>&,
                             const std::string&) const;
template Option Verb::option(const std::string&, std::vector<int>&, const std::string&) const;
template Option Verb::option(const std::string&, std::vector<double>&, const std::string&) const;
template Option Verb::option(const std::string&, std::vector<std::string>&,
                             const std::string&) const;
template Option Verb::option(const std::string&, std::vector<std::filesystem::path>&,
                             const std::string&) const;

Option Verb::text_option(const std::string& names,
                         const std::function<void(const std::string&)>& use,
                         const std::string& help) const {
  return Option(verb_->add_option_function<std::string>(names, use, help));
}

Option Verb::list_option(const std::string& names,
                         const std::function<void(const std::vector<std::string>&)>& use,
                         const std::string& help) const {
  return Option(verb_->add_option_function<std::vector<std::string>>(names, use, help));
}

void Verb::keep_alone(Option option, const std::set<std::string>& with) const {
  for (CLI::Option* other : verb_->get_options()) {
    if (other != option.option_ && !with.contains(other->get_name()))
      option.option_->excludes(other);
  }
}

void Verb::when_chosen(std::function<void()> run) const {
  verb_->callback(std::move(run));
}

Result<Done> parse_words(const std::vector<std::string>& words,
                         const std::function<void(const Verb&)>& add) {
  const std::string name = "verb";
  CLI::App app;
  add(Verb(app, name, ""));
  std::vector<std::string> last_first(words.rbegin(), words.rend());  // as CLI11 takes them
  last_first.push_back(name);
  try {
    app.parse(std::move(last_first));
  } catch (const CLI::ParseError& error) {
    return Error{.message = error.what()};
  }
  return Done{};
}

}  // namespace mixcmp::cli
