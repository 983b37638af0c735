#include "model/data/npy.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "model/common/file.hpp"
#include "model/data/column_names.hpp"
#include "model/data/npy_header.hpp"
#include "model/golden/arithmetic.hpp"

namespace mixcmp::model {
namespace {

constexpr std::string_view accepted_types = "floats of 2, 4, 8 bytes or integers of 1, 2, 4, 8";

/// Where a column's numbers stand among the file's data.
struct ColumnLayout {
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

/// a * b, or none where no file could be that large.
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

Result<Layout> plain_layout(const NpyHeader& header, std::span<const std::string> columns) {
  MIXCMP_TRY(scalar, scalar_of(header.fields[0]));
  std::string names;
  for (const std::string& column : columns) names += (names.empty() ? "" : ", ") + column;
  if (header.shape.size() != 2 || header.shape[1] != columns.size()) {
    return shape_error(header,
                       fmt::format("(rows, {}), the columns being {}", columns.size(), names));
  }
  const std::uint64_t rows = header.shape[0];
  const auto bytes = static_cast<std::size_t>(scalar.bytes);
  const auto column_bytes = product(rows, bytes);
  const auto total = product(column_bytes.value_or(SIZE_MAX), columns.size());
  if (!column_bytes || !total) return shape_error(header, "an array that fits a file");
  Layout layout{.rows = rows, .total_bytes = *total};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    layout.columns.push_back(header.fortran_order
                                 ? ColumnLayout{scalar, k * *column_bytes, bytes}
                                 : ColumnLayout{scalar, k * bytes, bytes * columns.size()});
  }
  return layout;
}

Result<Layout> structured_layout(const NpyHeader& header, std::span<const std::string> columns) {
  if (header.shape.size() != 1) return shape_error(header, "(rows,) for an array of named fields");
  std::vector<std::string> names;
  std::size_t row_bytes = 0;
  for (const NpyField& field : header.fields) {
    names.push_back(field.name);
    row_bytes += field.bytes;
  }
  const auto total = product(header.shape[0], row_bytes);
  if (!total) return shape_error(header, "an array that fits a file");
  Layout layout{.rows = header.shape[0], .total_bytes = *total};
  for (const std::string& column : columns) {
    const auto found = std::find(names.begin(), names.end(), column);
    if (found == names.end()) return missing_column(column, names);
    const NpyField& field = header.fields[static_cast<std::size_t>(found - names.begin())];
    MIXCMP_TRY(scalar, scalar_of(field));
    layout.columns.push_back({scalar, field.offset, row_bytes});
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

/// `bits` of one format in another, rounded once; signs of zeros and NaNs as such.
Bits into(FloatFormat target, FloatFormat source, Bits bits) {
  const bool negative = source.sign(bits);
  if (source.is_nan(bits)) return target.quiet_nan();
  if (source.is_infinite(bits)) return target.infinity(negative);
  if (source.is_zero(bits)) return target.zero(negative);
  return golden::from_rational(target, golden::to_rational(source, bits)) | target.zero(negative);
}

FloatFormat float_of(int bytes) {
  return FloatFormat::parse(bytes == 2 ? "binary16" : bytes == 4 ? "binary32" : "binary64").value();
}

mpq_class integer_of(std::uint64_t bits, const NpyScalar& scalar) {
  if (scalar.kind == 'u') return mpq_class(static_cast<unsigned long>(bits));
  const int unused = 64 - 8 * scalar.bytes;
  return mpq_class(static_cast<long>(bits << unused) >> unused);
}

/// None where a finite number is beyond the format's largest.
std::optional<Bits> read_scalar(std::string_view bytes, const NpyScalar& scalar,
                                FloatFormat format) {
  const std::uint64_t bits = load(bytes, scalar.big_endian);
  const bool is_float = scalar.kind == 'f';
  const Bits value = is_float ? into(format, float_of(scalar.bytes), bits)
                              : golden::from_rational(format, integer_of(bits, scalar));
  const bool infinite_before = is_float && float_of(scalar.bytes).is_infinite(bits);
  if (format.is_infinite(value) && !infinite_before) return std::nullopt;
  return value;
}

Result<Table> parse_npy(std::string_view file, FloatFormat format,
                        std::span<const std::string> columns) {
  MIXCMP_TRY(header, parse_npy_header(file));
  MIXCMP_TRY(layout, header.structured ? structured_layout(header, columns)
                                       : plain_layout(header, columns));
  const std::string_view data = file.substr(header.data_offset);
  if (data.size() != layout.total_bytes) {
    return Error{.field = "data",
                 .message = "the data do not fill the shape",
                 .received = fmt::format("{} bytes", data.size()),
                 .accepted = fmt::format("{} bytes", layout.total_bytes)};
  }
  Table table{.format = format, .columns = {columns.begin(), columns.end()}};
  for (std::uint64_t row = 0; row < layout.rows; ++row) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const ColumnLayout& column = layout.columns[k];
      const auto bytes = data.substr(column.first + row * column.stride,
                                     static_cast<std::size_t>(column.scalar.bytes));
      const auto value = read_scalar(bytes, column.scalar, format);
      if (!value) {
        return Error{.field = fmt::format("{}, row {}", columns[k], row),
                     .message = "out of range",
                     .received = fmt::format("a number beyond the largest of {}", format.name()),
                     .accepted = "a smaller one, or a reference format with more exponent bits"};
      }
      table.values.push_back(*value);
    }
  }
  return table;
}

}  // namespace

Result<Table> read_npy(const std::filesystem::path& path, FloatFormat format,
                       std::span<const std::string> columns) {
  MIXCMP_TRY(file, read_file(path));
  Result<Table> table = parse_npy(file, format, columns);
  if (table.ok()) return table;
  Error error = table.error();
  error.file = path.string();
  return error;
}

}  // namespace mixcmp::model
