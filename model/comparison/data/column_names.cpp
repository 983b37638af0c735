#include "model/comparison/data/column_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>

#include "model/base/common/nearest.hpp"

namespace mixcmp::data {
namespace {

/// The subscript k if `wanted` is "p_k" for the name "p"; none otherwise.
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

/// An error at the key of the scene that `key` comes from. `key` is a ColumnNames or a
/// WantedColumn.
template <class Key>
Error mistake_of(const Key& key, std::string message, std::string received, std::string accepted) {
  return {.file = key.place.file,
          .line = key.place.line,
          .field = key.field,
          .message = std::move(message),
          .received = std::move(received),
          .accepted = std::move(accepted)};
}

Result<WantedColumn> file_column(std::span<const ColumnNames> all, const std::string& wanted) {
  const auto explains_it = [&](const ColumnNames& names) { return explains(names, wanted); };
  const auto found = std::find_if(all.begin(), all.end(), explains_it);
  if (found == all.end()) return WantedColumn{.name = wanted, .column = wanted};
  const auto again = std::find_if(std::next(found), all.end(), explains_it);
  if (again != all.end()) {
    return mistake_of(*again, fmt::format("a second column for {}", wanted),
                      fmt::format("{} beside {}", again->field, found->field), "one of them");
  }
  const std::size_t subscript = found->is_list ? *subscript_in(wanted, found->name) : 0;
  if (subscript < found->columns.size()) {
    return WantedColumn{.name = wanted,
                        .column = found->columns[subscript],
                        .field = found->field,
                        .place = found->place};
  }
  return mistake_of(*found, fmt::format("no column for {}", wanted),
                    fmt::format("a list of {}", found->columns.size()),
                    fmt::format("{} columns or more", subscript + 1));
}

/// Numbers for all of `wanted`: the given ones and, for the others, the first unused ones.
std::vector<std::string> suggested_numbers(std::span<const WantedColumn> wanted,
                                           std::uint64_t columns) {
  std::set<std::uint64_t> taken;
  for (const WantedColumn& column : wanted) {
    if (const auto* number = std::get_if<std::uint64_t>(&column.column)) taken.insert(*number);
  }
  std::vector<std::string> numbers;
  std::uint64_t next = 0;
  for (const WantedColumn& column : wanted) {
    if (const auto* number = std::get_if<std::uint64_t>(&column.column)) {
      numbers.push_back(std::to_string(*number));
      continue;
    }
    while (taken.contains(next)) ++next;
    numbers.push_back(next < columns ? std::to_string(next) : "?");
    ++next;
  }
  return numbers;
}

/// A value of data.columns that would define `wanted`: "{ p = [0, 1], r = 2 }".
std::string suggested_columns(std::span<const WantedColumn> wanted, std::uint64_t columns) {
  const std::vector<std::string> numbers = suggested_numbers(wanted, columns);
  std::map<std::string, std::string> number_of;
  for (std::size_t k = 0; k < wanted.size(); ++k) number_of[wanted[k].name] = numbers[k];
  std::vector<std::string> entries;
  for (const WantedColumn& column : wanted) {
    if (!number_of.contains(column.name)) continue;  // already in a list
    const std::string base = column.name.substr(0, column.name.rfind('_'));
    std::vector<std::string> list;
    while (number_of.contains(fmt::format("{}_{}", base, list.size()))) {
      list.push_back(number_of.extract(fmt::format("{}_{}", base, list.size())).mapped());
    }
    if (!list.empty()) entries.push_back(fmt::format("{} = [{}]", base, fmt::join(list, ", ")));
    const auto alone = number_of.extract(column.name);
    if (!alone.empty()) entries.push_back(fmt::format("{} = {}", column.name, alone.mapped()));
  }
  return fmt::format("{{ {} }}", fmt::join(entries, ", "));
}

}  // namespace

Result<std::vector<WantedColumn>> file_columns(std::span<const ColumnNames> names,
                                               std::span<const std::string> wanted) {
  for (const ColumnNames& one : names) {
    const auto is_wanted = [&](const std::string& column) { return explains(one, column); };
    if (std::any_of(wanted.begin(), wanted.end(), is_wanted)) continue;
    return mistake_of(one, "no input needs such a column",
                      one.is_list ? one.name + "_0, ..." : one.name,
                      list_with_nearest(one.name, wanted));
  }
  std::vector<WantedColumn> columns;
  for (const std::string& column : wanted) {
    MIXCMP_TRY(named, file_column(names, column));
    columns.push_back(named);
  }
  return columns;
}

std::vector<WantedColumn> columns_by_name(std::span<const std::string> names) {
  std::vector<WantedColumn> columns;
  for (const std::string& name : names) columns.push_back({.name = name, .column = name});
  return columns;
}

Result<std::size_t> find_column(const WantedColumn& wanted, std::span<const std::string> known,
                                const std::string& source) {
  if (const auto* number = std::get_if<std::uint64_t>(&wanted.column)) {
    return numbered_column(wanted, *number, known.size(), source);
  }
  const auto& name = std::get<std::string>(wanted.column);
  const auto found = std::find(known.begin(), known.end(), name);
  if (found == known.end()) return missing_column(name, known);
  return static_cast<std::size_t>(found - known.begin());
}

Result<std::size_t> numbered_column(const WantedColumn& wanted, std::uint64_t number,
                                    std::uint64_t count, const std::string& source) {
  if (number < count) return static_cast<std::size_t>(number);
  return column_mistake(
      wanted, "no column of this number in " + source, std::to_string(number),
      count == 0 ? "nothing: it has no columns" : fmt::format("0..{}, counted from 0", count - 1));
}

Error column_mistake(const WantedColumn& wanted, std::string message, std::string received,
                     std::string accepted) {
  return mistake_of(wanted, std::move(message), std::move(received), std::move(accepted));
}

Error missing_column(const std::string& column, std::span<const std::string> known) {
  return {.field = column,
          .message = "no such column",
          .received = "nothing",
          .accepted = list_with_nearest(column, known),
          .kind = ErrorKind::missing_column};
}

Error unnamed_columns(std::span<const WantedColumn> wanted, std::uint64_t columns) {
  std::vector<std::string> unnumbered;
  for (const WantedColumn& column : wanted) {
    if (const auto* name = std::get_if<std::string>(&column.column)) unnumbered.push_back(*name);
  }
  return {.message = "the columns of a plain array have no names",
          .received = "no number for " + fmt::format("{}", fmt::join(unnumbered, ", ")),
          .accepted = fmt::format("the number of each one's column, counted from 0 and below {}, "
                                  "for example {}",
                                  columns, suggested_columns(wanted, columns)),
          .kind = ErrorKind::unnamed_columns};
}

Result<Table> select_columns(const Table& table, std::span<const WantedColumn> wanted) {
  Table selected{.format = table.format,
                 .columns = {},
                 .labels = table.labels,
                 .lines = table.lines,
                 .source = table.source};
  std::vector<std::size_t> places;
  for (const WantedColumn& column : wanted) {
    MIXCMP_TRY(place, find_column(column, table.columns, table.source));
    places.push_back(place);
    selected.columns.push_back(column.name);
    selected.origins.push_back({.number = place, .name = table.columns[place]});
  }
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (const std::size_t place : places) selected.values.push_back(table.at(row, place));
  }
  return selected;
}

}  // namespace mixcmp::data
