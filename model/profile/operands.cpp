#include "model/profile/operands.hpp"

#include <algorithm>

#include "model/common/check.hpp"
#include "model/golden/encoding.hpp"

namespace mixcmp::model {

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
  std::size_t theirs = row;
  for (std::size_t ours = size_; ours < values_.size(); ours += capacity_) {
    values_[ours] = from.values_[theirs];
    theirs += from.capacity_;
  }
  ++size_;
}

bool double_holds(FloatFormat format) {
  return format.precision() <= 53 && format.exponent_bits() <= 11;
}

OperandSource::OperandSource(const Comparisons& data) : data_(data) {
  const Table& table = data.table();
  MIXCMP_CHECK(double_holds(table.format));
  golden::BigFloat value(golden::encoding_precision);
  columns_.assign(table.columns.size(), std::vector<double>(table.rows()));
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
      golden::decode(value, table.format, table.at(row, column));
      columns_[column][row] = mpfr_get_d(value.get(), MPFR_RNDN);
    }
  }
}

const std::vector<double>& OperandSource::values(std::size_t input) const {
  return columns_[data_.sources()[input].column];
}

void OperandSource::fetch_run(std::size_t first, std::size_t second, std::size_t length,
                              OperandBlock& block) const {
  const std::size_t start = block.size();
  for (std::size_t input = 0; input < data_.input_count(); ++input) {
    const std::vector<double>& values = columns_[data_.sources()[input].column];
    double* const target = block.column(input) + start;
    if (!data_.pairs() || data_.sources()[input].second) {
      std::copy_n(values.data() + second, length, target);
    } else {
      std::fill_n(target, length, values[first]);
    }
  }
  block.resize(start + length);
}

void OperandSource::fetch(std::uint64_t first, std::size_t count, OperandBlock& block) const {
  MIXCMP_CHECK(count <= block.capacity());
  block.resize(0);
  if (count == 0) return;
  auto [i, j] = data_.items(first);
  while (block.size() < count) {
    // All pairs of one first item are neighbours; so are all rows.
    const std::size_t length = std::min(count - block.size(), data_.table().rows() - j);
    fetch_run(i, j, length, block);
    ++i;
    j = i + 1;
  }
}

void OperandSource::fetch(const std::vector<std::uint64_t>& indices, OperandBlock& block) const {
  MIXCMP_CHECK(indices.size() <= block.capacity());
  block.resize(0);
  for (const std::uint64_t index : indices) {
    const auto [i, j] = data_.items(index);
    fetch_run(i, j, 1, block);
  }
}

}  // namespace mixcmp::model
