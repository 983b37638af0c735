#include "model/comparison/data/comparisons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "model/base/common/check.hpp"
#include "model/base/common/nearest.hpp"
#include "model/base/number/exact.hpp"

namespace mixcmp::data {
namespace {

/// Index of the first pair (i, i + 1) of item i: the sum of (count - 1) + (count - 2) + ... It is
/// below 2^63 for up to 2^31 items, so it is exact.
std::uint64_t first_pair_of(std::uint64_t i, std::uint64_t count) {
  return i * (2 * count - i - 1) / 2;
}

/// The key that names a table's source.
std::string key_of(std::size_t table) {
  return table == 0 ? "data.file" : "data.with";
}

Error no_column(const std::string& input, const InputColumn& place, const Table& table) {
  return {.field = key_of(place.table),
          .message = fmt::format("no column {} for the input {}", place.name, input),
          .received = "no such column",
          .accepted = list_with_nearest(place.name, table.columns)};
}

std::optional<std::size_t> find_column(const Table& table, std::string_view name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  if (found == table.columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - table.columns.begin());
}

Error wrong_count(std::size_t table, std::string message, std::string_view what,
                  std::uint64_t received, std::uint64_t low, std::uint64_t high) {
  return {.field = key_of(table),
          .message = std::move(message),
          .received = fmt::format("{} {}", received, what),
          .accepted = fmt::format("{}..{} {}", low, high, what)};
}

Result<Done> check_counts(Pairing pairing, const std::vector<Table>& tables) {
  const std::uint64_t rows = tables[0].rows();
  if (pairing == Pairing::all && (rows < 2 || rows > max_paired_items)) {
    return wrong_count(0, "no such number of items can be paired", "items", rows, 2,
                       max_paired_items);
  }
  if (rows == 0) return wrong_count(0, "nothing to compare", "rows", rows, 1, max_paired_items);
  if (!has_second_table(pairing)) return Done{};
  const std::uint64_t others = tables[1].rows();
  const std::uint64_t least = pairing == Pairing::arg_min ? 2 : 1;
  if (others < least) {
    return wrong_count(1, "too few rows", "rows", others, least, max_paired_items);
  }
  const std::uint64_t most =
      pairing == Pairing::arg_min ? max_arg_min_comparisons / (others - 1) : max_paired_items;
  if (rows > most || others > max_paired_items) {
    return wrong_count(0, "too many comparisons", "rows", rows, 1, most);
  }
  return Done{};
}

}  // namespace

std::pair<std::uint64_t, std::uint64_t> pair_items(std::uint64_t index, std::uint64_t count) {
  MIXCMP_CHECK(count <= max_paired_items && index < pair_count(count));
  // Item i comes first in the pairs from i (count - 1/2) - i^2 / 2 on. The computed root is off by
  // its rounding.
  const double n = static_cast<double>(count) - 0.5;
  const double root = n - std::sqrt(std::max(0.0, n * n - 2 * static_cast<double>(index)));
  std::uint64_t first = std::min(static_cast<std::uint64_t>(std::max(0.0, root)), count - 2);
  while (first_pair_of(first, count) > index) --first;
  while (first + 2 < count && first_pair_of(first + 1, count) <= index) ++first;
  return {first, first + 1 + index - first_pair_of(first, count)};
}

std::uint64_t pair_index(std::uint64_t i, std::uint64_t j, std::uint64_t count) {
  MIXCMP_CHECK(i < j && j < count && count <= max_paired_items);
  return first_pair_of(i, count) + (j - i - 1);
}

std::uint64_t pair_count(std::uint64_t count) {
  return count == 0 ? 0 : count * (count - 1) / 2;
}

Result<Comparisons> Comparisons::make(Pairing pairing, std::vector<Table> tables,
                                      const std::vector<std::string>& inputs) {
  std::vector<Source> sources;
  for (const std::string& input : inputs) {
    MIXCMP_TRY(place, input_column(pairing, input));
    const Table& table = tables[place.table];
    const auto column = find_column(table, place.name);
    if (!column) return no_column(input, place, table);
    sources.push_back({.table = place.table, .column = *column, .item = place.item});
  }
  for (std::size_t table = 0; table < tables.size(); ++table) {
    const auto reads = [&](const Source& source) { return source.table == table; };
    if (std::any_of(sources.begin(), sources.end(), reads)) continue;
    return Error{.field = "data.pairs",
                 .message = fmt::format("no input is a column of the {} table",
                                        table == 0 ? "first" : "second"),
                 .received = fmt::format("{}", fmt::join(inputs, ", ")),
                 .accepted = pairing == Pairing::cross ? "inputs of item i and inputs of item j"
                                                       : "inputs of the row and of items i and j"};
  }
  MIXCMP_DO(check_counts(pairing, tables));
  return Comparisons(pairing, std::move(tables), std::move(sources));
}

Result<Comparisons> Comparisons::rows(Table table, const std::vector<std::string>& inputs) {
  return make(Pairing::rows, {std::move(table)}, inputs);
}

Result<Comparisons> Comparisons::all_pairs(Table items, const std::vector<std::string>& inputs) {
  return make(Pairing::all, {std::move(items)}, inputs);
}

Result<Comparisons> Comparisons::cross(Table first, Table second,
                                       const std::vector<std::string>& inputs) {
  return make(Pairing::cross, {std::move(first), std::move(second)}, inputs);
}

Result<Comparisons> Comparisons::arg_min(Table rows, Table candidates,
                                         const std::vector<std::string>& inputs,
                                         const CompareItems& compare) {
  MIXCMP_TRY(data, make(Pairing::arg_min, {std::move(rows), std::move(candidates)}, inputs));
  data.find_least_candidates(compare);
  return data;
}

/// All rows of a block are compared with candidate j before any is compared with j + 1, so
/// `compare` decides many comparisons in one call.
void Comparisons::find_least_candidates(const CompareItems& compare) {
  constexpr std::size_t block = 4096;
  const std::uint64_t rows = tables_[0].rows(), candidates = tables_[1].rows();
  best_before_.resize(rows * (candidates - 1));
  least_.assign(rows, 0);
  std::vector<Items> items;
  std::vector<std::uint8_t> greater(block);
  for (std::uint64_t start = 0; start < rows; start += block) {
    const std::uint64_t end = std::min(rows, start + block);
    for (std::uint64_t j = 1; j < candidates; ++j) {
      items.clear();
      for (std::uint64_t row = start; row < end; ++row) {
        best_before_[row * (candidates - 1) + j - 1] = least_[row];
        items.push_back({.row = row, .first = least_[row], .second = j});
      }
      compare(*this, items, greater);
      for (std::uint64_t row = start; row < end; ++row) {
        if (greater[row - start] != 0) least_[row] = static_cast<std::uint32_t>(j);
      }
    }
  }
}

Comparisons Comparisons::in_format(FloatFormat format) const {
  Comparisons same = *this;
  for (Table& table : same.tables_) {
    for (Bits& value : table.values) {
      const Bits number = converted(format, table.format, value);
      MIXCMP_CHECK(converted(table.format, format, number) == value);
      value = number;
    }
    table.format = format;
  }
  return same;
}

std::uint64_t Comparisons::size() const {
  const std::uint64_t rows = tables_[0].rows();
  switch (pairing_) {
    case Pairing::rows: return rows;
    case Pairing::all: return pair_count(rows);
    case Pairing::cross: return rows * tables_[1].rows();
    case Pairing::arg_min: return rows * (tables_[1].rows() - 1);
  }
  MIXCMP_CHECK(false);
}

void Comparisons::fetch(std::uint64_t index, std::span<Bits> operands) const {
  fetch(items(index), operands);
}

void Comparisons::fetch(const Items& items, std::span<Bits> operands) const {
  MIXCMP_CHECK(operands.size() == sources_.size());
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    const Source& source = sources_[k];
    operands[k] = tables_[source.table].at(items.of(source.item), source.column);
  }
}

