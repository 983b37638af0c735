#include "generator/cli/suite_file.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "generator/cli/options.hpp"
#include "model/settings/section.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;
using settings::Setting;

/// The options of `mixcmp verify` that a suite can give.
constexpr std::array<const char*, 9> option_names = {
    "first", "sample", "seed", "resets", "traffic", "truth", "simulator", "judge", "share"};

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

/// Reads the table of one [[run]].
class RunReader {
public:
  explicit RunReader(const Setting& table) : table_(table) {}

  Result<std::vector<SuiteRun>> read(const fs::path& folder) {
    MIXCMP_TRY(done, add_entries(std::get<Setting::Table>(table_.value), ""));
    if (scenes_.empty()) {
      return mistake_at(table_, "run.scenes", "a run without a scene", "no such key",
                        "one scene file or a list of them");
    }
    std::vector<SuiteRun> runs;
    for (const std::string& scene : scenes_) {
      runs.push_back({.scene = folder / scene, .options = {}, .name = scene});
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
        return mistake_at(entry, "run." + key, "cannot be the value of an option", value.kind(),
                          "a number, a text, true, false, or a list of these");
      }
      MIXCMP_TRY(added, add_choice(entry, key));
    }
    return Done{};
  }

  Result<Done> add_choice(const Setting& entry, const std::string& key) {
    const std::vector<Setting> values = values_of(entry);
    if (values.empty()) {
      return mistake_at(entry, "run." + key, "no run has this option", "an empty list",
                        "one value at least");
    }
    if (key == "scenes") {
      for (const Setting& value : values) scenes_.push_back(plain_text(value));
      return Done{};
    }
    const bool of_scene = key.find('.') != std::string::npos;
    const bool known =
        std::find(option_names.begin(), option_names.end(), key) != option_names.end();
    if (!of_scene && !known) {
      return mistake_at(entry, "run." + key, "no such option of a run", key,
                        fmt::format("scenes, {}, or a key of the scene, such as system.lanes",
                                    fmt::join(option_names, ", ")));
    }
    Choice& choice = choices_.emplace_back();
    for (const Setting& value : values) {
      choice.values.push_back(
          of_scene ? std::vector<std::string>{"--set", key + "=" + settings::toml_value(value)}
                   : std::vector<std::string>{"--" + key + "=" + plain_text(value)});
    }
    return Done{};
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
  std::vector<std::string> scenes_;
  std::vector<Choice> choices_;
};

}  // namespace

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
  MIXCMP_TRY(tables, settings::tables_of(file, "run", "one table for each group of runs"));
  for (const Setting& table : tables) {
    MIXCMP_TRY(runs, RunReader(table).read(path.parent_path()));
    suite.runs.insert(suite.runs.end(), runs.begin(), runs.end());
  }
  if (suite.runs.empty()) {
    return Error{.file = path.string(),
                 .message = "a suite without a run",
                 .accepted = "one [[run]] at least"};
  }
  return suite;
}

}  // namespace mixcmp::cli
