#include "model/comparison/data/operand_source.hpp"

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/base/number/double.hpp"

namespace mixcmp::data {

OperandBlock::OperandBlock(std::size_t inputs, std::size_t capacity)
    : capacity_(capacity), values_(inputs * capacity) {}

std::vector<const double*> OperandBlock::columns(std::size_t first) const {
  std::vector<const double*> columns;
  for (std::size_t at = first; at < values_.size(); at += capacity_) {
    columns.push_back(values_.data() + at);
  }
  return columns;
}

void OperandBlock::append(const OperandBlock& from, std::size_t row) {
  MIXCMP_CHECK(!full());
  std::size_t theirs = row;
  for (std::size_t ours = size_; ours < values_.size(); ours += capacity_) {
    values_[ours] = from.values_[theirs];
    theirs += from.capacity_;
  }
  ++size_;
}

OperandSource::OperandSource(const Comparisons& data) : data_(data) {
  MIXCMP_CHECK(fits_double(data.format()));
  for (const Table& table : data.tables()) {
    auto& columns = columns_.emplace_back(table.columns.size(), std::vector<double>(table.rows()));
    for (std::size_t column = 0; column < columns.size(); ++column) {
      for (std::size_t row = 0; row < table.rows(); ++row) {
        columns[column][row] = to_double(table.format, table.at(row, column));
      }
    }
  }
}

const std::vector<double>& OperandSource::values(std::size_t input) const {
  const Comparisons::Source& source = data_.sources()[input];
  return columns_[source.table][source.column];
}

void OperandSource::fetch_run(const Items& at, std::size_t length, OperandBlock& block) const {
  const std::size_t start = block.size();
  for (std::size_t input = 0; input < data_.input_count(); ++input) {
    const Item item = data_.sources()[input].item;
    const double* const from = values(input).data() + at.of(item);
    double* const target = block.column(input) + start;
    if (item == data_.moving_item()) {
      std::copy_n(from, length, target);
    } else {
      std::fill_n(target, length, *from);
    }
  }
  block.resize(start + length);
}

void OperandSource::fetch(std::uint64_t first, std::size_t count, OperandBlock& block) const {
  MIXCMP_CHECK(count <= block.capacity());
  block.resize(0);
  while (block.size() < count) {
    const std::uint64_t index = first + block.size();
    const std::uint64_t left = count - block.size();
    fetch_run(data_.items(index), std::min(left, data_.run_length(index)), block);
  }
}

void OperandSource::fetch(std::span<const std::uint64_t> indices, OperandBlock& block) const {
  MIXCMP_CHECK(indices.size() <= block.capacity());
  block.resize(0);
  for (const std::uint64_t index : indices) fetch_run(data_.items(index), 1, block);
}

}  // namespace mixcmp::data
