#include "generator/cli/options.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdint>

#include "generator/cli/output.hpp"
#include "generator/datapath/delays.hpp"
#include "model/scene/load_comparisons.hpp"
#include "model/scene/locate.hpp"

namespace mixcmp::cli {
namespace {

/// --flag VALUE means --set key=VALUE.
struct Shortcut {
  const char* flag;
  const char* key;
  const char* help;
};

constexpr std::array<Shortcut, 8> shortcuts = {{
    {"--variant", "comparison.variant", "one of the scene's [[variant]]s in place of [comparison]"},
    {"--format", "reduced.format", "reduced format of the lanes, s17e8"},
    {"--bound", "reduced.bound", "certified or profiled"},
    {"--inputs", "reduced.inputs", "rounded or exact"},
    {"--lanes", "system.lanes", "p_L, 1..512"},
    {"--references", "system.references", "p_H, 0..16"},
    {"--target-mhz", "system.target_mhz", "clock that the cut points are chosen for"},
    {"--device", "system.device", "device whose rough delays choose the cut points"},
}};

/// A search of many contests takes long enough to be asked about.
model::ContestProgress contest_progress() {
  return [shown = std::uint64_t{0}](std::uint64_t done, std::uint64_t all) mutable {
    constexpr std::uint64_t many = 1'000'000;
    const std::uint64_t percent = 100 * done / all;
    if (all <= many || percent == shown) return;
    shown = percent;
    show_progress(done == all ? "" : fmt::format("arg_min: {} of {} comparisons", done, all));
  };
}

bool needs_quotes(const std::string& text) {
  return text.find_first_of(" \t\"'$&|;<>()[]{}*?!#~`\\") != std::string::npos;
}

}  // namespace

std::string quoted(const std::string& text) {
  if (!needs_quotes(text)) return text;
  std::string quoted_text = "'";
  for (const char c : text) quoted_text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted_text + "'";
}

void add_scene_options(CLI::App& verb, SceneOptions& options,
                       const std::set<std::string>& left_out) {
  verb.add_option("SCENE", options.scene, "the scene file (docs/scene_file.md)")->required();
  verb.add_option("--set", options.settings,
                  "override one key of the scene: section.key=value; may be repeated")
      ->allow_extra_args(false);
  for (const Shortcut& shortcut : shortcuts) {
    if (left_out.contains(shortcut.flag)) continue;
    verb.add_option_function<std::string>(
        shortcut.flag,
        [&options, &shortcut](const std::string& value) {
          options.settings.push_back(fmt::format("{}={}", shortcut.key, value));
          options.shortcuts[shortcut.key] = shortcut.flag;
        },
        fmt::format("{} (--set {}=...)", shortcut.help, shortcut.key));
  }
  verb.add_flag("--json", options.json, "print the result as JSON");
}

model::Error at_fault(const model::Error& found, const SceneOptions& options) {
  model::Error error = located(found, options.scene, options.settings);
  const auto shortcut = options.shortcuts.find(error.field);
  if (error.file == "--set" && shortcut != options.shortcuts.end()) error.file = shortcut->second;
  return error;
}

model::Result<LoadedScene> load(const SceneOptions& options) {
  model::Result<model::Scene> loaded_scene = model::load_scene(options.scene, options.settings);
  if (!loaded_scene.ok()) return at_fault(loaded_scene.error(), options);
  model::Scene scene = std::move(loaded_scene).value();
  if (const auto delays = gen::delays_of(scene.system.device); !delays.ok()) {
    model::Error error = delays.error();
    if (!error.file.empty()) return error;  // the device file's own
    error.file = options.scene.string();
    return at_fault(error, options);
  }
  LoadedScene loaded = {std::move(scene), std::nullopt};
  if (loaded.scene.data) {
    MIXCMP_TRY(data, model::load_comparisons(loaded.scene, contest_progress()));
    loaded.data = std::move(data);
  }
  return loaded;
}

model::Result<model::Design> design_of(const SceneOptions& options, const LoadedScene& loaded) {
  auto design = make_design(loaded.scene, loaded.data ? &*loaded.data : nullptr);
  if (!design.ok()) return at_fault(design.error(), options);
  return design;
}

model::Result<std::vector<LoadedScene>> load_formulations(const SceneOptions& options,
                                                          const LoadedScene& loaded) {
  std::vector<LoadedScene> formulations = {loaded};
  if (!loaded.scene.variant.empty()) return formulations;
  for (const std::string& variant : loaded.scene.variants) {
    std::vector<std::string> settings = options.settings;
    settings.push_back("comparison.variant=" + variant);
    MIXCMP_TRY(scene, model::load_scene(options.scene, settings));
    formulations.push_back({std::move(scene), loaded.data});
  }
  return formulations;
}

std::string command_line(const std::string& verb, const SceneOptions& options) {
  std::string line = "mixcmp " + verb + " " + quoted(options.scene.filename().string());
  for (const std::string& setting : options.settings) line += " --set " + quoted(setting);
  return line;
}

}  // namespace mixcmp::cli
