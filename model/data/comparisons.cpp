#include "model/data/comparisons.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

#include "model/common/check.hpp"
#include "model/common/nearest.hpp"

namespace mixcmp::model {
namespace {

/// Index of the first pair (i, i + 1) of item i: the sum of (count - 1) + (count - 2) + ... Below
/// 2^63 for up to 2^31 items, so exact.
std::uint64_t first_pair_of(std::uint64_t i, std::uint64_t count) {
  return i * (2 * count - i - 1) / 2;
}

Error no_column(const std::string& input, const std::string& column, const Table& table) {
  return {.field = "data",
          .message = fmt::format("no column {} for the input {}", column, input),
          .received = "no such column",
          .accepted = list_with_nearest(column, table.columns)};
}

std::optional<std::size_t> find_column(const Table& table, std::string_view name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  if (found == table.columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - table.columns.begin());
}

}  // namespace

std::optional<ItemColumn> item_column(std::string_view input) {
  if (input.size() < 2 || (!input.ends_with('i') && !input.ends_with('j'))) return std::nullopt;
  return ItemColumn{.name = std::string(input.substr(0, input.size() - 1)),
                    .second = input.ends_with('j')};
}

std::pair<std::uint64_t, std::uint64_t> pair_items(std::uint64_t index, std::uint64_t count) {
  MIXCMP_CHECK(count <= max_paired_items && index < pair_count(count));
  std::uint64_t low = 0, high = count - 1;  // the first item lies in [low, high)
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (first_pair_of(middle, count) <= index ? low : high) = middle;
  }
  return {low, low + 1 + index - first_pair_of(low, count)};
}

std::uint64_t pair_count(std::uint64_t count) {
  return count == 0 ? 0 : count * (count - 1) / 2;
}

Result<Comparisons> Comparisons::rows(Table table, const std::vector<std::string>& inputs) {
  std::vector<Source> sources;
  for (const std::string& input : inputs) {
    const auto column = find_column(table, input);
    if (!column) return no_column(input, input, table);
    sources.push_back({.column = *column, .second = false});
  }
  if (table.rows() == 0) {
    return Error{.field = "data",
                 .message = "nothing to compare",
                 .received = "no rows",
                 .accepted = "at least one"};
  }
  return Comparisons(std::move(table), std::move(sources), false);
}

Result<Comparisons> Comparisons::all_pairs(Table items, const std::vector<std::string>& inputs) {
  std::vector<Source> sources;
  for (const std::string& input : inputs) {
    const auto item = item_column(input);
    if (!item) {
      return Error{.field = "data.pairs",
                   .message = "with pairs, inputs are columns of item i or item j",
                   .received = input,
                   .accepted = "a column's name followed by i or j"};
    }
    const auto column = find_column(items, item->name);
    if (!column) return no_column(input, item->name, items);
    sources.push_back({.column = *column, .second = item->second});
  }
  if (items.rows() < 2 || items.rows() > max_paired_items) {
    return Error{.field = "data.pairs",
                 .message = "no such number of items can be paired",
                 .received = fmt::format("{} items", items.rows()),
                 .accepted = fmt::format("2..{} items", max_paired_items)};
  }
  return Comparisons(std::move(items), std::move(sources), true);
}

std::uint64_t Comparisons::size() const {
  return pairs_ ? pair_count(table_.rows()) : table_.rows();
}

void Comparisons::fetch(std::uint64_t index, std::span<Bits> operands) const {
  MIXCMP_CHECK(operands.size() == sources_.size());
  const auto [first, second] = items(index);
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    operands[k] = table_.at(sources_[k].second ? second : first, sources_[k].column);
  }
}

std::pair<std::uint64_t, std::uint64_t> Comparisons::items(std::uint64_t index) const {
  MIXCMP_CHECK(index < size());
  return pairs_ ? pair_items(index, table_.rows()) : std::pair(index, index);
}

}  // namespace mixcmp::model
