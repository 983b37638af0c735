#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/hardware/datapath/schedule.hpp"
#include "generator/hardware/rtl/module.hpp"
#include "model/base/number/operand_format.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::rtl {

/// A port of a datapath: the bits that it reads of a comparison's operands or words.
struct OperandPort {
  std::string name;
  int low;
  int width;
};

/// Lanes or references of one kind.
struct DatapathGroup {
  std::string datapath;  ///< the module's name
  std::vector<OperandPort> operands;
  std::string channel;  ///< the module that surrounds the datapath with its streams
  std::string label;    ///< label of the loop that instantiates the channels
  datapath::Schedule schedule;
  int first = 0;  ///< the number of the group's first lane or reference
  int count = 0;
};

/// Names and widths that the modules around the datapaths agree on.
struct SystemShape {
  std::string top;
  std::vector<DatapathGroup> lane_groups;
  std::vector<DatapathGroup> reference_groups;  ///< empty: p_H = 0
  /// The lanes that are asked before the references are: one behind each segment of a pairwise
  /// engine, or in a system of streams `count` of them behind the crossbar.
  std::optional<DatapathGroup> second_tier;
  int second_tier_slot_bits = 0;             ///< in a system of streams: slot_bits of these lanes
  std::vector<std::string> input_ports;      ///< the datapaths' operand ports, in packing order
  std::vector<OperandFormat> input_formats;  ///< one per port
  int lanes = 0;                             ///< p_L
  int lanes_per_group = 1;                   ///< lanes in lock step, which share a channel
  int references = 0;                        ///< p_H
  /// Bits of a comparison's words if lanes read words of an engine's items; 0: lanes read operands.
  int word_bits = 0;
  int tag_bits = 0;
  /// The low bits of a tag by which a reference asks for operands; 0: the whole tag.
  int asking_bits = 0;
  int slot_bits = 0;
  int input_registers = 0;    ///< registers between a port of operands and its lane
  int counter_bits = 0;       ///< bits of each counter's output; 0: no counters
  int read_counter_bits = 0;  ///< bits of counts that software reads on a port; 0: no port
  scene::ResultOrder order = scene::ResultOrder::tagged;
  scene::OperandStore operands = scene::OperandStore::carried;
  int beat_bits = 0;  ///< a request of carried operands has 2^beat_bits beats
  /// Carried operands wait in block memories that are written whole and read beat by beat.
  bool block_memory = false;

  int operand_bits() const;  ///< bits of a comparison's operands
  int tdata_bytes() const { return (operand_bits() + 7) / 8; }
  int lane_operand_bits() const { return word_bits > 0 ? word_bits : operand_bits(); }
  int lane_tdata_bytes() const { return (lane_operand_bits() + 7) / 8; }
  int channels() const { return lanes / lanes_per_group; }
  int ask_bits() const { return asking_bits > 0 ? asking_bits : tag_bits; }
  /// Bits of a tag on the refetch stream, padded to bytes as AXI4-Stream wants it.
  int refetch_bits() const { return (ask_bits() + 7) / 8 * 8; }
  int channel_bits() const;  ///< width of a channel's number, at least 1
  int payload_bits() const;  ///< width of a request's tag, or of a beat's part of the operands
  /// Cycles that the channel adds to its lane's latency, for a decided comparison that never waits.
  int channel_latency_cycles() const;
  bool recomputes() const { return references > 0; }
  /// The lanes of the second tier, or 0. Not for engines.
  int second_lanes() const { return second_tier ? second_tier->count : 0; }
  /// The number of streams by which operands are fetched again: those of the references, then those
  /// of the second tier. Not for engines.
  int refetch_streams() const { return refetches() ? references + second_lanes() : 0; }
  bool has_counter_port() const { return read_counter_bits > 0; }
  bool counts_answers() const { return has_counter_port() && recomputes(); }
  /// The operand ports of a datapath that takes operands as they arrive.
  std::vector<OperandPort> operand_ports() const;
  bool refetches() const { return recomputes() && operands == scene::OperandStore::refetched; }
};

/// The second tier of a system of streams, seen as the lanes of a system of its own. Each takes
/// requests of the first tier from the crossbar. Its tag is the sender and the tag by which
/// operands are fetched again. It asks the references through a crossbar of its own.
SystemShape second_tier_shape(const SystemShape& shape);

}  // namespace mixcmp::rtl
