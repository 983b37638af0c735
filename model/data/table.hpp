#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/format/float_format.hpp"

namespace mixcmp::model {

/// Rows of numbers in one format: spheres, atoms, points, or whole comparisons.
struct Table {
  FloatFormat format;
  std::vector<std::string> columns;
  std::vector<Bits> values;  ///< row-major, rows() * columns.size()
  /// What a report calls row i (an atom's "A 151 MET CA"); empty: the row number.
  std::vector<std::string> labels;

  std::size_t rows() const { return columns.empty() ? 0 : values.size() / columns.size(); }
  Bits at(std::size_t row, std::size_t column) const {
    return values[row * columns.size() + column];
  }
  std::string label(std::size_t row) const {
    return labels.empty() ? std::to_string(row) : labels[row];
  }
};

}  // namespace mixcmp::model
