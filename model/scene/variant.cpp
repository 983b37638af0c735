#include "model/scene/variant.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/base/common/nearest.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/settings/section.hpp"
#include "model/comparison/expression/name.hpp"

namespace mixcmp::scene {
namespace {

settings::Setting::Table* table_of(settings::Setting::Table& root, const std::string& name) {
  const auto found =
      std::find_if(root.entries.begin(), root.entries.end(),
                   [&](const settings::Setting& entry) { return entry.key == name; });
  return found == root.entries.end() ? nullptr
                                     : std::get_if<settings::Setting::Table>(&found->value);
}

void erase(settings::Setting::Table& table, const std::string& key) {
  std::erase_if(table.entries, [&](const settings::Setting& entry) { return entry.key == key; });
}

/// The settings without any key about variants.
settings::Settings without_variants(settings::Settings settings) {
  erase(settings.root, "variant");
  if (settings::Setting::Table* comparison = table_of(settings.root, "comparison")) {
    erase(*comparison, "variant");
  }
  return settings;
}

/// The name of a [[variant]]: it must be unique, and valid as a part of a module's name.
Result<std::string> read_name(const settings::Setting& table,
                              const std::vector<Formulation>& known) {
  settings::Section section("variant", table);
  std::string name;
  section.require("name");
  section.text("name", name);
  for (const settings::Setting& entry : section.entries()) section.find(entry.key);
  if (const auto error = section.finish()) return *error;
  const std::string problem =
      name == no_variant ? "comparison.variant = \"none\" means [comparison]" : name_problem(name);
  if (!problem.empty()) {
    return section.mistake("name", problem, in_quotes(name), std::string(accepted_names()));
  }
  for (const Formulation& other : known) {
    if (other.variant != name) continue;
    return section.mistake("name", "two variants have it", in_quotes(name), "a name of its own");
  }
  return name;
}

/// Replaces keys of [comparison] by a variant's. [comparison]'s name and all its other keys stay.
Result<Formulation> formulation_of(const settings::Setting& table, std::string name,
                                   const settings::Settings& base) {
  Formulation formulation{.variant = std::move(name),
                          .settings = base,
                          .file = settings::file_of(table),
                          .line = table.line};
  settings::Setting::Table* comparison = table_of(formulation.settings.root, "comparison");
  if (comparison == nullptr) return formulation;  // read_comparison reports it
  bool says_something = false;
  for (const settings::Setting& entry : std::get<settings::Setting::Table>(table.value).entries) {
    if (entry.key == "name") continue;
    says_something = true;
    settings::find_or_add(*comparison, entry.key) = entry;
  }
  if (says_something) return formulation;
  return settings::mistake_at(table, "variant", "says nothing of its own",
                              in_quotes(formulation.variant), "f, g or both");
}

/// Sets which formulation comparison.variant names.
Result<Done> read_choice(const settings::Settings& settings, Formulations& formulations) {
  settings::Section section(settings, "comparison");
  const settings::Setting* key = section.find("variant");
  if (key == nullptr) return Done{};
  std::string name;
  section.text("variant", name);
  if (!std::holds_alternative<std::string>(key->value)) {
    return section.mistake("variant", "wrong type", key->shown(), "a variant's name");
  }
  std::vector<std::string> names;
  for (std::size_t k = 1; k < formulations.all.size(); ++k) {
    if (formulations.all[k].variant == name) formulations.chosen = k;
    names.push_back(formulations.all[k].variant);
  }
  formulations.is_as_written = name == no_variant;
  if (name.empty() || formulations.chosen > 0 || formulations.is_as_written) return Done{};
  if (names.empty()) {
    formulations.move = name;
    return Done{};
  }
  names.emplace_back(no_variant);
  return section.mistake("variant", "no such variant", key->shown(),
                         list_with_nearest(name, names));
}

}  // namespace

Error Formulation::name_mistake(std::string message, std::string received) const {
  return {.file = file,
          .line = line,
          .field = "variant.name",
          .message = std::move(message),
          .received = std::move(received),
          .accepted = std::string(accepted_names())};
}

Result<Formulations> read_formulations(const settings::Settings& settings) {
  Formulations formulations;
  const settings::Settings base = without_variants(settings);
  formulations.all.push_back({.variant = {}, .settings = base});
  MIXCMP_TRY(tables, tables_of(settings, "variant", "one table for each formulation"));
  constexpr std::size_t max_variants = 64;
  if (tables.size() > max_variants) {
    return settings::mistake_at(tables[max_variants], "variant", "too many variants",
                                fmt::format("{}", tables.size()),
                                fmt::format("at most {}", max_variants));
  }
  for (const settings::Setting& table : tables) {
    MIXCMP_TRY(name, read_name(table, formulations.all));
    MIXCMP_TRY(formulation, formulation_of(table, name, base));
    formulations.all.push_back(std::move(formulation));
  }
  MIXCMP_DO(read_choice(settings, formulations));
  return formulations;
}

}  // namespace mixcmp::scene
