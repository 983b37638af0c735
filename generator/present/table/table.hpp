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

/// A cell as people read it.
std::string shown(const Column& column, const Json& cell);
/// A text with the fields of an object in it, "{lanes} of {all_lanes}".
std::string in_words(const std::string& form, const Json& object);

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
/// Where there is one thing and no table, a field is a field of a JSON object, and a line if it has
/// a title. Its text may be given: as a form with names of fields, "{lanes} of {all_lanes}", or as
/// a function, which may give several lines; no line if it gives an empty text.
template <class Source>
struct Field {
  Column column;
  std::function<Json(const Source&)> value;
  std::function<Lines(const Source&)> lines = {};       ///< in place of the title and the cell
  std::function<void(Source&, const Json&)> read = {};  ///< none if the cell is computed
  std::string words = {};                               ///< the line's text, by names of fields

  template <class Value>
  Field(Column shown_as, Value cell_of)
      : column(std::move(shown_as)), value([cell_of](const Source& source) -> Json {
          return Json(std::invoke(cell_of, source));
        }) {
    using Cell = std::invoke_result_t<Value, Source&>;
    if constexpr (std::is_lvalue_reference_v<Cell> &&
                  !std::is_const_v<std::remove_reference_t<Cell>>) {
      read = [cell_of](Source& to, const Json& from) { from.get_to(std::invoke(cell_of, to)); };
    }
  }

  template <class Value, class Text>
  Field(Column shown_as, Value cell_of, Text text)
      : Field(std::move(shown_as), std::move(cell_of)) {
    if constexpr (std::is_convertible_v<Text, std::string>) {
      words = text;
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

template <class Source>
Lines lines_of(const Fields<Source>& fields, const Source& source) {
  const Json object = object_of(fields, source);
  Lines lines;
  for (const Field<Source>& field : fields) {
    const Column& column = field.column;
    if (field.lines) {
      for (Line& line : field.lines(source)) lines.push_back(std::move(line));
    } else if (!column.title.empty() && !field.words.empty()) {
      lines.push_back({column.title, in_words(field.words, object)});
    } else if (const Json cell = field.value(source); !column.title.empty() && !cell.is_null()) {
      lines.push_back({column.title, shown(column, cell)});
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

/// A member that has fields: an object in JSON, and its lines. An optional member may be absent.
template <class Source, class Member, class Inner>
Field<Source> record(Column column, Member member, const Fields<Inner>& fields) {
  constexpr bool is_optional =
      std::is_same_v<std::invoke_result_t<Member, Source&>, std::optional<Inner>&>;
  column.may_be_absent |= is_optional;
  // The record by a pointer, null if it is not there.
  const auto in = [member](const Source& source) -> const Inner* {
    if constexpr (is_optional) {
      const std::optional<Inner>& inner = std::invoke(member, source);
      return inner ? &*inner : nullptr;
    } else {
      return &std::invoke(member, source);
    }
  };
  Field<Source> field(
      std::move(column),
      [in, fields](const Source& source) {
        const Inner* const inner = in(source);
        return inner == nullptr ? Json() : object_of(fields, *inner);
      },
      [in, fields](const Source& source) {
        const Inner* const inner = in(source);
        return inner == nullptr ? Lines{} : lines_of(fields, *inner);
      });
  field.read = [member, fields](Source& source, const Json& json) {
    if constexpr (is_optional) {
      read_object(fields, json, std::invoke(member, source).emplace());
    } else {
      read_object(fields, json, std::invoke(member, source));
    }
  };
  return field;
}

/// A member with several things: an array of objects in JSON, and their lines. If the column may be
/// absent, it is where the member is empty. `fields_in`: the fields, given the source.
template <class Source, class Inner>
Field<Source> list(Column column, std::vector<Inner> Source::*member,
                   std::function<Fields<Inner>(const Source&)> fields_in) {
  const bool may_be_absent = column.may_be_absent;
  Field<Source> field(
      std::move(column),
      [=](const Source& source) {
        Json array = may_be_absent ? Json() : Json::array();
        for (const Inner& each : source.*member) {
          array.push_back(object_of(fields_in(source), each));
        }
        return array;
      },
      [=](const Source& source) {
        Lines lines;
        for (const Inner& each : source.*member) {
          for (Line& line : lines_of(fields_in(source), each)) lines.push_back(std::move(line));
        }
        return lines;
      });
  field.read = [=](Source& source, const Json& json) {
    for (const Json& each : json) {
      read_object(fields_in(source), each, (source.*member).emplace_back());
    }
  };
  return field;
}
template <class Source, class Inner>
Field<Source> list(Column column, std::vector<Inner> Source::*member, const Fields<Inner>& fields) {
  return list<Source, Inner>(std::move(column), member, [fields](const Source&) { return fields; });
}

}  // namespace mixcmp::table
