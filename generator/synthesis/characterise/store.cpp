#include "generator/synthesis/characterise/store.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>

#include "generator/synthesis/characterise/sqlite.hpp"
#include "model/base/common/cache_folder.hpp"
#include "model/base/common/folder_lock.hpp"
#include "model/base/common/output_file.hpp"

namespace mixcmp::characterise {
namespace {

using measured::Clock;
using measured::ClockSource;

/// SQLite's application_id, which marks a file as ours: "mxcm".
constexpr int application_id = 0x6d78636d;
constexpr int layout_version = 1;
/// The time to wait for another process. It locks the file for one insertion at a time.
constexpr int patience_ms = 60'000;

constexpr const char* layout =
    "CREATE TABLE result (hash TEXT PRIMARY KEY, tools TEXT NOT NULL, luts INT NOT NULL,"
    " registers INT NOT NULL, dsps INT NOT NULL, memories INT NOT NULL, carries INT NOT NULL,"
    " shift_luts INT NOT NULL, mhz REAL, low_mhz REAL, high_mhz REAL, seeds INT, routed INT,"
    " no_clock TEXT NOT NULL) WITHOUT ROWID;";

Result<int> pragma(const std::filesystem::path& path, sqlite3* database, const std::string& name) {
  Statement statement(database, "PRAGMA " + name);
  if (statement.step() != SQLITE_ROW) return sqlite_error(path, database);
  return statement.integer(0);
}

SynthesisResult result_of(const Statement& row) {
  SynthesisResult result;
  result.area = {.luts = row.integer(0),
                 .registers = row.integer(1),
                 .dsps = row.integer(2),
                 .memories = row.integer(3),
                 .carries = row.integer(4),
                 .shift_luts = row.integer(5)};
  if (!row.is_null(6)) {
    const bool routed = row.integer(10) != 0;
    result.clock = {.mhz = row.real(6),
                    .low_mhz = row.real(7),
                    .high_mhz = row.real(8),
                    .seeds = row.integer(9),
                    .source = routed ? ClockSource::routed : ClockSource::estimate_before_routing};
  }
  result.no_clock = row.text(11);
  return result;
}

void bind_clock(Statement& statement, const std::optional<Clock>& clock) {
  if (!clock) {
    for (int parameter = 9; parameter <= 13; ++parameter) statement.bind_null(parameter);
    return;
  }
  statement.bind(9, clock->mhz).bind(10, clock->low_mhz).bind(11, clock->high_mhz);
  statement.bind(12, clock->seeds).bind(13, clock->source == ClockSource::routed ? 1 : 0);
}

}  // namespace

void ResultStore::Closer::operator()(sqlite3* database) const {
  sqlite3_close(database);
}

Result<ResultStore> ResultStore::open(const std::filesystem::path& path) {
  std::error_code failed;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), failed);
  if (failed) {
    return Error{.file = path.parent_path().string(),
                 .message = "cannot be created: " + failed.message()};
  }
  const std::filesystem::file_status status = std::filesystem::status(path, failed);
  if (std::filesystem::is_directory(status)) {
    MIXCMP_DO(make_writable_folder(path));
    ResultStore store(path, nullptr);
    store.folder_.emplace(path);
    return store;
  }
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    return Error{.file = path.string(),
                 .message = "is no file that can hold results",
                 .received = "a device or a pipe",
                 .accepted = "a store of mixcmp, a folder, or a path where nothing is yet"};
  }
  if (std::filesystem::exists(status) && access(path.c_str(), R_OK | W_OK) != 0) {
    return cannot_write(path, errno);
  }
  sqlite3* opened = nullptr;
  sqlite3_open(path.c_str(), &opened);
  ResultStore store(path, Database(opened));
  MIXCMP_DO(store.prepare());
  return store;
}

/// Checks or creates the table in one transaction: two processes may both find the file empty.
Result<Done> ResultStore::prepare() {
  sqlite3* database = database_.get();
  if (sqlite3_errcode(database) != SQLITE_OK) return sqlite_error(path_, database);
  sqlite3_busy_timeout(database, patience_ms);
  MIXCMP_DO(execute(path_, database, "BEGIN IMMEDIATE"));
  const Result<Done> fitting = check_identity();
  MIXCMP_DO(execute(path_, database, fitting.ok() ? "COMMIT" : "ROLLBACK"));
  return fitting;
}

Result<Done> ResultStore::check_identity() {
  sqlite3* database = database_.get();
  MIXCMP_TRY(owner, pragma(path_, database, "application_id"));
  MIXCMP_TRY(version, pragma(path_, database, "user_version"));
  MIXCMP_TRY(changes, pragma(path_, database, "schema_version"));
  if (changes == 0 && owner == 0) return create();
  if (owner != application_id || version != layout_version) {
    return Error{.file = path_.string(),
                 .message = owner != application_id ? "is a database of something else"
                                                    : "is a store of another version of mixcmp",
                 .received = fmt::format("application {:#x}, version {}", owner, version),
                 .accepted = fmt::format("application {:#x}, version {}; or a path where no file "
                                         "is yet",
                                         application_id, layout_version)};
  }
  Statement check(database, "PRAGMA quick_check(1)");
  if (check.step() != SQLITE_ROW) return sqlite_error(path_, database);
  if (check.text(0) == "ok") return Done{};
  return Error{.file = path_.string(),
               .message = "is a damaged store; without it everything is measured again",
               .received = check.text(0),
               .accepted = "a sound file, or a path where none is yet"};
}

Result<Done> ResultStore::create() {
  return execute(path_, database_.get(),
                 fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}; {}",
                             application_id, layout_version, layout));
}

Result<std::optional<SynthesisResult>> ResultStore::find(const std::string& hash) const {
  if (folder_) return folder_->find(hash);
  Statement statement(database_.get(),
                      "SELECT luts, registers, dsps, memories, carries, shift_luts, mhz, low_mhz,"
                      " high_mhz, seeds, routed, no_clock FROM result WHERE hash = ?");
  switch (statement.bind(1, hash).step()) {
    case SQLITE_ROW: return std::optional(result_of(statement));
    case SQLITE_DONE: return std::optional<SynthesisResult>();
    default: return sqlite_error(path_, database_.get());
  }
}

Result<Done> ResultStore::add(const std::string& hash, const SynthesisResult& result,
                              const std::string& tools) {
  if (folder_) return folder_->add(hash, result, tools);
  Statement statement(database_.get(),
                      "INSERT OR REPLACE INTO result VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  const devices::Area& area = result.area;
  statement.bind(1, hash).bind(2, tools).bind(3, area.luts).bind(4, area.registers);
  statement.bind(5, area.dsps).bind(6, area.memories).bind(7, area.carries);
  statement.bind(8, area.shift_luts);
  bind_clock(statement, result.clock);
  if (statement.bind(14, result.no_clock).step() == SQLITE_DONE) return Done{};
  return sqlite_error(path_, database_.get());
}

Result<int> ResultStore::size() const {
  MIXCMP_CHECK(!folder_);
  Statement statement(database_.get(), "SELECT count(*) FROM result");
  if (statement.step() != SQLITE_ROW) return sqlite_error(path_, database_.get());
  return statement.integer(0);
}

Result<std::filesystem::path> default_store_path() {
  if (const auto cache = cache_folder()) return *cache / "characterisation.sqlite";
  return Error{.field = "--store",
               .message = "no place for the store of results",
               .received = "neither $XDG_CACHE_HOME nor $HOME is an absolute path",
               .accepted = "--store FILE"};
}

}  // namespace mixcmp::characterise
