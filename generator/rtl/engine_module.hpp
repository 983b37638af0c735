#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/rtl/system_modules.hpp"
#include "model/scene/engine.hpp"

namespace mixcmp::gen {

/// What an engine and the system inside it agree on.
struct EngineShape {
  /// Where an operand of the comparison comes from.
  struct Source {
    std::size_t column;
    bool second;  ///< of item j
  };

  std::string top;
  model::EngineSpec spec;
  std::vector<std::string> columns;  ///< of an item, the first lowest, in the order of first use
  std::vector<Source> sources;       ///< one an input
  int column_width = 0;              ///< bits of one column

  int item_bits() const { return column_width * static_cast<int>(columns.size()); }
  int item_bytes() const { return (item_bits() + 7) / 8; }
  /// Of an item's number in a report, padded to bytes.
  int index_field_bits() const { return (spec.index_bits() + 7) / 8 * 8; }
};

/// None where the scene asks for no engine. `inputs`: the expression's.
std::optional<EngineShape> engine_shape(const SystemShape& system,
                                        const std::vector<std::string>& inputs,
                                        const model::EngineSpec& spec);

/// The whole: the engine around the system. Each kind has a file of its own.
rtl::Module engine_module(const EngineShape& engine, const SystemShape& system);

}  // namespace mixcmp::gen
