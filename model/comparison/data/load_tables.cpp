#include "model/comparison/data/load_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "model/base/common/check.hpp"
#include "model/base/common/file.hpp"
#include "model/base/number/decimal.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/data/csv.hpp"
#include "model/comparison/data/npy.hpp"
#include "model/comparison/data/pdb.hpp"
#include "model/comparison/data/sphere_family.hpp"
#include "model/comparison/data/uniform_spheres.hpp"

namespace mixcmp::data {
namespace {

/// A coordinate or radius may be rounded up to its limit.
Result<Done> check_limit(const char* field, double limit, FloatFormat format) {
  if (!format.is_infinite(from_rational(format, mpq_class(limit)))) return Done{};
  return Error{.field = field,
               .message = fmt::format("beyond the largest number of {}", format.name()),
               .received = fmt::format("{}", limit),
               .accepted = "a smaller number, or a reference format with more exponent bits"};
}

Result<Table> generated_table(const DataSpec& data, FloatFormat format) {
  const auto count = static_cast<std::uint64_t>(data.count);
  if (data.items == "sphere_family") {
    return sphere_family({.name = data.family, .count = count, .seed = data.seed}, format);
  }
  MIXCMP_TRY(side, check_limit("data.side", data.side, format));
  MIXCMP_DO(check_limit("data.radius_max", data.radius_max, format));
  return uniform_spheres(
      {.count = count, .side = data.side, .radius_max = data.radius_max, .seed = data.seed},
      format);
}

/// Selects the wanted columns of a table that was read or generated completely. If the scene names
/// no columns, all of them stay.
Result<Table> chosen_columns(Table table, std::span<const ColumnNames> names,
                             std::span<const WantedColumn> wanted) {
  MIXCMP_TRY(selected, select_columns(table, wanted));
  if (!names.empty()) return selected;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    table.origins.push_back({.number = k, .name = table.columns[k]});
  }
  return table;
}

/// Rounds the numbers of a table that was read or generated in one format.
Result<Done> round_columns(Table& table, std::span<const WantedColumn> wanted) {
  for (const WantedColumn& column : wanted) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), column.name);
    if (!column.rounded_to || found == table.columns.end()) continue;
    const auto place = static_cast<std::size_t>(found - table.columns.begin());
    for (std::size_t row = 0; row < table.rows(); ++row) {
      Bits& bits = table.values[row * table.columns.size() + place];
      const Bits rounded = converted(*column.rounded_to, table.format, bits);
      if (column.rounded_to->is_infinite(rounded) && !table.format.is_infinite(bits)) {
        return Error{
            .file = table.source,
            .field = fmt::format("row {}, {}", table.label(row), column.name),
            .message = fmt::format("beyond the largest number of {}", column.rounded_to->name()),
            .received = to_text(table.format, bits),
            .accepted = "a smaller number, or a format with more exponent bits"};
      }
      if (column.rounded_to->is_nan(rounded) && !table.format.is_nan(bits)) {
        table.lost.add({1, fmt::format("{} in {}, row {}, {}, read in {}",
                                       to_text(table.format, bits), table.source, table.label(row),
                                       column.name, column.rounded_to->name())});
      }
      bits = converted(table.format, *column.rounded_to, rounded);
    }
  }
  return Done{};
}

/// Reads or generates the table `which`, 0 or 1, of the scene; its columns get the scene's names.
Result<Table> read_table(const DataSpec& data, std::size_t which, FloatFormat format,
                         std::span<const WantedColumn> wanted) {
  const std::filesystem::path& file = which == 0 ? data.file : data.with;
  if (file.extension() == ".csv") return read_csv(file, format, wanted);
  if (file.extension() == ".npy") return read_npy(file, format, wanted);
  MIXCMP_TRY(table, file.empty() ? generated_table(data, format) : read_pdb(file, format));
  table.source = table_name(data, which);
  MIXCMP_TRY(chosen, chosen_columns(std::move(table), which == 0 ? data.columns : data.with_columns,
                                    wanted));
  MIXCMP_DO(round_columns(chosen, wanted));
  return chosen;
}

