#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "generator/faces/cli/verb.hpp"
#include "generator/tasks/scene.hpp"
#include "model/base/common/command_line.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/number/bound.hpp"
#include "model/comparison/data/comparisons.hpp"
#include "model/design/design.hpp"

namespace mixcmp::cli {

/// The options that all verbs with a scene share.
struct SceneOptions {
  std::filesystem::path scene;
  std::vector<std::string> settings;  ///< "section.key=value", shortcuts included
  /// The shortcut that has set a key, by key: errors name it.
  std::map<std::string, std::string> shortcuts;
  bool json = false;

  tasks::SceneRequest request() const { return {scene, settings}; }
};

enum class SceneArgument {
  required,
  optional,  ///< the verb itself checks that something else is given
};

/// Adds SCENE, --set, the shortcuts (--format, --lanes, ...) and --json to a verb. Shortcuts that
/// mean something else to it, or nothing, are `left_out`.
void add_scene_options(const Verb& verb, SceneOptions& options,
                       const std::set<std::string>& left_out = {},
                       SceneArgument argument = SceneArgument::required);

using tasks::check_has_data;
using tasks::LoadedScene;

/// Loads the scene and its data, and shows the progress of a long search for arg-mins.
Result<LoadedScene> load(const SceneOptions& options);

/// The error with the place where the user wrote the value at fault: the key's line in a file, or
/// the shortcut that set it.
Error as_user_error(const Error& found, const SceneOptions& options);

/// The error of a task, which names a key's place, with the shortcut that set the key.
Error with_shortcut(Error error, const SceneOptions& options);

/// The result of a task, whose error gets its shortcut.
template <class T>
Result<T> with_shortcuts(Result<T> result, const SceneOptions& options) {
  if (!result.ok()) return with_shortcut(result.error(), options);
  return result;
}

/// The scene with the lanes of its chain, by design::with_chain_lanes. `data` may be null.
Result<scene::Scene> with_chain_lanes(const scene::Scene& scene, const data::Comparisons* data,
                                      const SceneOptions& options);

/// Accepts a whole number in these limits, which help and errors then state. It is decimal, without
/// zeros in front: CLI11 would take "010" for eight.
Condition within(settings::Limits limits);
Condition whole(std::uint64_t least,
                std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// One of several shards or portions, as an option names it: "2/8" is the second of eight.
struct Fraction {
  std::uint64_t number = 1;
  std::uint64_t count = 1;
};
std::optional<Fraction> fraction_of(const std::string& text);
/// Accepts the text of a Fraction.
Condition a_fraction();

/// The number that fills `text`; none for any other text.
std::optional<double> number(const std::string& text);

/// The value of an option as the user writes it: a list has commas, and nothing is no text.
std::string text_of(const std::optional<double>& value);
std::string text_of(const std::vector<std::string>& words);
std::string text_of(const std::vector<Bound>& bounds);
std::string text_of(const std::vector<LaneInputs>& inputs);
std::string text_of(const std::vector<scene::Multipliers>& multipliers);

/// Accepts a number in these limits, but not NaN.
Condition between(double least, double most, const std::string& unit);

/// Reads the kinds of inputs given for this option: "exact", "rounded", or up to `most` digits.
Result<std::vector<LaneInputs>> parse_inputs(const std::string& option,
                                             const std::vector<std::string>& words, int most);

/// Reads the names of error bounds given for this option.
Result<std::vector<Bound>> parse_bounds(const std::string& option,
                                        const std::vector<std::string>& names);

/// The design of the scene's system. Errors name the file and line of the key at fault.
Result<design::Design> design_of(const SceneOptions& options, const LoadedScene& loaded);

/// The files that the scene is read from: its own, its plans, its device, its data.
std::vector<std::filesystem::path> inputs_of(const SceneOptions& options,
                                             const scene::Scene& scene);

/// The verb and its settings as a command that gives the same result. It names the scene by its
/// file name, without folders, since it is printed into generated files.
CommandLine command_line(const std::string& verb, const SceneOptions& options);

/// As command_line, but with the scene's whole path: a command for the terminal.
CommandLine runnable_command(const std::string& verb, const SceneOptions& options);

}  // namespace mixcmp::cli
