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

constexpr std::string_view no_such_column = "no such column";

bool explains(const ColumnNames& names, const std::string& wanted) {
  return names.is_list ? subscript_in(wanted, names.name).has_value() : wanted == names.name;
}

Error mistake(const ColumnNames& names, std::string message, std::string received,
              std::string accepted) {
  return {.file = names.place.file,
          .line = names.place.line,
          .field = names.field,
          .message = std::move(message),
          .received = std::move(received),
          .accepted = std::move(accepted)};
}

Result<std::string> file_column(std::span<const ColumnNames> all, const std::string& wanted) {
  const auto explains_it = [&](const ColumnNames& names) { return explains(names, wanted); };
  const auto found = std::find_if(all.begin(), all.end(), explains_it);
  if (found == all.end()) return wanted;
  const auto again = std::find_if(std::next(found), all.end(), explains_it);
  if (again != all.end()) {
    return mistake(*again, fmt::format("a second column for {}", wanted),
                   fmt::format("{} beside {}", again->field, found->field), "one of them");
  }
  if (!found->is_list) return found->columns[0];
  const std::size_t subscript = *subscript_in(wanted, found->name);
  if (subscript < found->columns.size()) return found->columns[subscript];
  return mistake(*found, fmt::format("no column for {}", wanted),
                 fmt::format("a list of {}", found->columns.size()),
                 fmt::format("{} columns or more", subscript + 1));
}

}  // namespace

Result<std::vector<std::string>> file_columns(std::span<const ColumnNames> names,
                                              std::span<const std::string> wanted) {
  for (const ColumnNames& one : names) {
    const auto is_wanted = [&](const std::string& column) { return explains(one, column); };
    if (std::any_of(wanted.begin(), wanted.end(), is_wanted)) continue;
    return mistake(one, "no input needs such a column",
                   one.is_list ? one.name + "_0, ..." : one.name,
                   list_with_nearest(one.name, wanted));
  }
  std::vector<std::string> columns;
  for (const std::string& column : wanted) {
    MIXCMP_TRY(named, file_column(names, column));
    columns.push_back(named);
  }
  return columns;
}

Error missing_column(const std::string& column, std::span<const std::string> known) {
  return {.field = column,
          .message = std::string(no_such_column),
          .received = "nothing",
          .accepted = list_with_nearest(column, known)};
}

bool is_missing_column(const Error& error) {
  return error.message == no_such_column;
}

Result<Table> select_columns(const Table& table, std::span<const std::string> columns,
                             std::span<const std::string> wanted) {
  std::vector<std::size_t> places;
  for (const std::string& column : columns) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), column);
    if (found == table.columns.end()) return missing_column(column, table.columns);
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
