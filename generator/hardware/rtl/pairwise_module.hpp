#pragma once

#include "generator/hardware/rtl/counter_port.hpp"
#include "generator/hardware/rtl/engine_shape.hpp"
#include "generator/hardware/rtl/item_words.hpp"
#include "generator/hardware/rtl/segment_module.hpp"

namespace mixcmp::rtl {

/// The shape of a pairwise engine, on which its modules agree.
struct PairwiseShape {
  EngineShape engine;
  ItemWords words;
  std::vector<SegmentGroup> segments;

  int segment_count() const { return segments.back().first + segments.back().count; }
  /// Lanes of the widest segment.
  int lanes_per_segment() const;
  /// Reports cannot leave by more streams than there are segments.
  int streams() const;
  /// Bytes of a beat of one report stream.
  int report_bytes() const;
};

/// The shape on which an engine's references and the modules around them agree: a request carries
/// its operands, and its sender is the pair's tag.
SystemShape reference_shape(SystemShape system);

/// The template pairwise_engine, everything but lanes and references, with its parameters;
/// unconnected.
TemplateInstance pairwise_template(const PairwiseShape& shape, const SystemShape& system);

/// The counters of the engine's top.
std::vector<Counters> pairwise_counters(const PairwiseShape& shape, const SystemShape& system);

/// The engine's top module: it takes items and returns reports of pairs.
Module pairwise_module(const PairwiseShape& shape, const SystemShape& system);

}  // namespace mixcmp::rtl
