#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// Results as data: tables of rows, and named values. Each form, JSON, CSV, text, Markdown and (in
/// page) HTML, has one writer.
namespace mixcmp::table {

using Json = nlohmann::ordered_json;

/// One column: its name and form for programs, its title and form for people.
struct Column {
  std::string name;            ///< the field in JSON and CSV: "throughput_per_s"
  std::string title = {};      ///< the heading in text and HTML: "G/s"
  int width = 0;               ///< of text, aligned to the right; 0: aligned to the left
  int gap = 2;                 ///< blanks before the column in text
  std::string shown = "{}";    ///< fmt's form of a number in text and HTML
  double unit = 1;             ///< the unit in which people read numbers: 1e9 for G/s
  std::string in_csv = "{}";   ///< fmt's form of a cell in CSV
  std::string group = {};      ///< a second heading, above adjacent columns
  bool may_be_absent = false;  ///< a missing cell has no field in JSON objects
};

/// Cells by column. A null cell is missing: null in JSON, nothing in CSV, `Table::missing` for
/// people.
struct Row {
  std::vector<Json> cells;
  std::string remark = {};  ///< says why the other cells are worth nothing; empty: they are valid
};

struct Table {
  std::vector<Column> columns = {};
  std::vector<Row> rows = {};
  std::string missing = "-";
  std::string remark_name = {};  ///< the field of remarks in JSON
};

/// A table for programs.
Table named_table(const std::vector<std::string>& names);
/// A table of texts that only people read.
Table text_table(const std::vector<std::string>& titles);

/// Objects with the columns' names. A row with a remark has only its first cell and the remark.
Json to_json(const Table& table);
/// In rows with a remark, the last cell is the remark.
std::string to_csv(const Table& table);
/// The headings, then a line for each row. A remark follows the row's first cell that has a text.
std::string to_text(const Table& table);
std::string to_markdown(const Table& table);

/// The headings, and the cells of a row, as people read them.
std::vector<std::string> shown_titles(const Table& table);
std::vector<std::string> shown_cells(const Table& table, const Row& row);

/// A cell that may be missing.
template <class Value>
Json cell(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

/// A value as a cell; an enumerator by its name.
template <class Value>
Json json_of(const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    return to_string(value);
  } else {
    return value;
  }
}

/// A cell in a form of fmt, which may also name fields of an object: "{lanes} of {all_lanes}".
std::string in_words(const std::string& form, const Json& cell, const Json& object);

/// A line about a thing: a name, and a text behind it. A line without a text is only its name.
struct Line {
  std::string name;
  std::string text = {};
  int indent = 2;
};
using Lines = std::vector<Line>;

/// All texts begin `text_column` letters from the left.
std::string to_text(const Lines& lines, int text_column);

/// A column of a type of rows, and its cell. `value`: a member of the row, or a function of it.
///   const Fields<Plan> fields = {{{"lanes", "p_L", 5}, &Plan::lanes}};
///   to_text(table_of(fields, plans));
/// A single thing has no table: each field is then one of a JSON object, and a line if it has a
/// title. The line's text may be given, as a form with names of fields ("{lanes} of {all_lanes}")
/// or as a function; a function may give several lines, or an empty text for none.
template <class Source>
struct Field {
  Column column;
  std::function<Json(const Source&)> value;
  std::function<Lines(const Source&)> lines = {};       ///< in place of the title and the cell
  std::function<void(Source&, const Json&)> read = {};  ///< none if the cell is computed

  template <class Value>
  Field(Column shown_as, Value cell_of)
      : column(std::move(shown_as)), value([cell_of](const Source& source) -> Json {
          return json_of(std::invoke(cell_of, source));
        }) {
    using Cell = std::invoke_result_t<Value, Source&>;
    if constexpr (std::is_lvalue_reference_v<Cell> &&
                  !std::is_const_v<std::remove_reference_t<Cell>> &&
                  !std::is_enum_v<std::remove_reference_t<Cell>>) {
      read = [cell_of](Source& to, const Json& from) { from.get_to(std::invoke(cell_of, to)); };
    }
  }

