#include "model/scene/error_location.hpp"

#include "model/base/settings/section.hpp"
#include "model/scene/plan.hpp"

namespace mixcmp::scene {
namespace {

const settings::Setting* find_in(const settings::Setting* table, const std::string& key) {
  const auto* entries = std::get_if<settings::Setting::Table>(&table->value);
  return entries == nullptr ? nullptr : entries->find(key);
}

}  // namespace

Error with_location(Error error, const SceneSource& scene, std::span<const std::string> overrides) {
  const std::size_t dot = error.field.find('.');
  if (error.line > 0 || dot == std::string::npos || error.file.starts_with("--set")) return error;
  const Result<SceneSettings> read = read_scene_settings(scene, overrides);
  if (!read.ok()) return error;
  const settings::Setting* section = read->settings.root.find(error.field.substr(0, dot));
  if (section == nullptr) return error;
  const settings::Setting* key = find_in(section, error.field.substr(dot + 1));
  const settings::Setting& place = key != nullptr ? *key : *section;
  error.file = settings::file_of(place);
  error.line = place.line;
  return error;
}

}  // namespace mixcmp::scene
