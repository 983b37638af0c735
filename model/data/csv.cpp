#include "model/data/csv.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/common/file.hpp"
#include "model/data/column_names.hpp"
#include "model/data/number.hpp"

namespace mixcmp::model {
namespace {

struct Record {
  int line;
  std::vector<std::string> fields;
};

/// Takes a text apart into records, one at a time.
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

/// Where each wanted column stands in the header.
Result<std::vector<std::size_t>> find_columns(const Record& header,
                                              std::span<const std::string> wanted) {
  std::vector<std::string> names;
  for (const std::string& name : header.fields) names.emplace_back(trimmed(name));
  std::vector<std::size_t> places;
  for (const std::string& column : wanted) {
    const auto found = std::find(names.begin(), names.end(), column);
    const auto times = std::count(names.begin(), names.end(), column);
    if (times == 0) {
      Error error = missing_column(column, names);
      error.line = header.line;
      return error;
    }
    if (times > 1) {
      return Error{.line = header.line,
                   .field = column,
                   .message = "two columns of this name",
                   .received = fmt::format("{} of them", times),
                   .accepted = "one"};
    }
    places.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return places;
}

Result<Done> append_row(Table& table, const Record& record, const Record& header,
                        std::span<const std::size_t> places) {
  if (record.fields.size() != header.fields.size()) {
    return Error{.line = record.line,
                 .message = "wrong number of fields",
                 .received = fmt::format("{}", record.fields.size()),
                 .accepted = fmt::format("{}, as in the first line", header.fields.size())};
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Result<Bits> number = read_number(table.format, record.fields[places[k]]);
    if (!number.ok()) {
      Error error = number.error();
      error.line = record.line;
      error.field = table.columns[k];
      return error;
    }
    table.values.push_back(*number);
  }
  return Done{};
}

Result<Table> parse_csv(std::string_view text, FloatFormat format,
                        std::span<const std::string> columns) {
  RecordReader records(text);
  if (!records.more()) {
    return Error{.message = "no header",
                 .received = "an empty file",
                 .accepted = "a first line that names the columns"};
  }
  MIXCMP_TRY(header, records.next());
  MIXCMP_TRY(places, find_columns(header, columns));
  Table table{.format = format, .columns = {columns.begin(), columns.end()}};
  while (records.more()) {
    MIXCMP_TRY(record, records.next());
    const Result<Done> appended = append_row(table, record, header, places);
    if (!appended.ok()) return appended.error();
  }
  return table;
}

}  // namespace

Result<Table> read_csv(const std::filesystem::path& path, FloatFormat format,
                       std::span<const std::string> columns) {
  MIXCMP_TRY(text, read_file(path));
  Result<Table> table = parse_csv(text, format, columns);
  if (table.ok()) return table;
  Error error = table.error();
  error.file = path.string();
  return error;
}

}  // namespace mixcmp::model
