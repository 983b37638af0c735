#include "model/data/column_names.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "model/common/nearest.hpp"

namespace mixcmp::model {
namespace {

/// k of "p_k".
std::optional<std::size_t> subscript_in(const std::string& wanted, const std::string& name) {
  if (!wanted.starts_with(name + "_")) return std::nullopt;
  const char* const begin = wanted.data() + name.size() + 1;
  const char* const end = wanted.data() + wanted.size();
  std::size_t subscript = 0;
  const auto [stop, status] = std::from_chars(begin, end, subscript);
  if (status != std::errc{} || stop != end) return std::nullopt;
  return subscript;
}

bool explains(const ColumnNames& names, const std::string& wanted) {
  return names.is_list ? subscript_in(wanted, names.name).has_value() : wanted == names.name;
}

Result<std::string> file_column(std::span<const ColumnNames> all, const std::string& wanted) {
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const ColumnNames& names) { return explains(names, wanted); });
  if (found == all.end()) return wanted;
  if (!found->is_list) return found->columns[0];
  const std::size_t subscript = *subscript_in(wanted, found->name);
  if (subscript < found->columns.size()) return found->columns[subscript];
  return Error{.line = found->line,
               .field = found->field,
               .message = fmt::format("no column for {}", wanted),
               .received = fmt::format("a list of {}", found->columns.size()),
               .accepted = fmt::format("{} columns or more", subscript + 1)};
}

}  // namespace

Result<std::vector<std::string>> file_columns(std::span<const ColumnNames> names,
                                              std::span<const std::string> wanted) {
  for (const ColumnNames& one : names) {
    const auto is_wanted = [&](const std::string& column) { return explains(one, column); };
    if (std::any_of(wanted.begin(), wanted.end(), is_wanted)) continue;
    return Error{.line = one.line,
                 .field = one.field,
                 .message = "no input needs such a column",
                 .received = one.is_list ? one.name + "_0, ..." : one.name,
                 .accepted = list_with_nearest(one.name, wanted)};
  }
  std::vector<std::string> columns;
  for (const std::string& column : wanted) {
    MIXCMP_TRY(named, file_column(names, column));
    columns.push_back(named);
  }
  return columns;
}

Result<Table> select_columns(const Table& table, std::span<const std::string> columns,
                             std::span<const std::string> wanted) {
  std::vector<std::size_t> places;
  for (const std::string& column : columns) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), column);
    if (found == table.columns.end()) {
      return Error{.field = "data",
                   .message = fmt::format("no column {}", column),
                   .received = "no such column",
                   .accepted = list_with_nearest(column, table.columns)};
    }
    places.push_back(static_cast<std::size_t>(found - table.columns.begin()));
  }
  Table selected{.format = table.format,
                 .columns = {wanted.begin(), wanted.end()},
                 .values = {},
                 .labels = table.labels};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (const std::size_t place : places) selected.values.push_back(table.at(row, place));
  }
  return selected;
}

}  // namespace mixcmp::model
