#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/rtl/system_modules.hpp"
#include "model/data/pairing.hpp"
#include "model/scene/engine.hpp"

namespace mixcmp::gen {

/// What an engine and the system inside it agree on.
struct EngineShape {
  /// The place of an operand of the comparison.
  struct Source {
    std::size_t column;  ///< of its item's
    model::Item item;
  };

  std::string top;
  model::EngineSpec spec;
  int capacity = 0;                  ///< items of a set, or candidates
  std::vector<std::string> columns;  ///< of an item, the first lowest, in the order of first use
  std::vector<std::string> row_columns;  ///< of a row, likewise; none of a pairwise engine
  std::vector<Source> sources;           ///< one an input
  int column_width = 0;                  ///< bits of one column

  const std::vector<std::string>& columns_of(model::Item item) const {
    return item == model::Item::row ? row_columns : columns;
  }
  int index_bits() const { return model::index_bits_for(capacity); }
  int row_bits() const { return column_width * static_cast<int>(row_columns.size()); }
  int row_bytes() const { return (row_bits() + 7) / 8; }
  int item_bits() const { return column_width * static_cast<int>(columns.size()); }
  int item_bytes() const { return (item_bits() + 7) / 8; }
  /// Width in bits of an item's number in a report, padded to bytes.
  int index_field_bits() const { return (index_bits() + 7) / 8 * 8; }
};

/// The engine of a scene; none where it asks for none. `inputs`: the expression's.
std::optional<EngineShape> engine_shape(const SystemShape& system,
                                        const std::vector<std::string>& inputs,
                                        const model::EngineSpec& spec);

/// The whole: the engine around the system. Each kind has a file of its own.
rtl::Module engine_module(const EngineShape& engine, const SystemShape& system);

}  // namespace mixcmp::gen
