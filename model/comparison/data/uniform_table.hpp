#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/base/common/result.hpp"
#include "model/comparison/data/table.hpp"

namespace mixcmp::data {

/// The numbers low..high, both included, or the multiples of `grid` among them.
struct UniformNumbers {
  mpq_class low, high;
  std::optional<mpq_class> grid = {};
};

struct UniformColumn {
  std::string name;
  UniformNumbers numbers;
  std::optional<FloatFormat> rounded_to = {};  ///< as in WantedColumn
};

struct UniformTable {
  std::vector<UniformColumn> columns;
  std::uint64_t count = 8192;
  std::uint64_t seed = 1;
  std::uint32_t which = 0;  ///< 0 or 1: other tables, other numbers
};

/// Numbers drawn independently and uniformly. The number in row n is drawn by RowRandom of the seed
/// with the stream stream_of(name) + which: so it depends neither on the number of rows nor on
/// the other columns. Without a grid it is low + (high - low) * u / 2^53, with u the high 53 bits
/// of the first 64, rounded to the column's format. With a grid it is one of the multiples, each as
/// likely. A number that rounding moved out of the range, or off the grid, is drawn again from the
/// next bits. Error: a column of which the format has no number, named by `field`.
Result<Table> uniform_table(const UniformTable& uniform, FloatFormat format);

}  // namespace mixcmp::data
