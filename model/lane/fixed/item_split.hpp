#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/lane/fixed/fixed_lane.hpp"

/// Lanes that compare two items of one set, with each other or with a row. Each item and each row
/// takes part in many comparisons. Values that depend only on one item, or only on the row, are
/// computed once, when the item or the row is loaded. They are stored as its word.
namespace mixcmp::fixed {

/// The source of an input's operand.
struct ItemInput {
  int column;  ///< the item's column, or the row's
  ItemRole role;

  friend bool operator==(const ItemInput&, const ItemInput&) = default;
};

/// The computation of an item's word, or of a row's.
struct ItemLoader {
  /// Its inputs are the columns and its `outputs` the word's fields. A field that pairs read of
  /// both items occurs only once. The lane has no parts.
  FixedLane lane;
  /// The word's flags, after its fields. A flag is set if an operand of the inputs that it lists
  /// does not fit.
  std::vector<std::vector<NodeId>> flags;
};

struct ItemSplit {
  ItemLoader items;
  ItemLoader rows;  ///< without nodes if no input belongs to a row
  /// One for each split lane: the rest of it, with `loaded_inputs`.
  std::vector<FixedLane> lanes;

  const ItemLoader& of(ItemRole role) const { return role == ItemRole::row ? rows : items; }
};

/// Splits one or more lanes of the same comparison, none in block floating point, so that all of
/// them read the same words. An operand that several lanes read is one field, in the finest of
/// their formats. Operands are rounded down, so its upper bits are the operand in a coarser format.
/// `inputs`: one for each input of the comparison. `columns`, `row_columns`: the names of an item's
/// and of a row's columns. A lane's decisions do not change: for the same operands it gives the
/// same verdict or stays undecided.
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
/// The flags that a lane reads, each once: first those of item i, then those of item j.
std::vector<LoadedFlag> flags_read(const FixedLane& lane);

}  // namespace mixcmp::fixed
