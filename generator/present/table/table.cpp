#include "generator/present/table/table.hpp"

#include <fmt/args.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mixcmp::table {
namespace {

/// A cell in a form of fmt; nothing if it is missing.
std::string formatted(const std::string& form, const Json& cell) {
  const auto in_form = [&form](const auto& value) {
    return fmt::vformat(form, fmt::make_format_args(value));
  };
  if (cell.is_null()) return "";
  if (cell.is_string()) return in_form(cell.get_ref<const std::string&>());
  if (cell.is_number_float()) return in_form(cell.get<double>());
  if (cell.is_number_unsigned()) return in_form(cell.get<std::uint64_t>());
  if (cell.is_number_integer()) return in_form(cell.get<std::int64_t>());
  return cell.dump();
}

std::string shown(const Table& table, const Column& column, const Json& cell) {
  if (cell.is_null()) return table.missing;
  if (cell.is_string()) return cell.get<std::string>();
  if (column.unit == 1) return formatted(column.shown, cell);
  return formatted(column.shown, cell.get<double>() / column.unit);
}

/// A text in its column. A column aligned to the left is the last one, and may be empty.
std::string placed(const Column& column, const std::string& text) {
  if (column.width == 0 && text.empty()) return "";
  return fmt::format("{:{}}{:>{}}", "", column.gap, text, column.width);
}

/// Headings above those of the columns. Columns without a group have their own title there.
std::string group_line(const Table& table) {
  std::string line;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    Column column = table.columns[k];
    if (column.group.empty()) {
      line += placed(column, column.title);
      continue;
    }
    for (; k + 1 < table.columns.size() && table.columns[k + 1].group == column.group; ++k) {
      column.width += table.columns[k + 1].gap + table.columns[k + 1].width;
    }
    line += placed(column, column.group);
  }
  return line + "\n";
}

std::string title_lines(const Table& table) {
  std::string groups, titles;
  for (const Column& column : table.columns) {
    if (!column.group.empty()) groups = group_line(table);
  }
  for (const Column& column : table.columns) {
    titles += placed(column, groups.empty() || !column.group.empty() ? column.title : "");
  }
  return groups + titles + "\n";
}

/// The first cell with a text, and the remark in place of all behind it.
std::string remark_line(const Table& table, const Row& row) {
  std::string line;
  for (std::size_t k = 0; k < row.cells.size(); ++k) {
    const std::string text = shown(table, table.columns[k], row.cells[k]);
    line += placed(table.columns[k], text);
    if (!text.empty()) break;
  }
  return line + "  " + row.remark + "\n";
}

}  // namespace

std::string in_words(const std::string& form, const Json& cell, const Json& object) {
  if (form == "{}" && cell.is_string()) return cell.get<std::string>();
  fmt::dynamic_format_arg_store<fmt::format_context> values;
  const auto add = [&values](const Json& value, auto argument) {
    if (value.is_string()) values.push_back(argument(value.get_ref<const std::string&>()));
    if (value.is_number_float()) values.push_back(argument(value.get<double>()));
    if (value.is_number_unsigned()) return values.push_back(argument(value.get<std::uint64_t>()));
    if (value.is_number_integer()) values.push_back(argument(value.get<std::int64_t>()));
  };
  add(cell, [](const auto& value) { return value; });
  for (const auto& [name, value] : object.items()) {
    add(value, [name = name.c_str()](const auto& one) { return fmt::arg(name, one); });
  }
  return fmt::vformat(form, values);
}

std::string to_text(const Lines& lines, int text_column) {
  std::string text;
  for (const Line& line : lines) {
    text += std::string(static_cast<std::size_t>(line.indent), ' ');
    text += line.text.empty()
                ? line.name
                : fmt::format("{:<{}} {}", line.name, text_column - line.indent - 1, line.text);
    text += "\n";
  }
  return text;
}

Table named_table(const std::vector<std::string>& names) {
  Table table;
  for (const std::string& name : names) table.columns.push_back({name});
  return table;
}

Table text_table(const std::vector<std::string>& titles) {
  Table table;
  for (const std::string& title : titles) table.columns.push_back({.name = {}, .title = title});
  return table;
}

void append(Table& table, Table more) {
  if (table.columns.empty()) table.columns = std::move(more.columns);
  for (Row& row : more.rows) table.rows.push_back(std::move(row));
}

Json to_json(const Table& table) {
  Json rows = Json::array();
  for (const Row& row : table.rows) {
    Json object = Json::object();
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
      object[table.columns[k].name] = row.cells[k];
      if (row.remark.empty()) continue;
      object[table.remark_name] = row.remark;
      break;
    }
    rows.push_back(std::move(object));
  }
  return rows;
}

std::string to_csv(const Table& table) {
  std::vector<std::string> names;
  for (const Column& column : table.columns) names.push_back(column.name);
  std::string lines;
  for (const Row& row : table.rows) {
    std::vector<std::string> cells;
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
      const bool is_remark = !row.remark.empty() && k + 1 == row.cells.size();
      cells.push_back(
          formatted(table.columns[k].in_csv, is_remark ? Json(row.remark) : row.cells[k]));
    }
    lines += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return fmt::format("{}\n{}", fmt::join(names, ","), lines);
}

std::string to_text(const Table& table) {
  std::string text = title_lines(table);
  for (const Row& row : table.rows) {
    if (!row.remark.empty()) {
      text += remark_line(table, row);
      continue;
    }
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
      text += placed(table.columns[k], shown(table, table.columns[k], row.cells[k]));
    }
    text += "\n";
  }
  return text;
}

std::string to_markdown(const Table& table) {
  const std::vector<std::string> titles = shown_titles(table);
  std::string text = fmt::format("| {} |\n|", fmt::join(titles, " | "));
  for (std::size_t k = 0; k < titles.size(); ++k) text += "---|";
  text += "\n";
  for (const Row& row : table.rows) {
    text += fmt::format("| {} |\n", fmt::join(shown_cells(table, row), " | "));
  }
  return text;
}

std::vector<std::string> shown_titles(const Table& table) {
  std::vector<std::string> titles;
  for (const Column& column : table.columns) {
    titles.push_back(column.title.empty() ? column.group : column.title);
  }
  return titles;
}

std::vector<std::string> shown_cells(const Table& table, const Row& row) {
  std::vector<std::string> cells;
  for (std::size_t k = 0; k < row.cells.size(); ++k) {
    const bool valid = row.remark.empty() || cells.empty();
    cells.push_back(valid ? shown(table, table.columns[k], row.cells[k]) : table.missing);
  }
  if (!row.remark.empty()) cells.back() = row.remark;
  return cells;
}

}  // namespace mixcmp::table
