#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/fixed/fixed_lane.hpp"

/// Comparisons of two items of one set, for a row or for themselves, where each item and each row
/// meets many others: what depends on one item alone, or on the row alone, is computed once, when
/// it is loaded, and kept as its word.
namespace mixcmp::fixed {

/// Where the operand of an input comes from.
struct ItemInput {
  int column;  ///< of the item or of the row
  ItemRole role;

  friend bool operator==(const ItemInput&, const ItemInput&) = default;
};

/// What computes the word of an item, or of a row.
struct ItemLoader {
  /// Its inputs are the columns, its `outputs` the word's fields, each once, though pairs may read
  /// it of both items. It has no parts.
  FixedLane lane;
  /// The word's flags, behind its fields: each the inputs of the lane whose operands do not fit.
  std::vector<std::vector<NodeId>> flags;
};

struct ItemSplit {
  ItemLoader items;
  ItemLoader rows;  ///< without nodes where no input is of a row
  /// One for each of the lanes that were split: the rest of it, with `loaded_inputs`.
  std::vector<FixedLane> lanes;

  const ItemLoader& of(ItemRole role) const { return role == ItemRole::row ? rows : items; }
};

/// Splits one or more lanes of the same comparison, none in block floating point, so that all of
/// them read the same words. An operand that several of them read is one field, in the finest of
/// their formats: since operands are rounded down, its upper bits are what a coarser format would
/// hold. `inputs`: one for each input of the comparison. `columns`, `row_columns`: the names of an
/// item's and of a row's. A lane decides as before: for the same operands it gives the same
/// verdict, and is undecided where it was.
ItemSplit split_by_item(const std::vector<const FixedLane*>& lanes,
                        const std::vector<ItemInput>& inputs,
                        const std::vector<std::string>& columns,
                        const std::vector<std::string>& row_columns);

/// A flag of the word of one of the two items, or of the row.
struct LoadedFlag {
  ItemRole role;
  std::size_t flag;

  friend auto operator<=>(const LoadedFlag&, const LoadedFlag&) = default;
};
/// The flags that a lane reads, each once: those of item i first, then those of item j.
std::vector<LoadedFlag> flags_read(const FixedLane& lane);

}  // namespace mixcmp::fixed
