#include "model/cost/devices/family.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "embedded/family_files.hpp"
#include "model/base/common/nearest.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/settings/section.hpp"
#include "model/cost/devices/parts.hpp"

namespace mixcmp::devices {
namespace {

using settings::Setting;
using settings::Settings;

/// The key of a section; null where there is none.
const Setting* find(const Setting::Table& file, const char* section, const std::string& key) {
  const Setting* found = file.find(section);
  const auto* table = found == nullptr ? nullptr : std::get_if<Setting::Table>(&found->value);
  return table == nullptr ? nullptr : table->find(key);
}

/// Tells whether a file leaves nothing of this key to its family. Each file has a name of its own,
/// and a command or a tool of its own comes with its own options.
bool decides(const Setting::Table& file, const std::string& section, const std::string& key) {
  if (find(file, section.c_str(), key) != nullptr) return true;
  if (section == "device") return key == "name";
  if (section == "timing") return find(file, "timing", "tool") != nullptr;
  if (section != "synthesis") return false;
  return find(file, "synthesis", "command") != nullptr ||
         find(file, "synthesis", "missing") != nullptr;
}

/// Adds the keys of `family` that the file leaves to it.
void inherit(Setting::Table& file, const Setting::Table& family) {
  const Setting::Table own = file;
  for (Setting section : family.entries) {
    auto& keys = std::get<Setting::Table>(section.value).entries;
    std::erase_if(keys, [&](const Setting& key) { return decides(own, section.key, key.key); });
    if (own.find(section.key) == nullptr) {
      file.entries.push_back(std::move(section));
      continue;
    }
    auto* target = std::get_if<Setting::Table>(&find_or_add(file, section.key).value);
    if (target == nullptr) continue;  // a mistake, of which the section's reader tells
    target->entries.insert(target->entries.end(), keys.begin(), keys.end());
  }
}

Result<Settings> read_part(const Setting& key, const std::string& name) {
  if (const auto part = find_part(name)) {
    return with_family(settings::parse_settings(device_file_of(*part), "parts.csv").value());
  }
  return settings::mistake_at(key, "device.part", "unknown part", in_quotes(name),
                              candidates_for(name));
}

Result<Settings> read_family(const Setting& key, const std::string& name) {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : family_files()) {
    names.emplace_back(file.name.substr(0, file.name.rfind('.')));
    if (names.back() != name) continue;
    return with_family(settings::parse_settings(std::string(file.text), file.name).value());
  }
  return settings::mistake_at(key, "device.family", "unknown family", in_quotes(name),
                              list_with_nearest(name, names));
}

}  // namespace

Result<Settings> with_family(Settings file) {
  const Setting* part = find(file.root, "device", "part");
  const Setting* family = find(file.root, "device", "family");
  const Setting* base = part != nullptr ? part : family;
  if (base == nullptr) return file;
  if (part != nullptr && family != nullptr) {
    return settings::mistake_at(*family, "device.family", "beside a part, which has a family",
                                family->shown(), "part, or family");
  }
  const auto* name = std::get_if<std::string>(&base->value);
  if (name == nullptr) {
    return settings::mistake_at(*base, "device." + base->key, "wrong type", base->shown(),
                                "a string");
  }
  MIXCMP_TRY(inherited, part != nullptr ? read_part(*part, *name) : read_family(*family, *name));
  inherit(file.root, inherited.root);
  return file;
}

}  // namespace mixcmp::devices
