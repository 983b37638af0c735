#include "generator/faces/cli/suite_file.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>

#include "generator/faces/cli/options.hpp"
#include "model/base/settings/section.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;
using settings::Setting;

/// One option with its values, each as words of the command line.
struct Choice {
  std::vector<std::vector<std::string>> values;
};

std::vector<Setting> values_of(const Setting& setting) {
  const auto* array = std::get_if<Setting::Array>(&setting.value);
  return array != nullptr ? *array : std::vector<Setting>{setting};
}

std::string plain_text(const Setting& value) {
  const auto* text = std::get_if<std::string>(&value.value);
  return text != nullptr ? *text : settings::toml_value(value);
}

bool is_scalar(const Setting& value) {
  return !std::holds_alternative<Setting::Array>(value.value) &&
         !std::holds_alternative<Setting::Table>(value.value) &&
         !std::holds_alternative<Setting::Foreign>(value.value);
}

/// Reads the table of one group of runs.
class RunReader {
public:
  RunReader(const Setting& table, const GroupForm& form) : table_(table), form_(form) {}

  Result<std::vector<SuiteRun>> read(const fs::path& folder) {
    MIXCMP_DO(add_entries(std::get<Setting::Table>(table_.value), ""));
    if (scenes_.empty()) {
      return mistake_at(table_, form_.name + ".scenes", "a run without a scene", "no such key",
                        "one scene file or a list of them");
    }
    std::vector<SuiteRun> runs;
    for (const std::string& scene : scenes_) {
      runs.push_back({.scene = folder / scene,
                      .options = {},
                      .name = scene,
                      .portions = portions_,
                      .group = form_.name,
                      .file = settings::file_of(table_),
                      .line = table_.line});
    }
    for (const Choice& choice : choices_) runs = combinations(runs, choice);
    return runs;
  }

private:
  /// `path`: the keys around this table, "system." inside `system.lanes = 4`.
  Result<Done> add_entries(const Setting::Table& table, const std::string& path) {
    for (const Setting& entry : table.entries) {
      const std::string key = path + entry.key;
      if (const auto* inner = std::get_if<Setting::Table>(&entry.value)) {
        MIXCMP_TRY(added, add_entries(*inner, key + "."));
        continue;
      }
      for (const Setting& value : values_of(entry)) {
        if (is_scalar(value)) continue;
        return mistake_at(entry, form_.name + "." + key, "cannot be the value of an option",
                          value.kind(), "a number, a text, true, false, or a list of these");
      }
      MIXCMP_DO(add_choice(entry, key));
    }
    return Done{};
  }

  Result<Done> add_choice(const Setting& entry, const std::string& key) {
    if (key == "portions" && form_.has_portions) return read_portions(entry);
    const std::vector<Setting> values = values_of(entry);
    if (values.empty()) {
      return mistake_at(entry, form_.name + "." + key, "no run has this option", "an empty list",
                        "one value at least");
    }
    if (key == "scenes") {
      for (const Setting& value : values) scenes_.push_back(plain_text(value));
      return Done{};
    }
    const bool of_scene = key.find('.') != std::string::npos;
    const bool is_flag = contains(form_.flags, key);
    if (!of_scene && !is_flag && !contains(form_.options, key)) {
      return mistake_at(entry, form_.name + "." + key, "no such option of a run", key,
                        fmt::format("scenes, {}, or a key of the scene, such as system.lanes",
                                    fmt::join(all_keys(), ", ")));
    }
    if (is_flag) return add_flag(entry, key);
    Choice& choice = choices_.emplace_back();
    for (const Setting& value : values) {
      choice.values.push_back(
          of_scene ? std::vector<std::string>{"--set", key + "=" + settings::toml_value(value)}
                   : std::vector<std::string>{"--" + key + "=" + plain_text(value)});
    }
    return Done{};
  }

  Result<Done> read_portions(const Setting& entry) {
    const auto* count = std::get_if<std::int64_t>(&entry.value);
    constexpr std::int64_t most = 1'000'000;
    if (count == nullptr || *count < 1 || *count > most) {
      return mistake_at(entry, form_.name + ".portions", "no number of portions", entry.shown(),
                        fmt::format("1..{}", most));
    }
    portions_ = static_cast<int>(*count);
    return Done{};
  }

  Result<Done> add_flag(const Setting& entry, const std::string& key) {
    const auto* given = std::get_if<bool>(&entry.value);
    if (given == nullptr) {
      return mistake_at(entry, form_.name + "." + key, "wrong type", entry.shown(),
                        "true or false");
    }
    if (*given) choices_.push_back({{{"--" + option_of(key)}}});
    return Done{};
  }

  /// An option is written with dashes where a key has underscores.
  static std::string option_of(std::string key) {
    std::replace(key.begin(), key.end(), '_', '-');
    return key;
  }

  static bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  std::vector<std::string> all_keys() const {
    std::vector<std::string> keys = form_.options;
    keys.insert(keys.end(), form_.flags.begin(), form_.flags.end());
    if (form_.has_portions) keys.emplace_back("portions");
    return keys;
  }

  static std::vector<SuiteRun> combinations(const std::vector<SuiteRun>& runs,
                                            const Choice& choice) {
    std::vector<SuiteRun> result;
    for (const SuiteRun& run : runs) {
      for (const std::vector<std::string>& words : choice.values) {
        SuiteRun& one = result.emplace_back(run);
        for (const std::string& word : words) {
          one.options.push_back(word);
          one.name += " " + quoted(word);
        }
      }
    }
    return result;
  }

  const Setting& table_;
  const GroupForm& form_;
  int portions_ = 1;
  std::vector<std::string> scenes_;
  std::vector<Choice> choices_;
};

}  // namespace

const GroupForm& verify_group() {
  static const GroupForm form{.name = "run",
                              .options = {"first", "sample", "seed", "resets", "traffic", "truth",
                                          "simulator", "judge", "share"},
                              .flags = {},
                              .has_portions = true};
  return form;
}

Error mistake_in(const SuiteRun& run, const Error& error) {
  return {.file = run.file,
          .line = run.line,
          .field = run.group,
          .message = fmt::format("{}: {}", run.name, error.to_string()),
          .kind = error.kind};
}

Result<std::vector<SuiteRun>> read_groups(const settings::Settings& file, const GroupForm& form) {
  MIXCMP_TRY(tables, settings::tables_of(file, form.name, "one table for each group of runs"));
  std::vector<SuiteRun> all;
  for (const Setting& table : tables) {
    MIXCMP_TRY(runs, RunReader(table, form).read(file.path.parent_path()));
    all.insert(all.end(), runs.begin(), runs.end());
  }
  return all;
}

Result<Suite> read_suite(const fs::path& path) {
  MIXCMP_TRY(file, settings::read_settings(path, {}));
  Suite suite;
  settings::Section head(file, "suite");
  constexpr double most_minutes = 1e6;
  head.number("minutes", suite.minutes, 0, most_minutes);
  if (const auto error = head.finish()) return *error;
  for (const Setting& entry : file.root.entries) {
    if (entry.key == "suite" || entry.key == "run") continue;
    return mistake_at(entry, entry.key, "no such section of a suite", entry.key,
                      "[suite] and [[run]]");
  }
  MIXCMP_TRY(runs, read_groups(file, verify_group()));
  suite.runs = std::move(runs);
  if (suite.runs.empty()) {
    return Error{.file = path.string(),
                 .message = "a suite without a run",
                 .accepted = "one [[run]] at least"};
  }
  return suite;
}

}  // namespace mixcmp::cli
