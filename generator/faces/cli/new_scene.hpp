#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/faces/cli/options.hpp"
#include "model/comparison/data/pairing.hpp"

namespace mixcmp::cli {

/// The answers from which `mixcmp new` makes a scene.
struct NewScene {
  std::filesystem::path path;  ///< of the scene file, which need not exist
  std::string name;
  std::string f;
  std::string g;
  std::string reference;  ///< empty: as the data suggest, without data s53e8
  std::string device;
  std::string file;  ///< of data, as seen from the scene's folder; empty: no data
  std::string with;  ///< the second file, where the pairing has two; as seen from there
  data::Pairing pairing = data::Pairing::rows;
  /// A column with another name than its input: the scene's name, and the file's name or number of
  /// the column. Several columns have commas between them.
  using Column = std::pair<std::string, std::string>;
  std::vector<Column> columns;
  std::vector<Column> with_columns;
};

/// Reads the scene with its data, as `mixcmp check` would read its file. Unless --reference says
/// otherwise, operands arrive as integers where a .npy file has these and the scene's systems can
/// take them, and floats of at most 32 bits make s24e8 the reference. Functions make it one in
/// fixed point, whose bits follow from the ranges. Errors name the option of `mixcmp new` from
/// which a value came.
Result<LoadedScene> load_new(const NewScene& scene);

/// Why operands do not arrive as integers although the data have some; none where they do.
std::optional<Error> why_not_integers(const NewScene& scene, const LoadedScene& loaded);

/// The text of the scene file: every key with a sentence, and the commands that come next. An input
/// has the range of its data, if it has finite ones. Without data, references in fixed point need
/// some range, and operands are drawn from it.
std::string scene_text(const NewScene& scene, const LoadedScene& loaded);

/// The commands that come next, each with its purpose. `file` names the scene as seen from the
/// folder in which they will be typed; the plan is made beside it.
std::vector<std::pair<std::string, std::string>> next_commands(const LoadedScene& loaded,
                                                               const std::filesystem::path& file);

/// The text of those commands. Each has a line that begins with `margin`, and its purpose stands in
/// a column behind them.
std::string next_text(const LoadedScene& loaded, const std::filesystem::path& file,
                      const std::string& margin);

}  // namespace mixcmp::cli
