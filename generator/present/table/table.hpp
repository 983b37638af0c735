#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Results as data: tables of rows, and named values. Each form, JSON, CSV, text, Markdown and (in
/// page) HTML, has one writer.
namespace mixcmp::table {

using Json = nlohmann::ordered_json;

/// One column: its name and form for programs, its title and form for people.
struct Column {
  std::string name;           ///< the field in JSON and CSV: "throughput_per_s"
  std::string title = {};     ///< the heading in text and HTML: "G/s"
  int width = 0;              ///< of text, aligned to the right; 0: aligned to the left
  int gap = 2;                ///< blanks before the column in text
  std::string shown = "{}";   ///< fmt's form of a number in text and HTML
  double unit = 1;            ///< the unit in which people read numbers: 1e9 for G/s
  std::string in_csv = "{}";  ///< fmt's form of a cell in CSV
  std::string group = {};     ///< a second heading, above adjacent columns
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

/// A column of a type of rows, and its cell. `value`: a member of the row, or a function of it.
///   const Fields<Plan> fields = {{{"lanes", "p_L", 5}, &Plan::lanes}};
///   to_text(table_of(fields, plans));
template <class Source>
struct Field {
  Column column;
  std::function<Json(const Source&)> value;

  template <class Value>
  Field(Column shown_as, Value cell_of)
      : column(std::move(shown_as)), value([cell_of](const Source& source) -> Json {
          return Json(std::invoke(cell_of, source));
        }) {}
};
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

/// The fields of a member of `Outer`.
template <class Outer, class Member>
Fields<Outer> within(const Fields<Member>& fields, Member Outer::*member) {
  Fields<Outer> lifted;
  for (const Field<Member>& field : fields) {
    lifted.push_back(
        {field.column, [field, member](const Outer& outer) { return field.value(outer.*member); }});
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

/// The JSON object of one row.
template <class Source>
Json object_of(const Fields<Source>& fields, const Source& source) {
  Json object = Json::object();
  for (const Field<Source>& field : fields) object[field.column.name] = field.value(source);
  return object;
}

}  // namespace mixcmp::table
