#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "model/judge/emulator/block.hpp"

namespace mixcmp::emulator {

/// The columns of a block that are filled from outside.
struct ColumnLayout {
  int columns = 0;
  std::vector<std::pair<int, int>> inputs;        ///< column, operand
  std::vector<std::pair<int, double>> constants;  ///< column, value
};

/// A pass over comparisons, a block at a time, with the scratch memory for the columns of one.
class ColumnBlocks {
public:
  /// `operands` has one array of `count` doubles per operand; `layout` must outlive this object.
  ColumnBlocks(const ColumnLayout& layout, std::span<const double* const> operands,
               std::size_t count);

  /// Goes on to the next block; false after the last.
  bool next();

  /// The block's first comparison, its number of comparisons, and their columns, which are filled
  /// up to whole vectors with copies of the first.
  std::size_t first() const { return first_; }
  std::size_t size() const { return size_; }
  const Block& block() const { return block_; }

private:
  void point_to_operands();
  double* scratch_column(int index);

  const ColumnLayout& layout_;
  std::span<const double* const> operands_;
  std::size_t count_;
  std::size_t block_size_;
  std::unique_ptr<double[]> memory_;
  double* scratch_;
  std::vector<const double*> columns_;
  std::vector<double*> results_;
  Block block_{};
  std::size_t first_ = 0, size_ = 0;
};

}  // namespace mixcmp::emulator
