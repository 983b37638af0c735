#include "model/judge/emulator/column_blocks.hpp"

#include <algorithm>
#include <memory>

namespace mixcmp::emulator {
namespace {

/// The length of a cache line in doubles. The distance of columns is the length of a block and one
/// line. That distance is no power of two, so columns do not compete for the same cache sets. It is
/// a multiple of a line, so no vector straddles two lines.
constexpr std::size_t cache_line = 8;

std::size_t stride(std::size_t block_size) {
  return block_size + cache_line;
}

std::size_t numbers(int columns, std::size_t block_size) {
  return static_cast<std::size_t>(columns) * stride(block_size);
}

double* aligned(double* memory) {
  void* address = memory;
  std::size_t space = 2 * cache_line * sizeof(double);
  return static_cast<double*>(
      std::align(cache_line * sizeof(double), cache_line * sizeof(double), address, space));
}

/// A block size with which all columns fit into 32 KiB, unless there are too many columns.
std::size_t fitting_block_size(int columns) {
  constexpr std::size_t cached_numbers = 4096, smallest_block = 2 * block_granularity;
  const std::size_t fitting = cached_numbers / static_cast<std::size_t>(std::max(columns, 1));
  return std::clamp(fitting / block_granularity * block_granularity, smallest_block,
                    max_block_size);
}

std::size_t whole_vectors(std::size_t count) {
  return (count + block_granularity - 1) / block_granularity * block_granularity;
}

}  // namespace

ColumnBlocks::ColumnBlocks(const ColumnLayout& layout, std::span<const double* const> operands,
                           std::size_t count)
    : layout_(layout),
      operands_(operands),
      count_(count),
      block_size_(std::min(fitting_block_size(layout.columns), whole_vectors(count))),
      memory_(new double[numbers(layout.columns, block_size_) + cache_line]),
      scratch_(aligned(memory_.get())),
      columns_(static_cast<std::size_t>(layout.columns)),
      results_(static_cast<std::size_t>(layout.columns)) {
  for (int column = 0; column < layout.columns; ++column) {
    columns_[column] = results_[column] = scratch_column(column);
  }
  for (const auto& [column, value] : layout.constants) {
    std::fill_n(results_[column], block_size_, value);
  }
}

double* ColumnBlocks::scratch_column(int index) {
  return scratch_ + numbers(index, block_size_);
}

void ColumnBlocks::point_to_operands() {
  const std::size_t whole = whole_vectors(size_);
  for (const auto& [column, operand] : layout_.inputs) {
    const double* values = operands_[operand] + first_;
    columns_[column] = values;
    if (whole == size_) continue;
    double* copy = scratch_column(column);
    std::fill(std::copy_n(values, size_, copy), copy + whole, values[0]);
    columns_[column] = copy;
  }
}

bool ColumnBlocks::next() {
  first_ += size_;
  size_ = std::min(block_size_, count_ - first_);
  if (size_ == 0) return false;
  point_to_operands();
  block_ = {.columns = columns_.data(), .results = results_.data(), .size = whole_vectors(size_)};
  return true;
}

}  // namespace mixcmp::emulator
