#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
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
};

/// What an input of a comparison of two items names: "cxi" is column "cx" of the first.
struct ItemColumn {
  std::string name;
  bool second;
};
/// None for a name that does not end in i or j, or is nothing else.
std::optional<ItemColumn> item_column(std::string_view input);

/// Pairs i < j of `count` items, numbered (0,1), (0,2), ..., (1,2), ...; exact up to 2^31 items.
constexpr std::uint64_t max_paired_items = std::uint64_t{1} << 31;
std::uint64_t pair_count(std::uint64_t count);
std::pair<std::uint64_t, std::uint64_t> pair_items(std::uint64_t index, std::uint64_t count);

/// The comparisons a scene asks for, addressable by index: every row of a table, or every pair
/// i < j of its rows. With pairs, input "cxi" is column "cx" of item i, "cxj" that of item j.
class Comparisons {
public:
  /// `inputs` are the expression's, in order. Errors name the input that no column serves.
  static Result<Comparisons> rows(Table table, const std::vector<std::string>& inputs);
  static Result<Comparisons> all_pairs(Table items, const std::vector<std::string>& inputs);

  std::uint64_t size() const;
  /// Writes the operands of comparison `index` in the order of `inputs`.
  void fetch(std::uint64_t index, std::span<Bits> operands) const;
  /// (i, j) of comparison `index`, i < j in order (0,1), (0,2), ...; (index, index) for rows.
  std::pair<std::uint64_t, std::uint64_t> items(std::uint64_t index) const;

  /// Where an input's operands stand in the table.
  struct Source {
    std::size_t column;
    bool second;  ///< of item j
  };

  const Table& table() const { return table_; }
  std::size_t input_count() const { return sources_.size(); }
  const std::vector<Source>& sources() const { return sources_; }
  bool pairs() const { return pairs_; }

private:
  Comparisons(Table table, std::vector<Source> sources, bool pairs)
      : table_(std::move(table)), sources_(std::move(sources)), pairs_(pairs) {}

  Table table_;
  std::vector<Source> sources_;
  bool pairs_;
};

}  // namespace mixcmp::model
