#include "model/comparison/data/csv.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/base/common/file.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/number/decimal.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/data/number.hpp"

namespace mixcmp::data {
namespace {

struct Record {
  int line;
  std::vector<std::string> fields;
};

/// Splits a text into records, one at a time.
class RecordReader {
public:
  explicit RecordReader(std::string_view text) : text_(text) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (text_.starts_with(byte_order_mark)) place_ = byte_order_mark.size();
  }

  /// False at the end of the text.
  bool more() {
    while (place_ < text_.size() && (text_[place_] == '\n' || at_carriage_return())) {
      line_ += text_[place_] == '\n';
      ++place_;
    }
    return place_ < text_.size();
  }

  Result<Record> next() {
    Record record{.line = line_};
    while (true) {
      MIXCMP_TRY(field, next_field());
      record.fields.push_back(std::move(field));
      if (place_ < text_.size() && text_[place_] == ',') {
        ++place_;
        continue;
      }
      return record;
    }
  }

private:
  bool at_carriage_return() const {
    return text_[place_] == '\r' && (place_ + 1 == text_.size() || text_[place_ + 1] == '\n');
  }
  bool at_field_end() const {
    return place_ == text_.size() || text_[place_] == ',' || text_[place_] == '\n' ||
           at_carriage_return();
  }

  Result<std::string> next_field() {
    if (place_ < text_.size() && text_[place_] == '"') return next_quoted();
    const std::size_t begin = place_;
    while (!at_field_end()) ++place_;
    return std::string(text_.substr(begin, place_ - begin));
  }

  Result<std::string> next_quoted() {
    const int opened = line_;
    std::string field;
    for (++place_; place_ < text_.size(); ++place_) {
      const bool quote = text_[place_] == '"';
      const bool doubled = quote && text_.substr(place_ + 1).starts_with('"');
      if (quote && !doubled) break;
      place_ += doubled;
      line_ += text_[place_] == '\n';
      field += text_[place_];
    }
    if (place_ == text_.size()) {
      return Error{.line = opened,
                   .message = "a quoted field is not closed",
                   .received = "the end of the file",
                   .accepted = "a closing '\"'"};
    }
    ++place_;
    if (at_field_end()) return field;
    return Error{.line = line_,
                 .message = "text after a quoted field",
                 .received = fmt::format("'{}'", text_[place_]),
                 .accepted = "',' or the end of the line; quotes inside quotes doubled"};
  }