/// The rule that assigns an input to a table by its name, as the end of an error message.
std::string input_rule(const DataSpec& data) {
  const std::string first = table_name(data, 0), second = table_name(data, 1);
  switch (data.pairing) {
    case Pairing::rows: return "";
    case Pairing::all: return fmt::format(": an input ending in i or j is of an item of {}", first);
    case Pairing::cross:
      return fmt::format(": an input ending in i is of an item of {}, in j of {}", first, second);
    case Pairing::arg_min:
      return fmt::format(
          ": an input ending in i or j is of a candidate of {}, any other of a row of {}", second,
          first);
  }
  MIXCMP_CHECK(false);
}

Place place_of(const DataSpec& data, const std::string& key) {
  const auto found = data.places.find(key);
  if (found != data.places.end()) return found->second;
  const auto section = data.places.find("");
  return section == data.places.end() ? Place{} : section->second;
}

std::string source_key(const DataSpec& data, std::size_t which) {
  if (which == 1) return data.with.empty() ? "items" : "with";
  return data.file.empty() ? "items" : "file";
}

/// Checks that the file can be read. The error is placed at the key that names the file.
Result<Done> check_source(const DataSpec& data, std::size_t which) {
  const std::filesystem::path& path = which == 0 ? data.file : data.with;
  if (path.empty()) return Done{};
  const Result<Done> readable = check_readable(path);
  if (readable.ok()) return Done{};
  const Place place = place_of(data, source_key(data, which));
  Error error = readable.error();
  error.message += " " + path.string();
  error.file = place.file;
  error.line = place.line;
  error.field = "data." + source_key(data, which);
  return error;
}

/// Places an error about missing column numbers at the key that gives such numbers or, without
/// that, at the key that names the file.
Error at_columns_key(const DataSpec& data, std::size_t which, Error error) {
  const std::string key = which == 0 ? "columns" : "with_columns";
  const Place place = place_of(data, data.places.contains(key) ? key : source_key(data, which));
  error.file = place.file;
  error.line = place.line;
  error.field = "data." + key;
  error.message += ", and " + table_name(data, which) + " is one";
  return error;
}

class TableLoader {
public:
  TableLoader(const DataSpec& data, const std::vector<std::string>& inputs, FloatFormat format,
              std::span<const OperandFormat> arriving)
      : data_(data), inputs_(inputs), format_(format), arriving_(arriving) {}

  Result<std::vector<Table>> load() const {
    MIXCMP_TRY(needed, needed_columns());
    std::vector<Table> tables;
    for (std::size_t which = 0; which < (has_second_table(data_.pairing) ? 2u : 1u); ++which) {
      MIXCMP_TRY(table, load_table(which, needed[which]));
      tables.push_back(std::move(table));
    }
    return tables;
  }

private:
  /// The columns that the inputs need from each table, in order of first need.
  Result<std::array<std::vector<std::string>, 2>> needed_columns() const {
    std::array<std::vector<std::string>, 2> columns;
    for (const std::string& input : inputs_) {
      MIXCMP_TRY(column, input_column(data_.pairing, input));
      std::vector<std::string>& known = columns[column.table];
      if (std::find(known.begin(), known.end(), column.name) == known.end()) {
        known.push_back(column.name);
      }
    }
    return columns;
  }

  /// The first input that needs the column with the scene's name `column`.
  std::string needing_input(std::size_t which, const std::string& column) const {
    for (const std::string& input : inputs_) {
      const Result<InputColumn> needed = input_column(data_.pairing, input);
      if (needed.ok() && needed->table == which && needed->name == column) return input;
    }
    MIXCMP_CHECK(false);
  }

  /// The format to which numbers of a column are rounded first.
  std::optional<FloatFormat> rounding_of(std::size_t which, const std::string& column) const {
    for (std::size_t k = 0; k < arriving_.size(); ++k) {
      const Result<InputColumn> needed = input_column(data_.pairing, inputs_[k]);
      if (!needed.ok() || needed->table != which || needed->name != column) continue;
      const FloatFormat* floating = arriving_[k].floating();
      if (floating == nullptr || *floating == format_) return std::nullopt;
      return *floating;
    }
    return std::nullopt;
  }

