#include "model/scene/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "model/base/common/output_file.hpp"
#include "model/base/settings/section.hpp"

namespace mixcmp::scene {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view a_scene = "the path of a scene file, as seen from the plan";

/// A path without its "..", unless removing these would change its target because a folder is a
/// link.
fs::path shortened(const fs::path& path) {
  const fs::path normal = path.lexically_normal();
  std::error_code absent;
  return fs::equivalent(path, normal, absent) ? normal : path;
}

/// The file that the plan `from.back()` names; an error if it is one of `from`.
Result<fs::path> scene_of(const settings::Setting& key, const std::vector<fs::path>& from) {
  const auto wrong = [&](std::string message) {
    return settings::mistake_at(key, "scene", std::move(message), key.shown(),
                                std::string(a_scene));
  };
  const auto* name = std::get_if<std::string>(&key.value);
  if (name == nullptr || name->empty()) return wrong("not a path");
  // Names are relative to the plan itself, even if the given path is a link to it.
  MIXCMP_TRY(plan_file, follow_links(from.back()));
  const fs::path scene = shortened(plan_file.parent_path() / *name);
  std::error_code absent;
  if (!fs::is_regular_file(scene, absent)) return wrong("there is no such file");
  for (const fs::path& plan : from) {
    if (fs::equivalent(scene, plan, absent)) return wrong("a plan cannot be its own scene");
  }
  return scene;
}

bool is_number(const settings::Setting& setting) {
  return std::holds_alternative<std::int64_t>(setting.value) ||
         std::holds_alternative<double>(setting.value);
}

bool is_text(const settings::Setting& setting) {
  return std::holds_alternative<std::string>(setting.value);
}

Result<PlanNotes> read_notes(const settings::Settings& plan) {
  constexpr std::array numbers = {"throughput_per_s", "clock_mhz", "recomputation_rate", "slack"};
  constexpr std::array texts = {"device", "command", "clock_basis", "areas"};
  PlanNotes notes{.path = plan.path, .values = {}};
  const settings::Section section(plan, "plan");
  if (const auto error = section.finish(); error && !section.present()) return *error;
  for (const settings::Setting& entry : section.entries()) {
    const auto is_one_of = [&](const auto& names) {
      return std::find(names.begin(), names.end(), entry.key) != names.end();
    };
    const auto wrong = [&](const char* accepted) {
      return section.mistake(entry.key, "wrong type",
                             fmt::format("{} ({})", entry.shown(), entry.kind()), accepted);
    };
    if (is_one_of(numbers) && !is_number(entry)) return wrong("a number");
    if (is_one_of(texts) && !is_text(entry)) return wrong("a string");
    const bool plain =
        is_number(entry) || is_text(entry) || std::holds_alternative<bool>(entry.value);
    if (!plain) return wrong("a string, a number, true or false");
    notes.values.emplace_back(entry.key, entry.shown());
  }
  return notes;
}

void erase(settings::Setting::Table& table, const std::string& key) {
  std::erase_if(table.entries, [&](const settings::Setting& entry) { return entry.key == key; });
}

settings::Setting::Table* section_of(settings::Setting::Table& root, const std::string& name) {
  for (settings::Setting& entry : root.entries) {
    if (entry.key == name) return std::get_if<settings::Setting::Table>(&entry.value);
  }
  return nullptr;
}

/// If the plan gives the number of lanes (or references, by `name`), as [[name]] or system.name,
/// erases both of these keys from the scene.
void forget_counts(settings::Setting::Table& root, settings::Setting::Table& plan,
                   const std::string& name) {
  const settings::Setting::Table* system = section_of(plan, "system");
  const bool counted =
      plan.find(name) != nullptr || (system != nullptr && system->find(name) != nullptr);
  if (!counted) return;
  erase(root, name);
  if (settings::Setting::Table* old = section_of(root, "system")) erase(*old, name);
}

void lay_over(settings::Setting::Table& root, settings::Setting::Table& plan) {
  for (const char* name : {"lanes", "references"}) forget_counts(root, plan, name);
  for (settings::Setting& entry : plan.entries) {
    if (entry.key == "scene" || entry.key == "plan") continue;
    settings::Setting::Table* old = section_of(root, entry.key);
    auto* section = std::get_if<settings::Setting::Table>(&entry.value);
    if (old == nullptr || section == nullptr) {
      settings::find_or_add(root, entry.key) = std::move(entry);
      continue;
    }
    for (settings::Setting& setting : section->entries)
      settings::find_or_add(*old, setting.key) = std::move(setting);
  }
}

Result<SceneSettings> read_layers(std::vector<fs::path> from);

/// Reads the files below `file`, which is the content of `from.back()`. `from` begins with the
/// plans that led to that file.
Result<SceneSettings> read_below(settings::Settings file, std::vector<fs::path> from) {
  const settings::Setting* named = file.root.find("scene");
  if (named == nullptr) {
    return SceneSettings{.settings = std::move(file), .plan = {}, .files = std::move(from)};
  }
  MIXCMP_TRY(scene, scene_of(*named, from));
  from.push_back(scene);
  MIXCMP_TRY(below, read_layers(std::move(from)));
  MIXCMP_TRY(notes, read_notes(file));
  lay_over(below.settings.root, file.root);
  below.plan = std::move(notes);
  return below;
}

/// Reads the file `from.back()` and the files below it.
Result<SceneSettings> read_layers(std::vector<fs::path> from) {
  MIXCMP_TRY(file, settings::read_settings(from.back(), {}));
  return read_below(std::move(file), std::move(from));
}

}  // namespace

Result<SceneSettings> read_scene_settings(const SceneSource& source,
                                          std::span<const std::string> overrides) {
  MIXCMP_TRY(file, source.text ? settings::parse_settings(*source.text, source.path)
                               : settings::read_settings(source.path, {}));
  MIXCMP_TRY(read, read_below(std::move(file), {source.path}));
  MIXCMP_DO(settings::apply_overrides(read.settings, overrides));
  return read;
}

}  // namespace mixcmp::scene
