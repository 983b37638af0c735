#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "generator/synthesis/characterise/result_folder.hpp"
#include "generator/synthesis/characterise/synthesis.hpp"

struct sqlite3;

namespace mixcmp::characterise {

/// Results of synthesis, stored under their jobs' hashes in one SQLite file, or in a folder with a
/// file for each (ResultFolder). A result is stored whole or not at all, even if the program is
/// interrupted. Several processes may share the store, and several machines a folder.
class ResultStore {
public:
  /// Opens `path` if it is a folder. Otherwise it is a file, which is made with its folders if it
  /// does not exist. An error if the file is no store, is damaged, or has another version.
  static Result<ResultStore> open(const std::filesystem::path& path);

  Result<std::optional<SynthesisResult>> find(const std::string& hash) const;
  /// Adds a result, or replaces the one with this hash. `tools` is stored for people who read the
  /// file.
  Result<Done> add(const std::string& hash, const SynthesisResult& result,
                   const std::string& tools);
  /// The number of results in the SQLite file.
  Result<int> size() const;

  const std::filesystem::path& path() const { return path_; }

private:
  struct Closer {
    void operator()(sqlite3* database) const;
  };
  using Database = std::unique_ptr<sqlite3, Closer>;

  ResultStore(std::filesystem::path path, Database database)
      : path_(std::move(path)), database_(std::move(database)) {}
  Result<Done> prepare();
  Result<Done> check_identity();
  Result<Done> create();

  std::filesystem::path path_;
  Database database_;                   ///< null: the store is a folder
  std::optional<ResultFolder> folder_;  ///< none: the store is a file
};

/// $XDG_CACHE_HOME/mixcmp/characterisation.sqlite, or $HOME/.cache/... if that is not set.
Result<std::filesystem::path> default_store_path();

}  // namespace mixcmp::characterise
