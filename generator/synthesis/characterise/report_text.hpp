#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/common/result.hpp"

/// Common parts of vendors' reports: lines, fields "name : value", and tables.
namespace mixcmp::characterise {

/// A value and its line, 1-based.
struct ReportField {
  std::string text;
  int line = 0;
};

/// A report, by lines.
class ReportText {
public:
  ReportText(std::filesystem::path path, std::string_view text);

  const std::filesystem::path& path() const { return path_; }
  int size() const { return static_cast<int>(lines_.size()); }
  /// The text of a line, 1-based, without its end.
  const std::string& line(int number) const {
    return lines_.at(static_cast<std::size_t>(number) - 1);
  }

  /// The first line from `from` on that contains `words`; 0 if there is none.
  int find(std::string_view words, int from = 1) const;

  Error error(int line, std::string message, std::string received, std::string accepted) const;
  /// The error of a report in which a section or a field is missing.
  Error missing(const std::string& what) const;

private:
  std::filesystem::path path_;
  std::vector<std::string> lines_;
};

/// `text` without blanks at its ends.
std::string trimmed(std::string_view text);

/// The cells of a table's line, "| a | b |" or "; a ; b ;", with their blanks.
std::vector<std::string> cells_of(const std::string& line, char separator);

/// A table of a report with the names of its columns.
class ReportTable {
public:
  /// The table whose header is at this line. A rule follows the header, and a rule ends the table.
  ReportTable(const ReportText& report, int header_line, char separator);

  /// The lines of the table's records.
  const std::vector<int>& records() const { return records_; }
  /// The column with this name; none if there is no such column.
  std::optional<std::size_t> column(std::string_view name) const;
  std::vector<std::size_t> columns_that(bool (*wanted)(const std::string& name)) const;

  /// The cell of a record, with its blanks. An error if the record and the header have different
  /// numbers of cells.
  Result<std::string> cell(int line, std::size_t column) const;
  /// The number at the start of a cell, rounded up to an integer: "2825.0 (1208.7)" is 2825.
  Result<int> count(int line, std::size_t column) const;

private:
  const ReportText& report_;
  char separator_;
  std::vector<std::string> names_;
  std::vector<int> records_;
};

/// The number at the start of `text`; none if there is no number.
std::optional<double> leading_number(std::string_view text);

}  // namespace mixcmp::characterise
