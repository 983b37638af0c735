#pragma once

#include <string>

#include "generator/hardware/rtl/item_words.hpp"
#include "generator/hardware/rtl/system_shape.hpp"

namespace mixcmp::rtl {

/// Equal segments of a pairwise engine that follow each other in its chain.
struct SegmentGroup {
  std::string module;
  std::string label;           ///< label of the loop that instantiates them
  std::size_t lane_group = 0;  ///< the group of the system's lanes that they hold
  int lanes = 0;               ///< lanes of each segment
  int first = 0;               ///< the number of the first segment
  int count = 0;
};

/// The segments that hold the system's lanes, at most `lanes_per_segment` each, in their order.
std::vector<SegmentGroup> segment_groups(const SystemShape& system, int lanes_per_segment);

/// Bits of a word in the chain: its flags, its number, the word itself.
int chain_bits(const EngineShape& engine, const ItemWords& words);
/// Bits of the code with which a segment reports one pair.
int code_bits(const scene::EngineSpec& engine);
/// Bits of a beat of exceptions from segments of `lanes` lanes.
int entry_bits(const EngineShape& engine, int lanes);

/// A segment: the template pair_segment around its lanes.
Module segment_module(const SystemShape& system, const EngineShape& engine, const ItemWords& words,
                      const SegmentGroup& segments);

}  // namespace mixcmp::rtl
