#include "generator/synthesis/characterise/sqlite.hpp"

namespace mixcmp::characterise {

Error sqlite_error(const std::filesystem::path& path, sqlite3* database) {
  const int code = sqlite3_errcode(database);
  const bool damaged = code == SQLITE_NOTADB || code == SQLITE_CORRUPT;
  return {.file = path.string(),
          .message = damaged ? "is no SQLite file, or a damaged one" : "SQLite cannot go on",
          .received = sqlite3_errmsg(database),
          .accepted = "a store of mixcmp, or a path where none is yet"};
}

Result<Done> execute(const std::filesystem::path& path, sqlite3* database, const std::string& sql) {
  if (sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK) return Done{};
  return sqlite_error(path, database);
}

Statement::Statement(sqlite3* database, const std::string& sql)
    : prepared_(sqlite3_prepare_v2(database, sql.c_str(), -1, &statement_, nullptr)) {}

Statement::~Statement() {
  sqlite3_finalize(statement_);
}

Statement& Statement::bind(int parameter, const std::string& text) {
  sqlite3_bind_text(statement_, parameter, text.c_str(), -1, SQLITE_TRANSIENT);
  return *this;
}

Statement& Statement::bind(int parameter, int number) {
  sqlite3_bind_int(statement_, parameter, number);
  return *this;
}

Statement& Statement::bind(int parameter, double number) {
  sqlite3_bind_double(statement_, parameter, number);
  return *this;
}

Statement& Statement::bind_null(int parameter) {
  sqlite3_bind_null(statement_, parameter);
  return *this;
}

int Statement::step() {
  return prepared_ == SQLITE_OK ? sqlite3_step(statement_) : prepared_;
}

int Statement::integer(int column) const {
  return sqlite3_column_int(statement_, column);
}

double Statement::real(int column) const {
  return sqlite3_column_double(statement_, column);
}

std::string Statement::text(int column) const {
  const unsigned char* text = sqlite3_column_text(statement_, column);
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}

}  // namespace mixcmp::characterise
