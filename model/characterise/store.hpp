#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "model/characterise/synthesis.hpp"

struct sqlite3;

namespace mixcmp::characterise {

/// Results of synthesis, kept in one SQLite file under their jobs' hashes. A result is stored whole
/// or not at all, even if the program is interrupted; several processes may share the file.
class ResultStore {
public:
  /// Makes the file and its folders where there are none. It is an error if the file is no store,
  /// is damaged, or has another version.
  static Result<ResultStore> open(const std::filesystem::path& path);

  Result<std::optional<SynthesisResult>> find(const std::string& hash) const;
  /// Adds a result, or replaces the one with this hash. `tools` is kept for people who read the
  /// file.
  Result<Done> add(const std::string& hash, const SynthesisResult& result,
                   const std::string& tools);
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
  Database database_;
};

/// $XDG_CACHE_HOME/mixcmp/characterisation.sqlite, $HOME/.cache/... where that is not set.
Result<std::filesystem::path> default_store_path();

}  // namespace mixcmp::characterise
