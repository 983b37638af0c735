#pragma once

#include "generator/hardware/rtl/counter_port.hpp"
#include "generator/hardware/rtl/engine_shape.hpp"
#include "generator/hardware/rtl/item_words.hpp"

namespace mixcmp::rtl {

/// The shape of an arg-min engine, on which its modules agree.
struct ArgMinShape {
  EngineShape engine;
  ItemWords words;
  int place_bits = 0;  ///< 2^place_bits rows may be inside
};

/// Bits of the number of a row inside an engine whose `lanes` lanes have 2^slot_bits slots and
/// whose conversion takes `word_latency_cycles`: there is a place for every row that finds room.
int place_bits(int lanes, int slot_bits, int word_latency_cycles);
/// Bits of a tag by which a reference asks for a pair of candidates and a row.
int asking_bits(const EngineShape& engine, int place_bits);

/// Changes the system inside an engine: its lanes then read words, and its references ask the
/// engine for operands. Returns the engine around it. The system's lanes are scheduled.
ArgMinShape arg_min_shape(const EngineShape& engine, ItemWords words, SystemShape& system);

/// The template arg_min_engine, which makes the comparisons, with its parameters; unconnected.
TemplateInstance arg_min_template(const ArgMinShape& shape, const SystemShape& system);

/// The template operand_memory of an engine with this many references; unconnected.
TemplateInstance operand_memory_template(const EngineShape& engine, int place_bits, int references);

/// The conversions of candidates and rows without the engine: a module with their columns as inputs
/// and their words as outputs.
Module arg_min_conversions_module(const ArgMinShape& shape);

/// The counters of the engine's top: those of the system inside and its own.
std::vector<Counters> arg_min_counters(const SystemShape& system);

/// The engine's top module around the system: it takes candidates and rows, and returns the index
/// of the best candidate for each row.
Module arg_min_module(const ArgMinShape& shape, const SystemShape& system);

}  // namespace mixcmp::rtl
