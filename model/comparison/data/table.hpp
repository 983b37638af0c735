#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/base/number/float_format.hpp"
#include "model/base/number/operand_format.hpp"

namespace mixcmp::data {

/// A column's number and name in its file, and the type of its numbers there.
struct FileColumn {
  std::uint64_t number;               ///< counted from 0
  std::string name;                   ///< empty if the file has no names
  std::optional<OperandFormat> type;  ///< none in text

  /// `width`, or `column 2` if there is no name.
  std::string shown() const { return name.empty() ? "column " + std::to_string(number) : name; }
};

/// Numbers of a file that a format does not keep: whole numbers that it rounds (written in digits,
/// or integers by their type), others than 0 that become 0, and in a format without infinities
/// those that become a NaN: infinities, and numbers that round to none of its numbers.
struct LostNumbers {
  std::uint64_t count = 0;
  std::string first;  ///< "17 in a.csv, line 3, x, read in s3e5"; empty: none

  void add(const LostNumbers& others) {
    if (count == 0) first = others.first;
    count += others.count;
  }
};

/// Rows of numbers in one format: spheres, atoms, points, or whole comparisons.
struct Table {
  FloatFormat format;
  std::vector<std::string> columns;
  std::vector<Bits> values = {};  ///< row-major, rows() * columns.size()
  /// The name of row i in reports ("A 151 MET CA" for an atom). Empty: the row's line or number is
  /// used.
  std::vector<std::string> labels = {};
  std::vector<int> lines = {};           ///< the file's line in which row i begins; empty: no lines
  std::string source = {};               ///< name of the file or of the generator
  std::vector<FileColumn> origins = {};  ///< one per column if there is a source
  LostNumbers lost = {};

  std::size_t rows() const { return columns.empty() ? 0 : values.size() / columns.size(); }
  Bits at(std::size_t row, std::size_t column) const {
    return values[row * columns.size() + column];
  }
  /// The label, "of line 7", or the number counted from 0.
  std::string label(std::size_t row) const {
    if (!labels.empty()) return labels[row];
    if (!lines.empty()) return "of line " + std::to_string(lines[row]);
    return std::to_string(row);
  }
};

}  // namespace mixcmp::data
