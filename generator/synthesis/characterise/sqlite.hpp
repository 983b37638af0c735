#pragma once

#include <sqlite3.h>

#include <filesystem>
#include <string>

#include "model/base/common/result.hpp"

namespace mixcmp::characterise {

/// SQLite's last error, as an error of the file.
Error sqlite_error(const std::filesystem::path& path, sqlite3* database);

/// Executes statements that return no rows.
Result<Done> execute(const std::filesystem::path& path, sqlite3* database, const std::string& sql);

/// A prepared statement with its values. As in SQLite, columns count from 0 and parameters from 1.
/// An error of preparation is returned by `step`.
class Statement {
public:
  Statement(sqlite3* database, const std::string& sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& bind(int parameter, const std::string& text);
  Statement& bind(int parameter, int number);
  Statement& bind(int parameter, double number);
  Statement& bind_null(int parameter);

  /// Returns SQLITE_ROW, SQLITE_DONE or an error code.
  int step();
  int integer(int column) const;
  double real(int column) const;
  std::string text(int column) const;
  bool is_null(int column) const;

private:
  sqlite3_stmt* statement_ = nullptr;
  int prepared_;
};

}  // namespace mixcmp::characterise
