#pragma once

#include <cstdint>
#include <vector>

#include "model/comparison/data/comparisons.hpp"

namespace mixcmp::data {

/// Operands of comparisons as columns of doubles, one column per input.
class OperandBlock {
public:
  OperandBlock(std::size_t inputs, std::size_t capacity);

  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  bool full() const { return size_ == capacity_; }
  void resize(std::size_t size) { size_ = size; }
  double* column(std::size_t input) { return values_.data() + input * capacity_; }
  const double* column(std::size_t input) const { return values_.data() + input * capacity_; }
  /// The columns from row `first` on.
  std::vector<const double*> columns(std::size_t first = 0) const;
  /// Appends row `row` of another block with the same number of inputs.
  void append(const OperandBlock& from, std::size_t row);

private:
  std::size_t capacity_;
  std::size_t size_ = 0;
  std::vector<double> values_;
};

/// The data's operands as doubles, exactly: the format has at most 53 digits and 11 exponent bits.
class OperandSource {
public:
  explicit OperandSource(const Comparisons& data);

  const Comparisons& data() const { return data_; }
  /// The column that an input reads, one value per row of its table.
  const std::vector<double>& values(std::size_t input) const;
  /// Replaces the block's contents by the `count` comparisons from `first` on.
  void fetch(std::uint64_t first, std::size_t count, OperandBlock& block) const;
  /// Replaces the block's contents by the comparisons of these indices.
  void fetch(std::span<const std::uint64_t> indices, OperandBlock& block) const;

private:
  /// Appends `length` comparisons to the block. The first has the items `at`. From one to the next
  /// the moving item grows by 1.
  void fetch_run(const Items& at, std::size_t length, OperandBlock& block) const;

  const Comparisons& data_;
  std::vector<std::vector<std::vector<double>>> columns_;  ///< [table][column][row]
};

}  // namespace mixcmp::data