  std::string_view text_;
  std::size_t place_ = 0;
  int line_ = 1;
};

/// A guess at the form of a line that does not consist of fields between commas: "separated by
/// ';'". Empty if nothing is suspicious.
std::string likely_form(const Record& record) {
  const auto count = [&](char c) {
    std::size_t all = 0;
    for (const std::string& field : record.fields) {
      all += static_cast<std::size_t>(std::count(field.begin(), field.end(), c));
    }
    return all;
  };
  const std::string_view first = record.fields.front();
  const std::size_t commas = record.fields.size() - 1;
  const bool blank = std::all_of(record.fields.begin(), record.fields.end(),
                                 [](const std::string& field) { return trimmed(field).empty(); });
  if (blank) return "blank";
  if (count('\0') > 0) return "text in UTF-16, or no text";
  if (first.starts_with('#') || first.starts_with('%')) return "a comment";
  if (count('\r') > 0) return "several lines that end in CR without LF";
  if (count(';') > commas) return "separated by ';'";
  if (count('\t') > commas) return "separated by tabs";
  if (commas == 0 && trimmed(first).find(' ') != std::string_view::npos) {
    return "separated by blanks";
  }
  return {};
}

bool is_number(FloatFormat format, std::string_view text) {
  return from_text(format, trimmed(text)).ok();
}

/// The error for a missing column; it says so if the first line seems to be no header.
Error without_column(Error missing, const Record& header, FloatFormat format) {
  std::string seems = likely_form(header);
  const auto number = [&](const std::string& field) { return is_number(format, field); };
  if (seems.empty() && std::all_of(header.fields.begin(), header.fields.end(), number)) {
    seems = "numbers";
  }
  if (seems.empty()) return missing;
  missing.received = "a first line that seems to be " + seems;
  missing.accepted = "a first line that names the columns, with ',' between them";
  return missing;
}

Error two_columns(const std::string& name, std::span<const std::string> names) {
  const auto first = std::find(names.begin(), names.end(), name);
  const auto second = std::find(std::next(first), names.end(), name);
  return {.field = name,
          .message = "two columns of this name",
          .received = fmt::format("{} of them", std::count(names.begin(), names.end(), name)),
          .accepted = fmt::format("one, or the column's number in place of its name, here {} or {}",
                                  first - names.begin(), second - names.begin())};
}

/// Finds a wanted column of the file. The name of a column that is chosen by number must not be a
/// number: then the file has no header, and its first row would be lost.
Result<FileColumn> locate_column(const WantedColumn& wanted, std::span<const std::string> names,
                                 const Record& header, FloatFormat format,
                                 const std::string& source) {
  const Result<std::size_t> place = find_column(wanted, names, source);
  if (!place.ok()) {
    const bool missing = place.error().kind == ErrorKind::missing_column;
    return missing ? without_column(place.error(), header, format) : place.error();
  }
  const std::string& name = names[*place];
  const bool by_name = std::holds_alternative<std::string>(wanted.column);
  if (by_name && std::count(names.begin(), names.end(), name) > 1) return two_columns(name, names);
  if (!by_name && is_number(format, name)) {
    return Error{.message = "the first line seems to hold numbers, not names of columns",
                 .received = fmt::format("{} in column {}", in_quotes(name), *place),
                 .accepted =
                     "a first line that names the columns; in the scene, the name of a "
                     "column that is called like a number"};
  }
  return FileColumn{.number = *place, .name = printable_line(name)};
}

/// The wanted columns, in their order.
Result<std::vector<FileColumn>> find_columns(const Record& header, FloatFormat format,
                                             std::span<const WantedColumn> wanted,
                                             const std::string& source) {
  std::vector<std::string> names;
  for (const std::string& name : header.fields) names.emplace_back(trimmed(name));
  std::vector<FileColumn> columns;
  for (const WantedColumn& column : wanted) {
    const Result<FileColumn> found = locate_column(column, names, header, format, source);
    if (!found.ok()) {
      Error error = found.error();
      if (error.file.empty()) error.line = header.line;
      return error;
    }
    columns.push_back(*found);
  }
  return columns;
}

Result<Done> append_row(Table& table, const Record& record, std::size_t field_count,
                        std::span<const WantedColumn> wanted) {
  if (record.fields.size() != field_count) {
    const std::string seems = likely_form(record);
    return Error{.line = record.line,
                 .message = "wrong number of fields",
                 .received = fmt::format("{}{}", record.fields.size(),
                                         seems.empty() ? "" : ", the line seems to be " + seems),
                 .accepted = fmt::format("{}, as in the first line", field_count)};
  }
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const FileColumn& column = table.origins[k];
    const std::string_view text = record.fields[column.number];
    const FloatFormat rounded_to = wanted[k].rounded_to.value_or(table.format);
    const Result<Bits> number = read_number(rounded_to, text);
    if (!number.ok()) {
      Error error = number.error();
      error.line = record.line;
      error.field = column.shown();
      return error;
    }
    table.values.push_back(converted(table.format, rounded_to, *number));
    if (is_lost(rounded_to, text, *number)) {
      table.lost.add(
          {1, fmt::format("{} in {}, line {}, {}, read in {}", trimmed(text), table.source,
                          record.line, column.shown(), rounded_to.name())});
    }
  }
  table.lines.push_back(record.line);
  return Done{};
}

Result<Table> parse_csv(std::string_view text, FloatFormat format,
                        std::span<const WantedColumn> wanted, const std::string& source) {
  RecordReader records(text);
  if (!records.more()) {
    return Error{.message = "no header",
                 .received = "an empty file",
                 .accepted = "a first line that names the columns"};
  }
  MIXCMP_TRY(header, records.next());
  MIXCMP_TRY(columns, find_columns(header, format, wanted, source));
  Table table{.format = format, .columns = {}, .source = source, .origins = std::move(columns)};
  for (const WantedColumn& column : wanted) table.columns.push_back(column.name);
  while (records.more()) {
    MIXCMP_TRY(record, records.next());
    const Result<Done> appended = append_row(table, record, header.fields.size(), wanted);
    if (!appended.ok()) return appended.error();
  }
  return table;
}

}  // namespace

Result<Table> read_csv(const std::filesystem::path& path, FloatFormat format,
                       std::span<const WantedColumn> wanted) {
  MIXCMP_TRY(text, read_file(path));
  Result<Table> table = parse_csv(text, format, wanted, path.filename().string());
  if (table.ok()) return table;
  Error error = table.error();
  if (error.file.empty()) error.file = path.string();
  return error;
}

}  // namespace mixcmp::data
