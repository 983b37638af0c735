#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "model/base/common/result.hpp"

namespace mixcmp::settings {

/// A file of settings as written.
struct SettingsFile {
  std::filesystem::path path;
  std::string text;
};

/// One key of a scene file with its TOML value, not yet interpreted.
struct Setting {
  /// A value of a type that no scene uses; `kind` names the type: "a date or time".
  struct Foreign {
    std::string kind;
  };
  struct Table {
    std::vector<Setting> entries;  ///< in the order of the file, those of --set last
    const Setting* find(const std::string& key) const;
  };
  using Array = std::vector<Setting>;

  std::string key;                                     ///< empty in arrays
  std::shared_ptr<const SettingsFile> file = nullptr;  ///< null: from --set
  int line = 0;                                        ///< 1-based; 0: from --set
  int end_line = 0;                                    ///< last line of the value
  std::variant<bool, std::int64_t, double, std::string, Array, Table, Foreign> value;

  /// "a number", "a string", ...
  std::string kind() const;
  /// The value as shown in an error message.
  std::string shown() const;
};

/// The settings of a scene file, or of a plan with its scene (plan.hpp), with --set overrides
/// applied, not yet interpreted.
struct Settings {
  std::filesystem::path path;  ///< the file, or a plan's scene; for errors about missing keys
  Setting::Table root;
};

/// Parses the text of a file; `path` is for the errors.
Result<Settings> parse_settings(std::string text, const std::filesystem::path& path);

/// Reads a file and applies the overrides. Each is "section.key=value"; a value that is not TOML
/// counts as a string.
Result<Settings> read_settings(const std::filesystem::path& path,
                               std::span<const std::string> overrides);

/// A basic string of TOML; `text` is UTF-8.
std::string toml_string(const std::string& text);
/// A key of TOML, in quotes if necessary.
std::string toml_key(const std::string& key);
/// A complete value of TOML on one line; `value` contains nothing Foreign.
std::string toml_value(const Setting& value);

Result<Done> apply_overrides(Settings& settings, std::span<const std::string> overrides);

/// The entries of `root`'s sections that the overrides, already applied, have changed. An entry is
/// returned whole even if an override changed only a part of it.
Setting::Table overridden_entries(const Setting::Table& root,
                                  std::span<const std::string> overrides);

/// The entry with that key. If there is none, an empty table is added.
Setting& find_or_add(Setting::Table& table, const std::string& key);

}  // namespace mixcmp::settings
