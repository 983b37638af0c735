#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/hardware/datapath/delays.hpp"
#include "generator/hardware/datapath/schedule.hpp"
#include "generator/hardware/rtl/engine_shape.hpp"
#include "generator/hardware/rtl/module.hpp"
#include "model/design/design.hpp"
#include "model/lane/fixed/item_split.hpp"

/// Words of an engine's items, and of its rows if it has any. They hold everything that lanes read
/// of an item, and are computed once, when it is loaded.
namespace mixcmp::rtl {

/// A port of a lane: bits of the word of one of its items, or of the row.
struct LanePort {
  std::string name;
  data::Item item;
  int low;
  int width;
};

/// A lane that reads words. It computes in fixed point on converted values, or it takes the columns
/// as they arrive.
struct WordLane {
  design::Lane lane;
  std::vector<LanePort> ports;  ///< in the order of the lane's inputs
};

/// The word of an item, or of a row.
struct Word {
  /// Bits of the word, the first field lowest: a computed value, one of its flags, or a column as
  /// it arrives.
  struct Field {
    std::string name;
    int width;
    int low;
  };
  std::vector<Field> fields;         ///< empty for a row in an engine without rows
  std::vector<std::size_t> columns;  ///< columns that the word holds as they arrive
  datapath::Schedule schedule;
  std::string module;  ///< computes it; empty if nothing is computed

  int bits() const { return fields.empty() ? 0 : fields.back().low + fields.back().width; }
  bool converts() const { return !module.empty(); }
};

struct ItemWords {
  Word items;
  Word rows;                              ///< takes as long to compute as an item's word
  std::optional<fixed::ItemSplit> split;  ///< none if nothing is computed
  std::vector<WordLane> lanes;            ///< one per group of the design's lanes
  std::optional<WordLane> second_tier;

  const Word& of(data::Item item) const { return item == data::Item::row ? rows : items; }
  /// The datapath that computes the word of an item or a row; only for words that are converted.
  const fixed::FixedLane& loader_of(data::Item item) const {
    return (item == data::Item::row ? split->rows : split->items).lane;
  }
  int latency_cycles() const { return items.schedule.latency_cycles; }
};

/// Splits the lanes of a design with an engine.
ItemWords item_words(const design::Design& design, const EngineShape& engine,
                     const datapath::DelayTable& delays);

/// The datapath that computes the word of an item or a row from its columns; only for words that
/// are converted.
Module item_word_module(const ItemWords& words, data::Item item, const EngineShape& engine);

/// A lane that reads words; `header` is left to the caller.
Module word_lane_module(const std::string& name, const WordLane& lane,
                        const datapath::Schedule& schedule);

}  // namespace mixcmp::rtl
