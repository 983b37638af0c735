#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/datapath/delays.hpp"
#include "generator/datapath/schedule.hpp"
#include "generator/rtl/engine_shape.hpp"
#include "generator/rtl/module.hpp"
#include "model/design/design.hpp"
#include "model/fixed/item_split.hpp"

/// What the lanes of a pairwise engine know of an item: computed once, when the item is loaded.
namespace mixcmp::rtl {

/// A port of a lane: bits of the word of one of its two items.
struct LanePort {
  std::string name;
  bool second;  ///< of item j; else of item i
  int low;
  int width;
};

/// A lane that reads words: one that computes in fixed point on what is converted already, or one
/// that takes the columns as they arrive.
struct WordLane {
  design::Lane lane;
  std::vector<LanePort> ports;  ///< in the order of the lane's inputs
};

struct ItemWords {
  /// Bits of the word, the first field lowest: what was computed, its flags, columns as they
  /// arrive.
  struct Field {
    std::string name;
    int width;
    int low;
  };
  std::vector<Field> fields;
  std::optional<fixed::ItemSplit> split;  ///< none where nothing is computed
  datapath::Schedule schedule;
  std::vector<std::size_t> columns;  ///< those that the word holds as they arrive
  std::vector<WordLane> lanes;       ///< one per group of the design's lanes
  std::optional<WordLane> second_tier;

  int bits() const { return fields.back().low + fields.back().width; }
  bool converts() const { return split.has_value(); }
};

/// Splits the lanes of a design with a pairwise engine.
ItemWords item_words(const design::Design& design, const EngineShape& engine,
                     const datapath::DelayTable& delays);

/// The datapath that computes an item's word from its columns; only for words that are converted.
Module item_word_module(const std::string& name, const ItemWords& words, const EngineShape& engine);

/// A lane that reads words; `header` is left to the caller.
Module word_lane_module(const std::string& name, const WordLane& lane,
                        const datapath::Schedule& schedule);

}  // namespace mixcmp::rtl
