#pragma once

#include <cstdint>
#include <vector>

#include "model/data/comparisons.hpp"

namespace mixcmp::model {

/// Comparisons as columns of doubles, one an input.
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
  /// Appends row `row` of another block with as many inputs.
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
  /// Every value that an input takes, one a row of its table.
  const std::vector<double>& values(std::size_t input) const;
  /// Comparisons first, first + 1, ... replace the block's contents.
  void fetch(std::uint64_t first, std::size_t count, OperandBlock& block) const;
  /// The comparisons of these indices.
  void fetch(const std::vector<std::uint64_t>& indices, OperandBlock& block) const;

private:
  /// Comparisons from `at` on whose moving item counts up.
  void fetch_run(const Items& at, std::size_t length, OperandBlock& block) const;

  const Comparisons& data_;
  std::vector<std::vector<std::vector<double>>> columns_;  ///< of each table
};

}  // namespace mixcmp::model
