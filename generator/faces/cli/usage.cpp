#include "generator/faces/cli/usage.hpp"

#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "generator/faces/cli/command_table.hpp"
#include "model/base/common/nearest.hpp"
#include "model/base/common/result.hpp"

namespace mixcmp::cli {
namespace {

std::vector<std::string> options_of(const CLI::App& verb) {
  std::vector<std::string> names;
  for (const CLI::Option* option : verb.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

Error unused_word(const CLI::App& app, const CLI::App* verb, const std::string& word) {
  if (word.starts_with("-")) {
    const CLI::App& owner = verb != nullptr ? *verb : app;
    return {.field = verb != nullptr ? verb->get_name() : "",
            .message = "unknown option",
            .received = word,
            .accepted = list_with_nearest(word, options_of(owner))};
  }
  if (verb != nullptr) {
    return {.field = verb->get_name(),
            .message = "an argument too many",
            .received = word,
            .accepted = fmt::format("what mixcmp {} --help lists", verb->get_name())};
  }
  return {.message = "unknown verb",
          .received = word,
          .accepted = list_with_nearest(word, verbs_of(app))};
}

}  // namespace

std::string verb_names(const CLI::App& app) {
  return fmt::format("{}", fmt::join(verbs_of(app), ", "));
}

Error usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> verbs = app.get_subcommands();
  const CLI::App* verb = verbs.empty() ? nullptr : verbs.front();
  const std::vector<std::string> unused = app.remaining(true);
  const bool is_unused = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  // Behind a word that is no verb, that verb's options look like options of the program itself.
  const bool has_wrong_verb = verb == nullptr && !unused.empty();
  if (is_unused || has_wrong_verb) return unused_word(app, verb, unused.front());
  if (verb == nullptr) return {.message = error.what()};
  return {.field = verb->get_name(),
          .message = fmt::format("{} (mixcmp {} --help)", error.what(), verb->get_name())};
}

}  // namespace mixcmp::cli
