#include "generator/faces/cli/options.hpp"

#include <fmt/core.h>

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
#include "generator/hardware/datapath/delays.hpp"
#include "model/base/settings/bound_name.hpp"
#include "model/judge/workload/load_comparisons.hpp"
#include "model/plan/profile/profiled_error.hpp"
#include "model/scene/error_location.hpp"
#include "model/scene/override_error.hpp"
#include "model/scene/plan.hpp"

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

/// An error of the data with the place where the user wrote its cause. Errors in a data file stay
/// as they are; others may come from an override.
Error as_user_data_error(const Error& error, const data::DataSpec& data,
                         const SceneOptions& options) {
  if (error.file == data.file.string() || error.file == data.with.string()) return error;
  const auto attempt = [&](std::span<const std::string> settings) -> std::optional<Error> {
    const Result<scene::Scene> scene = scene::load_scene(options.scene, settings);
    if (!scene.ok()) return scene.error();
    if (!scene->data) return std::nullopt;
    const Result<data::Comparisons> comparisons = workload::load_comparisons(*scene);
    return comparisons.ok() ? std::nullopt : std::optional(comparisons.error());
  };
  return as_user_error(scene::with_setting(error, options.settings, attempt), options);
}

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

}  // namespace

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
  Error error = scene::with_location(found, options.scene, options.settings);
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
  Result<scene::Scene> chain = design::with_chain_lanes(scene, data);
  if (!chain.ok()) return as_user_error(chain.error(), options);
  return chain;
}

Result<LoadedScene> load(const SceneOptions& options) {
  Result<scene::Scene> loaded_scene = scene::load_scene(options.scene, options.settings);
  if (!loaded_scene.ok()) return as_user_error(loaded_scene.error(), options);
  scene::Scene scene = std::move(loaded_scene).value();
  if (const auto delays = datapath::delays_of(scene.system.device); !delays.ok()) {
    Error error = delays.error();
    if (!error.file.empty()) return error;  // an error in the device file
    error.file = options.scene.string();
    return as_user_error(error, options);
  }
  LoadedScene loaded = {std::move(scene), std::nullopt};
  if (loaded.scene.data) {
    auto data = workload::load_comparisons(loaded.scene, comparison_progress());
    if (!data.ok()) return as_user_data_error(data.error(), *loaded.scene.data, options);
    loaded.data = std::move(data).value();
  }
  return loaded;
}

Result<Done> check_has_data(const LoadedScene& loaded, const std::string& why) {
  if (loaded.data) return Done{};
  return Error{.file = loaded.scene.path.string(),
               .field = "data",
               .message = why,
               .received = "a scene without [data]",
               .accepted = "[data] with items or file"};
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
  auto design = design::make_design(loaded.scene, loaded.data ? &*loaded.data : nullptr,
                                    profile::profile_error);
  if (design.ok()) return design;
  const Error error = as_user_error(design.error(), options);
  // The errors of a profiled bound are measured on the data, which takes too long to do again.
  const std::vector<scene::LaneGroupSpec> groups = loaded.scene.lane_groups();
  const bool certified = std::all_of(groups.begin(), groups.end(),
                                     [](const auto& group) { return !group.reduced.is_profiled; });
  if (!certified) return error;
  return as_user_error(
      scene::with_setting(error, options.settings,
                          [&](std::span<const std::string> settings) -> std::optional<Error> {
                            const auto read = scene::load_scene(options.scene, settings);
                            if (!read.ok()) return read.error();
                            // Messages that suggest a command name all settings.
                            scene::Scene scene = *read;
                            scene.settings = options.settings;
                            const Result<design::Design> attempt =
                                design::make_design(scene, nullptr);
                            if (attempt.ok()) return std::nullopt;
                            return scene::with_location(attempt.error(), options.scene, settings);
                          }),
      options);
}

Result<std::vector<LoadedScene>> load_formulations(const SceneOptions& options,
                                                   const LoadedScene& loaded) {
  std::vector<LoadedScene> formulations = {loaded};
  if (!loaded.scene.variant.empty()) return formulations;
  for (const std::string& variant : loaded.scene.variants) {
    std::vector<std::string> settings = options.settings;
    settings.push_back("comparison.variant=" + variant);
    MIXCMP_TRY(scene, scene::load_scene(options.scene, settings));
    formulations.push_back({std::move(scene), loaded.data});
  }
  return formulations;
}

std::vector<std::filesystem::path> inputs_of(const SceneOptions& options,
                                             const scene::Scene& scene) {
  std::vector<std::filesystem::path> inputs =
      value_or_exit(scene::read_scene_settings(options.scene, options.settings)).files;
  if (scene.system.device.ends_with(".toml")) inputs.emplace_back(scene.system.device);
  if (scene.data) inputs.insert(inputs.end(), {scene.data->file, scene.data->with});
  return inputs;
}

std::string command_line(const std::string& verb, const SceneOptions& options) {
  SceneOptions named = options;
  named.scene = options.scene.filename();
  return runnable_command(verb, named);
}

std::string runnable_command(const std::string& verb, const SceneOptions& options) {
  std::string line = "mixcmp " + verb + " " + quoted(options.scene.string());
  for (const std::string& setting : options.settings) line += " --set " + quoted(setting);
  return line;
}

}  // namespace mixcmp::cli
