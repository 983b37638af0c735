#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/fixed/fixed_lane.hpp"

/// Comparisons of two items of one set, where each item meets many others: what depends on one
/// item alone is computed once, when the item is loaded, and kept as the item's word.
namespace mixcmp::fixed {

/// Where the operand of an input comes from.
struct ItemInput {
  int column;   ///< of the item
  bool second;  ///< of item j; else of item i

  friend bool operator==(const ItemInput&, const ItemInput&) = default;
};

struct ItemSplit {
  /// Computes the word. Its inputs are the columns of an item, its `outputs` the word's fields,
  /// each once, though pairs may read it of both items. It has no parts.
  FixedLane loader;
  /// The word's flags, behind its fields: each the inputs of the loader whose operands do not fit.
  std::vector<std::vector<NodeId>> flags;
  /// One for each of the lanes that were split: the rest of it, with `loaded_inputs`.
  std::vector<FixedLane> lanes;
};

/// Splits one or more lanes of the same comparison, none in block floating point, so that all of
/// them read one word. An operand that several of them read is one field, in the finest of their
/// formats: since operands are rounded down, its upper bits are what a coarser format would hold.
/// `inputs`: one for each input of the comparison. A lane decides as before: for the same operands
/// it gives the same verdict, and is undecided where it was.
ItemSplit split_by_item(const std::vector<const FixedLane*>& lanes,
                        const std::vector<ItemInput>& inputs,
                        const std::vector<std::string>& columns);

/// A flag of the word of one of the two items.
struct LoadedFlag {
  bool second;
  std::size_t flag;

  friend auto operator<=>(const LoadedFlag&, const LoadedFlag&) = default;
};
/// The flags that a lane reads, each once: those of item i first.
std::vector<LoadedFlag> flags_read(const FixedLane& lane);

}  // namespace mixcmp::fixed
