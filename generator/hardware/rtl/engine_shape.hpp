#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/hardware/rtl/system_shape.hpp"
#include "model/comparison/data/pairing.hpp"
#include "model/scene/engine.hpp"

namespace mixcmp::rtl {

/// Names and widths that an engine and the system inside it agree on.
struct EngineShape {
  /// The source of an operand of the comparison: a column of one of its items.
  struct Source {
    std::size_t column;  ///< index in the columns of the item
    data::Item item;
  };

  std::string top;
  scene::EngineSpec spec;
  int capacity = 0;                  ///< items of a set, or candidates
  std::vector<std::string> columns;  ///< an item's, lowest bits first, in the order of first use
  std::vector<std::string> row_columns;  ///< a row's, like `columns`; empty for a pairwise engine
  std::vector<Source> sources;           ///< one per input
  std::vector<OperandFormat> column_formats;      ///< one for each of `columns`
  std::vector<OperandFormat> row_column_formats;  ///< one for each of `row_columns`

  const std::vector<std::string>& columns_of(data::Item item) const {
    return item == data::Item::row ? row_columns : columns;
  }
  int index_bits() const { return scene::index_bits_for(capacity); }
  const std::vector<OperandFormat>& formats_of(data::Item item) const {
    return item == data::Item::row ? row_column_formats : column_formats;
  }
  int row_bits() const { return total_width(row_column_formats); }
  int row_bytes() const { return (row_bits() + 7) / 8; }
  int item_bits() const { return total_width(column_formats); }
  int item_bytes() const { return (item_bits() + 7) / 8; }
  /// Width in bits of an item's number on an output stream, padded to bytes.
  int index_field_bits() const { return (index_bits() + 7) / 8 * 8; }
};

/// The engine that `spec` asks for; nullopt if it asks for none. `inputs`: the names of the
/// expression's inputs.
std::optional<EngineShape> engine_shape(const SystemShape& system,
                                        const std::vector<std::string>& inputs,
                                        const scene::EngineSpec& spec);

}  // namespace mixcmp::rtl
