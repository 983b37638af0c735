#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/comparison/data/pairing.hpp"
#include "model/comparison/data/table.hpp"

namespace mixcmp::data {

/// Pairs i < j of `count` items, numbered (0,1), (0,2), ..., (1,2), ...; exact up to 2^31 items.
constexpr std::uint64_t max_paired_items = std::uint64_t{1} << 31;
std::uint64_t pair_count(std::uint64_t count);
std::pair<std::uint64_t, std::uint64_t> pair_items(std::uint64_t index, std::uint64_t count);
/// The number of the pair (i, j), i < j < count.
std::uint64_t pair_index(std::uint64_t i, std::uint64_t j, std::uint64_t count);

/// The most comparisons of arg_min. The first item of each is stored in memory.
constexpr std::uint64_t max_arg_min_comparisons = std::uint64_t{1} << 28;

/// The numbers of the rows in one comparison. Pairing::all and Pairing::cross use `first` and
/// `second`, Pairing::arg_min and Pairing::rows all three.
struct Items {
  std::uint64_t row = 0;
  std::uint64_t first = 0;   ///< i
  std::uint64_t second = 0;  ///< j

  std::uint64_t of(Item item) const {
    return item == Item::row ? row : item == Item::first ? first : second;
  }
  friend bool operator==(const Items&, const Items&) = default;
};

class Comparisons;

/// Sets greater[k] to whether f is greater than g in the comparison of items[k].
using CompareItems = std::function<void(const Comparisons& data, std::span<const Items> items,
                                        std::span<std::uint8_t> greater)>;

/// The comparisons that a scene asks for, by index. With pairs, input "cxi" is column "cx" of item
/// i, "cxj" that of item j.
///
/// arg_min finds, for each row of the first table, the candidate (a row of the second table) with
/// the least cost. f is the cost of candidate i for the row, g that of j. The comparisons are those
/// of
///
///     best = 0; for j = 1 .. candidates - 1: compare (best, j); if f > g: best = j
///
/// so the first of equal candidates stays, and an unordered comparison changes nothing.
class Comparisons {
public:
  /// `inputs` are the expression's, in order. Errors name an input without a column.
  static Result<Comparisons> rows(Table table, const std::vector<std::string>& inputs);
  static Result<Comparisons> all_pairs(Table items, const std::vector<std::string>& inputs);
  static Result<Comparisons> cross(Table first, Table second,
                                   const std::vector<std::string>& inputs);
  static Result<Comparisons> arg_min(Table rows, Table candidates,
                                     const std::vector<std::string>& inputs,
                                     const CompareItems& compare);

  std::uint64_t size() const;
  /// Writes the operands of comparison `index` in the order of `inputs`.
  void fetch(std::uint64_t index, std::span<Bits> operands) const;
  /// Writes the operands of the comparison of these items in the order of `inputs`. The items need
  /// not belong to any index.
  void fetch(const Items& items, std::span<Bits> operands) const;
  /// The items of comparison `index`. (first, second) is (0,1), (0,2), ..., (1,2), ... with
  /// Pairing::all, and (0,0), (0,1), ... with Pairing::cross. With Pairing::arg_min rows come one
  /// after the other, each with second = 1, 2, ...; with Pairing::rows all three are `index`.
  Items items(std::uint64_t index) const;
  /// The length, at least 1, of the run of comparisons that begins at `index`. In a run,
  /// moving_item() grows by 1 from one comparison to the next, and the other items stay the same.
  std::uint64_t run_length(std::uint64_t index) const;
  Item moving_item() const { return pairing_ == Pairing::rows ? Item::row : Item::second; }

  /// The candidate with the least cost for `row`; only for Pairing::arg_min.
  std::uint64_t arg_min(std::uint64_t row) const { return least_[row]; }

  /// The table, the column and the item of an input's operands.
  struct Source {
    std::size_t table;
    std::size_t column;
    Item item;
  };

  /// Converts all numbers to another format. It must hold each of them.
  Comparisons in_format(FloatFormat format) const;

  const std::vector<Table>& tables() const { return tables_; }
  const Table& table() const { return tables_[0]; }  ///< the first table
  FloatFormat format() const { return tables_[0].format; }
  std::size_t input_count() const { return sources_.size(); }
  const std::vector<Source>& sources() const { return sources_; }
  Pairing pairing() const { return pairing_; }
  /// Whether any comparison may read row `row` of the source's table through `source`.
  bool takes_part(const Source& source, std::uint64_t row) const;

private:
  Comparisons(Pairing pairing, std::vector<Table> tables, std::vector<Source> sources)
      : pairing_(pairing), tables_(std::move(tables)), sources_(std::move(sources)) {}

  static Result<Comparisons> make(Pairing pairing, std::vector<Table> tables,
                                  const std::vector<std::string>& inputs);
  void find_least_candidates(const CompareItems& compare);

  Pairing pairing_;
  std::vector<Table> tables_;
  std::vector<Source> sources_;
  std::vector<std::uint32_t> best_before_;  ///< for arg_min: item i of each comparison
  std::vector<std::uint32_t> least_;        ///< for arg_min: best candidate of each row
};

/// The numbers of all tables that their format does not keep.
LostNumbers lost_numbers_of(const Comparisons& data);

/// The items of a comparison in words, for a report: "items 3 and 7".
std::string describe(const Comparisons& data, std::uint64_t index);

}  // namespace mixcmp::data
