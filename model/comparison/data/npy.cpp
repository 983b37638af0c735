#include "model/comparison/data/npy.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "model/base/common/file.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/number/decimal.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/data/npy_header.hpp"

namespace mixcmp::data {
namespace {

constexpr std::string_view accepted_types = "floats of 2, 4, 8 bytes or integers of 1, 2, 4, 8";

/// The place of a column's numbers in the file's data; `first` and `stride` are in bytes.
struct ColumnLayout {
  FileColumn column;
  NpyScalar scalar;
  std::size_t first;
  std::size_t stride;
};

struct Layout {
  std::uint64_t rows;
  std::vector<ColumnLayout> columns;
  std::size_t total_bytes;
};

Error shape_error(const NpyHeader& header, std::string accepted) {
  std::string shape;
  for (const std::uint64_t length : header.shape) shape += fmt::format("{}, ", length);
  return {.field = "shape",
          .message = "not the shape of this data",
          .received = fmt::format(
              "({})", shape.substr(0, shape.size() - std::min(shape.size(), std::size_t{2}))),
          .accepted = std::move(accepted)};
}

FloatFormat float_of(int bytes) {
  return FloatFormat::parse(bytes == 2 ? "binary16" : bytes == 4 ? "binary32" : "binary64").value();
}

OperandFormat type_of(const NpyScalar& scalar) {
  if (scalar.kind == 'f') return OperandFormat(float_of(scalar.bytes));
  return OperandFormat(FixedFormat{.width = 8 * scalar.bytes, .is_signed = scalar.kind == 'i'});
}

/// a * b, or none if no file could be that large.
std::optional<std::size_t> product(std::uint64_t a, std::uint64_t b) {
  std::size_t result = 0;
  if (__builtin_mul_overflow(a, b, &result) || result > (std::size_t{1} << 48)) return std::nullopt;
  return result;
}

Result<NpyScalar> scalar_of(const NpyField& field) {
  if (field.scalar) return *field.scalar;
  return Error{.field = field.name.empty() ? "descr" : field.name,
               .message = "not numbers we read",
               .received = field.type,
               .accepted = std::string(accepted_types)};
}

/// Finds the wanted columns of a plain array. They have no names and no implied order, so the scene
/// must give a number for each.
Result<std::vector<FileColumn>> plain_columns(std::span<const WantedColumn> wanted,
                                              std::uint64_t count, OperandFormat type,
                                              const std::string& source) {
  std::vector<FileColumn> columns;
  bool all_numbered = true;
  for (const WantedColumn& column : wanted) {
    const auto* number = std::get_if<std::uint64_t>(&column.column);
    if (number == nullptr && !column.field.empty()) {
      return column_mistake(column, "the columns of " + source + " have no names",
                            in_quotes(std::get<std::string>(column.column)),
                            fmt::format("a number below {}, the first column being 0", count));
    }
    all_numbered = all_numbered && number != nullptr;
    if (number == nullptr) continue;
    MIXCMP_TRY(place, numbered_column(column, *number, count, source));
    columns.push_back({.number = place, .name = {}, .type = type});
  }
  if (!all_numbered) return unnamed_columns(wanted, count);
  return columns;
}

Result<Layout> plain_layout(const NpyHeader& header, std::span<const WantedColumn> wanted,
                            const std::string& source) {
  MIXCMP_TRY(scalar, scalar_of(header.fields[0]));
  if (header.shape.size() != 2) {
    return shape_error(header, "(rows, columns), or (rows,) for an array of named fields");
  }
  const std::uint64_t rows = header.shape[0], count = header.shape[1];
  if (count == 0) return shape_error(header, "at least one column");
  const auto bytes = static_cast<std::size_t>(scalar.bytes);
  const auto column_bytes = product(rows, bytes), row_bytes = product(count, bytes);
  const auto total = product(column_bytes.value_or(SIZE_MAX), count);
  if (!column_bytes || !row_bytes || !total) {
    return shape_error(header, "an array that fits a file");
  }
  Layout layout{.rows = rows, .total_bytes = *total};
  MIXCMP_TRY(columns, plain_columns(wanted, count, type_of(scalar), source));
  for (const FileColumn& column : columns) {
    layout.columns.push_back(
        header.fortran_order ? ColumnLayout{column, scalar, column.number * *column_bytes, bytes}
                             : ColumnLayout{column, scalar, column.number * bytes, *row_bytes});
  }
  return layout;
}

Result<Layout> structured_layout(const NpyHeader& header, std::span<const WantedColumn> wanted,
                                 const std::string& source) {
  if (header.shape.size() != 1) return shape_error(header, "(rows,) for an array of named fields");
  std::vector<std::string> names;
  std::vector<NpyField> fields;
  std::size_t row_bytes = 0;
  for (const NpyField& field : header.fields) {
    row_bytes += field.bytes;
    if (field.name.empty()) continue;
    if (std::find(names.begin(), names.end(), field.name) != names.end()) {
      return Error{.field = "descr",
                   .message = "two fields of this name",
                   .received = in_quotes(field.name),
                   .accepted = "names that differ, as NumPy has them"};
    }
    names.push_back(field.name);
    fields.push_back(field);
  }
  const auto total = product(header.shape[0], row_bytes);
  if (!total) return shape_error(header, "an array that fits a file");
  Layout layout{.rows = header.shape[0], .total_bytes = *total};
  for (const WantedColumn& column : wanted) {
    MIXCMP_TRY(place, find_column(column, names, source));
    MIXCMP_TRY(scalar, scalar_of(fields[place]));
    const std::string name = printable_line(names[place]);
    layout.columns.push_back({{.number = place, .name = name, .type = type_of(scalar)},
                              scalar,
                              fields[place].offset,
                              row_bytes});
  }
  return layout;
}

std::uint64_t load(std::string_view bytes, bool big_endian) {
  std::uint64_t value = 0;
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    const std::size_t place = big_endian ? k : bytes.size() - 1 - k;
    value = value << 8 | static_cast<unsigned char>(bytes[place]);
  }
  return value;
}

mpq_class integer_of(std::uint64_t bits, const NpyScalar& scalar) {
  if (scalar.kind == 'u') return mpq_class(static_cast<unsigned long>(bits));
  const int unused = 64 - 8 * scalar.bytes;
  return mpq_class(static_cast<long>(bits << unused) >> unused);
}

/// Rounds a number to a format; none if it is finite and becomes an infinity.
std::optional<Bits> read_scalar(std::uint64_t bits, const NpyScalar& scalar, FloatFormat format) {
  const bool is_float = scalar.kind == 'f';
  const Bits value = is_float ? converted(format, float_of(scalar.bytes), bits)
                              : from_rational(format, integer_of(bits, scalar));
  const bool infinite_before = is_float && float_of(scalar.bytes).is_infinite(bits);
  if (format.is_infinite(value) && !infinite_before) return std::nullopt;
  return value;
}

/// Whether `value`, which read_scalar made of an integer, is another one, or of a float other than
/// 0, is 0, or is a NaN that was none.
bool is_lost(std::uint64_t bits, const NpyScalar& scalar, FloatFormat format, Bits value) {
  if (format.is_nan(value)) return scalar.kind != 'f' || !float_of(scalar.bytes).is_nan(bits);
  if (scalar.kind != 'f') return to_rational(format, value) != integer_of(bits, scalar);
  return format.is_zero(value) && !float_of(scalar.bytes).is_zero(bits);
}

std::string text_of(std::uint64_t bits, const NpyScalar& scalar) {
  if (scalar.kind != 'f') return integer_of(bits, scalar).get_str();
  return to_text(float_of(scalar.bytes), bits);
}

Result<Table> parse_npy(std::string_view file, FloatFormat format,
                        std::span<const WantedColumn> wanted, const std::string& source) {
  MIXCMP_TRY(header, parse_npy_header(file));
  MIXCMP_TRY(layout, header.structured ? structured_layout(header, wanted, source)
                                       : plain_layout(header, wanted, source));
  const std::string_view data = file.substr(header.data_offset);
  if (data.size() != layout.total_bytes) {
    return Error{.field = "data",
                 .message = "the data do not fill the shape",
                 .received = fmt::format("{} bytes", data.size()),
                 .accepted = fmt::format("{} bytes", layout.total_bytes)};
  }
  Table table{.format = format, .columns = {}, .source = source};
  for (const WantedColumn& column : wanted) table.columns.push_back(column.name);
  for (const ColumnLayout& column : layout.columns) table.origins.push_back(column.column);
  for (std::uint64_t row = 0; row < layout.rows; ++row) {
    for (std::size_t k = 0; k < layout.columns.size(); ++k) {
      const ColumnLayout& column = layout.columns[k];
      const FloatFormat rounded_to = wanted[k].rounded_to.value_or(format);
      const auto bytes = data.substr(column.first + row * column.stride,
                                     static_cast<std::size_t>(column.scalar.bytes));
      const std::uint64_t bits = load(bytes, column.scalar.big_endian);
      const auto value = read_scalar(bits, column.scalar, rounded_to);
      if (!value) {
        return Error{
            .field = fmt::format("row {}, {}", row, column.column.shown()),
            .message = "out of range",
            .received = fmt::format("a number beyond the largest of {}", rounded_to.name()),
            .accepted = "a smaller one, or a format with more exponent bits"};
      }
      table.values.push_back(converted(format, rounded_to, *value));
      if (is_lost(bits, column.scalar, rounded_to, *value)) {
        table.lost.add(
            {1, fmt::format("{} in {}, row {}, {}, read in {}", text_of(bits, column.scalar),
                            source, row, column.column.shown(), rounded_to.name())});
      }
    }
  }
  return table;
}

}  // namespace

Result<Table> read_npy(const std::filesystem::path& path, FloatFormat format,
                       std::span<const WantedColumn> wanted) {
  MIXCMP_TRY(file, read_file(path));
  Result<Table> table = parse_npy(file, format, wanted, path.filename().string());
  if (table.ok()) return table;
  Error error = table.error();
  if (error.file.empty()) error.file = path.string();
  return error;
}

}  // namespace mixcmp::data