  template <class Value, class Text>
  Field(Column shown_as, Value cell_of, Text text)
      : Field(std::move(shown_as), std::move(cell_of)) {
    if constexpr (std::is_convertible_v<Text, std::string>) {
      column.shown = text;
    } else if constexpr (std::is_same_v<std::invoke_result_t<Text, const Source&>, Lines>) {
      lines = std::move(text);
    } else {
      lines = [title = column.title, text](const Source& source) -> Lines {
        const std::string given = text(source);
        return given.empty() ? Lines{} : Lines{{title, given}};
      };
    }
  }
};

/// A line without a field in JSON.
template <class Source, class Text>
Field<Source> line(std::string title, Text text) {
  return {{.name = {}, .title = std::move(title)}, [](const Source&) { return ""; }, text};
}

template <class Source>
using Fields = std::vector<Field<Source>>;

/// The fields with these names, in this order. Each name must be there.
template <class Source>
Fields<Source> pick(const Fields<Source>& fields, const std::vector<std::string_view>& names) {
  Fields<Source> picked;
  for (const std::string_view name : names) {
    for (const Field<Source>& field : fields) {
      if (field.column.name == name) picked.push_back(field);
    }
  }
  return picked;
}

/// The fields of a part of `Outer`: of a member, or of what a function makes of it.
template <class Outer, class Inner, class Part>
Fields<Outer> within(const Fields<Inner>& fields, Part part) {
  Fields<Outer> lifted;
  for (const Field<Inner>& field : fields) {
    Field<Outer>& outer = lifted.emplace_back(
        field.column, [=](const Outer& source) { return field.value(std::invoke(part, source)); });
    if (!field.lines) continue;
    outer.lines = [=](const Outer& source) { return field.lines(std::invoke(part, source)); };
  }
  return lifted;
}

/// A column whose cells are all equal.
template <class Source>
Fields<Source> constant(Column column, Json cell) {
  return {{std::move(column), [cell = std::move(cell)](const Source&) { return cell; }}};
}

template <class Source>
Fields<Source> operator+(Fields<Source> fields, const Fields<Source>& more) {
  fields.insert(fields.end(), more.begin(), more.end());
  return fields;
}

template <class Source>
Row row_of(const Fields<Source>& fields, const Source& source, std::string remark = "") {
  Row row{{}, std::move(remark)};
  for (const Field<Source>& field : fields) row.cells.push_back(field.value(source));
  return row;
}

template <class Source>
Table table_of(const Fields<Source>& fields, const std::vector<Source>& sources) {
  Table table;
  for (const Field<Source>& field : fields) table.columns.push_back(field.column);
  for (const Source& source : sources) table.rows.push_back(row_of(fields, source));
  return table;
}

/// Adds the rows of a table with the same columns, which a table without columns gets.
void append(Table& table, Table more);

/// The JSON object of one row. Fields without a name are only for people.
template <class Source>
Json object_of(const Fields<Source>& fields, const Source& source) {
  Json object = Json::object();
  for (const Field<Source>& field : fields) {
    if (field.column.name.empty()) continue;
    Json cell = field.value(source);
    if (cell.is_null() && field.column.may_be_absent) continue;
    object[field.column.name] = std::move(cell);
  }
  return object;
}

/// The lines of one thing.
template <class Source>
Lines lines_of(const Fields<Source>& fields, const Source& source) {
  const Json object = object_of(fields, source);
  Lines lines;
  for (const auto& [column, value, lines_in, read] : fields) {
    if (lines_in) {
      for (Line& line : lines_in(source)) lines.push_back(std::move(line));
    } else if (const Json cell = value(source); !column.title.empty() && !cell.is_null()) {
      lines.push_back({column.title, in_words(column.shown, cell, object)});
    }
  }
  return lines;
}

/// The reverse of object_of, for the members among the fields. Throws nlohmann::json::exception if
/// one is missing that may not be absent, or has another type.
template <class Source>
void read_object(const Fields<Source>& fields, const Json& object, Source& source) {
  for (const Field<Source>& field : fields) {
    const std::string& name = field.column.name;
    if (!field.read || (field.column.may_be_absent && !object.contains(name))) continue;
    field.read(source, object.at(name));
  }
}

/// The JSON of a thing that may be missing; then it is null.
template <class Source>
Json object_of(const Fields<Source>& fields, const std::optional<Source>& source) {
  return source ? object_of(fields, *source) : Json();
}
template <class Source>
Lines lines_of(const Fields<Source>& fields, const std::optional<Source>& source) {
  return source ? lines_of(fields, *source) : Lines{};
}
template <class Source>
void read_object(const Fields<Source>& fields, const Json& object, std::optional<Source>& source) {
  read_object(fields, object, source.emplace());
}

/// The JSON of several things: an array of their objects.
template <class Source>
Json object_of(const Fields<Source>& fields, const std::vector<Source>& sources) {
  Json array = Json::array();
  for (const Source& source : sources) array.push_back(object_of(fields, source));
  return array;
}
template <class Source>
Lines lines_of(const Fields<Source>& fields, const std::vector<Source>& sources) {
  Lines lines;
  for (const Source& source : sources) {
    for (Line& line : lines_of(fields, source)) lines.push_back(std::move(line));
  }
  return lines;
}
template <class Source>
void read_object(const Fields<Source>& fields, const Json& array, std::vector<Source>& sources) {
  for (const Json& each : array) read_object(fields, each, sources.emplace_back());
}

/// A member that has fields: one thing, an optional one, or several.
template <class Source, class Member, class Inner>
Field<Source> record(Column column, Member member, const Fields<Inner>& fields) {
  Field<Source> field(
      std::move(column),
      [=](const Source& source) { return object_of(fields, std::invoke(member, source)); },
      [=](const Source& source) { return lines_of(fields, std::invoke(member, source)); });
  field.read = [=](Source& source, const Json& json) {
    read_object(fields, json, std::invoke(member, source));
  };
  return field;
}

}  // namespace mixcmp::table