Items Comparisons::items(std::uint64_t index) const {
  MIXCMP_CHECK(index < size());
  switch (pairing_) {
    case Pairing::rows: return {.row = index, .first = index, .second = index};
    case Pairing::all: {
      const auto [i, j] = pair_items(index, tables_[0].rows());
      return {.first = i, .second = j};
    }
    case Pairing::cross: {
      const std::uint64_t others = tables_[1].rows();
      return {.first = index / others, .second = index % others};
    }
    case Pairing::arg_min: {
      const std::uint64_t others = tables_[1].rows() - 1;
      return {.row = index / others, .first = best_before_[index], .second = 1 + index % others};
    }
  }
  MIXCMP_CHECK(false);
}

std::uint64_t Comparisons::run_length(std::uint64_t index) const {
  const Items at = items(index);
  switch (pairing_) {
    case Pairing::rows: return size() - index;
    case Pairing::all: return tables_[0].rows() - at.second;
    case Pairing::cross: return tables_[1].rows() - at.second;
    case Pairing::arg_min: {
      const std::uint64_t most = tables_[1].rows() - at.second;
      std::uint64_t length = 1;
      while (length < most && best_before_[index + length] == at.first) ++length;
      return length;
    }
  }
  MIXCMP_CHECK(false);
}

bool Comparisons::takes_part(const Source& source, std::uint64_t row) const {
  const bool ordered = pairing_ == Pairing::all || pairing_ == Pairing::arg_min;
  if (!ordered || source.item == Item::row) return true;
  return source.item == Item::second ? row > 0 : row + 1 < tables_[source.table].rows();
}

LostNumbers lost_numbers_of(const Comparisons& data) {
  LostNumbers all;
  for (const Table& table : data.tables()) all.add(table.lost);
  return all;
}

std::string describe(const Comparisons& data, std::uint64_t index) {
  const Items items = data.items(index);
  const Table &first = data.tables().front(), &last = data.tables().back();
  switch (data.pairing()) {
    case Pairing::rows: return "row " + first.label(items.row);
    case Pairing::all:
    case Pairing::cross:
      return fmt::format("items {} and {}", first.label(items.first), last.label(items.second));
    case Pairing::arg_min:
      return fmt::format("row {}, candidates {} and {}", first.label(items.row),
                         last.label(items.first), last.label(items.second));
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::data
