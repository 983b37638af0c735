#pragma once

#include <array>
#include <string>
#include <string_view>

#include "model/base/common/result.hpp"
#include "model/cost/measured/component_key.hpp"

namespace mixcmp::measured {

/// The cells of a table's row that identify its component. A cell that does not apply to the
/// component is empty or "0".
struct KeyCells {
  std::string kind;
  std::string name;         ///< of a unit; of a reference its unusual traits: "fused at_600_mhz"
  std::string format;       ///< "s17e8"; of a lane in fixed point "q13"
  std::string inputs;       ///< of a lane in floating point
  std::string bound;        ///< of a lane
  std::string multipliers;  ///< of lanes and references with a product
  std::string initiation_interval = "0";  ///< of a reference
  std::string ports = "0";                ///< the count of a component that has one
};

/// A cell's place in a row is that of its column in this list.
struct KeyColumn {
  std::string_view name;
  std::string KeyCells::*cell;
};
inline constexpr std::array<KeyColumn, 8> key_columns = {{
    {"kind", &KeyCells::kind},
    {"name", &KeyCells::name},
    {"format", &KeyCells::format},
    {"inputs", &KeyCells::inputs},
    {"bound", &KeyCells::bound},
    {"multipliers", &KeyCells::multipliers},
    {"initiation_interval", &KeyCells::initiation_interval},
    {"ports", &KeyCells::ports},
}};

KeyCells cells_of(const ComponentKey& key);
/// Reads what `cells_of` writes. An error's field is the name of a column.
Result<ComponentKey> key_of(const KeyCells& cells);

}  // namespace mixcmp::measured
