#include "generator/faces/cli/options.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <climits>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/output.hpp"
#include "model/base/settings/bound_name.hpp"

namespace mixcmp::cli {
namespace {

/// An option for a key: --flag VALUE means --set key=VALUE.
struct Shortcut {
  const char* flag;
  const char* key;
  const char* help;
  std::optional<settings::Limits> limits = {};
};

constexpr std::array<Shortcut, 9> shortcuts = {{
    {"--variant", "comparison.variant", "one of the scene's [[variant]]s in place of [comparison]"},
    {"--format", "reduced.format", "reduced format of the lanes, s17e8"},
    {"--bound", "reduced.bound", "certified or profiled"},
    {"--inputs", "reduced.inputs", "rounded, exact, or so many digits, 20"},
    {"--lanes", "system.lanes", "p_L, 1..512, in groups or a pairwise engine 1..4096"},
    {"--references", "system.references", "p_H", settings::limits::references},
    {"--target-mhz", "system.target_mhz", "clock that the cut points are chosen for"},
    {"--device", "system.device", "device whose rough delays choose the cut points"},
    {"--prefix", "system.prefix", "prefix of all module names but the top's"},
}};

/// Shows the progress of a search for arg-mins, if it has many comparisons and so takes long.
workload::ComparisonProgress comparison_progress() {
  return [shown = std::uint64_t{0}](std::uint64_t done, std::uint64_t all) mutable {
    constexpr std::uint64_t many = 1'000'000;
    const std::uint64_t percent = 100 * done / all;
    if (all <= many || percent == shown) return;
    shown = percent;
    show_progress(done == all ? "" : fmt::format("arg_min: {} of {} comparisons", done, all));
  };
}

std::string help_of(const Shortcut& shortcut) {
  const std::string limits = shortcut.limits ? ", " + to_string(*shortcut.limits) : "";
  return fmt::format("{}{} (--set {}=...)", shortcut.help, limits, shortcut.key);
}

/// Reads a number without sign and without leading zeros.
std::optional<std::uint64_t> decimal_integer(const std::string& text) {
  std::uint64_t value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, status] = std::from_chars(text.data(), last, value);
  const bool zeros_in_front = text.size() > 1 && text[0] == '0';
  if (status != std::errc{} || end != last || zeros_in_front) return std::nullopt;
  return value;
}

template <class Value>
std::string list_of(const std::vector<Value>& values) {
  std::vector<std::string> words;
  for (const Value& value : values) words.emplace_back(to_string(value));
  return text_of(words);
}

}  // namespace

std::string text_of(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "";
}

std::string text_of(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ","));
}

std::string text_of(const std::vector<Bound>& bounds) {
  return list_of(bounds);
}

std::string text_of(const std::vector<LaneInputs>& inputs) {
  return list_of(inputs);
}

std::string text_of(const std::vector<scene::Multipliers>& multipliers) {
  return list_of(multipliers);
}

std::optional<Fraction> fraction_of(const std::string& text) {
  constexpr std::uint64_t most = 1'000'000;
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const auto number = decimal_integer(text.substr(0, slash));
  const auto count = decimal_integer(text.substr(slash + 1));
  if (!number || !count || *number < 1 || *number > *count || *count > most) return std::nullopt;
  return Fraction{*number, *count};
}

Condition a_fraction() {
  return {[](const std::string& text) {
            return fraction_of(text) ? std::string()
                                     : fmt::format(
                                           "received {}; accepted K/N, the K-th of N, 1 <= K <= "
                                           "N <= 1000000",
                                           text);
          },
          "K/N"};
}

std::optional<double> number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool is_whole =
      !text.empty() && std::isspace(static_cast<unsigned char>(text[0])) == 0 && *end == '\0';
  return is_whole ? std::optional(value) : std::nullopt;
}

void add_scene_options(const Verb& verb, SceneOptions& options,
                       const std::set<std::string>& left_out, SceneArgument argument) {
  const Option scene = verb.option("SCENE", options.scene, "the scene file (docs/scene_file.md)");
  if (argument == SceneArgument::required) scene.required();
  verb.option("--set", options.settings,
              "override one key of the scene: section.key=value; may be repeated")
      .one_value_each();
  for (const Shortcut& shortcut : shortcuts) {
    if (left_out.contains(shortcut.flag)) continue;
    verb.text_option(
        shortcut.flag,
        [&options, &shortcut](const std::string& value) {
          options.settings.push_back(fmt::format("{}={}", shortcut.key, value));
          options.shortcuts[shortcut.key] = shortcut.flag;
        },
        help_of(shortcut));
  }
  verb.flag("--json", options.json, "print the result as JSON");
}