  /// Adds to the error of a missing column the input that needs it, and the rule that assigns this
  /// input to the table.
  Error with_input(std::size_t which, const std::string& wanted, Error error) const {
    const std::string need = fmt::format(", which the input {} needs{}",
                                         needing_input(which, wanted), input_rule(data_));
    if (!error.file.empty()) {
      error.message += need;
      return error;
    }
    error.message = fmt::format("no column {}{}", error.field, need);
    error.field = which == 0 ? "data.file" : "data.with";
    return error;
  }

  Result<Table> load_table(std::size_t which, const std::vector<std::string>& wanted) const {
    if (data_.items == "uniform") return drawn_table(which, wanted);
    MIXCMP_DO(check_source(data_, which));
    MIXCMP_TRY(columns, file_columns(which == 0 ? data_.columns : data_.with_columns, wanted));
    for (WantedColumn& column : columns) column.rounded_to = rounding_of(which, column.name);
    const Result<Table> table = read_table(data_, which, format_, columns);
    if (table.ok()) return table;
    const Error& error = table.error();
    if (error.kind == ErrorKind::unnamed_columns) return at_columns_key(data_, which, error);
    if (error.kind != ErrorKind::missing_column) return error;
    const auto missing = std::find_if(
        columns.begin(), columns.end(),
        [&](const WantedColumn& column) { return column.column == ColumnKey(error.field); });
    return with_input(which, missing->name, error);
  }

  Result<Table> drawn_table(std::size_t which, const std::vector<std::string>& wanted) const {
    UniformTable uniform{
        .columns = {},
        .count = static_cast<std::uint64_t>(which == 0 ? data_.count : data_.with_count),
        .seed = data_.seed,
        .which = static_cast<std::uint32_t>(which)};
    for (const std::string& column : wanted) {
      uniform.columns.push_back({column, numbers_of(which, column), rounding_of(which, column)});
    }
    MIXCMP_TRY(table, uniform_table(uniform, format_));
    table.source = table_name(data_, which);
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      table.origins.push_back({.number = k, .name = table.columns[k]});
    }
    return table;
  }

  /// The numbers that all inputs of a column allow. Grids are powers of two, so that the coarsest
  /// one is part of the others.
  UniformNumbers numbers_of(std::size_t which, const std::string& column) const {
    std::optional<UniformNumbers> numbers;
    for (std::size_t k = 0; k < inputs_.size(); ++k) {
      const Result<InputColumn> needed = input_column(data_.pairing, inputs_[k]);
      if (!needed.ok() || needed->table != which || needed->name != column) continue;
      const UniformNumbers& allowed = data_.numbers[k];
      if (!numbers) numbers = allowed;
      numbers->low = std::max(numbers->low, allowed.low);
      numbers->high = std::min(numbers->high, allowed.high);
      if (allowed.grid) numbers->grid = std::max(numbers->grid.value_or(0), *allowed.grid);
    }
    MIXCMP_CHECK(numbers.has_value());
    return *numbers;
  }

  const DataSpec& data_;
  const std::vector<std::string>& inputs_;
  FloatFormat format_;
  std::span<const OperandFormat> arriving_;
};

}  // namespace

Result<std::vector<Table>> load_tables(const DataSpec& data, const std::vector<std::string>& inputs,
                                       FloatFormat format,
                                       std::span<const OperandFormat> arriving) {
  Result<std::vector<Table>> tables = TableLoader(data, inputs, format, arriving).load();
  if (!tables.ok()) return with_place(data, tables.error());
  return tables;
}

Error with_place(const DataSpec& data, Error error) {
  if (!error.file.empty()) return error;
  if (error.field.empty()) error.field = "data";
  for (const std::size_t which : {std::size_t{0}, std::size_t{1}}) {
    if (error.field != (which == 0 ? "data.file" : "data.with")) continue;
    error.field = "data." + source_key(data, which);
    error.received += " in " + table_name(data, which);
    break;
  }
  const std::string_view section = "data.";
  const Place place = place_of(
      data, error.field.starts_with(section) ? error.field.substr(section.size()) : std::string());
  error.file = place.file;
  error.line = place.line;
  return error;
}

}  // namespace mixcmp::data
