#include <fmt/format.h>

#include "model/base/settings/section.hpp"
#include "model/comparison/expression/name.hpp"
#include "model/scene/sections.hpp"

namespace mixcmp::scene {
namespace {

/// Reads a key whose value is an expression or a list of expressions.
std::vector<const settings::Setting*> read_expressions(settings::Section& section,
                                                       const std::string& key) {
  const settings::Setting* setting = section.find(key);
  if (setting == nullptr) return {};
  if (std::holds_alternative<std::string>(setting->value)) return {setting};
  constexpr const char* accepted = "a string, or a list of strings, one for each part";
  const auto* list = std::get_if<settings::Setting::Array>(&setting->value);
  std::vector<const settings::Setting*> expressions;
  for (const settings::Setting& element : list == nullptr ? settings::Setting::Array{} : *list) {
    if (!std::holds_alternative<std::string>(element.value)) {
      section.fail(key, "not an expression in the list",
                   fmt::format("{} ({})", element.shown(), element.kind()), accepted);
    }
  }
  if (list == nullptr || list->empty()) {
    section.fail(key, list == nullptr ? "wrong type" : "an empty list",
                 fmt::format("{} ({})", setting->shown(), setting->kind()), accepted);
    return {};
  }
  for (const settings::Setting& element : *list) expressions.push_back(&element);
  return expressions;
}

bool is_list(settings::Section& section, const std::string& key) {
  const settings::Setting* setting = section.find(key);
  return setting != nullptr && std::holds_alternative<settings::Setting::Array>(setting->value);
}

/// Checks that f and g are both strings or both lists of the same length, at most max_parts.
void check_lists(settings::Section& section, std::size_t f_count, std::size_t g_count) {
  const bool f_list = is_list(section, "f"), g_list = is_list(section, "g");
  if (f_list != g_list || f_count != g_count) {
    const auto shown = [](bool list, std::size_t count) {
      return list ? fmt::format("a list of {}", count) : std::string("a string");
    };
    section.fail("g", "f and g are the sides of the same parts", shown(g_list, g_count),
                 fmt::format("{}, as f is", shown(f_list, f_count)));
  }
  if (f_count > max_parts) {
    section.fail("f", "too many parts", fmt::format("a list of {}", f_count),
                 fmt::format("1..{}", max_parts));
  }
}

/// Checks that `combine` is given if and only if f and g are lists or there is an index.
void check_combination(settings::Section& section) {
  const bool list = is_list(section, "f"), indexed = section.find("for") != nullptr;
  const bool combined = section.find("combine") != nullptr;
  if ((list || indexed) && !combined) {
    section.fail("combine", "missing: it says what the verdicts of several parts make together",
                 "nothing", "\"all\" or \"any\"");
  }
  if (!list && !indexed && combined) {
    section.fail("combine", "there is nothing to combine", "one f and one g",
                 "lists of f and g, or an index: for = \"k in 0..2\"");
  }
}

}  // namespace

Result<ComparisonSpec> read_comparison(const settings::Settings& settings,
                                       std::span<const LetDefinition> lets) {
  ComparisonSpec comparison;
  settings::Section section(settings, "comparison");
  section.require("name");
  section.require("f");
  section.require("g");
  section.text("name", comparison.name);
  const std::string problem = name_problem(comparison.name);
  if (!problem.empty()) {
    section.fail("name", problem, fmt::format("\"{}\"", comparison.name),
                 std::string(accepted_names()));
  }
  const std::vector<const settings::Setting*> f = read_expressions(section, "f");
  const std::vector<const settings::Setting*> g = read_expressions(section, "g");
  section.choice("combine", comparison.combination, {Combination::all, Combination::any});
  std::string range;
  section.text("for", range);
  if (!f.empty() && !g.empty()) check_lists(section, f.size(), g.size());
  check_combination(section);
  if (const auto error = section.finish()) return *error;
  comparison.index = section.find("for");
  for (std::size_t k = 0; k < f.size(); ++k) comparison.parts.push_back({f[k], g[k]});
  MIXCMP_DO(expand_parts(settings, lets, comparison));
  return comparison;
}

}  // namespace mixcmp::scene