Condition within(settings::Limits limits) {
  return {[limits](const std::string& text) {
            const auto value = decimal_integer(text);
            const bool accepted =
                value && *value <= INT_MAX && limits.allow(static_cast<int>(*value));
            return accepted ? std::string()
                            : fmt::format("received {}; accepted {}", text, to_string(limits));
          },
          to_string(limits)};
}

Condition whole(std::uint64_t least, std::uint64_t most) {
  const bool bounded = most < std::numeric_limits<std::uint64_t>::max();
  const std::string range = bounded ? fmt::format("an integer from {} to {}", least, most)
                                    : fmt::format("an integer of at least {}", least);
  return {[=](const std::string& text) {
            const auto value = decimal_integer(text);
            const bool accepted = value && least <= *value && *value <= most;
            return accepted ? std::string() : fmt::format("received {}; accepted {}", text, range);
          },
          ""};
}

Condition between(double least, double most, const std::string& unit) {
  return {[=](const std::string& text) {
            const auto value = number(text);
            const bool accepted = value && least <= *value && *value <= most;
            return accepted ? std::string()
                            : fmt::format("received {}; accepted {}..{}", text, least, most);
          },
          unit};
}

Error as_user_error(const Error& found, const SceneOptions& options) {
  return with_shortcut(tasks::located(found, options.request()), options);
}

Error with_shortcut(Error error, const SceneOptions& options) {
  // The file "--set" means the key that the error names, "--set key" means another key.
  const std::string set = "--set";
  const std::string key = error.file == set                   ? error.field
                          : error.file.starts_with(set + " ") ? error.file.substr(set.size() + 1)
                                                              : "";
  const auto shortcut = options.shortcuts.find(key);
  if (shortcut != options.shortcuts.end()) error.file = shortcut->second;
  return error;
}

Result<scene::Scene> with_chain_lanes(const scene::Scene& scene, const data::Comparisons* data,
                                      const SceneOptions& options) {
  return with_shortcuts(tasks::with_chain_lanes(scene, data, options.request()), options);
}

Result<LoadedScene> load(const SceneOptions& options) {
  Result<LoadedScene> loaded =
      with_shortcuts(tasks::load(options.request(), comparison_progress()), options);
  if (!loaded.ok()) return loaded;
  if (const auto note = tasks::lost_numbers_note(*loaded)) tell_note(*note);
  return loaded;
}

Result<std::vector<Bound>> parse_bounds(const std::string& option,
                                        const std::vector<std::string>& names) {
  std::vector<Bound> choices;
  for (const std::string& name : names) {
    const auto choice = settings::parse_bound(name);
    if (choice.ok()) {
      choices.push_back(*choice);
      continue;
    }
    Error error = choice.error();
    error.field = option;
    return error;
  }
  return choices;
}

Result<std::vector<LaneInputs>> parse_inputs(const std::string& option,
                                             const std::vector<std::string>& words, int most) {
  std::vector<LaneInputs> choices;
  for (const std::string& word : words) {
    const auto inputs = LaneInputs::parse(word, settings::limits::lane_precision.least, most);
    if (inputs.ok()) {
      choices.push_back(*inputs);
      continue;
    }
    Error error = inputs.error();
    error.field = option;
    return error;
  }
  return choices;
}

Result<design::Design> design_of(const SceneOptions& options, const LoadedScene& loaded) {
  return with_shortcuts(tasks::design_of(options.request(), loaded), options);
}

std::vector<std::filesystem::path> inputs_of(const SceneOptions& options,
                                             const scene::Scene& scene) {
  return value_or_exit(tasks::inputs_of(options.request(), scene));
}

CommandLine command_line(const std::string& verb, const SceneOptions& options) {
  return {verb, options.scene.filename(), options.settings};
}

CommandLine runnable_command(const std::string& verb, const SceneOptions& options) {
  return {verb, options.scene, options.settings};
}

}  // namespace mixcmp::cli
